// SPDX-License-Identifier: MIT
#include "core/contract/temporary_file.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

TEST(TemporaryFile, IsReadFromItsBeginningAndAsAWhole) {
  const std::string text = std::string(100'000, 'x') + '\0' + "end\n";
  const TemporaryFile file = temporary_file(text, "none");
  EXPECT_EQ(std::fgetc(file.get()), 'x');
  EXPECT_EQ(content_of(file), text) << "wherever it stands";
  EXPECT_EQ(content_of(file), text) << "once more";
  EXPECT_EQ(content_of(temporary_file("", "none")), "");
}

TEST(TemporaryFile, HoldsWhatIsWrittenThroughItsDescriptor) {
  const TemporaryFile file = temporary_file("", "none");
  ASSERT_EQ(::write(::fileno(file.get()), "abc", 3), 3);
  EXPECT_EQ(content_of(file), "abc");
}

TEST(TemporaryFile, IsNotForProgramsThatAreStarted) {
  const TemporaryFile file = temporary_file("", "none");
  EXPECT_NE(::fcntl(::fileno(file.get()), F_GETFD) & FD_CLOEXEC, 0);
}

/// Lets the process write to no file while it lives. (Without descriptors, not even the checks of a
/// sanitizer would work.)
class NoByteInFiles {
 public:
  NoByteInFiles() : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit none{0, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &none);
  }
  ~NoByteInFiles() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  NoByteInFiles(const NoByteInFiles&) = delete;
  NoByteInFiles& operator=(const NoByteInFiles&) = delete;

 private:
  void (*handler_)(int);
  rlimit before_{};
};

TEST(TemporaryFile, SaysForWhatThereIsNone) {
  std::string said;
  {
    const NoByteInFiles limit;
    try {
      temporary_file("text", "no file for the script");
    } catch (const EnvironmentError& error) {
      said = error.what();
    }
  }
  EXPECT_THAT(said, testing::StartsWith("no file for the script: "));
}

}  // namespace
}  // namespace phytobench
