// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/stored_result.hpp"

#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/comparison/google_benchmark_result.hpp"
#include "benchmarks/comparison/result_document.hpp"
#include "benchmarks/comparison/timings_result.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {

using nlohmann::ordered_json;

namespace fs = std::filesystem;

namespace {

constexpr const char* accepted =
    "a result is what `phytobench bench measure --out` writes, what a Google Benchmark program "
    "writes with --benchmark_out_format=json, or a run's folder or timings.jsonl";

void refuse_time(double seconds, const std::string& what, const std::string& whose) {
  if (std::isfinite(seconds) && seconds > 0.0) return;
  throw InputError(fmt::format("{}: {}: a time of {} s is no positive number; measure again", whose,
                               what, seconds));
}

/// Null is what JSON makes of a time that is no number.
double seconds_from(const ordered_json& json) {
  return json.is_null() ? std::nan("") : json.get<double>();
}

ordered_json benchmark_json(const StoredBenchmark& benchmark) {
  ordered_json json{
      {"name", benchmark.name}, {"inputs", benchmark.inputs}, {"answer", benchmark.answer}};
  if (!benchmark.objection.empty()) json["objection"] = benchmark.objection;
  json["processes"] = benchmark.processes;
  return json;
}

StoredBenchmark benchmark_from(const ordered_json& json) {
  StoredBenchmark benchmark{.name = json.at("name"),
                            .inputs = json.at("inputs"),
                            .answer = json.at("answer"),
                            .is_by_process = true};
  if (json.contains("objection")) benchmark.objection = json.at("objection");
  for (const ordered_json& samples : json.at("processes")) {
    std::vector<double> process;
    for (const ordered_json& seconds : samples) process.push_back(seconds_from(seconds));
    if (!process.empty()) benchmark.processes.push_back(std::move(process));
  }
  return benchmark;
}

StoredResult result_from(const ordered_json& document, const std::string& whose) {
  StoredResult result{.origin = origin_from(document.at("origin")),
                      .machine = result_machine_from(document.at("machine")),
                      .seed = document.at("seed")};
  result.origin.given = whose;
  result.origin.kind = "result";
  result.origin.program_digest.clear();  // there is no program that could run again
  if (document.contains("reference") && !document.at("reference").is_null()) {
    const ordered_json& reference = document.at("reference");
    result.reference = ReferenceTime{.name = reference.at("name"),
                                     .seconds = seconds_from(reference.at("seconds"))};
  }
  for (const ordered_json& benchmark : document.at("benchmarks"))
    result.benchmarks.push_back(benchmark_from(benchmark));
  return result;
}

[[noreturn]] void refuse_schema(const std::string& schema, const std::string& whose) {
  if (schema.starts_with("phytobench/comparison-"))
    throw InputError(whose + ": is an earlier comparison, not a result of one side; " + accepted);
  if (schema.starts_with("phytobench/counters-") || schema.starts_with("phytobench/instructions-"))
    throw InputError(
        whose + ": holds counts, no times; `phytobench history append` takes it, and " + accepted);
  throw InputError(fmt::format(
      "{}: {}; {}", whose,
      schema.empty() ? "is no result" : "is of the schema '" + schema + "', no result", accepted));
}

StoredResult result_in(const std::string& text, const std::string& whose) {
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (start == std::string::npos || text[start] != '{')
    throw InputError(fmt::format("{}: {}; {}", whose,
                                 start == std::string::npos ? "is empty" : "is no JSON object",
                                 accepted));
  const ordered_json document = parsed_document(text, whose);
  const std::string schema = schema_of(document);
  if (schema == stored_result_schema) return stored_result_from(text, whose);
  if (schema.empty() && is_google_benchmark_document(document))
    return google_benchmark_result_from(text, whose);
  refuse_schema(schema, whose);
}

}  // namespace

std::vector<double> StoredBenchmark::repetitions() const {
  std::vector<double> result;
  for (const std::vector<double>& process : processes) {
    if (process.empty()) continue;
    if (is_by_process)
      result.push_back(median(process));
    else
      result.insert(result.end(), process.begin(), process.end());
  }
  return result;
}

void validate(const StoredResult& result, const std::string& whose) {
  std::set<std::string> names;
  if (result.reference)
    refuse_time(result.reference->seconds, "reference '" + result.reference->name + "'", whose);
  for (const StoredBenchmark& benchmark : result.benchmarks) {
    if (!names.insert(benchmark.name).second)
      throw InputError(fmt::format("{}: benchmark '{}' is there twice; write the file again", whose,
                                   benchmark.name));
    for (const std::vector<double>& process : benchmark.processes)
      for (const double seconds : process)
        refuse_time(seconds, "benchmark '" + benchmark.name + "'", whose);
  }
}

std::string to_json(const StoredResult& result) {
  ordered_json json{{"schema", stored_result_schema}, {"origin", origin_json(result.origin)}};
  json["machine"] = {{"processor", result.machine.processor},
                     {"logical_processors", result.machine.logical_processors},
                     {"kernel", result.machine.kernel}};
  json["seed"] = result.seed;
  if (result.reference)
    json["reference"] = {{"name", result.reference->name}, {"seconds", result.reference->seconds}};
  json["benchmarks"] = ordered_json::array();
  for (const StoredBenchmark& benchmark : result.benchmarks)
    json["benchmarks"].push_back(benchmark_json(benchmark));
  return json.dump(1, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

StoredResult stored_result_from(const std::string& json, const std::string& whose) {
  const ordered_json document = parsed_document(json, whose);
  if (schema_of(document) != stored_result_schema) refuse_schema(schema_of(document), whose);
  StoredResult result;
  try {
    result = result_from(document, whose);
  } catch (const ordered_json::exception& error) {
    throw InputError(fmt::format("{}: is no whole {} ({}); measure again", whose,
                                 stored_result_schema, error.what()));
  }
  validate(result, whose);
  return result;
}

StoredResult read_stored_result(const fs::path& path) {
  std::error_code ignored;
  if (fs::is_directory(path, ignored)) return timings_result_of_run(path);
  const std::string text = read_text_file(path);
  if (is_timings_text(text)) return timings_result_from(path, text);
  return result_in(text, path.string());
}

}  // namespace phytobench
