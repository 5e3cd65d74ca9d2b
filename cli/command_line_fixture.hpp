// SPDX-License-Identifier: MIT
// For tests: runs the program as a user does. Arguments in; exit code, standard output and standard
// error out. The build names the program in PHYTOBENCH_PROGRAM; PHYTOBENCH_DATA is passed through.
#pragma once

#include <fcntl.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {

using Words = std::vector<std::string>;

struct Outcome {
  int code = -1;
  std::string out;
  std::string err;
};

inline std::string content_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  EXPECT_TRUE(stream.is_open()) << file;
  return std::string(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
}

/// Lines after the first that begin so.
inline std::size_t lines_with(const std::string& text, const std::string& start) {
  std::size_t count = 0;
  for (std::size_t at = text.find("\n" + start); at != std::string::npos;
       at = text.find("\n" + start, at + 1))
    ++count;
  return count;
}

inline std::ptrdiff_t line_count(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

/// Text of a key, or nothing if it is missing or no text.
inline std::string text_at(const nlohmann::json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

/// Starts the program in `folder` with its output in files; 0 if that fails.
inline pid_t start(const Words& arguments, const std::filesystem::path& folder,
                   const std::filesystem::path& out, const std::filesystem::path& err) {
  Words words = {PHYTOBENCH_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  constexpr int fresh = O_WRONLY | O_CREAT | O_TRUNC;
  ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), fresh, 0600);
  ::posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), fresh, 0600);
  ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawnattr_t attributes;  // the program must see to it itself that a write only fails
  ::posix_spawnattr_init(&attributes);
  sigset_t defaults;
  ::sigemptyset(&defaults);
  ::sigaddset(&defaults, SIGXFSZ);
  ::posix_spawnattr_setsigdefault(&attributes, &defaults);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
  pid_t child = 0;
  const int error =
      ::posix_spawn(&child, PHYTOBENCH_PROGRAM, &actions, &attributes, argv.data(), environ);
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    ADD_FAILURE() << PHYTOBENCH_PROGRAM << ": " << std::strerror(error);
    return 0;
  }
  return child;
}

/// Waits for a program; -1 if it was killed.
inline int exit_code_of(pid_t child) {
  int status = 0;
  if (child == 0 || ::waitpid(child, &status, 0) != child || !WIFEXITED(status)) return -1;
  return WEXITSTATUS(status);
}

inline int exit_code_of(const Words& arguments, const std::filesystem::path& folder,
                        const std::filesystem::path& out, const std::filesystem::path& err) {
  return exit_code_of(start(arguments, folder, out, err));
}

/// While it lives, neither this process nor those it starts can write files larger than so many
/// bytes: to them the disk is full there.
class SmallFilesOnly {
 public:
  explicit SmallFilesOnly(rlim_t bytes) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    handler_ = std::signal(SIGXFSZ, SIG_IGN);  // of this test, not of the program
    EXPECT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  }
  ~SmallFilesOnly() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallFilesOnly(const SmallFilesOnly&) = delete;
  SmallFilesOnly& operator=(const SmallFilesOnly&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int) = SIG_DFL;
};

/// A fresh working folder for one test, removed afterwards.
class CommandLine : public testing::Test {
 protected:
  CommandLine()
      : root_(std::filesystem::path(testing::TempDir()) /
              ("phytobench_cli_" + std::to_string(::getpid()))) {
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(folder());
  }
  ~CommandLine() override {
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
  }

  /// The folder commands run in; their output is kept beside it.
  std::filesystem::path folder() const { return root_ / "work"; }

  /// run() with arguments separated by single spaces.
  Outcome run_line(const std::string& arguments) const {
    Words words;
    std::istringstream stream(arguments);
    for (std::string word; stream >> word;) words.push_back(word);
    return run(words);
  }

  /// Wrong input: exit code 2, one line that holds `part`, and nothing on standard output.
  void expect_refused_line(const std::string& arguments, const std::string& part) const {
    const Outcome outcome = run_line(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
    EXPECT_THAT(outcome.err, testing::HasSubstr(part)) << arguments;
    EXPECT_EQ(line_count(outcome.err), 1) << outcome.err;
  }

  Outcome run(const Words& arguments) const {
    Outcome outcome;
    outcome.code = exit_code_of(arguments, folder(), root_ / "out", root_ / "err");
    outcome.out = content_of(root_ / "out");
    outcome.err = content_of(root_ / "err");
    return outcome;
  }

  /// The same with standard output on a full disk.
  Outcome run_on_full_disk(const Words& arguments) const {
    Outcome outcome;
    outcome.code = exit_code_of(arguments, folder(), "/dev/full", root_ / "err");
    outcome.err = content_of(root_ / "err");
    return outcome;
  }

  /// The same with Ctrl-C after so many milliseconds; code -1 if that killed it.
  Outcome run_and_interrupt(const Words& arguments, int milliseconds) const {
    Outcome outcome;
    const pid_t child = start(arguments, folder(), root_ / "out", root_ / "err");
    ::usleep(static_cast<useconds_t>(1000 * milliseconds));
    if (child != 0) ::kill(child, SIGINT);
    outcome.code = exit_code_of(child);
    outcome.out = content_of(root_ / "out");
    outcome.err = content_of(root_ / "err");
    return outcome;
  }

  /// The same, later and later until Ctrl-C is heard (code 130): how long a program takes to start
  /// nobody knows, and before that the signal just kills it. `after_each` looks at what is left.
  Outcome interrupt(const Words& slow, const std::function<void()>& after_each = {}) const {
    Outcome outcome;
    for (int milliseconds = 100; outcome.code != 130 && milliseconds < 10'000; milliseconds *= 2) {
      outcome = run_and_interrupt(slow, milliseconds);
      EXPECT_NE(outcome.code, 0) << "it was done before";
      if (after_each) after_each();
    }
    EXPECT_EQ(outcome.code, 130) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(line_count(outcome.err), 1) << outcome.err;
    return outcome;
  }

  /// Standard output of a command that must succeed in silence.
  std::string output_of(const Words& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return outcome.out;
  }

  nlohmann::json json_of(const Words& arguments, const std::string& schema) const {
    const nlohmann::json document = nlohmann::json::parse(output_of(arguments), nullptr, false);
    EXPECT_TRUE(document.is_object()) << "standard output is not one JSON document";
    if (document.is_object()) EXPECT_EQ(text_at(document, "schema"), schema);
    return document;
  }

  /// A refusal is one line on standard error that names the trouble, and nothing else.
  void expect_refused(const Words& arguments, int code, const std::string& named) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.code, code);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(line_count(outcome.err), 1) << outcome.err;
    EXPECT_THAT(outcome.err, testing::StartsWith("phytobench: "));
    EXPECT_THAT(outcome.err, testing::HasSubstr(named));
  }

  void write(const std::filesystem::path& name, const std::string& content) const {
    std::filesystem::create_directories((folder() / name).parent_path());
    std::ofstream stream(folder() / name, std::ios::binary);
    stream << content;
    ASSERT_TRUE(stream.flush().good()) << name;
  }

  /// The same, and where it is.
  std::string file(const std::string& name, const std::string& content) const {
    write(name, content);
    return (folder() / name).string();
  }
  std::string read(const std::filesystem::path& name) const { return content_of(folder() / name); }
  bool exists(const std::filesystem::path& name) const {
    return std::filesystem::exists(folder() / name);
  }

  /// Names of what a command has left in its folder.
  std::set<std::string> left_behind() const {
    std::set<std::string> names;
    for (const std::filesystem::directory_entry& entry :
         std::filesystem::directory_iterator(folder()))
      names.insert(entry.path().filename().string());
    return names;
  }

 private:
  std::filesystem::path root_;
};

}  // namespace phytobench
