// SPDX-License-Identifier: MIT
#include "reports/judge/judged_run.hpp"

#include <algorithm>

namespace phytobench {

namespace {

struct TablePlace {
  std::size_t row = 0;
  std::size_t column = 0;
};

TablePlace largest_of(const std::vector<std::vector<double>>& values) {
  TablePlace best;
  for (std::size_t row = 0; row < values.size(); ++row)
    for (std::size_t column = 0; column < values[row].size(); ++column)
      if (values[row][column] > values[best.row][best.column]) best = {row, column};
  return best;
}

/// Medians of one quantity in every cell; `complete` says whether each had evidence.
template <class Id>
std::vector<std::vector<MedianOfRounds>> cell_estimates(const PublishedTable& table,
                                                        const Evidence& evidence, const Id& id,
                                                        bool& complete) {
  std::vector<std::vector<MedianOfRounds>> values;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    auto& own = values.emplace_back();
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      const auto median = evidence.median_of(id(row, column));
      complete &= median.has_value();
      own.push_back(median.value_or(MedianOfRounds{}));
    }
  }
  return values;
}

std::vector<JudgedCompanion> judge_companions(const PublishedTable& table,
                                              const Evidence& evidence) {
  std::vector<JudgedCompanion> companions;
  for (const std::string& name : table.companions) {
    const auto id = [&](std::size_t row, std::size_t column) {
      return table.companion_at(row, column, name);
    };
    bool complete = true;
    auto values = cell_estimates(table, evidence, id, complete);
    if (complete) companions.push_back({name, evidence.is_timing(id(0, 0)), std::move(values)});
  }
  return companions;
}

/// Published and measured values per unit of work: the same counts stand behind both.
void divide_by_work(JudgedTable& judged, const Evidence& evidence) {
  const PublishedTable& table = *judged.table;
  if (table.per.empty()) return;
  bool complete = true;
  const auto id = [&](std::size_t row, std::size_t column) {
    return table.companion_at(row, column, table.per);
  };
  const auto work = cell_estimates(table, evidence, id, complete);
  if (!complete) return;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    auto& published = judged.published_per.emplace_back();
    auto& measured = judged.measured_per.emplace_back();
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      published.push_back(table.values[row][column] / work[row][column].value);
      measured.push_back(judged.values[row][column].value / work[row][column].value);
    }
  }
}

}  // namespace

JudgedTable judge_table(const PublishedTable& table, const Evidence& evidence) {
  JudgedTable judged{.table = &table};
  const auto id = [&](std::size_t row, std::size_t column) {
    return table.measurement_at(row, column);
  };
  judged.measured = true;
  judged.values = cell_estimates(table, evidence, id, judged.measured);
  judged.timed = evidence.is_timing(id(0, 0));
  judged.companions = judge_companions(table, evidence);
  divide_by_work(judged, evidence);
  // Normalise both tables to their own largest cell.
  const TablePlace top = largest_of(table.values);
  for (const auto& row : table.values) {
    auto& shares = judged.published_share.emplace_back();
    for (const double value : row) shares.push_back(value / table.values[top.row][top.column]);
  }
  if (!judged.measured) return judged;
  std::vector<std::vector<double>> medians;
  for (const auto& row : judged.values) {
    auto& own = medians.emplace_back();
    for (const Estimate& estimate : row) own.push_back(estimate.value);
  }
  const TablePlace largest = largest_of(medians);
  const std::string slowest = id(largest.row, largest.column);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    auto& shares = judged.share.emplace_back();
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
      shares.push_back(evidence.ratio_of(id(row, column), slowest).value_or(MedianOfRounds{}));
    }
  }
  return judged;
}

JudgedRun judge_run(RunContents run) {
  JudgedRun judged{.run = std::move(run), .papers = {}, .scaling = {}};
  const Evidence evidence(judged.run);
  for (const std::string& key : paper_keys())
    judged.papers.push_back({.paper = load_paper(key),
                             .claims = load_claims(key),
                             .errata = load_errata(key),
                             .assumptions = load_assumptions(key),
                             .judgements = {},
                             .tables = {}});
  // The judgements point into the claims, which must not move any more.
  for (JudgedPaper& paper : judged.papers) {
    for (const Claim& claim : paper.claims.claims)
      paper.judgements.push_back(judge(claim, evidence, judged.run.header.tier));
    for (const PublishedTable& table : paper.claims.tables)
      paper.tables.push_back(judge_table(table, evidence));
  }
  judged.scaling = judge_scaling(load_scaling_study("nearest-node"), judged.run, evidence);
  return judged;
}

}  // namespace phytobench
