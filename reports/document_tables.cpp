// SPDX-License-Identifier: MIT
#include "reports/document_tables.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_anchors.hpp"
#include "reports/document_numbers.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

std::string as_title(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

ordered_json estimate_cell(const Estimate& estimate, int decimals) {
  return table_cell(
      fmt::format("{:.{}f}", estimate.value, decimals),
      fmt::format("{:.{}f} to {:.{}f}", estimate.low, decimals, estimate.high, decimals));
}

class TableDocument {
 public:
  TableDocument(const JudgedTable& judged, const ClaimIndex& claims, bool without_varying)
      : judged_(judged), table_(*judged.table), claims_(claims), hide_times_(without_varying) {}

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
    add_grid(published ? "Published" : "Derived beforehand",
             published ? "as printed" : "with an independent program", false, [&](auto r, auto c) {
               return linked_cell(as_printed(table_.values[r][c]), claim_on(r, c), false);
             });
    if (visible) add_measured();
    if (published && has_claims()) add_verdicts();
    document_["companions"] = ordered_json::array();
    for (const JudgedCompanion& companion : judged_.companions)
      if (!companion.timed || !hide_times_) add_companion(companion);
    document_["has_companions"] = !document_["companions"].empty();
    return document_;
  }

 private:
  const ClaimLink* claim_on(std::size_t row, std::size_t column) const {
    return claims_.about(table_.measurement_at(row, column));
  }

  /// With as many decimals as the cell that has most: works print 11.0 beside 10.8.
  std::string as_printed(double value) const {
    std::size_t decimals = 0;
    for (const auto& row : table_.values)
      for (const double cell : row) {
        const std::string text = shown(cell);
        const std::size_t point = text.find('.');
        if (point != std::string::npos) decimals = std::max(decimals, text.size() - point - 1);
      }
    return decimals == 0 ? shown(value) : fmt::format("{:.{}f}", value, decimals);
  }

  bool has_claims() const {
    for (std::size_t row = 0; row < table_.rows.size(); ++row)
      for (std::size_t column = 0; column < table_.columns.size(); ++column)
        if (claim_on(row, column)) return true;
    return false;
  }

  void add_verdicts() {
    const bool varies = judged_.timed && !hide_times_;
    add_grid("Verdict", "on the claim about each cell", varies, [&](auto r, auto c) {
      const ClaimLink* const claim = claim_on(r, c);
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
      add_grid("Measured", "", false,
               [&](auto r, auto c) { return table_cell(shown(judged_.values[r][c].value)); });
      return;
    }
    add_grid("Measured", "seconds, median and its 95 % interval", true,
             [&](auto r, auto c) { return estimate_cell(judged_.values[r][c], 4); });
    add_grid("Published, relative", "to the slowest published cell", false, [&](auto r, auto c) {
      return table_cell(fmt::format("{:.3f}", judged_.published_share[r][c]));
    });
    add_grid("Measured, relative", "to the slowest measured cell, paired by round", true,
             [&](auto r, auto c) { return estimate_cell(judged_.share[r][c], 3); });
    if (judged_.published_per.empty()) return;
    add_grid("Published, per evaluation",
             "nanoseconds: printed seconds over the evaluations counted below", false,
             [&](auto r, auto c) {
               return table_cell(fmt::format("{:.0f}", 1e9 * judged_.published_per[r][c]));
             });
    add_grid("Measured, per evaluation", "nanoseconds", true, [&](auto r, auto c) {
      return table_cell(fmt::format("{:.2f}", 1e9 * judged_.measured_per[r][c]));
    });
  }

  void add_companion(const JudgedCompanion& companion) {
    add_grid(
        as_title(companion.name), companion.timed ? "median" : "exact count", companion.timed,
        [&](auto r, auto c) {
          const double value = companion.values[r][c].value;
          return table_cell(companion.timed ? fmt::format("{:.4f}", value) : with_thousands(value));
        },
        "companions");
  }

  template <class Cell>
  void add_grid(const std::string& title, const std::string& note, bool varies,
                const Cell& make_cell, const char* list = "grids") {
    ordered_json grid{{"title", title},
                      {"note", note},
                      {"has_note", !note.empty()},
                      {"varies", varies},
                      {"columns", table_.column_labels}};
    for (std::size_t row = 0; row < table_.rows.size(); ++row) {
      ordered_json cells = ordered_json::array();
      for (std::size_t column = 0; column < table_.columns.size(); ++column)
        cells.push_back(make_cell(row, column));
      grid["rows"].push_back({{"label", table_.row_labels[row]}, {"cells", cells}});
    }
    document_[list].push_back(grid);
  }

  const JudgedTable& judged_;
  const PublishedTable& table_;
  const ClaimIndex& claims_;
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
