// SPDX-License-Identifier: MIT
#include "benchmarks/regression/worker_protocol.hpp"

#include <functional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

std::string document(const char* what, ordered_json body) {
  ordered_json json;
  json["schema"] = fmt::format("phytobench/worker-{}", worker_protocol);
  json["answers"] = what;
  json.update(body);
  return json.dump() + "\n";
}

/// One entry per benchmark, under "benchmarks".
template <class Entry, class ToJson>
std::string list_document(const char* what, const std::vector<Entry>& entries,
                          const ToJson& one_to_json) {
  ordered_json list = ordered_json::array();
  for (const Entry& entry : entries) list.push_back(one_to_json(entry));
  return document(what, {{"benchmarks", list}});
}

/// Reads with `read` what should be a document of that kind.
template <class Result>
Result parsed(const std::string& text, const char* what, const std::string& whose,
              const std::function<Result(const ordered_json&)>& read) {
  try {
    const ordered_json json = ordered_json::parse(text);
    const std::string schema = json.at("schema");
    if (schema != fmt::format("phytobench/worker-{}", worker_protocol))
      throw InputError(fmt::format("{}: speaks {}, not version {}; compare builds of one protocol",
                                   whose, schema, worker_protocol));
    if (const std::string answers = json.at("answers"); answers != what)
      throw InputError(fmt::format("{}: answered '{}' instead of '{}'", whose, answers, what));
    return read(json);
  } catch (const ordered_json::exception& error) {
    throw InputError(
        fmt::format("{}: no answer to '{}' that can be read ({})", whose, what, error.what()));
  }
}

template <class Entry>
std::vector<Entry> parsed_list(const std::string& text, const char* what, const std::string& whose,
                               Entry (*read_one)(const ordered_json&)) {
  return parsed<std::vector<Entry>>(text, what, whose, [read_one](const ordered_json& json) {
    std::vector<Entry> entries;
    for (const ordered_json& one : json.at("benchmarks")) entries.push_back(read_one(one));
    return entries;
  });
}

VerifiedBenchmark verified_one(const ordered_json& json) {
  return {.name = json.at("name"),
          .inputs = json.at("inputs"),
          .answer = json.at("answer"),
          .objection = json.at("objection"),
          .work = json.at("work").get<WorkCounts>()};
}

CalibratedBenchmark calibrated_one(const ordered_json& json) {
  return {
      .name = json.at("name"), .iterations = json.at("iterations"), .seconds = json.at("seconds")};
}

SampledBenchmark sampled_one(const ordered_json& json) {
  SampledBenchmark sampled{.name = json.at("name"),
                           .objection = json.at("objection"),
                           .samples = {},
                           .involuntary_switches = json.at("involuntary_switches")};
  for (const ordered_json& sample : json.at("samples"))
    sampled.samples.push_back({.iterations = sample.at("iterations"),
                               .cpu_s = sample.at("cpu_s"),
                               .wall_s = sample.at("wall_s")});
  return sampled;
}

WorkerDescription worker_described(const ordered_json& json) {
  WorkerDescription description{.protocol = worker_protocol,
                                .compiler = json.at("compiler"),
                                .flags = json.at("flags"),
                                .counts_work = json.at("counts_work"),
                                .benchmarks = {}};
  for (const ordered_json& one : json.at("benchmarks"))
    description.benchmarks.push_back(
        {.name = one.at("name"), .summary = one.at("summary"), .is_own = one.at("is_own")});
  return description;
}

SamplePlan planned(const ordered_json& json) {
  SamplePlan plan{.seed = json.at("seed"), .samples = json.at("samples"), .benchmarks = {}};
  for (const ordered_json& one : json.at("benchmarks"))
    plan.benchmarks.push_back(
        {.name = one.at("name"), .iterations = one.at("iterations"), .answer = one.at("answer")});
  return plan;
}

}  // namespace

std::string to_json(const WorkerDescription& description) {
  ordered_json list = ordered_json::array();
  for (const WorkerDescription::Benchmark& one : description.benchmarks)
    list.push_back({{"name", one.name}, {"summary", one.summary}, {"is_own", one.is_own}});
  return document("list", {{"compiler", description.compiler},
                           {"flags", description.flags},
                           {"counts_work", description.counts_work},
                           {"benchmarks", list}});
}

std::string to_json(const std::vector<VerifiedBenchmark>& verified) {
  return list_document("verify", verified, [](const VerifiedBenchmark& one) {
    return ordered_json{{"name", one.name},
                        {"inputs", one.inputs},
                        {"answer", one.answer},
                        {"objection", one.objection},
                        {"work", one.work}};
  });
}

std::string to_json(const std::vector<CalibratedBenchmark>& calibrated) {
  return list_document("calibrate", calibrated, [](const CalibratedBenchmark& one) {
    return ordered_json{
        {"name", one.name}, {"iterations", one.iterations}, {"seconds", one.seconds}};
  });
}

std::string to_json(const SamplePlan& plan) {
  ordered_json list = ordered_json::array();
  for (const SamplePlan::Benchmark& one : plan.benchmarks)
    list.push_back({{"name", one.name}, {"iterations", one.iterations}, {"answer", one.answer}});
  return document("plan", {{"seed", plan.seed}, {"samples", plan.samples}, {"benchmarks", list}});
}

std::string to_json(const std::vector<SampledBenchmark>& sampled) {
  return list_document("sample", sampled, [](const SampledBenchmark& one) {
    ordered_json samples = ordered_json::array();
    for (const TimedSample& sample : one.samples)
      samples.push_back(
          {{"iterations", sample.iterations}, {"cpu_s", sample.cpu_s}, {"wall_s", sample.wall_s}});
    return ordered_json{{"name", one.name},
                        {"objection", one.objection},
                        {"involuntary_switches", one.involuntary_switches},
                        {"samples", samples}};
  });
}

WorkerDescription worker_description_from(const std::string& json, const std::string& whose) {
  return parsed<WorkerDescription>(json, "list", whose, worker_described);
}

std::vector<VerifiedBenchmark> verified_from(const std::string& json, const std::string& whose) {
  return parsed_list(json, "verify", whose, verified_one);
}

std::vector<CalibratedBenchmark> calibrated_from(const std::string& json,
                                                 const std::string& whose) {
  return parsed_list(json, "calibrate", whose, calibrated_one);
}

SamplePlan sample_plan_from(const std::string& json, const std::string& whose) {
  return parsed<SamplePlan>(json, "plan", whose, planned);
}

std::vector<SampledBenchmark> sampled_from(const std::string& json, const std::string& whose) {
  return parsed_list(json, "sample", whose, sampled_one);
}

}  // namespace phytobench
