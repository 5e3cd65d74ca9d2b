// SPDX-License-Identifier: MIT
#include "reports/document_tables.hpp"

#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "reference/claims.hpp"
#include "reference/papers.hpp"

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

TEST(TableDocument, ShowsPublishedCellsWithTheirPrintedDigits) {
  TwoCells cells;
  cells.table.values = {{11.0, 11.0}};
  cells.claim.digits = 3;
  cells.claims = ClaimIndex({{.claim = &cells.claim}}, false);
  const auto published = cells.grids()[0];
  EXPECT_EQ(published["rows"][0]["cells"][0]["text"], "11.0") << "three digits are printed";
  EXPECT_EQ(published["rows"][0]["cells"][1]["text"], "11") << "nothing is known of its digits";
}

/// A digit too few in a claim would round what is printed.
TEST(TableDocument, LosesNoDigitOfAPrintedTable) {
  for (const std::string& paper : paper_keys()) {
    const PaperClaims loaded = load_claims(paper);
    std::vector<Judgement> judgements;
    for (const Claim& claim : loaded.claims) judgements.push_back({.claim = &claim});
    const ClaimIndex index(judgements, false);
    for (const PublishedTable& table : loaded.tables) {
      if (table.origin != "published") continue;
      const auto printed = table_document({.table = &table}, index, false)["grids"][0];
      for (std::size_t row = 0; row < table.rows.size(); ++row)
        for (std::size_t column = 0; column < table.columns.size(); ++column) {
          const std::string label = table.row_labels[row];
          const auto& rows = printed["rows"];
          const auto shown = std::find_if(rows.begin(), rows.end(),
                                          [&](const auto& r) { return r["label"] == label; });
          ASSERT_NE(shown, rows.end()) << label;
          EXPECT_EQ(std::stod((*shown)["cells"][column]["text"].get<std::string>()),
                    table.values[row][column])
              << table.id << ", " << label;
        }
    }
  }
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

/// A table like the thesis' appendix, with a row and a column that only claims name.
struct MoreClaimsThanCells {
  PublishedTable table;
  std::vector<Claim> claims;

  MoreClaimsThanCells() {
    table.id = "appendix";
    table.paper = "b";
    table.origin = "published";
    table.rows = {"figure-1", "figure-3"};
    table.row_labels = {"Figure 1", "Figure 3"};
    table.columns = {"edges"};
    table.column_labels = {"Edges"};
    table.measurement = "b/appendix/{row}/{column}";
    table.values = {{10.0}, {30.0}};
    for (const char* id :
         {"fig-1.edges", "fig-1.seconds", "fig-2.edges", "fig-2.seconds", "fig-3.edges", "model"}) {
      Claim& claim = claims.emplace_back();
      claim.id = std::string("b/appendix/") + id;
      claim.locator = "appendix table";
      claim.published = "1,3";
    }
  }
  nlohmann::ordered_json grids() const {
    std::vector<Judgement> judgements;
    for (const Claim& claim : claims)
      judgements.push_back({.claim = &claim, .verdict = Verdict::not_comparable});
    JudgedTable judged{.table = &table, .measured = true};
    for (const double value : {10.0, 30.0})
      judged.values.emplace_back().emplace_back().value = value;
    return table_document(judged, ClaimIndex(judgements, false), false)["grids"];
  }
};

TEST(TableDocument, HasTheRowsAndColumnsThatOnlyClaimsName) {
  const auto grids = MoreClaimsThanCells().grids();
  ASSERT_EQ(grids.size(), 3u);
  for (const auto& grid : grids) {
    EXPECT_EQ(grid["columns"], nlohmann::ordered_json::array({"Edges", "Seconds"}));
    ASSERT_EQ(grid["rows"].size(), 3u);
    EXPECT_EQ(grid["rows"][1]["label"], "Figure 2") << "between its neighbours";
  }
  const auto cell = [&](std::size_t grid, std::size_t row, std::size_t column) {
    return grids[grid]["rows"][row]["cells"][column]["text"].get<std::string>();
  };
  EXPECT_EQ(cell(0, 1, 1), "1.3") << "as printed, with our decimal point";
  EXPECT_EQ(cell(0, 2, 0), "30");
  EXPECT_EQ(cell(0, 2, 1), "") << "no claim says what is printed there";
  EXPECT_EQ(cell(1, 1, 0), "-");
  EXPECT_EQ(cell(1, 2, 0), "30");
  EXPECT_EQ(cell(2, 1, 1), "not comparable");
}

TEST(TableDocument, IsAsPrintedWhereCellsHaveOtherNames) {
  MoreClaimsThanCells of;
  of.table.measurement = "b/appendix/{row}.{column}/count";
  EXPECT_EQ(of.grids()[0]["rows"].size(), 2u);
}

}  // namespace
}  // namespace phytobench
