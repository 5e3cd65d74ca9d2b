// SPDX-License-Identifier: MIT
#include "reports/browser/report_under_test.hpp"

#include <map>
#include <string>
#include <vector>

#include "core/picture/image.hpp"
#include "core/record/run_writer.hpp"
#include "reference/claims.hpp"
#include "reference/papers.hpp"
#include "reports/judge/fulfilled_claim.hpp"
#include "reports/write_report.hpp"

namespace phytobench {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t left_out_every = 9;      ///< claim
constexpr std::size_t contradicted_every = 7;  ///< claim

bool is_time(const std::string& measurement) {
  return measurement.ends_with("seconds");
}

/// "brzoska2019/table-1" of "brzoska2019/table-1/euclid.s/edges".
std::string experiment_of(const std::string& measurement) {
  return measurement.substr(0, measurement.find('/', measurement.find('/') + 1));
}

/// A number that is not the one that a claim needs.
RecordValue other_than(const RecordValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return *whole + 1;
  if (const auto* real = std::get_if<double>(&value)) return *real * 3.0 + 1.0;
  return std::get<std::string>(value) + " and more";
}

void add_claims(const std::vector<Claim>& claims, Measurements& all) {
  for (std::size_t i = 0; i < claims.size(); ++i) {
    if (claims[i].checks.empty() || i % left_out_every == 0) continue;
    auto held = fulfilled(claims[i], {});
    if (!held) continue;
    if (i % contradicted_every == 0) {
      RecordValue& first = held->begin()->second;
      first = other_than(first);
    }
    all.merge(*held);  // what is there stays
  }
}

void add_tables(const std::vector<PublishedTable>& tables, Measurements& all) {
  for (const PublishedTable& table : tables)
    for (std::size_t row = 0; row < table.values.size(); ++row)
      for (std::size_t column = 0; column < table.values[row].size(); ++column)
        all.try_emplace(table.measurement_at(row, column), table.values[row][column] * 1.02);
}

struct Results {
  std::vector<Record> records;
  std::vector<TimingSample> timings;
};

void add(const std::string& name, const RecordValue& value, Results& results) {
  const std::string experiment = experiment_of(name);
  const auto* seconds = std::get_if<double>(&value);
  if (!seconds || !is_time(name)) {
    results.records.push_back({.experiment = experiment, .measurement = name, .value = value});
    return;
  }
  for (const std::int64_t round : {0, 1, 2})
    results.timings.push_back({.experiment = experiment,
                               .measurement = name,
                               .round = round,
                               .value = *seconds * (1.0 + 0.01 * static_cast<double>(round))});
}

void write_pictures(RunWriter& writer, const std::string& experiment) {
  writer.write_artifact(experiment, "figure-4.7.svg",
                        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 90\" "
                        "role=\"img\" aria-label=\"A line\"><path d=\"M0 0L640 90\" "
                        "stroke=\"currentColor\"/><text x=\"9\" y=\"60\">a line</text></svg>");
  Image image(8, 8);
  writer.write_artifact(experiment, "figure-40-left.jpg", to_jpeg(image));
}

}  // namespace

void make_report_under_test(const fs::path& folder) {
  const fs::path run = folder / "run";
  RunWriter writer(run, {Tier::full, 7}, RunMode::fresh);
  for (const std::string& paper : paper_keys()) {
    const PaperClaims claims = load_claims(paper);
    Measurements measurements;
    add_claims(claims.claims, measurements);
    add_tables(claims.tables, measurements);
    std::map<std::string, Results> by_experiment;
    for (const auto& [name, value] : measurements)
      add(name, value, by_experiment[experiment_of(name)]);
    if (by_experiment.empty()) continue;  // a work of which nothing is measured yet
    write_pictures(writer, by_experiment.begin()->first);
    for (const auto& [experiment, results] : by_experiment)
      writer.append(experiment, results.records, results.timings);
  }
  write_report({.run_folders = {run}, .out_folder = folder / "report", .formats = {"html", "csv"}});
}

}  // namespace phytobench
