// SPDX-License-Identifier: MIT
#include "benchmarks/history/history_input.hpp"

#include <iterator>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/comparison/counter_gate.hpp"
#include "benchmarks/comparison/result_document.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {

using nlohmann::ordered_json;

namespace fs = std::filesystem;

namespace {

constexpr const char* counters_schema = "phytobench/counters-1";
constexpr const char* instructions_schema = "phytobench/instructions-1";

std::string inputs_of(const ordered_json& benchmark) {
  return benchmark.contains("inputs") ? benchmark.at("inputs").get<std::string>() : std::string();
}

/// The library turns -1 and 1.5 into numbers without a word.
std::uint64_t count_from(const ordered_json& json, const std::string& what) {
  if (!json.is_number_unsigned())
    throw InputError(what + ": " + json.dump() + " is no whole number from 0; count again");
  return json.get<std::uint64_t>();
}

HistoryInput counters_from(const std::string& text, const std::string& whose) {
  const CounterDocument document = counter_document_from(text, whose);
  HistoryInput input{.origin = document.origin, .machine = std::nullopt, .values = {}};
  for (const auto& [name, benchmark] : document.benchmarks)
    for (const auto& [counter, count] : benchmark.counters)
      input.values.push_back(
          HistoryValue::counted(name, benchmark.inputs, HistoryQuantity::counter(counter), count));
  return input;
}

/// What was counted of one benchmark: of the new build, where two were compared. Null where it
/// could not be counted.
const ordered_json& counted_of(const ordered_json& benchmark) {
  return benchmark.contains("new") ? benchmark.at("new") : benchmark;
}

HistoryInput instructions_from(const ordered_json& document) {
  HistoryInput input;
  for (const char* side : {"origin", "new"})
    if (document.contains(side)) input.origin = origin_from(document.at(side));
  if (document.contains("machine")) input.machine = result_machine_from(document.at("machine"));
  for (const ordered_json& benchmark : document.at("benchmarks")) {
    const std::string name = benchmark.at("name");
    const ordered_json& counted = counted_of(benchmark);
    if (counted.is_null()) continue;
    input.values.push_back(
        HistoryValue::counted(name, inputs_of(counted), HistoryQuantity::instructions(),
                              count_from(counted.at("instructions"), name + ", instructions")));
  }
  return input;
}

HistoryInput ratios_from(const StoredResult& result, const std::string& whose) {
  if (!result.reference)
    throw InputError(whose +
                     ": has no time of a reference kernel, and a history keeps no bare seconds; "
                     "measure again with `phytobench bench measure`");
  HistoryInput input{.origin = result.origin, .machine = result.machine, .values = {}};
  for (const StoredBenchmark& benchmark : result.benchmarks) {
    const std::vector<double> seconds = benchmark.repetitions();
    if (seconds.empty()) continue;
    input.values.push_back(HistoryValue::ratio(benchmark.name, benchmark.inputs,
                                               median(seconds) / result.reference->seconds));
  }
  return input;
}

HistoryInput input_from(const std::string& text, const std::string& whose) {
  const ordered_json document = parsed_document(text, whose);
  const std::string schema = schema_of(document);
  if (schema == stored_result_schema) return ratios_from(stored_result_from(text, whose), whose);
  if (schema == counters_schema) return counters_from(text, whose);
  if (schema != instructions_schema)
    throw InputError(fmt::format("{}: a history takes {}, {} and {}, and this is {}", whose,
                                 counters_schema, instructions_schema, stored_result_schema,
                                 schema.empty() ? "none of them" : schema));
  try {
    return instructions_from(document);
  } catch (const ordered_json::exception& error) {
    throw InputError(
        fmt::format("{}: is no whole {} ({}); write it again", whose, schema, error.what()));
  } catch (const InputError& error) {
    throw InputError(whose + ": " + error.what());
  }
}

bool is_same_build(const SideOrigin& a, const SideOrigin& b) {
  return a.commit == b.commit && a.changed == b.changed && a.compiler == b.compiler &&
         a.flags == b.flags;
}

bool is_same_machine(const ResultMachine& a, const ResultMachine& b) {
  return a.processor == b.processor && a.logical_processors == b.logical_processors;
}

/// Adds what one more file says, unless it contradicts those before.
void join(HistoryInput& all, HistoryInput&& next, const std::string& whose) {
  if (all.origin && next.origin && !is_same_build(*all.origin, *next.origin))
    throw InputError(whose + ": is of another build than the files before; append it on its own");
  if (all.machine && next.machine && !is_same_machine(*all.machine, *next.machine))
    throw InputError(whose + ": is of another machine than the files before; append it on its own");
  if (next.origin) all.origin = std::move(next.origin);
  if (next.machine) all.machine = std::move(next.machine);
  std::move(next.values.begin(), next.values.end(), std::back_inserter(all.values));
}

}  // namespace

HistoryInput read_history_input(const fs::path& file) {
  HistoryInput input = input_from(read_text_file(file), file.string());
  if (input.values.empty())
    throw NothingSelected(file.string() +
                          ": holds no value of any benchmark; nothing was appended");
  return input;
}

HistoryEntry history_entry_of(const std::vector<std::string>& files, const HistoryRun& here) {
  HistoryInput all;
  for (const std::string& file : files) join(all, read_history_input(file), file);
  HistoryEntry entry{.run = here, .values = std::move(all.values)};
  if (all.origin) {
    entry.run.commit = all.origin->commit;
    entry.run.changed = all.origin->changed;
    entry.run.compiler = all.origin->compiler;
    entry.run.flags = all.origin->flags;
  }
  if (all.machine) {
    entry.run.processor = all.machine->processor;
    entry.run.logical_processors = all.machine->logical_processors;
  }
  return entry;
}

}  // namespace phytobench
