// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/found_program.hpp"

#include "benchmarks/comparison/side_fixture.hpp"

namespace phytobench {
namespace {

class FoundProgram : public SideFolder {
 protected:
  void SetUp() override {
    SideFolder::SetUp();
    const char* path = std::getenv("PATH");
    before_ = path == nullptr ? "" : path;
    write_script("first/tool", "exit 0");
    write_script("second/tool", "exit 0");
    write("first/text", "no program");
    write_script("second/text", "exit 0");
    std::filesystem::create_directories(folder_ / "first" / "folder");
  }
  void TearDown() override {
    ::setenv("PATH", before_.c_str(), 1);
    SideFolder::TearDown();
  }

  std::string before_;
};

TEST_F(FoundProgram, IsTheFirstOnPathThatCanBeRun) {
  ::setenv("PATH", ((folder_ / "first").string() + ":" + (folder_ / "second").string()).c_str(), 1);
  EXPECT_EQ(found_program("tool"), folder_ / "first" / "tool");
  EXPECT_EQ(found_program("text"), folder_ / "second" / "text");
  EXPECT_EQ(found_program("folder"), std::nullopt);
  EXPECT_EQ(found_program("missing"), std::nullopt);
  EXPECT_EQ(found_program(""), std::nullopt);
}

TEST_F(FoundProgram, WithAFolderIsNotLookedFor) {
  EXPECT_EQ(found_program((folder_ / "second" / "tool").string()), folder_ / "second" / "tool");
  EXPECT_EQ(found_program((folder_ / "first" / "text").string()), std::nullopt);
  EXPECT_EQ(found_program((folder_ / "first" / "folder").string()), std::nullopt);
  EXPECT_EQ(found_program("first/tool"), std::nullopt);
}

}  // namespace
}  // namespace phytobench
