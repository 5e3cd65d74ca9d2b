// SPDX-License-Identifier: MIT
#include "core/record/records_file.hpp"

#include <set>

#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"
#include "core/record/experiment_lines.hpp"
#include "core/record/record_from_json.hpp"

namespace phytobench {

using nlohmann::ordered_json;

namespace {

constexpr std::string_view records_schema = "phytobench/records-2";
constexpr std::string_view any_version = "phytobench/records-";

RunHeader header_from(const ordered_json& line) {
  const std::string found =
      line.contains("schema") && line["schema"].is_string() ? line["schema"] : ordered_json("");
  if (found != records_schema && found.starts_with(any_version))
    throw InputError("this run has the schema " + found +
                     " of another version of phytobench, this version reads " +
                     std::string(records_schema) + "; run the experiments again");
  if (found != records_schema)
    throw InputError("not a run of this suite: the first line must name the schema " +
                     std::string(records_schema) +
                     "; give a folder that phytobench run --out has made");
  return {tier_named(line.at("tier").get<std::string>()), line.at("seed").get<std::uint64_t>()};
}

/// Collects the lines of an experiment until one says that it is complete.
class RecordsCollector {
 public:
  void add_line(const ordered_json& line) {
    if (!has_header_) {
      header_from(line);  // says first what is foreign
      throw InputError("the first line has lost its SHA-256; run the experiments again");
    }
    pending_.add(record_from(line));
  }

  void add_seal(const ordered_json& line, const Seal& seal) {
    if (has_header_)
      complete(line, seal);
    else
      content_.header = header_from(line);
    has_header_ = true;
    content_.last = seal;
  }

  bool has_header() const { return has_header_; }

  RecordsFile taken() {
    content_.unfinished = pending_.experiment();
    return std::move(content_);
  }

 private:
  void complete(const ordered_json& line, const Seal& seal) {
    std::vector<Record> records = pending_.completed(line);
    const std::string experiment = line.at("experiment");
    if (!experiments_.insert(experiment).second)
      throw InputError("experiment '" + experiment +
                       "' stands here twice; run the experiments again");
    for (Record& record : records) {
      if (!measurements_.insert(record.measurement).second)
        throw InputError("measurement '" + record.measurement +
                         "' stands here twice; run the experiments again");
      content_.records.push_back(std::move(record));
    }
    content_.experiments.push_back({experiment, seal.digest});
  }

  bool has_header_ = false;
  PendingLines<Record> pending_{record_words};
  RecordsFile content_;
  std::set<std::string> experiments_;
  std::set<std::string> measurements_;
};

}  // namespace

std::string records_header(const RunHeader& header) {
  ordered_json line;
  line["schema"] = records_schema;
  line["tier"] = name_of(header.tier);
  line["seed"] = header.seed;
  return line.dump();
}

std::string records_completion(const std::string& experiment, std::size_t records) {
  return completion_line(experiment, record_words, records).dump();
}

RecordsFile parse_records(const std::filesystem::path& file, std::string_view text) {
  return collect_sealed_lines<RecordsCollector>(file, text);
}

}  // namespace phytobench
