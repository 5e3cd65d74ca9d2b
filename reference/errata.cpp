// SPDX-License-Identifier: MIT
#include "reference/errata.hpp"

#include "reference/data_folder.hpp"
#include "reference/toml_table.hpp"

namespace phytobench {

namespace {

CounterExample counter_example_from(const TomlTable& table) {
  table.allow_only({"oracle", "arguments", "printed", "corrected", "tolerance", "why"});
  return {.oracle = table.text("oracle"),
          .arguments = table.numbers("arguments"),
          .printed = table.number_if_given("printed"),
          .corrected = table.number("corrected"),
          .tolerance = table.number("tolerance"),
          .why = table.text("why")};
}

Erratum erratum_from(const TomlTable& table, const std::string& paper) {
  table.allow_only({"id", "locator", "printed", "corrected", "consequence", "confidence", "claims",
                    "counter_example"});
  Erratum erratum{.id = table.text("id"),
                  .paper = paper,
                  .locator = table.text("locator"),
                  .printed = table.text("printed"),
                  .corrected = table.text("corrected"),
                  .consequence = table.text("consequence"),
                  .confidence = table.text("confidence"),
                  .claims = table.texts("claims"),
                  .counter_example = std::nullopt};
  if (erratum.confidence != "certain" && erratum.confidence != "probable")
    table.fail("'confidence' must be certain or probable");
  if (table.has("counter_example"))
    erratum.counter_example = counter_example_from(table.table("counter_example"));
  return erratum;
}

}  // namespace

std::vector<Erratum> load_errata(const std::string& paper) {
  std::vector<Erratum> errata;
  for (const std::filesystem::path& file : paper_files(paper, "errata"))
    for (const TomlTable& table : TomlTable::read(file).tables("erratum"))
      errata.push_back(erratum_from(table, paper));
  return errata;
}

}  // namespace phytobench
