// SPDX-License-Identifier: MIT
#include "core/contract/text_file.hpp"

#include <unistd.h>

#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

/// A fresh folder per test, removed with all it holds.
class TextFile : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        fs::path(testing::TempDir()) / (std::string("phytobench-") + test->test_suite_name() + "-" +
                                        test->name() + "-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }

  void TearDown() override { fs::remove_all(folder_); }

  /// Names of all that lies in the test's folder itself.
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
      found.push_back(entry.path().filename().string());
    return found;
  }

  fs::path folder_;
};

/// The message of the InputError that reading the file ends with.
std::string reading_error(const fs::path& file, std::uintmax_t most_bytes = 1000) {
  try {
    read_text_file(file, most_bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(TextFile, ComesBackAsItWasWritten) {
  const std::string zero("a\0b", 3);
  for (const std::string& text : std::vector<std::string>{
           "", "one line", "two\nlines\n", "dos\r\n", "\xc3\xa4", zero, std::string(100000, 'x')}) {
    write_file_atomically(folder_ / "file", text);
    EXPECT_EQ(read_text_file(folder_ / "file"), text);
  }
}

TEST_F(TextFile, ReplacesTheOldContentAndLeavesNothingElse) {
  write_file_atomically(folder_ / "file", "a long old content");
  write_file_atomically(folder_ / "file", "new");
  EXPECT_EQ(read_text_file(folder_ / "file"), "new");
  EXPECT_EQ(names(), std::vector<std::string>{"file"});
}

TEST_F(TextFile, MakesMissingFolders) {
  write_file_atomically(folder_ / "a" / "b" / "file", "text");
  EXPECT_EQ(read_text_file(folder_ / "a" / "b" / "file"), "text");
}

TEST_F(TextFile, MissingIsAnInputErrorThatNamesIt) {
  const fs::path file = folder_ / "nowhere";
  EXPECT_THAT(reading_error(file), testing::StartsWith(file.string() + ": no such file"));
  EXPECT_THAT(reading_error(folder_ / "no" / "where"), testing::HasSubstr("no such file"));
}

TEST_F(TextFile, FolderIsAnInputErrorThatNamesIt) {
  EXPECT_THAT(reading_error(folder_), testing::StartsWith(folder_.string() + ": is a folder"));
}

TEST_F(TextFile, TooLargeIsAnInputErrorThatNamesTheLimit) {
  const fs::path file = folder_ / "file";
  write_file_atomically(file, "12345678901");
  EXPECT_EQ(read_text_file(file, 11), "12345678901");
  EXPECT_THAT(reading_error(file, 10), testing::HasSubstr("larger than 10 bytes"));
}

TEST_F(TextFile, BelowAFileIsAnEnvironmentErrorAndChangesNothing) {
  write_file_atomically(folder_ / "file", "kept");
  EXPECT_THROW(write_file_atomically(folder_ / "file" / "child", "text"), EnvironmentError);
  EXPECT_THROW(write_file_atomically(folder_ / "file" / "deep" / "child", "text"),
               EnvironmentError);
  EXPECT_EQ(read_text_file(folder_ / "file"), "kept");
  EXPECT_EQ(names(), std::vector<std::string>{"file"});
}

TEST_F(TextFile, OverAFolderIsAnEnvironmentErrorAndLeavesNoPartBehind) {
  write_file_atomically(folder_ / "target" / "child", "kept");
  try {
    write_file_atomically(folder_ / "target", "text");
    ADD_FAILURE() << "a folder was overwritten";
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr((folder_ / "target").string()));
  }
  EXPECT_EQ(names(), std::vector<std::string>{"target"});
  EXPECT_EQ(read_text_file(folder_ / "target" / "child"), "kept");
}

TEST_F(TextFile, WithATooLongNameIsAnEnvironmentError) {
  EXPECT_THROW(write_file_atomically(folder_ / std::string(300, 'n'), "text"), EnvironmentError);
  EXPECT_TRUE(names().empty());
}

TEST_F(TextFile, MakeFolderMakesParentsAndAcceptsWhatExists) {
  make_folder(folder_ / "a" / "b");
  make_folder(folder_ / "a" / "b");
  make_folder(fs::path());
  EXPECT_TRUE(fs::is_directory(folder_ / "a" / "b"));
}

TEST_F(TextFile, MakeFolderWhereAFileIsIsAnEnvironmentError) {
  write_file_atomically(folder_ / "file", "kept");
  EXPECT_THROW(make_folder(folder_ / "file"), EnvironmentError);
  EXPECT_THROW(make_folder(folder_ / "file" / "below"), EnvironmentError);
  EXPECT_TRUE(fs::is_regular_file(folder_ / "file"));
}

TEST(ReadTextFile, StopsReadingADeviceWithoutEnd) {
  EXPECT_THROW(read_text_file("/dev/zero", 1 << 20), InputError);
}

}  // namespace
}  // namespace phytobench
