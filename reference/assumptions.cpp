// SPDX-License-Identifier: MIT
#include "reference/assumptions.hpp"

#include <filesystem>
#include <set>

#include <fmt/format.h>

#include "reference/data_folder.hpp"
#include "reference/toml_table.hpp"

namespace phytobench {

namespace {

Assumption assumption_from(const TomlTable& table) {
  table.allow_only({"id", "locator", "question", "reading", "alternatives", "claims"});
  Assumption assumption{.id = table.text("id"),
                        .locator = table.text("locator"),
                        .question = table.text("question"),
                        .reading = table.text("reading"),
                        .alternatives = table.text("alternatives"),
                        .claims = table.texts("claims")};
  if (assumption.claims.empty())
    table.fail(fmt::format("assumption '{}' names no claim that rests on it", assumption.id));
  return assumption;
}

}  // namespace

std::vector<Assumption> load_assumptions(const std::string& paper) {
  const std::filesystem::path file = paper_folder(paper) / "assumptions.toml";
  std::vector<Assumption> assumptions;
  if (!std::filesystem::exists(file)) return assumptions;
  const TomlTable root = TomlTable::read(file.string());
  root.allow_only({"assumption"});
  std::set<std::string> ids;
  for (const TomlTable& table : root.tables("assumption")) {
    assumptions.push_back(assumption_from(table));
    if (!ids.insert(assumptions.back().id).second)
      table.fail(fmt::format("assumption '{}' stands here twice", assumptions.back().id));
  }
  return assumptions;
}

}  // namespace phytobench
