// SPDX-License-Identifier: MIT
#include "reports/document_tables.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

/// Two cells, of which the first has a claim.
struct TwoCells {
  PublishedTable table;
  Claim claim;
  JudgedTable judged;
  ClaimIndex claims;

  TwoCells() {
    table.id = "table-1";
    table.paper = "b";
    table.origin = "published";
    table.rows = table.row_labels = {"r"};
    table.columns = table.column_labels = {"s", "d"};
    table.measurement = "b/table-1/{row}.{column}/edges";
    table.values = {{10.8, 11.0}};
    claim.id = "b/table-1/r.s";
    claim.locator = "Table 1";
    claims = ClaimIndex({{.claim = &claim, .verdict = Verdict::not_comparable}}, false);
    judged = {.table = &table, .measured = true, .values = {{{10.8}, {12.0}}}};
  }
  nlohmann::ordered_json grids() const { return table_document(judged, claims, false)["grids"]; }
};

TEST(TableDocument, ShowsPublishedCellsWithTheirPrintedDecimals) {
  const auto published = TwoCells().grids()[0];
  EXPECT_EQ(published["rows"][0]["cells"][0]["text"], "10.8");
  EXPECT_EQ(published["rows"][0]["cells"][1]["text"], "11.0");
}

TEST(TableDocument, LeadsFromACellToItsClaimAndSaysItsVerdict) {
  const auto grids = TwoCells().grids();
  EXPECT_EQ(grids[0]["rows"][0]["cells"][0]["link"], "claim-b-table-1-r-s");
  EXPECT_EQ(grids[0]["rows"][0]["cells"][1]["has_link"], false);
  const auto& verdicts = grids.back();
  EXPECT_EQ(verdicts["title"], "Verdict");
  EXPECT_EQ(verdicts["rows"][0]["cells"][0]["text"], "not comparable");
  EXPECT_EQ(verdicts["rows"][0]["cells"][1]["text"], "no claim of its own");
}

TEST(TableDocument, HasNoGridOfVerdictsForDerivedTables) {
  TwoCells cells;
  cells.table.origin = "derived";
  EXPECT_EQ(cells.grids().size(), 2u);
}

TEST(TableDocument, KeepsWorkBehindTheCellsApart) {
  TwoCells cells;
  cells.judged.companions = {{"kill_evaluations", false, {{{1234.0}, {5.0}}}}};
  const auto document = table_document(cells.judged, cells.claims, false);
  ASSERT_EQ(document["companions"].size(), 1u);
  EXPECT_EQ(document["companions"][0]["title"], "Kill evaluations");
  EXPECT_EQ(document["companions"][0]["rows"][0]["cells"][0]["text"], "1,234");
}

}  // namespace
}  // namespace phytobench
