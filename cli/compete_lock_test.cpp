// SPDX-License-Identifier: MIT
// Two runs of phytobench compete that begin in one folder.
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "cli/compete_fixture.hpp"

namespace phytobench {
namespace {

class CompeteLock : public CompeteCommand {};

TEST_F(CompeteLock, IsTakenBeforeTheFilesThatAnotherRunWritesAreLookedFor) {
  expect_done("lively.toml --steps 3 --checkpoint 1 --out shared");
  const auto files = files_below("shared");
  const int folder = ::open((this->folder() / "shared").c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(folder, LOCK_EX), 0);
  expect_refused_line("compete lively.toml --steps 3 --out shared",
                      "shared: another run is writing there");
  ::close(folder);
  expect_refused_line("compete lively.toml --steps 3 --out shared", "already holds checkpoint.bin");
  EXPECT_EQ(files_below("shared"), files);
}

}  // namespace
}  // namespace phytobench
