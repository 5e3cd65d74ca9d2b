// SPDX-License-Identifier: MIT
// [Lintermann1997] sec. 2.1 and 3: printed and corrected forms of the bush, of the algorithm, and
// of what L-systems are said not to do.
#include <algorithm>
#include <cmath>
#include <string>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/drawing_measures.hpp"
#include "reference/oracles/liebemann2017_parametric_lsystems.hpp"
#include "reference/oracles/lintermann1997_bush.hpp"
#include "reference/oracles/lintermann1997_p_graph.hpp"
#include "reference/oracles/lintermann1997_placement.hpp"

namespace phytobench {

namespace {

namespace literal = oracles::liebemann2017;
using namespace oracles::lintermann1997;
using oracles::Module;
using oracles::ParametricWord;

literal::Letters bush_word(const BushPrint& print, double steps) {
  return literal::derive_in_parallel(bush(print), static_cast<int>(steps));
}

/// Different places at which branches end.
double distinct_tips(const BushPrint& print, double steps) {
  oracles::TurtleDefaults defaults;
  defaults.angle_deg = 22.5;
  const ParametricWord word = oracles::modules_of(bush_word(print, steps));
  std::vector<oracles::SpacePoint> tips;
  const oracles::SpaceDrawing drawing = oracles::turtle_3d(word, defaults);
  std::vector<int> children(drawing.nodes.size(), 0);
  for (const int parent : drawing.parents)
    if (parent >= 0) ++children[static_cast<std::size_t>(parent)];
  for (std::size_t node = 0; node < children.size(); ++node)
    if (children[node] == 0) tips.push_back(drawing.nodes[node]);
  return static_cast<double>(oracles::distinct_points(tips));
}

BushPrint eight_slashes() {
  BushPrint print;
  print.slashes_first = print.slashes_second = print.slashes_stem = 8;
  return print;
}

/// Lines that are left when all of these letters have been deleted from the word.
double lines_without(const std::string& deleted, double steps) {
  double lines = 0;
  for (const std::string& letter : bush_word({}, steps))
    if (letter == "F" && deleted.find(letter) == std::string::npos) ++lines;
  return lines;
}

/// The example of sec. 3.1.1 with a limit of D; the other components never reach theirs.
double instances_of_D(double limit, const Reading& reading) {
  PGraph graph;
  graph["A"].edges = {{"B"}};
  graph["B"].edges = {{"C"}};
  graph["C"].edges = {{"D"}};
  graph["D"].edges = {{"D"}};
  for (auto& [name, prototype] : graph) prototype.maximal_recursions = 9;
  graph["C"].children = 3;
  graph["D"].maximal_recursions = static_cast<int>(limit);
  return i_tree(graph, "A", reading, 1000).count("D");
}

/// C(n) -> c R(n), R(k) -> d R(k - 1) while k > 0: how many d.
double successors_by_productions(double n) {
  literal::ParametricLSystem G;
  G.omega = {{"C", {n}}};
  G.P.push_back({"C", 1, [](const std::vector<double>& v) {
                   return ParametricWord{{"c", {}}, {"R", {v[0]}}};
                 }});
  G.P.push_back({"R", 1, [](const std::vector<double>& v) {
                   if (v[0] <= 0) return ParametricWord{};
                   return ParametricWord{{"d", {}}, {"R", {v[0] - 1}}};
                 }});
  const ParametricWord word = literal::derive(G, static_cast<int>(n) + 2);
  return static_cast<double>(std::count_if(
      word.begin(), word.end(), [](const Module& module) { return module.letter == "d"; }));
}

/// A(i) -> [ +(i golden) f(sqrt i) ] A(i + 1): distance of seed i and seed j.
double distance_of_seeds(double i, double j) {
  literal::ParametricLSystem G;
  G.omega = {{"A", {1}}};
  G.P.push_back({"A", 1, [](const std::vector<double>& v) {
                   return ParametricWord{{"[", {}},
                                         {"+", {v[0] * golden_angle_deg()}},
                                         {"f", {std::sqrt(v[0])}},
                                         {"F", {1}},
                                         {"]", {}},
                                         {"A", {v[0] + 1}}};
                 }});
  const int steps = static_cast<int>(std::max(i, j));
  const auto drawing = oracles::turtle_3d(literal::derive(G, steps), {});
  const auto at = [&](double seed) {
    return drawing.segments.at(static_cast<std::size_t>(seed) - 1).from;
  };
  return oracles::length_of(at(i), at(j));
}

OracleTable oracles_of_the_bush() {
  return {
      // Steps; different tips.
      {"lintermann1997/tips-of-the-bush",
       {1, [](const Arguments& a) { return distinct_tips(eight_slashes(), a[0]); },
        [](const Arguments& a) { return distinct_tips({}, a[0]); }}},
      // Steps; lines of the picture.
      {"lintermann1997/lines-of-the-bush",
       {1, [](const Arguments& a) { return lines_without("AFSL", a[0]); },
        [](const Arguments& a) { return lines_without("ASL", a[0]); }}},
      // Two seeds of a sunflower; their distance, if an L-system can place them.
      {"lintermann1997/seeds-by-an-l-system",
       {2, [](const Arguments&) { return undefined; },
        [](const Arguments& a) { return distance_of_seeds(a[0], a[1]); }}},
  };
}

}  // namespace

OracleTable lintermann1997_graphs_oracles() {
  OracleTable all = oracles_of_the_bush();
  // Limit of D; its instances.
  const auto corrected = [](const Arguments& a) { return instances_of_D(a[0], {}); };
  all["lintermann1997/comparison-with-the-limit"] = {
      1,
      [](const Arguments& a) {
        return instances_of_D(a[0], {Comparison::less, Counter::decremented, {}});
      },
      corrected};
  all["lintermann1997/counter-of-recursions"] = {
      1,
      [](const Arguments& a) {
        return instances_of_D(a[0], {Comparison::less_or_equal, Counter::never_decremented, {}});
      },
      corrected};
  // v_0, v_1, n, i.
  all["lintermann1997/value-of-a-successor"] = {
      4,
      [](const Arguments& a) {
        const int n = static_cast<int>(a[2]);
        return n == 1 ? undefined : v_i_as_printed(a[0], a[1], n, static_cast<int>(a[3]));
      },
      [](const Arguments& a) {
        return v_i_corrected(a[0], a[1], static_cast<int>(a[2]), static_cast<int>(a[3]));
      }};
  // n of a component; successors, if a grammar can have n as a parameter.
  all["lintermann1997/successors-by-a-grammar"] = {
      1, [](const Arguments&) { return undefined; },
      [](const Arguments& a) { return successors_by_productions(a[0]); }};
  return all;
}

}  // namespace phytobench
