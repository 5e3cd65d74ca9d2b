// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/instruction_counts.hpp"

#include <sys/personality.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <map>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/comparison/child_process.hpp"
#include "benchmarks/comparison/found_program.hpp"
#include "benchmarks/comparison/plain_text.hpp"
#include "benchmarks/regression/worker_protocol.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

std::vector<std::string> words_of(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::uint64_t count_from(const std::string& word, const std::string& whose) {
  std::uint64_t count = 0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, count);
  if (error != std::errc() || stop != end)
    throw InputError(fmt::format("{}: '{}' among the totals is no count", whose, one_line(word)));
  return count;
}

/// Words behind "key:" of the only line that begins so.
std::vector<std::string> only_line(const std::string& text, const std::string& key,
                                   const std::string& whose) {
  std::optional<std::vector<std::string>> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(key)) continue;
    if (found) throw InputError(fmt::format("{}: has '{}' twice; one count is needed", whose, key));
    found = words_of(line.substr(key.size()));
  }
  if (!found)
    throw InputError(
        fmt::format("{}: no line '{}': it breaks off, or Callgrind did not write it", whose, key));
  return *found;
}

/// A temporary folder whose name is as long for every build, with the worker and its data in it.
class CountingFolder {
 public:
  explicit CountingFolder(const CountRequest& request) {
    std::string name = (fs::temp_directory_path() / "phytobench-count-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr)
      throw EnvironmentError(fmt::format("no temporary folder {}: {}", name, std::strerror(errno)));
    path_ = name;
    // A copy: through a link a program still finds out its own path, whose length moves its heap.
    fs::copy_file(fs::absolute(request.worker), worker());
    if (request.data.empty()) return;
    has_data_ = true;
    fs::create_directory_symlink(fs::absolute(request.data), path_ / "share");
  }
  ~CountingFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  CountingFolder(const CountingFolder&) = delete;
  CountingFolder& operator=(const CountingFolder&) = delete;

  const fs::path& path() const { return path_; }
  fs::path worker() const { return path_ / "worker"; }
  fs::path counts() const { return path_ / "callgrind.out"; }

  /// All that the program sees. Valgrind reads options from the home and the current folder and
  /// from variables: there are none.
  std::vector<EnvironmentChange> environment() const {
    std::vector<EnvironmentChange> variables = {
        {"PATH", "/usr/bin:/bin"}, {"LC_ALL", "C"}, {"HOME", path_.string()}};
    if (has_data_) variables.emplace_back("PHYTOBENCH_DATA", (path_ / "share").string());
    // Where parts of Valgrind and libraries are, if they are in no usual place: equal on both
    // sides.
    for (const char* name : {"VALGRIND_LIB", "LD_LIBRARY_PATH"})
      if (const char* value = std::getenv(name)) variables.emplace_back(name, value);
    return variables;
  }

 private:
  fs::path path_;
  bool has_data_ = false;
};

/// While it lives, programs started by this thread get no random addresses. Where a container
/// forbids it, Valgrind's own placement of the program, which is fixed, has to do.
class FixedAddresses {
 public:
  FixedAddresses() : before_(::personality(0xffffffff)) {
    if (before_ >= 0)
      ::personality(static_cast<unsigned long>(before_) |
                    static_cast<unsigned long>(ADDR_NO_RANDOMIZE));
  }
  ~FixedAddresses() {
    if (before_ >= 0) ::personality(static_cast<unsigned long>(before_));
  }
  FixedAddresses(const FixedAddresses&) = delete;
  FixedAddresses& operator=(const FixedAddresses&) = delete;

 private:
  int before_;
};

std::vector<std::string> command_of(const CountRequest& request, const CountingFolder& folder) {
  std::vector<std::string> command = {"valgrind", "--tool=callgrind", "--instr-atstart=no",
                                      "--callgrind-out-file=" + folder.counts().string(),
                                      "--vgdb=no"};
  if (request.simulate_cache)
    for (const char* option :
         {"--cache-sim=yes", "--I1=32768,8,64", "--D1=32768,8,64", "--LL=8388608,16,64"})
      command.emplace_back(option);
  command.insert(command.end(), {folder.worker().string(), "once", request.benchmark});
  return command;
}

/// The line that begins so; empty if there is none.
std::string line_with(const std::string& text, const std::string& beginning) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(beginning)) return one_line(line);
  return "";
}

InstructionCount not_counted(CountOutcome outcome, const std::string& reason) {
  return {.outcome = outcome, .reason = reason, .totals = {}, .inputs = "", .answer = ""};
}

/// Why there is no count, if the run has not ended well.
InstructionCount explained(const ChildResult& result, const CountRequest& request) {
  if (result.signal == SIGILL || result.err.find("nrecognised instruction") != std::string::npos)
    return not_counted(CountOutcome::unsupported,
                       "Valgrind does not know an instruction of this build; build for x86-64-v3");
  if (const std::string line = line_with(result.err, "valgrind: "); !line.empty())
    return not_counted(CountOutcome::unsupported, line);
  const std::string said = line_with(result.err, "phytobench_worker: ");
  if (result.exit_code == 3 && said.find("callgrind") != std::string::npos)
    return not_counted(CountOutcome::unsupported, said);
  const std::string ending = "the worker " + ending_of(result, request.limit_s);
  return not_counted(CountOutcome::failed, said.empty() ? ending : ending + ": " + said);
}

InstructionCount counted_run(const ChildResult& result, const CountRequest& request,
                             const CountingFolder& folder) {
  const std::string whose = "the count of " + request.benchmark;
  const std::vector<VerifiedBenchmark> answers = verified_from(result.out, whose);
  if (answers.size() != 1 || answers.front().name != request.benchmark)
    throw InputError(whose + ": the worker ran something else");
  const CallgrindTotals totals = callgrind_totals_from(read_text_file(folder.counts()), whose);
  if (totals.instructions == 0)
    throw InputError(whose + ": no instruction was counted: the worker marks no region");
  return {.outcome = CountOutcome::counted,
          .reason = "",
          .totals = totals,
          .inputs = answers.front().inputs,
          .answer = answers.front().answer};
}

}  // namespace

CallgrindTotals callgrind_totals_from(const std::string& text, const std::string& whose) {
  const std::vector<std::string> events = only_line(text, "events:", whose);
  const std::vector<std::string> values = only_line(text, "totals:", whose);
  if (values.empty() || values.size() > events.size())
    throw InputError(
        fmt::format("{}: {} totals of {} kinds of events", whose, values.size(), events.size()));
  std::map<std::string, std::uint64_t> counts;  // zeros at the end may be left out
  for (std::size_t i = 0; i < events.size(); ++i)
    counts[events[i]] = i < values.size() ? count_from(values[i], whose) : 0;
  if (!counts.contains("Ir")) throw InputError(whose + ": counts no instructions (Ir)");
  CallgrindTotals totals{.instructions = counts["Ir"], .misses = std::nullopt};
  if (counts.contains("D1mr"))
    totals.misses = CacheMisses{.first_level_data = counts["D1mr"] + counts["D1mw"],
                                .last_level = counts["ILmr"] + counts["DLmr"] + counts["DLmw"]};
  return totals;
}

InstructionCount count_instructions(const CountRequest& request) {
  if (!found_program("valgrind"))
    return not_counted(CountOutcome::unsupported,
                       "valgrind is not installed; install the package of that name");
  const CountingFolder folder(request);
  const FixedAddresses fixed;
  const ChildResult result = run_child({.command = command_of(request, folder),
                                        .folder = folder.path(),
                                        .environment = folder.environment(),
                                        .inherited = InheritedEnvironment::nothing,
                                        .limit_s = request.limit_s,
                                        .is_interrupted = request.is_interrupted});
  if (!result.is_ok()) return explained(result, request);
  try {
    return counted_run(result, request, folder);
  } catch (const InputError& error) {
    return not_counted(CountOutcome::failed, one_line(error.what()));
  }
}

}  // namespace phytobench
