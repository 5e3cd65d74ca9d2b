// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/worker_client.hpp"

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

/// What arguments and environment of every worker take together. Longer ones are made a multiple.
constexpr std::size_t block_bytes = 8192;

std::string inherited(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Bytes that the system copies to the stack of the new process: the program's name once more than
/// the arguments, and each text with its end.
std::size_t size_of(const ChildOptions& call) {
  std::size_t bytes = call.command.front().size() + 1;
  for (const std::string& word : call.command) bytes += word.size() + 1;
  for (const auto& [name, value] : call.environment) bytes += name.size() + value->size() + 2;
  return bytes;
}

/// Neither its work nor its own failure ended it.
bool has_died(const ChildResult& result) {
  return result.timed_out || result.signal != 0;
}

std::string death_of(const ChildResult& result, double limit_s) {
  return "its worker " + ending_of(result, limit_s);
}

/// Throws InputError unless exactly the benchmarks that were asked for are answered, in any order;
/// they are brought into the order asked for.
template <class Answer>
std::vector<Answer> in_order(std::vector<Answer> answers, const std::vector<std::string>& names,
                             const std::string& whose) {
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto start = answers.begin() + static_cast<std::ptrdiff_t>(std::min(i, answers.size()));
    const auto found = std::find_if(start, answers.end(),
                                    [&](const Answer& answer) { return answer.name == names[i]; });
    if (found == answers.end())
      throw InputError(fmt::format("{}: did not answer for '{}'; build again", whose, names[i]));
    std::iter_swap(start, found);
  }
  if (!names.empty() && answers.size() != names.size())
    throw InputError(fmt::format("{}: answered for '{}' unasked; build again", whose,
                                 answers[names.size()].name));
  return answers;
}

}  // namespace

ChildOptions worker_call(const Side& side, const std::string& verb,
                         const std::vector<std::string>& arguments) {
  PHYTOBENCH_EXPECT(!side.worker.empty());
  ChildOptions call{.command = {side.worker.string(), verb},
                    .environment = {{"LC_ALL", "C"},
                                    {"PATH", inherited("PATH")},
                                    {"LD_LIBRARY_PATH", inherited("LD_LIBRARY_PATH")},
                                    {"PHYTOBENCH_DATA", side.data_folder.string()},
                                    {"PHYTOBENCH_PADDING", ""}},
                    .inherited = InheritedEnvironment::nothing};
  call.command.insert(call.command.end(), side.worker_options.begin(), side.worker_options.end());
  call.command.insert(call.command.end(), arguments.begin(), arguments.end());
  call.environment.back().second->assign(block_bytes - size_of(call) % block_bytes, 'x');
  return call;
}

WorkerClient::WorkerClient(Side side, WorkerClientOptions options)
    : side_(std::move(side)), options_(std::move(options)) {
  PHYTOBENCH_EXPECT(!side_.worker.empty());
}

ChildResult WorkerClient::run(ChildOptions call, double limit_s) const {
  call.limit_s = limit_s;
  call.is_interrupted = options_.is_interrupted;
  return run_child(call);
}

ChildResult WorkerClient::run_timed(ChildOptions call, double limit_s) const {
  call.processor = options_.processor;
  return run(std::move(call), limit_s);
}

std::string WorkerClient::answer_of(const ChildResult& result, const std::string& verb,
                                    double limit_s) const {
  if (result.is_ok()) return result.out;
  constexpr std::string_view prefix = "phytobench_worker: ";
  std::string said = last_line(result.err);
  if (said.starts_with(prefix)) said.erase(0, prefix.size());
  if (result.exit_code == 2) throw InputError(fmt::format("{}: {}", title_of(side_), said));
  if (result.exit_code == 4) throw NothingSelected(fmt::format("{}: {}", title_of(side_), said));
  throw EnvironmentError(fmt::format("{}: its worker, asked to {}, {}{}{}", title_of(side_), verb,
                                     ending_of(result, limit_s), said.empty() ? "" : ": ", said));
}

WorkerDescription WorkerClient::describe() const {
  const ChildResult result = run(worker_call(side_, "list", {}), options_.verify_limit_s);
  return worker_description_from(answer_of(result, "list", options_.verify_limit_s),
                                 title_of(side_));
}

std::vector<std::string> WorkerClient::names() {
  std::vector<std::string> names;
  for (const WorkerDescription::Benchmark& benchmark : describe().benchmarks)
    names.push_back(benchmark.name);
  return names;
}

std::vector<VerifiedBenchmark> WorkerClient::judge(const std::string& verb,
                                                   const std::vector<std::string>& names) const {
  const ChildResult result = run(worker_call(side_, verb, names), options_.verify_limit_s);
  if (!has_died(result) || names.empty())
    return in_order(
        verified_from(answer_of(result, verb, options_.verify_limit_s), title_of(side_)), names,
        title_of(side_));
  if (names.size() == 1)
    return {{.name = names.front(), .objection = death_of(result, options_.verify_limit_s)}};
  std::vector<VerifiedBenchmark> all;
  for (const std::string& name : names) all.push_back(judge(verb, {name}).front());
  return all;
}

std::vector<VerifiedBenchmark> WorkerClient::verify(const std::vector<std::string>& names_asked) {
  return judge("verify", names_asked.empty() ? names() : names_asked);
}

std::vector<VerifiedBenchmark> WorkerClient::counters(const std::vector<std::string>& names_asked) {
  return judge("counters", names_asked.empty() ? names() : names_asked);
}

std::vector<CalibratedBenchmark> WorkerClient::calibrate(const std::vector<std::string>& names,
                                                         double sample_ms) {
  std::vector<std::string> arguments = {"--sample-ms", fmt::format("{}", sample_ms)};
  arguments.insert(arguments.end(), names.begin(), names.end());
  const double limit_s = options_.sample_limit_s;
  const ChildResult result = run_timed(worker_call(side_, "calibrate", arguments), limit_s);
  if (has_died(result) && names.size() == 1)
    throw EnvironmentError(fmt::format("{}: {} while '{}' was calibrated", title_of(side_),
                                       death_of(result, limit_s), names.front()));
  return in_order(calibrated_from(answer_of(result, "calibrate", limit_s), title_of(side_)), names,
                  title_of(side_));
}

std::vector<SampledBenchmark> WorkerClient::sample(const SamplePlan& plan) {
  if (plan.benchmarks.empty()) return {};
  const double planned_s =
      1e-3 * options_.sample_ms * plan.samples * static_cast<double>(plan.benchmarks.size());
  const double limit_s = options_.sample_limit_s + 10.0 * planned_s;
  ChildOptions call = worker_call(side_, "sample", {});
  call.input = to_json(plan);
  const ChildResult result = run_timed(std::move(call), limit_s);
  std::vector<std::string> names;
  for (const SamplePlan::Benchmark& benchmark : plan.benchmarks) names.push_back(benchmark.name);
  if (!has_died(result))
    return in_order(sampled_from(answer_of(result, "sample", limit_s), title_of(side_)), names,
                    title_of(side_));
  if (names.size() == 1) return {{.name = names.front(), .objection = death_of(result, limit_s)}};
  std::vector<SampledBenchmark> all;
  for (const SamplePlan::Benchmark& benchmark : plan.benchmarks) {
    const SamplePlan alone{.seed = plan.seed, .samples = plan.samples, .benchmarks = {benchmark}};
    all.push_back(sample(alone).front());
  }
  return all;
}

}  // namespace phytobench
