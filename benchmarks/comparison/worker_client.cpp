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

constexpr std::string_view own_words = "phytobench_worker: ";

/// Where a worker judges or sizes a benchmark, it runs twice, and its oracle takes time as well.
constexpr std::size_t answers_without_samples = 3;

/// What the worker, or whatever ended it, has said last; empty if nothing.
std::string said_last(const ChildResult& result) {
  std::string said = last_line(result.err);
  if (said.starts_with(own_words)) said.erase(0, own_words.size());
  return said;
}

/// Whether the worker itself says no. A plugin that ends the program uses no such words.
bool is_refusal(const ChildResult& result) {
  return !result.timed_out && (result.exit_code == 2 || result.exit_code == 4) &&
         last_line(result.err).starts_with(own_words);
}

/// "ended with exit code 3: disk full".
std::string ending_in_words(const ChildResult& result, double limit_s) {
  const std::string said = said_last(result);
  return ending_of(result, limit_s) + (result.is_ok() ? " without an answer" : "") +
         (said.empty() ? "" : ": " + said);
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
  if (result.is_ok() && !result.out.empty()) return result.out;
  if (is_refusal(result)) {
    const std::string refusal = fmt::format("{}: {}", title_of(side_), said_last(result));
    if (result.exit_code == 4) throw NothingSelected(refusal);
    throw InputError(refusal);
  }
  const std::string ending = ending_in_words(result, limit_s);
  throw WorkerDied(fmt::format("{}: its worker, asked to {}, {}", title_of(side_), verb, ending),
                   {.reason = "its worker " + ending, .was_stopped = result.timed_out});
}

double WorkerClient::limit_of(std::size_t answers, double otherwise) const {
  return options_.answer_limit_s ? *options_.answer_limit_s * static_cast<double>(answers)
                                 : otherwise;
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
  const double limit_s = limit_of(answers_without_samples * std::max<std::size_t>(names.size(), 1),
                                  options_.verify_limit_s);
  const ChildResult result = run(worker_call(side_, verb, names), limit_s);
  try {
    return in_order(verified_from(answer_of(result, verb, limit_s), title_of(side_)), names,
                    title_of(side_));
  } catch (const WorkerDied& died) {
    if (names.empty()) throw;
    if (names.size() == 1) return {{.name = names.front(), .objection = died.death().reason}};
  }
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
  const double planned_s = 1e-3 * sample_ms * static_cast<double>(names.size());
  const double limit_s =
      limit_of(answers_without_samples * names.size(), options_.sample_limit_s) + 10.0 * planned_s;
  const ChildResult result = run_timed(worker_call(side_, "calibrate", arguments), limit_s);
  return in_order(calibrated_from(answer_of(result, "calibrate", limit_s), title_of(side_)), names,
                  title_of(side_));
}

std::vector<SampledBenchmark> WorkerClient::sample(const SamplePlan& plan) {
  if (plan.benchmarks.empty()) return {};
  const double planned_s =
      1e-3 * options_.sample_ms * plan.samples * static_cast<double>(plan.benchmarks.size());
  // A sample is at least one run, and one goes before the first.
  const std::size_t answers = (static_cast<std::size_t>(plan.samples) + 1) * plan.benchmarks.size();
  const double limit_s = limit_of(answers, options_.sample_limit_s) + 10.0 * planned_s;
  ChildOptions call = worker_call(side_, "sample", {});
  call.input = to_json(plan);
  const ChildResult result = run_timed(std::move(call), limit_s);
  std::vector<std::string> names;
  for (const SamplePlan::Benchmark& benchmark : plan.benchmarks) names.push_back(benchmark.name);
  return in_order(sampled_from(answer_of(result, "sample", limit_s), title_of(side_)), names,
                  title_of(side_));
}

}  // namespace phytobench
