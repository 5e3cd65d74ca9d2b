// SPDX-License-Identifier: MIT
// For tests of phytobench compete: a stand in which everything happens, and runs that are broken
// off.
#pragma once

#include <map>
#include <sstream>

#include "cli/command_line_fixture.hpp"

namespace phytobench {

/// Plants that bear seeds, rest, starve, fall ill and are taken out.
inline constexpr const char* lively = R"(seed = 3
steps = 40
[ground]
size = [60.0, 50.0]
corner = [-10.0, 5.0]
[competition]
rule = "combined"
[mortality]
rule = "mean-relative-growth"
threshold = 0.004
[seasons]
bad_year_share = 0.2
[illness]
duration = 10
is_deadly = true
[[species]]
name = "annual"
count = 80
largest_age = 30
largest_radius = 0.2
growth_rate = 0.03
[species.reproduction]
threshold = 0.08
seeds_per_metre = 8.0
dispersal_distance = 6.0
seed_mortality = 0.1
dormant_share = 0.4
germination_rate = 0.3
seedling_radius = 0.02
[[species]]
name = "shrub"
count = 60
[[event]]
kind = "disease"
step = 5
share = 0.3
[[event]]
kind = "removal"
step = 12
species = "shrub"
largest = 2
)";

class CompeteCommand : public CommandLine {
 protected:
  CompeteCommand() { write("lively.toml", lively); }

  void expect_done(const std::string& arguments) const {
    const Outcome outcome = run_line("compete " + arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
  }

  nlohmann::json document(const std::string& arguments) const {
    const Outcome outcome = run_line("compete --json " + arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const nlohmann::json result = nlohmann::json::parse(outcome.out, nullptr, false);
    EXPECT_EQ(text_at(result, "schema"), "phytobench/compete-1");
    return result;
  }

  /// Every file below a folder, by its name seen from there.
  std::map<std::string, std::string> files_below(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const std::filesystem::directory_entry& entry :
         std::filesystem::recursive_directory_iterator(folder() / name))
      if (entry.is_regular_file())
        files[std::filesystem::relative(entry.path(), folder() / name).string()] =
            content_of(entry.path());
    return files;
  }

  void expect_same_files(const std::string& a, const std::string& b) const {
    const auto first = files_below(a), second = files_below(b);
    for (const auto& [name, content] : first) {
      ASSERT_TRUE(second.contains(name)) << name;
      EXPECT_TRUE(second.at(name) == content) << name << " differs";
    }
    EXPECT_EQ(first.size(), second.size());
  }

  /// Starts a run and sends it a signal so many milliseconds after the file is there. The code is
  /// -1 if that killed it; 0 if it was done before.
  Outcome run_and_signal(int signal, const std::string& arguments, const std::string& file,
                         int milliseconds) const {
    Words words;
    std::istringstream stream("compete " + arguments);
    for (std::string word; stream >> word;) words.push_back(word);
    const std::filesystem::path out = folder() / "stdout", err = folder() / "stderr";
    const pid_t child = start(words, folder(), out, err);
    if (child == 0) return {};  // a signal to 0 would reach the tests themselves
    siginfo_t ended{};
    while (!exists(file) && ended.si_pid == 0) {
      ::usleep(500);
      ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    }
    ::usleep(static_cast<useconds_t>(1000 * milliseconds));
    ::kill(child, signal);
    const int code = exit_code_of(child);
    const Outcome outcome{code, content_of(out), content_of(err)};
    std::filesystem::remove(out);
    std::filesystem::remove(err);
    return outcome;
  }
};

}  // namespace phytobench
