// SPDX-License-Identifier: MIT
#include "reports/latex_text.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/latex_checker.hpp"

namespace phytobench {
namespace {

using testing::IsEmpty;

TEST(LatexText, EscapesWhatIsLatexsOwn) {
  EXPECT_EQ(latex_text(R"(50 % of a_1 & b#2 cost $3)"), R"(50 \% of a\_1 \& b\#2 cost \$3)");
  EXPECT_EQ(latex_text(R"({\x}^2~)"),
            R"(\{\textbackslash{}x\}\textasciicircum{}2\textasciitilde{})");
  EXPECT_EQ(latex_text("a < b > c | d"), R"(a \textless{} b \textgreater{} c \textbar{} d)");
}

TEST(LatexText, KeepsSignsApartThatWouldGrowTogether) {
  EXPECT_EQ(latex_text("a--b"), "a{-}{-}b");
  EXPECT_EQ(latex_text("?`"), "?{`}");
}

TEST(LatexText, GuardsWhatAfterARowWouldStartAnArgument) {
  EXPECT_EQ(latex_text("[1, 2]"), "{[}1, 2{]}");
  EXPECT_EQ(latex_text("* or +"), "{*} or +");
}

TEST(LatexText, OpensAndClosesQuotes) {
  EXPECT_EQ(latex_text(R"("ours" ("a"))"), "{``}ours{''} ({``}a{''})");
}

TEST(LatexText, WritesLettersBeyondAsciiAsCommands) {
  EXPECT_EQ(latex_text("Bäume ≤ 2 × π"),
            R"(B{\"a}ume \ensuremath{\leq} 2 \ensuremath{\times} \ensuremath{\pi})");
  EXPECT_EQ(latex_text("一😀"), "U+4E00U+1F600");
  EXPECT_EQ(latex_text("cut \xC3"), "cut U+00C3") << "a broken letter is no reason to fail";
}

TEST(LatexText, KeepsOneLineOneParagraph) {
  EXPECT_EQ(latex_text("a\n\nb\tc"), "a  b c");
}

TEST(LatexValue, SetsNumbersWithSignOrExponentAsMathematics) {
  EXPECT_EQ(latex_value("2243"), "2243");
  EXPECT_EQ(latex_value("-1.5"), "$-1.5$");
  EXPECT_EQ(latex_value("1e-06"), R"($1\times 10^{-6}$)");
  EXPECT_EQ(latex_value("2.5e+10"), R"($2.5\times 10^{10}$)");
  EXPECT_EQ(latex_value("1e+00"), R"($1\times 10^{0}$)");
  EXPECT_EQ(latex_value("1e-06 m"), "1e{-}06 m") << "no number";
  EXPECT_EQ(latex_value("nan"), "nan");
}

TEST(LatexId, MayBreakAfterSlashesAndHyphens) {
  EXPECT_EQ(latex_id("p/eq-1"), R"(\texttt{p/\allowbreak{}eq{-}\allowbreak{}1})");
}

TEST(LatexTextLaw, NoCharacterBreaksATable) {
  for (int c = 1; c < 128; ++c) {
    for (const char* around : {"", " ", "x", "-", "\""}) {
      const std::string text = around + std::string(1, static_cast<char>(c)) + around;
      const std::string row = latex_text(text) + " & " + latex_value(text) + " \\\\\n";
      const std::string table = "\\begin{tabular}{ll}\n" + row + row + "\\end{tabular}\n";
      EXPECT_THAT(LatexChecker::problems_of(table), IsEmpty()) << text;
    }
  }
}

// The checker itself.

TEST(LatexChecker, AcceptsATable) {
  EXPECT_THAT(LatexChecker::problems_of("\\begin{tabular}{@{}lr@{}}\n\\toprule\na & "
                                        "\\multicolumn{1}{c}{b} \\\\\n\\cmidrule(lr){2-2}\n"
                                        "$x_1$ & \\phantom{.00} \\\\ % 1 & 2 & 3\n"
                                        "\\bottomrule\n\\end{tabular}\n"),
              IsEmpty());
}

TEST(LatexChecker, FindsEveryMistake) {
  const std::string broken[] = {
      "{",
      "}",
      "$x",
      "a_b",
      "a^b",
      "a # b",
      "ä",
      "a < b",
      "say \"x\"",
      "\\undefined",
      "a & b",
      "\\begin{tabular}{lr} a & b \\\\",
      "\\begin{tabular}{lr} a & b \\end{tabular}",
      "\\begin{tabular}{lr} a \\\\ \\end{tabular}",
      "\\begin{tabular}{lr} a & b & c \\\\ \\end{tabular}",
      "\\begin{tabular}{lr} \\multicolumn{2}{c}{a} & b \\\\ \\end{tabular}",
      "\\begin{tabular}{lr} {a & b} \\\\ \\end{tabular}",
      "\\begin{tabular}{lr} a & b \\\\ [c] & d \\\\ \\end{tabular}",
      "\\begin{tabular}{lr} a \\midrule & b \\\\ \\end{tabular}",
      "\\begin{tabular}{lr} a & b \\\\ \\cmidrule(lr){2-3} \\end{tabular}",
      "\\begin{tabular}{lr} a & b \\\\ \\end{longtable}",
      "\\begin{figure} a \\end{figure}",
      "\\toprule",
      "\\phytobench@set{a%b}{1}",
  };
  for (const std::string& latex : broken)
    EXPECT_THAT(LatexChecker::problems_of(latex), Not(IsEmpty())) << latex;
}

}  // namespace
}  // namespace phytobench
