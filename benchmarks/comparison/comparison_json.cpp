// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/comparison_json.hpp"

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "benchmarks/comparison/result_document.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

using nlohmann::ordered_json;

namespace {

/// "same binary" as a key.
std::string key_of(SpeedVerdict verdict) {
  std::string key(name_of(verdict));
  for (char& c : key)
    if (c == ' ') c = '_';
  return key;
}

ordered_json estimate_json(const std::optional<Estimate>& estimate) {
  if (!estimate) return nullptr;
  return {{"value", estimate->value}, {"low", estimate->low}, {"high", estimate->high}};
}

/// Samples of one benchmark by block.
using SamplesOfBlock = std::map<int, std::vector<const ProcessSamples*>>;

struct SamplesOfBenchmark {
  SamplesOfBlock control;
  SamplesOfBlock comparison;
};

std::map<std::string, SamplesOfBenchmark> samples_by_benchmark(const PairTiming& timing) {
  std::map<std::string, SamplesOfBenchmark> all;
  for (const ProcessSamples& process : timing.samples) {
    SamplesOfBenchmark& own = all[process.benchmark];
    (process.is_control ? own.control : own.comparison)[process.block].push_back(&process);
  }
  return all;
}

ordered_json process_json(const ProcessSamples& process) {
  ordered_json json{{"side", process.is_second && !process.is_control ? "new" : "base"},
                    {"involuntary_switches", process.sampled.involuntary_switches},
                    {"samples", ordered_json::array()}};
  for (const TimedSample& sample : process.sampled.samples)
    json["samples"].push_back(
        ordered_json::array({sample.iterations, sample.cpu_s, sample.wall_s}));
  return json;
}

ordered_json blocks_json(const std::vector<BlockTimes>& blocks, const SamplesOfBlock& samples) {
  ordered_json json = ordered_json::array();
  for (const BlockTimes& block : blocks) {
    ordered_json one{{"block", block.block},
                     {"order", block.order},
                     {"redone", block.redone},
                     {"log_ratio", block.log_ratio()},
                     {"base_s", block.base},
                     {"new_s", block.other},
                     {"processes", ordered_json::array()}};
    const auto found = samples.find(block.block);
    if (found != samples.end())
      for (const ProcessSamples* process : found->second)
        one["processes"].push_back(process_json(*process));
    json.push_back(std::move(one));
  }
  return json;
}

ordered_json benchmark_json(const ConcludedBenchmark& concluded, const MeasuredBenchmark& measured,
                            const SamplesOfBenchmark& samples) {
  return {{"name", concluded.name},
          {"verdict", name_of(concluded.verdict)},
          {"reason", concluded.reason},
          {"objection", measured.objection},
          {"same_work", measured.is_same_work},
          {"ratio", estimate_json(concluded.ratio)},
          {"control", estimate_json(concluded.control)},
          {"noise_floor", concluded.noise_floor},
          {"p", concluded.p},
          {"iterations", nullptr},
          {"blocks", blocks_json(measured.blocks, samples.comparison)},
          {"control_blocks", blocks_json(measured.control, samples.control)}};
}

ordered_json benchmarks_json(const ComparisonReport& report) {
  const auto samples = samples_by_benchmark(report.timing);
  std::map<std::string, std::uint64_t> iterations;
  for (const CalibratedBenchmark& calibrated : report.timing.calibrated)
    iterations[calibrated.name] = calibrated.iterations;
  ordered_json json = ordered_json::array();
  for (std::size_t i = 0; i < report.concluded.size(); ++i) {
    const std::string& name = report.concluded[i].name;
    const auto own = samples.find(name);
    json.push_back(benchmark_json(report.concluded[i], report.timing.measured.benchmarks[i],
                                  own == samples.end() ? SamplesOfBenchmark{} : own->second));
    const auto known = iterations.find(name);
    if (known != iterations.end()) json.back()["iterations"] = known->second;
  }
  return json;
}

ordered_json settings_json(const ComparisonReport& report) {
  const VerdictSettings& verdicts = report.verdict_settings;
  const TimingSettings& timing = report.timing_settings;
  return {{"tolerance", verdicts.tolerance},
          {"alpha", verdicts.alpha},
          {"noise_factor", verdicts.noise_factor},
          {"budget_s", timing.budget_s},
          {"least_blocks", timing.least_blocks},
          {"most_blocks", timing.most_blocks},
          {"samples", timing.samples},
          {"sample_ms", timing.sample_ms}};
}

ordered_json run_json(const PairTiming& timing) {
  return {{"seconds", timing.seconds},
          {"redone_blocks", timing.redone_blocks},
          {"busy_blocks", timing.busy_blocks},
          {"dead_blocks", timing.dead_blocks},
          {"interrupted", timing.was_interrupted}};
}

ordered_json counts_json(const ComparisonReport& report) {
  ordered_json json = ordered_json::object();
  for (const SpeedVerdict verdict : verdicts_by_weight())
    json[key_of(verdict)] = count_of(report, verdict);
  return json;
}

ordered_json trials_json(const std::vector<FailedTrial>& trials) {
  ordered_json json = ordered_json::array();
  for (const FailedTrial& failed : trials)
    json.push_back({{"side", failed.side},
                    {"given", failed.given},
                    {"verdict", failed.verdict},
                    {"detail", failed.detail}});
  return json;
}

ordered_json result_json(const std::optional<StoredResult>& result) {
  return result ? ordered_json::parse(to_json(*result)) : ordered_json(nullptr);
}

}  // namespace

std::string comparison_json(const ComparisonReport& report) {
  const Measured& measured = report.timing.measured;
  PHYTOBENCH_EXPECT(report.concluded.size() == measured.benchmarks.size());
  ordered_json json{{"schema", comparison_schema}, {"summary", summary_in_words(report)}};
  json["base"] = origin_json(measured.base);
  json["new"] = origin_json(measured.other);
  json["same_program"] = measured.is_same_program;
  json["seed"] = measured.seed;
  json["settings"] = settings_json(report);
  json["run"] = run_json(report.timing);
  json["counts"] = counts_json(report);
  json["differences"] = differences_of_sides(measured);
  json["advice"] = advice(report);
  json["notes"] = report.notes;
  json["failed_trials"] = trials_json(report.failed_trials);
  json["benchmarks"] = benchmarks_json(report);
  json["results"] = {{"base", result_json(report.base_result)},
                     {"new", result_json(report.other_result)}};
  json["environment"] = report.environment_json.empty()
                            ? ordered_json(nullptr)
                            : ordered_json::parse(report.environment_json);
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace phytobench
