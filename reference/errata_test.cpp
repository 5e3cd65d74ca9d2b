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

#include "reference/oracles/alsweis_hopkins.hpp"
#include "reference/oracles/alsweis_overlap.hpp"
#include "reference/oracles/brzoska2019_equations.hpp"
#include "reference/oracles/brzoska2019_space_colonization.hpp"
#include "reference/papers.hpp"

namespace phytobench {
namespace {

using Arguments = std::vector<double>;

/// The printed and the corrected form of one equation.
struct OraclePair {
  std::size_t arguments;
  std::function<double(const Arguments&)> printed;
  std::function<double(const Arguments&)> corrected;
};

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

std::vector<oracles::brzoska2019::Point> points_of(const Arguments& a) {
  std::vector<oracles::brzoska2019::Point> points;
  for (std::size_t i = 0; i + 2 < a.size(); i += 3) points.push_back({a[i], a[i + 1], a[i + 2]});
  return points;
}

std::vector<oracles::alsweis::Plant> plants_of(const Arguments& a) {
  std::vector<oracles::alsweis::Plant> plants;
  for (std::size_t i = 0; i + 1 < a.size(); i += 2) plants.push_back({a[i], a[i + 1]});
  return plants;
}

/// Two points that stay nearest to the first node whatever grows between them.
double repeated_children(double iterations, bool without_guard) {
  oracles::brzoska2019::GrowthProblem problem;
  problem.attraction_points = {{-0.4, 0.08, 0}, {0.4, 0.08, 0}};
  problem.start_nodes = {{0, 0, 0}};
  problem.start_directions = {{0, 1, 0}};
  problem.start_parents = {-1};
  problem.iterations = static_cast<int>(iterations);
  problem.D = 0.25;
  problem.d_i = 0.5;
  problem.theta_rad = 160.0 * std::numbers::pi / 180.0;
  problem.d_c = [](int) { return 0.3; };
  problem.departures.no_repeat_guard = without_guard;
  const auto parents = oracles::brzoska2019::grow(problem).parents;
  return static_cast<double>(std::count(parents.begin(), parents.end(), 0));
}

/// Keys are "<paper>/<oracle>".
const std::map<std::string, OraclePair>& oracles_by_name() {
  namespace brzoska = oracles::brzoska2019;
  static const std::map<std::string, OraclePair> oracles = {
      {"alsweis/equation-a4",
       {3,
        [](const Arguments& a) {
          return oracles::alsweis::equation_a4_as_printed(a[0], a[1], a[2]);
        },
        [](const Arguments& a) {
          return oracles::alsweis::equation_a4_corrected(a[0], a[1], a[2]);
        }}},
      // Plants, x and y in turn; mean distance to the nearest.
      {"alsweis/equation-2.8-denominator",
       {6,
        [](const Arguments& a) {
          return oracles::alsweis::equation_2_8_denominator(plants_of(a), true);
        },
        [](const Arguments& a) {
          return oracles::alsweis::equation_2_8_denominator(plants_of(a), false);
        }}},
      // Sum of unit vectors, then tropism; the upward component is the value.
      {"brzoska2019/equation-10",
       {6,
        [](const Arguments& a) {
          return brzoska::equation_10_as_printed({a[0], a[1], a[2]}, {a[3], a[4], a[5]}).y;
        },
        [](const Arguments& a) {
          return brzoska::equation_10_corrected({a[0], a[1], a[2]}, {a[3], a[4], a[5]}).y;
        }}},
      // First and last kill distance, limits of the sigmoid, iterations, iteration.
      {"brzoska2019/equation-17",
       {6,
        [](const Arguments& a) {
          return brzoska::equation_17_as_printed(a[0], a[1], a[2], a[3], static_cast<int>(a[4]),
                                                 static_cast<int>(a[5]));
        },
        [](const Arguments& a) {
          return brzoska::equation_17_corrected(a[0], a[1], a[2], a[3], static_cast<int>(a[4]),
                                                static_cast<int>(a[5]));
        }}},
      // The function that eq. 16 should define; as printed there is none.
      {"brzoska2019/sigmoid",
       {1, [](const Arguments&) { return undefined; },
        [](const Arguments& a) { return brzoska::sig(a[0]); }}},
      // Two points seen from a node at the origin; nodes that may grow.
      {"brzoska2019/equation-9-new-nodes",
       {6,
        [](const Arguments& a) {
          return brzoska::equation_9(brzoska::equation_9_sum({0, 0, 0}, points_of(a))).x;
        },
        [](const Arguments& a) {
          return brzoska::length(brzoska::equation_9_sum({0, 0, 0}, points_of(a))) > 0 ? 1.0 : 0.0;
        }}},
      // A point at the node itself, and another; the upward component.
      {"brzoska2019/equation-9-point-at-node",
       {3,
        [](const Arguments& a) {
          const brzoska::Point other{a[0], a[1], a[2]};
          return brzoska::equation_9(brzoska::equation_9_sum({0, 0, 0}, {{0, 0, 0}, other})).y;
        },
        [](const Arguments& a) {
          return brzoska::equation_9(brzoska::equation_9_sum({0, 0, 0}, points_of(a))).y;
        }}},
      // Sum and tropism; nodes that may grow.
      {"brzoska2019/equation-10-new-nodes",
       {6,
        [](const Arguments& a) {
          return brzoska::equation_10_as_printed({a[0], a[1], a[2]}, {a[3], a[4], a[5]}).y;
        },
        [](const Arguments& a) {
          return brzoska::length({a[0] + a[3], a[1] + a[4], a[2] + a[5]}) > 0 ? 1.0 : 0.0;
        }}},
      // Iterations; children of the first node without and with the guard.
      {"brzoska2019/repeated-child",
       {1, [](const Arguments& a) { return repeated_children(a[0], true); },
        [](const Arguments& a) { return repeated_children(a[0], false); }}},
      // Cut-off ratios; volume between them.
      {"brzoska2019/base-volume",
       {2, [](const Arguments& a) { return brzoska::base_volume(a[0], a[1]); },
        [](const Arguments& a) {
          return a[0] + a[1] < 1 ? brzoska::base_volume(a[0], a[1]) : 0.0;
        }}},
      // Two angles and lambda; how much more the first turns, and how much larger its share is.
      {"brzoska2019/equation-13-turn-and-share",
       {3,
        [](const Arguments& a) {
          return brzoska::equation_13(a[0], a[2]) - brzoska::equation_13(a[1], a[2]);
        },
        [](const Arguments& a) {
          return brzoska::equation_13(a[0], a[2]) / a[0] - brzoska::equation_13(a[1], a[2]) / a[1];
        }}},
      // A point of a ring and the ring's normal; the point's x.
      {"brzoska2019/equation-3",
       {6,
        [](const Arguments& a) {
          return brzoska::equation_3_as_printed({a[0], a[1], a[2]}, {a[3], a[4], a[5]}).x;
        },
        [](const Arguments& a) {
          return brzoska::equation_3_corrected({a[0], a[1], a[2]}, {a[3], a[4], a[5]}).x;
        }}},
      // Vertices, triangles and lambda of two plants; how many file names, how many plants.
      {"brzoska2019/plants-with-one-file-name",
       {6,
        [](const Arguments& a) {
          return static_cast<double>(
              std::set<std::pair<double, double>>{{a[0], a[1]}, {a[3], a[4]}}.size());
        },
        [](const Arguments& a) {
          return static_cast<double>(
              std::set<Arguments>{{a[0], a[1], a[2]}, {a[3], a[4], a[5]}}.size());
        }}},
      // Vertices, triangles, limit; how many meshes.
      {"brzoska2019/meshes-needed",
       {3, [](const Arguments& a) { return std::ceil(std::max(a[0], a[1]) / a[2]); },
        [](const Arguments& a) { return std::ceil(a[0] / a[2]); }}},
      // Corners of a ring, printed and corrected number of vertices; vertices left over.
      {"brzoska2019/vertices-over-rings",
       {3, [](const Arguments& a) { return std::fmod(a[1], a[0] + 1); },
        [](const Arguments& a) { return std::fmod(a[2], a[0] + 1); }}},
      // Volume and density.
      {"brzoska2019/equation-22",
       {2, [](const Arguments& a) { return brzoska::equation_22_as_printed(a[0], a[1]); },
        [](const Arguments& a) { return brzoska::equation_22_corrected(a[0], a[1]); }}},
  };
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
