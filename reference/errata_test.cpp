// SPDX-License-Identifier: MIT
#include "reference/errata.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "reference/errata_oracles.hpp"
#include "reference/papers.hpp"

namespace phytobench {
namespace {

/// All of them.
const OracleTable& oracles_by_name() {
  static const OracleTable oracles = [] {
    OracleTable all;
#define ERRATA_ORACLES(name) all.merge(name##_oracles());
#include "reference/errata_oracles.def"
#undef ERRATA_ORACLES
    return all;
  }();
  return oracles;
}

/// Empty if the oracles give what the counter-example says, else what is wrong with it.
std::string objection(const std::string& paper, const CounterExample& example) {
  const auto found = oracles_by_name().find(paper + "/" + example.oracle);
  if (found == oracles_by_name().end()) return "unknown oracle " + example.oracle;
  const OraclePair& oracle = found->second;
  if (example.arguments.size() != oracle.arguments) return "wrong number of arguments";
  if (!(example.tolerance >= 0.0)) return "no tolerance";
  const double printed = oracle.printed(example.arguments);
  const double corrected = oracle.corrected(example.arguments);
  if (!(std::abs(corrected - example.corrected) <= example.tolerance))
    return "the corrected form gives " + std::to_string(corrected);
  if (!example.printed)
    return std::isnan(printed) ? "" : "the printed form gives " + std::to_string(printed);
  if (!(std::abs(printed - *example.printed) <= example.tolerance))
    return "the printed form gives " + std::to_string(printed);
  if (!(std::abs(printed - corrected) > example.tolerance)) return "the forms do not differ";
  return "";
}

/// Visits every counter-example of every paper.
void for_each_counter_example(
    const std::function<void(const Erratum&, const CounterExample&)>& visit) {
  for (const std::string& paper : paper_keys())
    for (const Erratum& erratum : load_errata(paper))
      if (erratum.counter_example) visit(erratum, *erratum.counter_example);
}

TEST(Errata, HaveUniqueIdsAndSayWhatIsWrong) {
  for (const std::string& paper : paper_keys()) {
    std::set<std::string> ids;
    for (const Erratum& erratum : load_errata(paper)) {
      SCOPED_TRACE(erratum.id);
      EXPECT_TRUE(ids.insert(erratum.id).second);
      EXPECT_EQ(erratum.paper, paper);
      EXPECT_FALSE(erratum.locator.empty());
      EXPECT_FALSE(erratum.printed.empty());
      EXPECT_FALSE(erratum.corrected.empty());
      EXPECT_NE(erratum.printed, erratum.corrected);
      EXPECT_FALSE(erratum.consequence.empty());
      if (erratum.counter_example) EXPECT_FALSE(erratum.counter_example->why.empty());
    }
  }
}

/// What an author who gets it by letter would miss.
std::string missing_for_a_letter(const Erratum& erratum) {
  std::string missing;
  const auto demand = [&](bool there, const char* what) {
    if (!there) missing += std::string(missing.empty() ? "" : ", ") + what;
  };
  const bool needs_number =
      erratum.kind == ErratumKind::formula || erratum.kind == ErratumKind::number ||
      erratum.kind == ErratumKind::missing_case || erratum.kind == ErratumKind::program;
  demand(!erratum.section.empty(), "section");
  demand(erratum.kind.has_value(), "kind");
  demand(!erratum.check.empty(), "check");
  demand(!needs_number || erratum.counter_example, "counter_example");
  if (erratum.counter_example) {
    demand(!erratum.counter_example->inputs.empty(), "inputs");
    demand(!erratum.counter_example->result.empty(), "result");
  }
  return missing;
}

TEST(Errata, SayWhatALetterToTheAuthorNeeds) {
  std::string missing;
  for (const std::string& paper : paper_keys())
    for (const Erratum& erratum : load_errata(paper))
      if (const std::string lacks = missing_for_a_letter(erratum); !lacks.empty())
        missing += "\n  " + paper + " " + erratum.id + ": " + lacks;
  EXPECT_TRUE(missing.empty()) << missing;
}

TEST(Errata, AnIncompleteEntryIsNoticed) {
  Erratum erratum{.section = "3.4.4", .kind = ErratumKind::wording, .check = "Read on."};
  EXPECT_EQ(missing_for_a_letter(erratum), "");
  erratum.kind = ErratumKind::formula;
  EXPECT_EQ(missing_for_a_letter(erratum), "counter_example");
  erratum.kind = ErratumKind::program;
  EXPECT_EQ(missing_for_a_letter(erratum), "counter_example");
  erratum.counter_example = CounterExample{.inputs = {"r"}};
  EXPECT_EQ(missing_for_a_letter(erratum), "result");
  EXPECT_EQ(missing_for_a_letter(Erratum{}), "section, kind, check");
}

TEST(Errata, SectionsAreInTheOrderOfTheWork) {
  const std::vector<std::string> sections = {"1.2",   "2",    "2.4", "2.4.1", "2.10",
                                             "3.4.4", "10.1", "A",   "B",     ""};
  for (std::size_t i = 0; i < sections.size(); ++i)
    for (std::size_t j = 0; j < sections.size(); ++j)
      EXPECT_EQ(section_is_before(sections[i], sections[j]), i < j)
          << sections[i] << " and " << sections[j];
}

TEST(ErrataOracle, CounterExamplesHoldForBothForms) {
  std::size_t count = 0;
  for_each_counter_example([&](const Erratum& erratum, const CounterExample& example) {
    EXPECT_EQ(objection(erratum.paper, example), "") << erratum.id;
    ++count;
  });
  EXPECT_GT(count, 0u);
}

TEST(ErrataOracle, EveryOracleHasACounterExample) {
  std::set<std::string> used;
  for_each_counter_example([&](const Erratum& erratum, const CounterExample& example) {
    used.insert(erratum.paper + "/" + example.oracle);
  });
  for (const auto& [name, oracle] : oracles_by_name()) EXPECT_TRUE(used.contains(name)) << name;
}

// The checker itself must refuse what is wrong.
TEST(ErrataOracle, AWrongCounterExampleIsRefused) {
  const CounterExample right{.oracle = "equation-22",
                             .arguments = {10.0, 4.0},
                             .printed = 2.5,
                             .corrected = 40.0,
                             .tolerance = 0.0,
                             .why = "exact"};
  const std::string paper = "brzoska2019";
  ASSERT_EQ(objection(paper, right), "");

  CounterExample wrong = right;
  wrong.oracle = "equation-23";
  EXPECT_NE(objection(paper, wrong), "") << "unknown oracle";

  wrong = right;
  wrong.arguments = {10.0};
  EXPECT_NE(objection(paper, wrong), "") << "an argument is missing";

  wrong = right;
  wrong.printed = std::nextafter(2.5, 3.0);
  EXPECT_NE(objection(paper, wrong), "") << "printed value off by one ulp";

  wrong = right;
  wrong.corrected = std::nextafter(40.0, 41.0);
  EXPECT_NE(objection(paper, wrong), "") << "corrected value off by one ulp";

  wrong = right;
  wrong.printed = std::nullopt;
  EXPECT_NE(objection(paper, wrong), "") << "the printed form has a value";

  wrong = right;
  wrong.tolerance = 40.0;
  EXPECT_NE(objection(paper, wrong), "") << "a tolerance that hides the difference";

  wrong = right;
  wrong.tolerance = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(objection(paper, wrong), "") << "a tolerance that is no number";
}

}  // namespace
}  // namespace phytobench
