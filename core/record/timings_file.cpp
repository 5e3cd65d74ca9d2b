// SPDX-License-Identifier: MIT
#include "core/record/timings_file.hpp"

#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"
#include "core/record/record_from_json.hpp"
#include "core/record/sealed_lines.hpp"

namespace phytobench {

using nlohmann::ordered_json;

namespace {

constexpr const char* schema = "phytobench/timings-2";

/// Collects the lines of an experiment until one says that it is complete.
class TimingsCollector {
 public:
  void add_line(const ordered_json& line) {
    if (!has_header_) refuse_header();
    pending_.push_back(timing_from(line));
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
    if (!pending_.empty()) content_.unfinished = pending_[0].experiment;
    return std::move(content_);
  }

 private:
  [[noreturn]] static void refuse_header() {
    throw InputError(std::string("the first line must name the schema ") + schema +
                     "; run the experiments again");
  }

  void begin(const ordered_json& line) {
    if (!line.contains("schema") || line.at("schema") != schema) refuse_header();
    has_header_ = true;
  }

  void start(const ordered_json& line) {
    if (!pending_.empty())
      throw InputError("timings of '" + pending_[0].experiment +
                       "' stand in no experiment; run the experiments again");
    content_.sessions.push_back(
        {.experiments = content_.experiments.size(), .environment_digest = line.at("environment")});
  }

  void complete(const ordered_json& line, const Seal& seal) {
    const std::string experiment = line.at("experiment");
    if (pending_.size() != line.at("timings").get<std::size_t>())
      throw InputError("experiment '" + experiment +
                       "' lost or gained timings; run the experiments again");
    for (TimingSample& sample : pending_) {
      if (sample.experiment != experiment)
        throw InputError("a timing of '" + sample.experiment + "' stands in '" + experiment +
                         "'; run the experiments again");
      content_.timings.push_back(std::move(sample));
    }
    content_.experiments.push_back({.name = experiment,
                                    .records_digest = line.at("records_sha256"),
                                    .artifacts = line.contains("artifacts")
                                                     ? line.at("artifacts").get<ArtifactDigests>()
                                                     : ArtifactDigests(),
                                    .before = content_.last,
                                    .timings = pending_.size(),
                                    .line = seal.line});
    pending_.clear();
  }

  bool has_header_ = false;
  std::vector<TimingSample> pending_;
  TimingsFile content_;
};

}  // namespace

std::string timings_header() {
  return ordered_json{{"schema", schema}}.dump();
}

std::string timings_session(const std::string& environment_digest) {
  return ordered_json{{"environment", environment_digest}}.dump();
}

std::string timings_completion(const std::string& experiment, std::size_t timings,
                               const std::string& records_digest,
                               const ArtifactDigests& artifacts) {
  ordered_json line;
  line["experiment"] = experiment;
  line["complete"] = true;
  line["timings"] = timings;
  line["records_sha256"] = records_digest;
  if (!artifacts.empty()) line["artifacts"] = artifacts;
  return line.dump();
}

TimingsFile parse_timings(const std::filesystem::path& file, std::string_view text) {
  TimingsCollector collector;
  read_sealed_lines(file, text,
                    {.line = [&](const ordered_json& line) { collector.add_line(line); },
                     .seal = [&](const ordered_json& line,
                                 const Seal& seal) { collector.add_seal(line, seal); }});
  if (!collector.has_header())
    throw InputError(file.string() + ":1: is empty; run the experiments again");
  return collector.taken();
}

}  // namespace phytobench
