// SPDX-License-Identifier: MIT
#include "reports/document_validation.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_numbers.hpp"
#include "reports/document_part.hpp"
#include "reports/document_tables.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

constexpr double promised = 0.95;  ///< of all intervals of the suite

std::string words(std::string text) {
  std::replace(text.begin(), text.end(), '_', ' ');
  return text;
}

/// "num_acc_1" -> "NumAcc1", as NIST spells it.
std::string set_name(const std::string& key) {
  std::string name;
  bool starts = true;
  for (const char letter : key) {
    if (letter != '_')
      name += starts ? static_cast<char>(std::toupper(static_cast<unsigned char>(letter))) : letter;
    starts = letter == '_';
  }
  return name;
}

std::string percent_to_tenths(double share) {
  return fmt::format("{:.1f} %", 100.0 * share);
}

std::string shown_digits(double digits) {
  return fmt::format("{:.1f}", digits);
}

ordered_json certified_rows(const Validation& validation) {
  ordered_json rows = ordered_json::array();
  for (const CertifiedAnswer& answer : validation.certified)
    rows.push_back(
        {{"set", set_name(answer.set)},
         {"statistic", words(answer.statistic)},
         {"several", answer.answers > 1},
         {"answers", answer.answers},
         {"function", words(answer.function)},
         {"unused", answer.is_counter_example || answer.is_unused},
         {"certified", fmt::format("{:.15g}", answer.certified)},
         {"computed", fmt::format("{:.15g}", answer.computed)},
         {"digits", shown_digits(answer.digits)},
         {"reachable", answer.reachable ? shown_digits(*answer.reachable) : std::string("-")}});
  return rows;
}

/// The fewest digits of what the suite uses, and where; what nothing rests on is counted apart.
std::string certified_summary(const Validation& validation) {
  const CertifiedAnswer* least = nullptr;
  std::int64_t answers = 0, unused = 0;
  for (const CertifiedAnswer& answer : validation.certified) {
    if (answer.is_counter_example) continue;
    (answer.is_unused ? unused : answers) += answer.answers;
    if (answer.is_unused) continue;
    // Digits that the data have lost as doubles are no fault of the program.
    if (answer.reachable && *answer.reachable <= answer.digits) continue;
    if (!least || answer.digits < least->digits) least = &answer;
  }
  std::string text;
  if (least)
    text = fmt::format(
        "Of {} answers of functions that verdicts or experiments use, those with the fewest digits "
        "that the data would allow agree in {} ({}, {}).",
        answers, shown_digits(least->digits), set_name(least->set), words(least->statistic));
  if (unused > 0)
    text += fmt::format(
        "{}{} of functions that nothing else in the suite uses: no verdict rests "
        "on them.",
        text.empty() ? "" : " ",
        counted(static_cast<std::size_t>(unused), "more answer is", "more answers are"));
  return text;
}

ordered_json exact_rows(const Validation& validation) {
  ordered_json rows = ordered_json::array();
  for (const ExactAnswer& answer : validation.exact)
    rows.push_back({{"function", words(answer.function)},
                    {"question", words(answer.question)},
                    {"judge", answer.judge},
                    {"values", answer.values},
                    {"digits", shown_digits(answer.digits)},
                    {"difference", fmt::format("{:.2g}", answer.largest_difference)}});
  return rows;
}

ordered_json transcription_rows(const Validation& validation) {
  ordered_json rows = ordered_json::array();
  for (const Transcription& row : validation.transcriptions)
    rows.push_back({{"measurement", row.measurement},
                    {"difference", fmt::format("{:.2g}", row.difference)},
                    {"unit", row.unit == "1" ? "" : row.unit}});
  return rows;
}

std::string transcription_summary(const Validation& validation) {
  const auto exact =
      std::count_if(validation.transcriptions.begin(), validation.transcriptions.end(),
                    [](const Transcription& row) { return row.difference == 0.0; });
  return fmt::format(
      "{} with independent transcriptions of printed equations, {} without any "
      "difference.",
      counted(validation.transcriptions.size(), "comparison"), exact);
}

ordered_json order_rows(const Validation& validation) {
  ordered_json rows = ordered_json::array();
  for (const ObservedOrder& row : validation.orders) {
    rows.push_back({{"measurement", row.measurement},
                    {"expected", fmt::format("{:.2g}", row.expected)},
                    {"order", fmt::format("{:.3f}", row.order.value)},
                    {"interval", fmt::format("{:.3f} to {:.3f}", row.order.low, row.order.high)}});
  }
  return rows;
}

ordered_json kept_rows(const Validation& validation) {
  ordered_json rows = ordered_json::array();
  for (const KeptQuantity& row : validation.kept)
    rows.push_back({{"measurement", row.measurement}, {"drift", fmt::format("{:.2g}", row.drift)}});
  return rows;
}

std::string shown_ranks(const RankedInterval& interval) {
  return fmt::format("{} and {}", interval.ranks.low, interval.ranks.high);
}

ordered_json rank_rows(const Validation& validation) {
  ordered_json rows = ordered_json::array();
  for (const IntervalRanks& row : validation.ranks) {
    const auto& exact = row.order_statistics;
    rows.push_back(
        {{"values", row.values},
         {"bootstrap", shown_ranks(row.bootstrap)},
         {"bootstrap_coverage", percent_to_tenths(row.bootstrap.coverage)},
         {"too_few", row.bootstrap.coverage < promised},
         {"others", fmt::format("{} of {}", row.other_ends, row.tried)},
         {"exact", exact ? shown_ranks(*exact) : std::string("none exists")},
         {"exact_coverage", exact ? percent_to_tenths(exact->coverage) : std::string("-")}});
  }
  return rows;
}

std::string coverage_label(const SimulatedCoverage& row) {
  const std::string of =
      row.statistic == "exponent" ? "exponent of {} sizes" : words(row.statistic) + " of {}";
  return fmt::format(fmt::runtime(of + ", {}"), row.values, words(row.method));
}

/// A row for each statistic, number of values and method, a column for each law.
ordered_json coverage_grid(const Validation& validation) {
  ordered_json grid{{"title", "Share of simulated data sets whose 95 % interval holds the truth"},
                    {"note", "with its own 95 % interval"},
                    {"has_note", true},
                    {"varies", false},
                    {"columns", ordered_json::array()},
                    {"rows", ordered_json::array()}};
  for (const SimulatedCoverage& row : validation.coverage) {
    const std::string law = words(row.law), label = coverage_label(row);
    ordered_json& columns = grid["columns"];
    if (std::find(columns.begin(), columns.end(), law) == columns.end()) columns.push_back(law);
    ordered_json& rows = grid["rows"];
    auto own = std::find_if(rows.begin(), rows.end(),
                            [&](const ordered_json& other) { return other["label"] == label; });
    if (own == rows.end()) {
      rows.push_back({{"label", label}, {"cells", ordered_json::array()}});
      own = rows.end() - 1;
    }
    const char* const note = row.share.high < promised ? " (too few)" : "";
    (*own)["cells"].push_back(
        table_cell(percent_to_tenths(row.share.value) + note,
                   fmt::format("{:.1f} to {:.1f}", 100.0 * row.share.low, 100.0 * row.share.high)));
  }
  return grid;
}

ordered_json round_rows(const Validation& validation) {
  ordered_json rows = ordered_json::array();
  for (const RoundMemory& row : validation.rounds)
    rows.push_back({{"experiment", row.experiment},
                    {"series", row.series},
                    {"correlation", fmt::format("{:.2f}", row.median_correlation)},
                    {"beyond", row.beyond}});
  return rows;
}

}  // namespace

ordered_json validation_document(const Validation& validation, bool without_varying) {
  ordered_json document;
  add_part(document, "certified", certified_rows(validation));
  document["certified_summary"] = certified_summary(validation);
  add_part(document, "exact", exact_rows(validation));
  add_part(document, "transcriptions", transcription_rows(validation));
  document["transcription_summary"] = transcription_summary(validation);
  add_part(document, "orders", order_rows(validation));
  add_part(document, "kept", kept_rows(validation));
  add_part(document, "ranks", rank_rows(validation));
  document["grids"] = ordered_json::array();
  if (!validation.coverage.empty()) document["grids"].push_back(coverage_grid(validation));
  document["has_coverage"] = !validation.coverage.empty();
  document["has_intervals"] = !validation.coverage.empty() || !validation.ranks.empty();
  document["data_sets"] = validation.coverage.empty()
                              ? std::string()
                              : with_thousands(static_cast<double>(validation.coverage[0].sets));
  add_part(document, "rounds", without_varying ? ordered_json::array() : round_rows(validation));
  document["sampled"] = validation.sampled_records;
  document["with_spread"] = validation.spread_records;
  return document;
}

}  // namespace phytobench
