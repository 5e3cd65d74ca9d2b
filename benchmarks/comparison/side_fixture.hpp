// SPDX-License-Identifier: MIT
// For tests: a folder per test, with small programs and a repository in it.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/child_process.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {

/// The message of the error of that type that an action ends with.
template <class Error, class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

/// Whether a process of that number is there, and is no corpse that waits for its parent.
inline bool is_alive(const std::string& number) {
  std::ifstream stat("/proc/" + number + "/stat");
  std::string text;
  std::getline(stat, text);
  return !text.empty() && text.find(") Z ") == std::string::npos;
}

/// True once a moment has passed in which the process may end.
inline bool ends(const std::string& number) {
  for (int i = 0; i < 200 && is_alive(number); ++i) ::usleep(10000);
  return !is_alive(number);
}

class SideFolder : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("phytobench-") + test->test_suite_name() + "-" + test->name() +
                       "-" + std::to_string(::getpid());
    std::replace(name.begin(), name.end(), '/', '-');
    folder_ = std::filesystem::path(testing::TempDir()) / name;
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    folder_ = std::filesystem::canonical(folder_);
    // Neither a repository around temporary files nor the user's settings of git count here.
    ::setenv("GIT_CEILING_DIRECTORIES", folder_.parent_path().c_str(), 1);
    ::setenv("GIT_CONFIG_GLOBAL", "/dev/null", 1);
    ::setenv("GIT_CONFIG_NOSYSTEM", "1", 1);
    for (const char* variable : {"GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE"})
      ::unsetenv(variable);
  }

  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::filesystem::path& name, const std::string& text) const {
    write_file_atomically(folder_ / name, text);
    return folder_ / name;
  }

  /// A program that the shell runs.
  std::filesystem::path write_script(const std::filesystem::path& name,
                                     const std::string& lines) const {
    write(name, "#!/bin/sh\n" + lines + "\n");
    std::filesystem::permissions(folder_ / name, std::filesystem::perms::owner_all);
    return folder_ / name;
  }

  /// A program that is an ELF file.
  std::filesystem::path write_program(const std::filesystem::path& name) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::filesystem::copy_file("/bin/sh", folder_ / name);
    return folder_ / name;
  }

  std::filesystem::path repository() const { return folder_ / "repository"; }

  /// Runs git there and returns what it prints, without the line end.
  std::string git(const std::vector<std::string>& words) const {
    std::vector<std::string> command = {"git", "-c", "user.name=Test", "-c",
                                        "user.email=test@example.org"};
    command.insert(command.end(), words.begin(), words.end());
    const ChildResult result = run_child({.command = command, .folder = repository()});
    EXPECT_TRUE(result.is_ok()) << result.err;
    return result.out.substr(0, result.out.find_last_not_of('\n') + 1);
  }

  void start_repository() const {
    std::filesystem::create_directories(repository());
    git({"init", "--quiet", "--initial-branch=main"});
  }

  /// Commits everything in the repository and returns the commit.
  std::string commit() const {
    git({"add", "--all"});
    git({"commit", "--quiet", "--allow-empty", "--message=change"});
    return git({"rev-parse", "HEAD"});
  }

  std::filesystem::path folder_;
};

}  // namespace phytobench
