// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/google_benchmark_result.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "benchmarks/comparison/paired_timing.hpp"
#include "benchmarks/comparison/result_document.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

using nlohmann::ordered_json;

namespace {

std::string caches_from(const ordered_json& context) {
  std::vector<std::string> caches;
  if (context.contains("caches"))
    for (const ordered_json& cache : context.at("caches"))
      caches.push_back(fmt::format(
          "L{} {} {} x {}", cache.at("level").get<int>(), cache.at("type").get<std::string>(),
          cache.at("size").get<std::int64_t>(), cache.value("num_sharing", 1)));
  return fmt::format("{}", fmt::join(caches, ", "));
}

ResultMachine machine_of(const ordered_json& context) {
  ResultMachine machine{.logical_processors = context.at("num_cpus"),
                        .caches = caches_from(context),
                        .mhz = context.value("mhz_per_cpu", 0.0),
                        .library_build = context.value("library_build_type", std::string())};
  const std::string executable =
      std::filesystem::path(context.value("executable", std::string())).filename().string();
  machine.text = fmt::format(
      "{} logical processors at {:.0f} MHz, caches {}, load {}, benchmark library built as {}, "
      "program {}",
      machine.logical_processors, machine.mhz, machine.caches.empty() ? "unknown" : machine.caches,
      context.contains("load_avg") ? context.at("load_avg").dump() : "unknown",
      machine.library_build.empty() ? "unknown" : machine.library_build,
      executable.empty() ? "unknown" : executable);
  return machine;
}

/// Versions before 1.4.1 do not say it, but end the names of aggregates in theirs.
bool is_aggregate(const ordered_json& entry, std::string_view name) {
  if (entry.contains("run_type")) return entry.at("run_type") != "iteration";
  for (const std::string_view ending : {"_mean", "_median", "_stddev", "_cv", "_BigO", "_RMS"})
    if (name.ends_with(ending)) return true;
  return false;
}

/// Of a curve through benchmarks of several sizes, and of none of them.
bool is_fitted(std::string_view name) {
  return name.ends_with("_BigO") || name.ends_with("_RMS");
}

/// "BM_fill/8" for the aggregate "BM_fill/8_mean".
std::string name_of_repetitions(const ordered_json& aggregate, const std::string& name) {
  return aggregate.value("run_name", name.substr(0, name.rfind('_')));
}

/// "BM_fill/real_time/threads:2" is measured by the clock.
bool is_by_clock(std::string_view name) {
  const std::size_t threads = name.rfind("/threads:");
  const std::string_view timed = name.substr(0, threads);
  return timed.ends_with("/real_time") || timed.ends_with("/manual_time");
}

double seconds_of_unit(const std::string& unit) {
  if (unit == "ns") return 1e-9;
  if (unit == "us") return 1e-6;
  if (unit == "ms") return 1e-3;
  if (unit == "s") return 1.0;
  throw InputError("'" + unit + "' is no unit of time; use ns, us, ms or s");
}

std::string objection_of(const ordered_json& entry) {
  if (entry.value("error_occurred", false))
    return "it says: " + entry.value("error_message", std::string("an error occurred"));
  if (entry.value("skipped", false))
    return "it was skipped: " + entry.value("skip_message", std::string("no reason is given"));
  return "";
}

double seconds_from(const ordered_json& entry, const std::string& name) {
  const ordered_json& time = entry.at(is_by_clock(name) ? "real_time" : "cpu_time");
  if (time.is_null()) return std::nan("");  // written as NaN, which is no JSON
  const auto in_unit = time.get<double>();
  return in_unit * seconds_of_unit(entry.at("time_unit"));
}

/// Gathers the repetitions of a name; "repeats" of a program that registers a name twice, too.
class RepetitionCollector {
 public:
  void add(const ordered_json& entry) {
    const std::string name = entry.at("name");
    if (is_aggregate(entry, name)) {
      if (!is_fitted(name)) found(name_of_repetitions(entry, name));
      return;
    }
    StoredBenchmark& benchmark = found(name);
    benchmark.is_aggregate_only = false;
    if (!benchmark.objection.empty()) return;
    benchmark.objection = objection_of(entry);
    if (benchmark.objection.empty()) {
      const double seconds = seconds_from(entry, name);
      if (seconds == 0.0)
        benchmark.objection = no_time_to_measure;
      else
        benchmark.processes.front().push_back(seconds);
    }
    if (!benchmark.objection.empty()) benchmark.processes.front().clear();
  }

  std::vector<StoredBenchmark> taken() { return std::move(benchmarks_); }

 private:
  StoredBenchmark& found(const std::string& name) {
    const auto [place, is_new] = places_.try_emplace(name, benchmarks_.size());
    if (is_new) benchmarks_.push_back({.name = name, .processes = {{}}, .is_aggregate_only = true});
    return benchmarks_[place->second];
  }

  std::vector<StoredBenchmark> benchmarks_;  ///< in the order of the file
  std::map<std::string, std::size_t> places_;
};

}  // namespace

bool is_google_benchmark_document(const ordered_json& document) {
  const auto context = document.find("context"), benchmarks = document.find("benchmarks");
  return context != document.end() && context->is_object() && benchmarks != document.end() &&
         benchmarks->is_array();
}

StoredResult google_benchmark_result_from(const std::string& json, const std::string& whose) {
  const ordered_json document = parsed_document(json, whose);
  StoredResult result{.origin = {.given = whose, .kind = "result"}};
  RepetitionCollector collector;
  std::size_t number = 0;
  try {
    result.machine = machine_of(document.at("context"));
    for (const ordered_json& entry : document.at("benchmarks")) {
      ++number;
      collector.add(entry);
    }
  } catch (const ordered_json::exception& error) {
    throw InputError(fmt::format(
        "{}: {} is not as Google Benchmark writes it ({}); write the file again", whose,
        number == 0 ? "context" : fmt::format("benchmark number {}", number), error.what()));
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: benchmark number {}: {}", whose, number, error.what()));
  }
  result.benchmarks = collector.taken();
  validate(result, whose);
  return result;
}

}  // namespace phytobench
