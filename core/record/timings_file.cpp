// SPDX-License-Identifier: MIT
#include "core/record/timings_file.hpp"

#include <algorithm>
#include <iterator>

#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"
#include "core/record/experiment_lines.hpp"
#include "core/record/record_from_json.hpp"

namespace phytobench {

using nlohmann::ordered_json;

namespace {

constexpr const char* timings_schema = "phytobench/timings-2";

/// Collects the lines of an experiment until one says that it is complete.
class TimingsCollector {
 public:
  void add_line(const ordered_json& line) {
    if (!has_header_) refuse_header();
    pending_.add(timing_from(line));
  }

  void add_seal(const ordered_json& line, const Seal& seal) {
    if (!has_header_)
      begin(line);
    else if (line.contains("environment"))
      start(line);
    else
      complete(line, seal);
    content_.last = seal;
  }

  bool has_header() const { return has_header_; }

  TimingsFile taken() {
    content_.unfinished = pending_.experiment();
    return std::move(content_);
  }

 private:
  [[noreturn]] static void refuse_header() {
    throw InputError(std::string("the first line must name the schema ") + timings_schema +
                     "; run the experiments again");
  }

  void begin(const ordered_json& line) {
    if (!line.contains("schema") || line.at("schema") != timings_schema) refuse_header();
    has_header_ = true;
  }

  void start(const ordered_json& line) {
    if (const auto experiment = pending_.experiment())
      throw InputError("timings of '" + *experiment +
                       "' stand in no experiment; run the experiments again");
    content_.sessions.push_back(
        {.experiments = content_.experiments.size(), .environment_digest = line.at("environment")});
  }

  void complete(const ordered_json& line, const Seal& seal) {
    std::vector<TimingSample> timings = pending_.completed(line);
    const std::size_t count = timings.size();
    std::move(timings.begin(), timings.end(), std::back_inserter(content_.timings));
    content_.experiments.push_back({.name = line.at("experiment"),
                                    .records_digest = line.at("records_sha256"),
                                    .artifacts = line.contains("artifacts")
                                                     ? line.at("artifacts").get<ArtifactDigests>()
                                                     : ArtifactDigests(),
                                    .before = content_.last,
                                    .timings = count,
                                    .line = seal.line});
  }

  bool has_header_ = false;
  PendingLines<TimingSample> pending_{timing_words};
  TimingsFile content_;
};

}  // namespace

std::string timings_header() {
  return ordered_json{{"schema", timings_schema}}.dump();
}

std::string timings_session(const std::string& environment_digest) {
  return ordered_json{{"environment", environment_digest}}.dump();
}

std::string timings_completion(const std::string& experiment, std::size_t timings,
                               const std::string& records_digest,
                               const ArtifactDigests& artifacts) {
  ordered_json line = completion_line(experiment, timing_words, timings);
  line["records_sha256"] = records_digest;
  if (!artifacts.empty()) line["artifacts"] = artifacts;
  return line.dump();
}

TimingsFile parse_timings(const std::filesystem::path& file, std::string_view text) {
  return collect_sealed_lines<TimingsCollector>(file, text);
}

}  // namespace phytobench
