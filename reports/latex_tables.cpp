// SPDX-License-Identifier: MIT
#include "reports/latex_tables.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "reference/claim_bases.hpp"
#include "reports/document_errata_kinds.hpp"
#include "reports/judge/for_each_judgement.hpp"
#include "reports/latex_text.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

constexpr std::size_t longest_unbroken_label = 32;  // longer ones wrap

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789.-") == std::string::npos;
}

/// Digits behind the point of a plain number, its point included; nothing for any other text.
std::string tail_of(const std::string& text) {
  const std::size_t point = text.find('.');
  return is_number(text) && point != std::string::npos ? text.substr(point) : "";
}

/// Fills a column of numbers up with blanks of a digit's width, so that their points stand below
/// each other.
void align_points(std::vector<std::string>& column) {
  std::size_t longest = 0;
  for (const std::string& text : column) longest = std::max(longest, tail_of(text).size());
  for (std::string& text : column) {
    const bool aligned = is_number(text);
    const std::size_t tail = tail_of(text).size();
    std::string filler = aligned && tail == 0 && longest > 0 ? "." : "";
    if (aligned) filler += std::string(longest - tail - filler.size(), '0');
    text = latex_value(text);
    if (!filler.empty()) text += R"(\phantom{)" + filler + "}";
  }
}

/// A table of cells, which are plain texts, below headings over one or more columns each.
struct Grid {
  std::vector<std::string> row_labels;
  std::vector<std::string> headings;
  std::vector<std::string> subheadings;           ///< of the columns below each heading; may be one
  std::vector<std::vector<std::string>> columns;  ///< subheadings.size() per heading
};

std::string label_column(const std::vector<std::string>& labels) {
  const bool wraps = std::any_of(labels.begin(), labels.end(), [](const std::string& label) {
    return label.size() > longest_unbroken_label;
  });
  return wraps ? R"(p{0.4\linewidth})" : "l";
}

std::string headings_of(const Grid& grid) {
  const std::size_t width = grid.subheadings.size();
  std::string first, rules, second;
  for (std::size_t i = 0; i < grid.headings.size(); ++i) {
    const std::size_t from = 2 + i * width;
    first += width == 1 ? " & " + latex_text(grid.headings[i])
                        : fmt::format(R"( & \multicolumn{{{}}}{{c}}{{{}}})", width,
                                      latex_text(grid.headings[i]));
    rules += fmt::format(R"(\cmidrule(lr){{{}-{}}})", from, from + width - 1);
    for (const std::string& subheading : grid.subheadings) second += " & " + latex_text(subheading);
  }
  return width == 1 ? first + " \\\\\n" : first + " \\\\\n" + rules + "\n" + second + " \\\\\n";
}

std::string tabular(Grid grid) {
  for (std::vector<std::string>& column : grid.columns) align_points(column);
  std::string latex = fmt::format("\\begin{{tabular}}{{@{{}}{}{}@{{}}}}\n\\toprule\n{}\\midrule\n",
                                  label_column(grid.row_labels),
                                  std::string(grid.columns.size(), 'r'), headings_of(grid));
  for (std::size_t row = 0; row < grid.row_labels.size(); ++row) {
    latex += latex_text(grid.row_labels[row]);
    for (const std::vector<std::string>& column : grid.columns) latex += " & " + column[row];
    latex += " \\\\\n";
  }
  return latex + "\\bottomrule\n\\end{tabular}\n";
}

template <class Cell>
std::vector<std::string> column_of(const PublishedTable& table, const Cell& cell) {
  std::vector<std::string> column;
  for (std::size_t row = 0; row < table.rows.size(); ++row) column.push_back(cell(row));
  return column;
}

std::string head_comment(const PublishedTable& table, const std::string& what) {
  return fmt::format("% {}, {}: {}\n% Needs \\usepackage{{booktabs}}. Written by phytobench.\n",
                     table.paper, latex_text(table.title), what);
}

/// A part of the row above it.
std::string part_label(const std::string& kind) {
  return "of these: " + kind;
}

}  // namespace

std::string latex_table(const JudgedTable& judged, bool without_varying) {
  const PublishedTable& table = *judged.table;
  const bool shown_measured = judged.measured && !(judged.timed && without_varying);
  const std::string origin = table.origin == "derived" ? "derived" : "published";
  Grid grid{table.row_labels, table.column_labels, {origin}, {}};
  if (shown_measured) grid.subheadings.emplace_back("measured");
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    grid.columns.push_back(column_of(table, [&](auto r) { return shown(table.values[r][c]); }));
    if (!shown_measured) continue;
    grid.columns.push_back(column_of(table, [&](auto r) {
      const double value = judged.values[r][c].value;
      return judged.timed ? fmt::format("{:.4f}", value) : shown(value);
    }));
  }
  const std::string what = shown_measured ? origin + " beside measured" : origin + " alone";
  return head_comment(table, what) + tabular(std::move(grid));
}

std::string latex_share_table(const JudgedTable& judged, bool without_varying) {
  if (!judged.timed || !judged.measured || without_varying) return "";
  const PublishedTable& table = *judged.table;
  Grid grid{{}, table.column_labels, {"published", "measured"}, {}};
  grid.columns.resize(2 * table.columns.size());
  // Intervals stand below their values: beside them the table would be wider than a page.
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    grid.row_labels.insert(grid.row_labels.end(), {table.row_labels[row], ""});
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      const Estimate& share = judged.share[row][c];
      std::vector<std::string>&published = grid.columns[2 * c], &measured = grid.columns[2 * c + 1];
      published.insert(published.end(),
                       {fmt::format("{:.3f}", judged.published_share[row][c]), ""});
      measured.insert(measured.end(), {fmt::format("{:.3f}", share.value),
                                       fmt::format("[{:.3f}, {:.3f}]", share.low, share.high)});
    }
  }
  return head_comment(table,
                      "shares of the largest cell, 95 percent intervals, ranges where there are "
                      "fewer than six rounds") +
         tabular(std::move(grid));
}

std::string latex_counts(const JudgedRun& judged, bool without_varying) {
  std::map<std::string, std::map<std::string, std::size_t>> counts;
  for_each_judgement(judged, [&](const JudgedPaper& paper, const Judgement& judgement) {
    if (without_varying && judgement.varies) return;
    const std::string& basis = judgement.claim->basis;
    ++counts[std::string(row_of(judgement).name)][basis];
    if (const auto kind = kind_of_correction(paper, judgement, without_varying))
      ++counts[part_label(*kind)][basis];
  });
  Grid grid{{}, {"all"}, {""}, {}};
  grid.headings.insert(grid.headings.end(), claim_bases.begin(), claim_bases.end());
  grid.columns.resize(grid.headings.size());
  const auto add_row = [&](const std::string& label) {
    grid.row_labels.push_back(label);
    std::size_t all = 0;
    for (std::size_t b = 0; b < claim_bases.size(); ++b) {
      const std::size_t count = counts[label][std::string(claim_bases[b])];
      grid.columns[b + 1].push_back(std::to_string(count));
      all += count;
    }
    grid.columns[0].push_back(std::to_string(all));
  };
  for (const VerdictRow& row : verdict_rows()) {
    add_row(std::string(row.name));
    if (row.verdict != Verdict::reproduced_with_erratum) continue;
    for (const CorrectedClaims& kind : corrected_by_kind(judged.papers, without_varying))
      add_row(part_label(kind.kind));
  }
  return "% Number of claims by verdict and by what the verdict rests on.\n"
         "% Needs \\usepackage{booktabs}. Written by phytobench.\n" +
         tabular(std::move(grid));
}

}  // namespace phytobench
