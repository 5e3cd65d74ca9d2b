// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/counter_gate.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/comparison/result_document.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/parameter_keys.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;
using Kind = CounterChangeKind;

constexpr const char* counters_schema = "phytobench/counters-1";

[[noreturn]] void refuse(const std::string& file, const std::string& problem) {
  throw InputError(fmt::format(
      "{}: {}; write it with phytobench bench counters --accept, or take back what changed it",
      file, problem));
}

bool is_digest(const ordered_json& value) {
  if (!value.is_string()) return false;
  const std::string& text = value.get_ref<const std::string&>();
  return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

CountedBenchmark benchmark_from(const ordered_json& json, const std::string& name,
                                const std::string& file) {
  if (!json.is_object() || !json.contains("inputs") || !is_digest(json["inputs"]))
    refuse(file, fmt::format("'{}' has no \"inputs\" of 64 digits", in_one_line(name)));
  if (!json.contains("counters") || !json["counters"].is_object() || json["counters"].empty())
    refuse(file, fmt::format("'{}' has no \"counters\"", in_one_line(name)));
  CountedBenchmark benchmark{.inputs = json["inputs"], .counters = {}};
  for (const auto& [counter, value] : json["counters"].items()) {
    if (!value.is_number_unsigned())
      refuse(file, fmt::format("{} of '{}' is no whole number >= 0", in_one_line(counter),
                               in_one_line(name)));
    benchmark.counters[counter] = value.get<std::uint64_t>();
  }
  return benchmark;
}

SideOrigin origin_in(const ordered_json& json, const std::string& file) {
  try {
    return origin_from(json);
  } catch (const ordered_json::exception& error) {
    refuse(file, fmt::format("its \"origin\" is damaged ({})", error.what()));
  }
}

std::string source_of(const SideOrigin& origin) {
  if (origin.commit.empty()) return "an unknown commit";
  return fmt::format("commit {}{}", origin.commit, origin.changed ? " with changes" : "");
}

/// Changes of the counters that both or one of them has.
void compare_counters(const std::string& benchmark, const WorkCounts& before,
                      const WorkCounts& after, std::vector<CounterChange>& changes) {
  std::map<std::string, std::pair<const std::uint64_t*, const std::uint64_t*>> all;
  for (const auto& [counter, value] : before) all[counter].first = &value;
  for (const auto& [counter, value] : after) all[counter].second = &value;
  for (const auto& [counter, values] : all) {
    const auto [old_value, new_value] = values;
    if (new_value == nullptr)
      changes.push_back({Kind::counter_gone, benchmark, counter, *old_value, 0});
    else if (old_value == nullptr)
      changes.push_back({Kind::counter_appeared, benchmark, counter, 0, *new_value});
    else if (*old_value != *new_value)
      changes.push_back({Kind::other_value, benchmark, counter, *old_value, *new_value});
  }
}

/// "(+5.0 %)": with as many decimals as it takes to show that it is not zero.
std::string percent_text(const CounterChange& change) {
  if (change.before == 0) return "(there was none)";
  const double percent = 100.0 *
                         (static_cast<double>(change.after) - static_cast<double>(change.before)) /
                         static_cast<double>(change.before);
  return std::abs(percent) >= 0.05 ? fmt::format("({:+.1f} %)", percent)
                                   : fmt::format("({:+.1g} %)", percent);
}

}  // namespace

std::vector<std::string> wrong_answers(const std::vector<VerifiedBenchmark>& verified) {
  std::vector<std::string> texts;
  for (const VerifiedBenchmark& one : verified)
    if (!one.objection.empty()) texts.push_back(fmt::format("{}: {}", one.name, one.objection));
  return texts;
}

CounterBaseline counted(const std::vector<VerifiedBenchmark>& verified, const std::string& whose) {
  CounterBaseline found;
  for (const VerifiedBenchmark& one : verified) {
    PHYTOBENCH_EXPECT(one.objection.empty());
    if (one.work.empty()) throw InputError(fmt::format("{}: {} counts no work", whose, one.name));
    if (!found.try_emplace(one.name, CountedBenchmark{one.inputs, one.work}).second)
      throw InputError(fmt::format("{}: answered twice for {}", whose, one.name));
  }
  return found;
}

std::vector<CounterChange> counter_changes(const CounterBaseline& before,
                                           const CounterBaseline& after) {
  std::map<std::string, std::pair<const CountedBenchmark*, const CountedBenchmark*>> all;
  for (const auto& [name, benchmark] : before) all[name].first = &benchmark;
  for (const auto& [name, benchmark] : after) all[name].second = &benchmark;
  std::vector<CounterChange> changes;
  for (const auto& [name, sides] : all) {
    const auto [old_one, new_one] = sides;
    if (new_one == nullptr) {
      changes.push_back({.kind = Kind::benchmark_gone, .benchmark = name});
    } else if (old_one == nullptr) {
      changes.push_back({.kind = Kind::benchmark_appeared, .benchmark = name});
    } else {
      if (old_one->inputs != new_one->inputs)
        changes.push_back({.kind = Kind::inputs_changed, .benchmark = name});
      compare_counters(name, old_one->counters, new_one->counters, changes);
    }
  }
  return changes;
}

std::string text_of(const CounterChange& change) {
  switch (change.kind) {
    case Kind::other_value:
      return fmt::format("{} {} {} -> {} {}", change.benchmark, change.counter,
                         with_thousands(change.before), with_thousands(change.after),
                         percent_text(change));
    case Kind::counter_appeared:
      return fmt::format("{} {} is new: {}", change.benchmark, change.counter,
                         with_thousands(change.after));
    case Kind::counter_gone:
      return fmt::format("{} {} is gone; it was {}", change.benchmark, change.counter,
                         with_thousands(change.before));
    case Kind::inputs_changed:
      return fmt::format("{} has other inputs: its counters are those of other work",
                         change.benchmark);
    case Kind::benchmark_appeared:
      return fmt::format("{} is new", change.benchmark);
    case Kind::benchmark_gone:
      return fmt::format("{} is gone", change.benchmark);
  }
  return "";
}

std::string with_thousands(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t end = text.size(); end > 3; end -= 3) text.insert(end - 3, 1, ',');
  return text;
}

std::string to_json(const CounterBaseline& baseline) {
  return to_json(CounterDocument{.origin = std::nullopt, .benchmarks = baseline});
}

std::string to_json(const CounterDocument& document) {
  ordered_json json;
  json["schema"] = counters_schema;
  if (document.origin) json["origin"] = origin_json(*document.origin);
  json["benchmarks"] = ordered_json::object();
  for (const auto& [name, benchmark] : document.benchmarks) {
    ordered_json& entry = json["benchmarks"][name];
    entry["inputs"] = benchmark.inputs;
    entry["counters"] = benchmark.counters;
  }
  // A path in the origin need not be UTF-8.
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

CounterBaseline counter_baseline_from(const std::string& text, const std::string& file) {
  return counter_document_from(text, file).benchmarks;
}

CounterDocument counter_document_from(const std::string& text, const std::string& file) {
  const ordered_json json = ordered_json::parse(text, nullptr, false);
  if (json.is_discarded()) refuse(file, "is not JSON, or breaks off");
  if (!json.is_object() || !json.contains("schema") || json["schema"] != counters_schema)
    refuse(file, fmt::format("its schema is not {}", counters_schema));
  if (!json.contains("benchmarks") || !json["benchmarks"].is_object())
    refuse(file, "has no \"benchmarks\"");
  CounterDocument document;
  if (json.contains("origin")) document.origin = origin_in(json["origin"], file);
  for (const auto& [name, benchmark] : json["benchmarks"].items())
    document.benchmarks[name] = benchmark_from(benchmark, name, file);
  if (to_json(document) != text)
    refuse(file,
           "is not as the program writes it (something twice, more than it knows, or in "
           "another order)");
  return document;
}

void refuse_stale_worker(const SideOrigin& worker, const SideOrigin& program) {
  if (worker.commit == program.commit && worker.changed == program.changed) return;
  throw InputError(
      fmt::format("{}: the worker there was built from {}, this program from {}; build both of the "
                  "same sources (cmake --build --preset counters --target phytobench_worker), or "
                  "name a worker with --worker",
                  worker.given, source_of(worker), source_of(program)));
}

}  // namespace phytobench
