// SPDX-License-Identifier: MIT
#include "reference/errata.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "reference/data_folder.hpp"
#include "reference/toml_table.hpp"

namespace phytobench {

namespace {

constexpr ErratumKind all_kinds[] = {ErratumKind::formula,      ErratumKind::number,
                                     ErratumKind::missing_case, ErratumKind::wording,
                                     ErratumKind::bookkeeping,  ErratumKind::program};

std::optional<ErratumKind> kind_from(const TomlTable& table) {
  if (!table.has("kind")) return std::nullopt;
  const std::string word = table.text("kind");
  for (const ErratumKind kind : all_kinds)
    if (name_of(kind) == word) return kind;
  table.fail(
      "'kind' must be formula, number, missing case, wording, bookkeeping or differs from the "
      "program");
}

CounterExample counter_example_from(const TomlTable& table) {
  table.allow_only({"oracle", "arguments", "inputs", "result", "printed", "corrected", "tolerance",
                    "tolerance_reason", "why"});
  CounterExample example{.oracle = table.text("oracle"),
                         .arguments = table.numbers("arguments"),
                         .inputs = {},
                         .result = table.text_or("result", ""),
                         .printed = table.number_if_given("printed"),
                         .corrected = table.number("corrected"),
                         .tolerance = table.number("tolerance"),
                         .why = table.text("why"),
                         .tolerance_reason = table.text_or("tolerance_reason", "")};
  if (table.has("inputs")) example.inputs = table.texts("inputs");
  if (!example.inputs.empty() && example.inputs.size() != example.arguments.size())
    table.fail(fmt::format("'inputs' has {} names for {} arguments", example.inputs.size(),
                           example.arguments.size()));
  return example;
}

Erratum erratum_from(const TomlTable& table, const std::string& paper) {
  table.allow_only({"id", "section", "locator", "kind", "printed", "corrected", "consequence",
                    "check", "confidence", "claims", "counter_example"});
  Erratum erratum{.id = table.text("id"),
                  .paper = paper,
                  .section = table.text_or("section", ""),
                  .locator = table.text("locator"),
                  .kind = kind_from(table),
                  .printed = table.text("printed"),
                  .corrected = table.text("corrected"),
                  .consequence = table.text("consequence"),
                  .check = table.text_or("check", ""),
                  .confidence = table.text("confidence"),
                  .claims = table.texts("claims"),
                  .counter_example = std::nullopt};
  if (erratum.confidence != "certain" && erratum.confidence != "probable")
    table.fail("'confidence' must be certain or probable");
  if (table.has("counter_example"))
    erratum.counter_example = counter_example_from(table.table("counter_example"));
  return erratum;
}

/// The parts of "2.4.3" or "A" as numbers that compare like the sections do.
std::vector<int> parts_of(const std::string& section) {
  constexpr int after_chapters = 1000, unknown = 2000;
  std::vector<int> parts;
  for (const char c : section) {
    if (c == '.' || parts.empty()) parts.push_back(0);
    if (c >= '0' && c <= '9') parts.back() = 10 * parts.back() + (c - '0');
    if (c >= 'A' && c <= 'Z') parts.back() = after_chapters + (c - 'A');
  }
  if (parts.empty()) parts.push_back(unknown);
  return parts;
}

}  // namespace

std::string name_of(ErratumKind kind) {
  switch (kind) {
    case ErratumKind::formula:
      return "formula";
    case ErratumKind::number:
      return "number";
    case ErratumKind::missing_case:
      return "missing case";
    case ErratumKind::wording:
      return "wording";
    case ErratumKind::bookkeeping:
      return "bookkeeping";
    case ErratumKind::program:
      return "differs from the program";
  }
  return "";
}

std::vector<Erratum> load_errata(const std::string& paper) {
  std::vector<Erratum> errata;
  std::set<std::string> ids;
  for (const std::filesystem::path& file : paper_files(paper, "errata"))
    for (const TomlTable& table : TomlTable::read(file).tables("erratum")) {
      errata.push_back(erratum_from(table, paper));
      if (!ids.insert(errata.back().id).second)
        table.fail(fmt::format("erratum '{}' stands here twice", errata.back().id));
    }
  return errata;
}

bool section_is_before(const std::string& a, const std::string& b) {
  return parts_of(a) < parts_of(b);
}

}  // namespace phytobench
