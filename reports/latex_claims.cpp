// SPDX-License-Identifier: MIT
#include "reports/latex_claims.hpp"

#include <fmt/format.h>

#include "reports/document_claims.hpp"
#include "reports/document_intervals.hpp"
#include "reports/document_measured.hpp"
#include "reports/latex_files.hpp"
#include "reports/latex_tables.hpp"
#include "reports/latex_text.hpp"
#include "reports/run_limits.hpp"

namespace phytobench {

namespace {

constexpr const char* table_head =
    R"(% Needs \usepackage{booktabs,longtable}. Written by phytobench.
\begin{longtable}{@{}p{0.33\linewidth}p{0.13\linewidth}p{0.16\linewidth}p{0.16\linewidth}p{0.12\linewidth}@{}}
\toprule
Claim & Place & Published & Measured & Verdict \tabularnewline
\midrule
\endhead
\bottomrule
\endfoot
)";

constexpr const char* macro_head = R"(% Numbers of phytobench by claim. Needs no package:
%   \input{claims}
%   measured \phytobenchclaim{ID}, published \phytobenchpublished{ID},
%   \phytobenchverdict{ID} (\phytobenchbasis{ID})
% An id that does not exist stops LaTeX, so that a text cannot drift from its run.
\makeatletter
\def\phytobench@get#1#2{\ifcsname phytobench@#1@#2\endcsname
  \csname phytobench@#1@#2\endcsname
  \else\PackageError{phytobench}{There is no claim '#2' in this run}{Compare the id with
  claims.csv.}\fi}
\def\phytobench@set#1#2#3#4#5{%
  \expandafter\gdef\csname phytobench@measured@#1\endcsname{#2}%
  \expandafter\gdef\csname phytobench@published@#1\endcsname{#3}%
  \expandafter\gdef\csname phytobench@verdict@#1\endcsname{#4}%
  \expandafter\gdef\csname phytobench@basis@#1\endcsname{#5}}
\DeclareRobustCommand*\phytobenchclaim[1]{\phytobench@get{measured}{#1}}
\DeclareRobustCommand*\phytobenchpublished[1]{\phytobench@get{published}{#1}}
\DeclareRobustCommand*\phytobenchverdict[1]{\phytobench@get{verdict}{#1}}
\DeclareRobustCommand*\phytobenchbasis[1]{\phytobench@get{basis}{#1}}
)";

std::string cell(const std::string& latex) {
  return R"(\raggedright )" + latex;
}

/// A number that is the whole published text is set as one; the unit follows it.
std::string published_text(const Claim& claim) {
  const std::string unit = published_with_unit(claim).substr(claim.published.size());
  return latex_value(claim.published) + latex_text(unit);
}

std::string verdict_text(const Judgement& judgement, bool hidden) {
  return hidden ? left_out_row : std::string(label_of(judgement.verdict));
}

std::string claim_row(const Judgement& judgement, bool hidden) {
  const Claim& claim = *judgement.claim;
  return fmt::format("{} {} &\n{} & {} & {} & {} ({}) \\tabularnewline\n",
                     cell(latex_text(claim.text)), latex_id(claim.id),
                     cell(latex_text(claim.locator)), cell(published_text(claim)),
                     cell(hidden ? "" : latex_value(shown_measured(judgement))),
                     cell(latex_text(verdict_text(judgement, hidden))), latex_text(claim.basis));
}

std::string macro_line(const Judgement& judgement, bool hidden) {
  const Claim& claim = *judgement.claim;
  const std::string verdict = latex_text(verdict_text(judgement, hidden));
  const std::string measured =
      hidden || judgement.measured.empty() ? "(" + verdict + ")" : latex_value(judgement.measured);
  return fmt::format("\\phytobench@set{{{}}}{{{}}}{{{}}}{{{}}}{{{}}}\n", claim.id, measured,
                     published_text(claim), verdict, latex_text(claim.basis));
}

/// Below the claims of a run that is not whole: tables travel without their report.
std::string incomplete_row(const std::string& text) {
  return text.empty() ? "" : "\\midrule\n" + cell(latex_text(text)) + " & & & & \\tabularnewline\n";
}

std::string incomplete_section(const std::string& text) {
  return text.empty() ? "" : "\\section*{Incomplete}\n" + latex_text(text) + "\n";
}

std::string limits_section(const JudgedRun& judged, bool without_varying) {
  std::string latex = "\\clearpage\\section*{What this run cannot tell}\n";
  for (const std::string& limit : run_limits(judged, without_varying))
    latex += latex_text(limit) + "\n\n";
  return latex;
}

std::string captioned(const std::string& file, const std::string& caption) {
  return fmt::format(
      "\\begin{{table}}[htbp]\\centering\\small\\setlength{{\\tabcolsep}}{{3pt}}\n"
      "\\caption{{{}}}\n\\input{{{}}}\n\\end{{table}}\n",
      caption, file);
}

}  // namespace

std::string latex_claim_table(const JudgedPaper& paper, bool without_varying,
                              const std::string& incomplete) {
  std::string latex = fmt::format("% All claims of {}.\n", paper.paper.key) + table_head;
  for (const Judgement& judgement : paper.judgements)
    latex += claim_row(judgement, without_varying && judgement.varies);
  return latex + incomplete_row(incomplete) + "\\end{longtable}\n";
}

std::string latex_claim_macros(const JudgedRun& judged, bool without_varying) {
  std::string latex = macro_head;
  if (const std::string text = incompleteness(judged); !text.empty()) latex += "% " + text + "\n";
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements)
      latex += macro_line(judgement, without_varying && judgement.varies);
  return latex + "\\makeatother\n";
}

std::string latex_wrapper(const JudgedRun& judged, bool without_varying) {
  std::string latex =
      "% Every table of this report in one document: pdflatex all.tex\n"
      "\\documentclass[a4paper]{article}\n\\usepackage[margin=18mm]{geometry}\n\\usepackage{"
      "booktabs,longtable}\n"
      "\\begin{document}\n\\input{claims}\n" +
      incomplete_section(incompleteness(judged)) +
      captioned("counts", "Claims by verdict and basis.");
  for (const JudgedPaper& paper : judged.papers) {
    latex += fmt::format("\\clearpage\\section*{{{} {}}}\n", latex_text(paper.paper.author),
                         latex_text(paper.paper.year));
    for (const JudgedTable& table : paper.tables) {
      const std::string caption = latex_text(table.table->title) + ".";
      latex += captioned(latex_table_name(*table.table), caption);
      if (!latex_share_table(table, without_varying).empty())
        latex += captioned(latex_table_name(*table.table) + "-shares",
                           caption + " Shares of the largest cell; below each its " +
                               latex_text(ends_of_medians) + ".");
    }
    latex += fmt::format("{{\\footnotesize\\input{{claims-{}}}}}\n", paper.paper.key);
  }
  return latex + limits_section(judged, without_varying) + "\\end{document}\n";
}

}  // namespace phytobench
