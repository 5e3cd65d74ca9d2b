// SPDX-License-Identifier: MIT
#include "reports/judge/judged_run.hpp"

#include <algorithm>

namespace phytobench {

namespace {

struct Place {
  std::size_t row = 0;
  std::size_t column = 0;
};

Place largest_of(const std::vector<std::vector<double>>& values) {
  Place best;
  for (std::size_t row = 0; row < values.size(); ++row)
    for (std::size_t column = 0; column < values[row].size(); ++column)
      if (values[row][column] > values[best.row][best.column]) best = {row, column};
  return best;
}

}  // namespace

JudgedTable judge_table(const PublishedTable& table, const Evidence& evidence) {
  JudgedTable judged{.table = &table};
  const auto id = [&](const Place& place) { return table.measurement_at(place.row, place.column); };
  judged.measured = true;
  std::vector<std::vector<double>> medians;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    auto& values = judged.values.emplace_back();
    auto& plain = medians.emplace_back();
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      const std::vector<double> samples = evidence.samples(id({row, column}));
      judged.measured &= !samples.empty();
      judged.timed |= evidence.is_timing(id({row, column}));
      values.push_back(samples.empty() ? Estimate{} : median_estimate(samples));
      plain.push_back(values.back().value);
    }
  }
  // Normalise both tables to their own largest cell.
  const Place top = largest_of(table.values);
  for (const auto& row : table.values) {
    auto& shares = judged.published_share.emplace_back();
    for (const double value : row) shares.push_back(value / table.values[top.row][top.column]);
  }
  if (!judged.measured) return judged;
  const std::vector<double> slowest = evidence.samples(id(largest_of(medians)));
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    auto& shares = judged.share.emplace_back();
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      const std::vector<double> samples = evidence.samples(id({row, column}));
      shares.push_back(samples.size() == slowest.size() ? paired_ratio_estimate(samples, slowest) : Estimate{});
    }
  }
  return judged;
}

JudgedRun judge_run(RunContents run) {
  JudgedRun judged{.run = std::move(run), .papers = {}};
  const Evidence evidence(judged.run);
  for (const std::string& key : paper_keys())
    judged.papers.push_back({.paper = load_paper(key),
                             .claims = load_claims(key),
                             .errata = load_errata(key),
                             .judgements = {},
                             .tables = {}});
  // The judgements point into the claims, which must not move any more.
  for (JudgedPaper& paper : judged.papers) {
    for (const Claim& claim : paper.claims.claims)
      paper.judgements.push_back(judge(claim, evidence, judged.run.header.tier));
    for (const PublishedTable& table : paper.claims.tables)
      paper.tables.push_back(judge_table(table, evidence));
  }
  return judged;
}

}  // namespace phytobench
