// SPDX-License-Identifier: MIT
#include "reports/document_tables.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_anchors.hpp"
#include "reports/document_intervals.hpp"
#include "reports/document_numbers.hpp"
#include "reports/document_tables_layout.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

std::string as_title(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

ordered_json estimate_cell(const MedianOfRounds& estimate, int decimals) {
  const auto shown = [&](double value) { return fmt::format("{:.{}f}", value, decimals); };
  return table_cell(shown(estimate.value),
                    shown_ends(estimate, shown(estimate.low), shown(estimate.high)));
}

class TableDocument {
 public:
  TableDocument(const JudgedTable& judged, const ClaimIndex& claims, bool without_varying)
      : judged_(judged),
        table_(*judged.table),
        claims_(claims),
        layout_(layout_of(table_, claims)),
        hide_times_(without_varying) {}

  ordered_json build() {
    const bool visible = judged_.measured && !(judged_.timed && hide_times_);
    document_["id"] = table_.id;
    document_["title"] = table_.title;
    document_["anchor"] = "table-" + slug(table_.paper) + "-" + slug(table_.id);
    document_["note"] = table_.note;
    document_["has_note"] = !table_.note.empty();
    document_["discussion"] = visible ? table_.discussion : "";  // it speaks of measured cells
    document_["has_discussion"] = visible && !table_.discussion.empty();
    document_["not_measured"] = !visible;
    document_["hidden"] = judged_.timed && hide_times_;
    document_["grids"] = ordered_json::array();
    const bool published = table_.origin == "published";
    add_grid(
        published ? "Published" : "Derived beforehand",
        published ? "as printed" : "with an independent program", false,
        [&](const TableLine& row, const TableLine& column) { return stated_cell(row, column); });
    if (visible) add_measured();
    if (published && has_claims()) add_verdicts();
    document_["companions"] = ordered_json::array();
    for (const JudgedCompanion& companion : judged_.companions)
      if (!companion.timed || !hide_times_) add_companion(companion);
    document_["has_companions"] = !document_["companions"].empty();
    return document_;
  }

 private:
  const ClaimLink* claim_on(const TableLine& row, const TableLine& column) const {
    return claims_.about(cell_name(table_, row, column));
  }

  ordered_json stated_cell(const TableLine& row, const TableLine& column) const {
    const ClaimLink* const claim = claim_on(row, column);
    if (!row.index || !column.index) return linked_cell(printed_by(claim), claim, false);
    const double value = table_.values[*row.index][*column.index];
    const bool published = table_.origin == "published";
    return linked_cell(published ? as_printed(value, claim) : shown(value), claim, false);
  }

  /// What a claim says is printed; works in German print 1,3 for 1.3.
  static std::string printed_by(const ClaimLink* claim) {
    std::string text = claim ? claim->published : "";
    std::replace(text.begin(), text.end(), ',', '.');
    return text;
  }

  /// With the digits that its claim says are printed: works print 11 beside 10.8.
  static std::string as_printed(double value, const ClaimLink* claim) {
    if (!claim || !claim->digits || value == 0.0) return shown(value);
    const int before_point = static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1;
    return fmt::format("{:.{}f}", value, std::max(0, *claim->digits - before_point));
  }

  bool has_claims() const {
    for (const TableLine& row : layout_.rows)
      for (const TableLine& column : layout_.columns)
        if (claim_on(row, column)) return true;
    return false;
  }

  void add_verdicts() {
    const bool varies = judged_.timed && !hide_times_;
    add_grid("Verdict", "on the claim about each cell", varies,
             [&](const TableLine& row, const TableLine& column) {
               const ClaimLink* const claim = claim_on(row, column);
               return linked_cell(claim ? claim->label : "no claim of its own", claim, true);
             });
  }

  /// `is_verdict`: the text is shown as a verdict, not as a number.
  static ordered_json linked_cell(const std::string& text, const ClaimLink* claim,
                                  bool is_verdict) {
    ordered_json cell = table_cell(text);
    if (!claim) return cell;
    cell["has_link"] = true;
    cell["link"] = claim->anchor;
    cell["class"] = is_verdict ? claim->look : "number";
    return cell;
  }

  void add_measured() {
    if (!judged_.timed) {
      add_numbers("Measured",
                  layout_.has_more_than(table_) ? "a dash: nothing to grow or compare" : "", false,
                  [&](auto r, auto c) { return table_cell(shown(judged_.values[r][c].value)); });
      return;
    }
    add_numbers("Measured", fmt::format("seconds, median and its {}", ends_of_medians), true,
                [&](auto r, auto c) { return estimate_cell(judged_.values[r][c], 4); });
    add_numbers("Published, relative", "to the slowest published cell", false, [&](auto r, auto c) {
      return table_cell(fmt::format("{:.3f}", judged_.published_share[r][c]));
    });
    add_numbers("Measured, relative", "to the slowest measured cell, paired by round", true,
                [&](auto r, auto c) { return estimate_cell(judged_.share[r][c], 3); });
    if (judged_.published_per.empty()) return;
    add_numbers("Published, per evaluation",
                "nanoseconds: printed seconds over the evaluations counted below", false,
                [&](auto r, auto c) {
                  return table_cell(fmt::format("{:.0f}", 1e9 * judged_.published_per[r][c]));
                });
    add_numbers("Measured, per evaluation", "nanoseconds", true, [&](auto r, auto c) {
      return table_cell(fmt::format("{:.2f}", 1e9 * judged_.measured_per[r][c]));
    });
  }

  void add_companion(const JudgedCompanion& companion) {
    add_numbers(
        as_title(companion.name), companion.timed ? "median" : "exact count", companion.timed,
        [&](auto r, auto c) {
          const double value = companion.values[r][c].value;
          return table_cell(companion.timed ? fmt::format("{:.4f}", value) : with_thousands(value));
        },
        "companions");
  }

  /// Numbers by row and column of the table itself; nothing where only a claim is.
  template <class Cell>
  void add_numbers(const std::string& title, const std::string& note, bool varies,
                   const Cell& make_cell, const char* list = "grids") {
    add_grid(
        title, note, varies,
        [&](const TableLine& row, const TableLine& column) {
          return row.index && column.index ? make_cell(*row.index, *column.index) : table_cell("-");
        },
        list);
  }

  template <class Cell>
  void add_grid(const std::string& title, const std::string& note, bool varies,
                const Cell& make_cell, const char* list = "grids") {
    ordered_json grid{{"title", title},
                      {"note", note},
                      {"has_note", !note.empty()},
                      {"varies", varies},
                      {"columns", ordered_json::array()},
                      {"rows", ordered_json::array()}};
    for (const TableLine& column : layout_.columns) grid["columns"].push_back(column.label);
    for (const TableLine& row : layout_.rows) {
      ordered_json cells = ordered_json::array();
      for (const TableLine& column : layout_.columns) cells.push_back(make_cell(row, column));
      grid["rows"].push_back({{"label", row.label}, {"cells", cells}});
    }
    document_[list].push_back(grid);
  }

  const JudgedTable& judged_;
  const PublishedTable& table_;
  const ClaimIndex& claims_;
  TableLayout layout_;
  bool hide_times_;
  ordered_json document_;
};

}  // namespace

ordered_json table_cell(const std::string& text, const std::string& interval) {
  return {{"text", text},
          {"interval", interval},
          {"has_interval", !interval.empty()},
          {"has_link", false},
          {"class", "number"}};
}

ordered_json table_document(const JudgedTable& judged, const ClaimIndex& claims,
                            bool without_varying) {
  return TableDocument(judged, claims, without_varying).build();
}

}  // namespace phytobench
