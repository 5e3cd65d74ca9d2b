// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/timings_result.hpp"

#include <algorithm>
#include <map>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/comparison/result_document.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/sha256.hpp"
#include "core/record/run_files.hpp"
#include "core/record/timings_file.hpp"

namespace phytobench {

using nlohmann::ordered_json;

namespace fs = std::filesystem;

namespace {

/// Times of different numbers of threads are different benchmarks, as Google Benchmark names them.
std::string name_of(const TimingSample& sample) {
  return sample.threads == 1 ? sample.measurement
                             : fmt::format("{}/threads:{}", sample.measurement, sample.threads);
}

std::vector<StoredBenchmark> benchmarks_of(const std::vector<TimingSample>& samples) {
  std::vector<StoredBenchmark> benchmarks;
  std::map<std::string, std::size_t> places;
  for (const TimingSample& sample : samples) {
    if (sample.unit != "s") continue;  // memory
    const auto [place, is_new] = places.try_emplace(name_of(sample), benchmarks.size());
    if (is_new) benchmarks.push_back({.name = place->first, .processes = {{}}});
    benchmarks[place->second].processes.front().push_back(sample.value);
  }
  return benchmarks;
}

void set_environment(StoredResult& result, const std::string& text, const std::string& whose) {
  const ordered_json document = parsed_document(text, whose);
  if (document.empty()) return;
  try {
    result.seed = document.at("seed");
    result.origin.commit = document.at("commit");
    result.origin.changed = document.at("source_changed");
    result.origin.compiler = document.at("compiler");
    result.origin.flags = document.at("flags");
    result.machine = result_machine_from(document.at("machine"));
  } catch (const ordered_json::exception& error) {
    throw InputError(
        fmt::format("{}: is damaged ({}); run the experiments again", whose, error.what()));
  }
}

StoredResult result_of(const std::vector<TimingSample>& timings, const fs::path& path) {
  StoredResult result{.origin = {.given = path.string(), .kind = "result"},
                      .benchmarks = benchmarks_of(timings)};
  validate(result, path.string());
  return result;
}

}  // namespace

bool is_timings_text(std::string_view text) {
  return text.substr(0, text.find('\n')).find("\"phytobench/timings-") != std::string_view::npos;
}

StoredResult timings_result_of_run(const fs::path& folder) {
  StoredResult result = result_of(read_run(folder).timings, folder);
  set_environment(result, read_environment(folder), (folder / "environment.json").string());
  return result;
}

StoredResult timings_result_from(const fs::path& file, std::string_view text) {
  const TimingsFile read = parse_timings(file, text);
  StoredResult result = result_of(read.timings, file);
  const fs::path folder = file.parent_path();
  const std::string environment = read_environment(folder);
  const std::string digest = sha256_hex(environment);
  const bool is_its_own =
      std::any_of(read.sessions.begin(), read.sessions.end(),
                  [&](const auto& session) { return session.environment_digest == digest; });
  if (is_its_own) set_environment(result, environment, (folder / "environment.json").string());
  return result;
}

}  // namespace phytobench
