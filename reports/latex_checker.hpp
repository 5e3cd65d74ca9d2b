// SPDX-License-Identifier: MIT
// For tests: a strict reading of the LaTeX that the reports write, with no TeX at hand. It knows
// the few commands that are written and takes everything else for a mistake.
#pragma once

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

class LatexChecker {
 public:
  /// What is wrong with a text; empty if nothing.
  static std::vector<std::string> problems_of(std::string_view latex) {
    LatexChecker checker(latex);
    checker.read_all();
    return checker.problems_;
  }

 private:
  explicit LatexChecker(std::string_view text) : text_(text) {}

  struct Environment {
    std::string name;
    std::size_t columns = 0;  ///< of a table; 0: none
    std::size_t cells = 1;    ///< of the row so far
    bool has_content = false;
  };

  void read_all() {
    while (!text_.empty()) read_one();
    expect(braces_ == 0, "braces do not match");
    expect(!mathematics_, "mathematics stays open");
    expect(environments_.empty(), "an environment stays open");
  }

  void read_one() {
    const char c = take();
    if (c == '\\') return read_command();
    if (c == '%') return skip_comment();
    if (std::isspace(static_cast<unsigned char>(c))) return;
    if (c == '{') return read_open();
    if (c == '}') return read_close();
    if (c == '&') return read_cell_end();
    mark_content();
    if (c == '$') mathematics_ = !mathematics_;
    if (c == '^' || c == '_') expect(mathematics(), std::string("bare ") + c);
    if (c == '#') expect(!text_.empty() && std::isdigit(text_.front()) != 0, "bare #");
    expect(static_cast<unsigned char>(c) < 0x80, "a letter beyond ASCII");
    expect(c != '"' && c != '<' && c != '>' && c != '|', std::string("bare ") + c);
  }

  char take() {
    const char c = text_.front();
    text_.remove_prefix(1);
    return c;
  }

  void expect(bool holds, const std::string& problem) {
    if (!holds) problems_.push_back(problem + " before '" + std::string(text_.substr(0, 30)) + "'");
  }

  bool mathematics() const { return mathematics_ || mathematics_braces_ > 0; }

  void mark_content() {
    if (!environments_.empty()) environments_.back().has_content = true;
  }

  void skip_comment() { text_.remove_prefix(std::min(text_.find('\n'), text_.size())); }

  void read_open() {
    ++braces_;
    if (mathematics_braces_ > 0) ++mathematics_braces_;
  }

  void read_close() {
    expect(braces_ > 0, "a brace closes nothing");
    --braces_;
    if (mathematics_braces_ > 0) --mathematics_braces_;
  }

  std::string take_group() {
    if (!text_.starts_with('{')) {
      expect(false, "an argument is missing");
      return "";
    }
    std::string group;
    int depth = 0;
    do {
      const char c = take();
      depth += c == '{' ? 1 : c == '}' ? -1 : 0;
      group += c;
    } while (depth > 0 && !text_.empty());
    return group.substr(1, group.size() - 2);
  }

  void read_command() {
    std::string name;
    while (!text_.empty() && (std::isalpha(text_.front()) != 0 || text_.front() == '@'))
      name += take();
    if (name.empty() && !text_.empty()) name = take();
    if (name == "\\" || name == "tabularnewline") return read_row_end();
    if (name == "begin") return read_begin();
    if (name == "end") return read_end();
    if (is_rule(name)) return read_rule(name);
    if (name == "multicolumn") return read_multicolumn();
    mark_content();
    expect(known().contains(name), "unknown command \\" + name);
    if (name == "phytobench@set" && !text_.starts_with('#')) return expect_id(take_group());
    if (name == "ensuremath" && text_.starts_with('{')) {
      take();
      ++braces_;
      mathematics_braces_ = 1;
    }
  }

  /// It becomes part of a command's name, where only letters without a meaning of their own may be.
  void expect_id(const std::string& id) {
    expect(id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789./_-") == std::string::npos,
           "an id that is none: " + id);
  }

  static bool is_rule(const std::string& name) {
    return name == "toprule" || name == "midrule" || name == "bottomrule" || name == "cmidrule" ||
           name == "endhead" || name == "endfoot";
  }

  void read_rule(const std::string& name) {
    expect(!environments_.empty() && environments_.back().columns > 0, "a rule outside a table");
    if (environments_.empty()) return;
    expect(!environments_.back().has_content, "a rule inside a row");
    if (name != "cmidrule") return;
    if (text_.starts_with("(lr)")) text_.remove_prefix(4);
    const std::string range = take_group();
    const std::size_t dash = range.find('-');
    expect(dash != std::string::npos && std::stoul(range) <= std::stoul(range.substr(dash + 1)) &&
               std::stoul(range.substr(dash + 1)) <= environments_.back().columns,
           "a rule beyond the table");
  }

  void read_multicolumn() {
    const std::string width = take_group();
    const std::string format = take_group();
    expect(format == "c" || format == "l" || format == "r", "format of \\multicolumn");
    expect(!environments_.empty() && environments_.back().columns > 0, "cells outside a table");
    if (environments_.empty()) return;
    environments_.back().cells += std::stoul(width) - 1;
    mark_content();
  }

  void read_begin() {
    Environment environment{.name = take_group()};
    if (environment.name == "tabular" || environment.name == "longtable")
      environment.columns = column_count(take_group());
    else
      expect(environment.name == "table" || environment.name == "document",
             "unknown environment " + environment.name);
    environments_.push_back(environment);
  }

  void read_end() {
    const std::string name = take_group();
    expect(!environments_.empty() && environments_.back().name == name, "\\end{" + name + "}");
    if (environments_.empty()) return;
    if (environments_.back().columns > 0)
      expect(!environments_.back().has_content, "a row has no end");
    environments_.pop_back();
  }

  void read_cell_end() {
    expect(!environments_.empty() && environments_.back().columns > 0, "& outside a table");
    expect(braces_ == 0, "& inside braces");
    if (environments_.empty()) return;
    ++environments_.back().cells;
    environments_.back().has_content = true;
  }

  void read_row_end() {
    expect(!environments_.empty() && environments_.back().columns > 0, "a row outside a table");
    if (environments_.empty()) return;
    Environment& table = environments_.back();
    expect(table.cells == table.columns, std::to_string(table.cells) + " cells in a table of " +
                                             std::to_string(table.columns) + " columns");
    table.cells = 1;
    table.has_content = false;
    while (!text_.empty() && std::isspace(static_cast<unsigned char>(text_.front()))) take();
    expect(!text_.starts_with('[') && !text_.starts_with('*'), "a row starts with an argument");
  }

  static std::size_t column_count(const std::string& format) {
    std::size_t count = 0;
    int depth = 0;
    for (const char c : format) {
      depth += c == '{' ? 1 : c == '}' ? -1 : 0;
      count += depth == 0 && (c == 'l' || c == 'r' || c == 'c' || c == 'p');
    }
    return count;
  }

  static const std::set<std::string>& known() {
    static const std::set<std::string> names = {
        // Characters.
        "{", "}", "#", "$", "%", "&", "_", "\"", "'", "`", "ss", "S", "ldots", "textbackslash",
        "textasciicircum", "textasciitilde", "textless", "textgreater", "textbar",
        // Mathematics.
        "ensuremath", "circ", "pm", "times", "cdot", "div", "leq", "geq", "neq", "approx", "propto",
        "infty", "surd", "sum", "in", "rightarrow", "alpha", "beta", "gamma", "delta", "Delta",
        "varepsilon", "eta", "theta", "kappa", "lambda", "mu", "nu", "pi", "rho", "sigma", "Sigma",
        "tau", "varphi", "omega", "Omega",
        // Layout.
        "texttt", "allowbreak", "phantom", "raggedright", "linewidth", "centering", "small",
        "footnotesize", "setlength", "tabcolsep", "caption", "input", "clearpage", "section",
        "documentclass", "usepackage",
        // Definitions of claims.tex.
        "makeatletter", "makeatother", "def", "gdef", "csname", "endcsname", "ifcsname", "else",
        "fi", "expandafter", "PackageError", "DeclareRobustCommand", "phytobench@get",
        "phytobench@set", "phytobenchclaim", "phytobenchpublished", "phytobenchverdict",
        "phytobenchbasis"};
    return names;
  }

  std::string_view text_;
  std::vector<std::string> problems_;
  std::vector<Environment> environments_;
  int braces_ = 0;
  int mathematics_braces_ = 0;  ///< depth inside \ensuremath
  bool mathematics_ = false;
};

}  // namespace phytobench
