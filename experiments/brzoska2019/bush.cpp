// SPDX-License-Identifier: MIT
// The productions of the bush of eq. 7 one by one: letters, branches, internodes and the leaf.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/lsystem/drawing_measures.hpp"
#include "experiments/brzoska2019/thesis_l_systems.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/lintermann1997_bush.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

constexpr double degrees_of_radian = 180.0 / std::numbers::pi;

/// Letters under the names of measurements.
const std::vector<std::pair<std::string, std::string>>& letter_names() {
  static const std::vector<std::pair<std::string, std::string>> names{
      {"A", "apices"}, {"F", "internodes"}, {"S", "stems"}, {"L", "leaves"},
      {"f", "moves"},  {"{", "polygons"},   {"[", "pairs"}, {"!", "thinner"},
      {"&", "down"},   {"/", "slash"},      {"^", "up"},    {"+", "plus"},
      {"-", "minus"},  {"|", "half_turn"},  {"'", "primes"}};
  return names;
}

std::int64_t count_of(const LSystem& system, const Word& word, const std::string& letter) {
  return static_cast<std::int64_t>(symbol_counts(system, word)[*find_symbol(system, letter, 0)]);
}

/// Letters after seven steps, and those of all steps beside their closed forms.
void record_counts(ExperimentContext& context, int primes) {
  namespace bush = oracles::lintermann1997;
  const bush::BushPrint print{.leaf_primes = primes};
  const LSystem system = thesis_l_system(equation_7_text(primes));
  std::int64_t differ = 0;
  for (int n = 0; n <= 9; ++n) {
    const Word word = derive(system, {.steps = n, .threads = context.untimed_threads()});
    if (primes == 2 && n <= 7)
      context.record(fmt::format("n-{}/apices", n), count_of(system, word, "A"), "letters");
    for (const auto& [letter, expected] :
         {std::pair{"A", bush::bush_A(n)}, std::pair{"F", bush::bush_F(n)},
          std::pair{"S", bush::bush_S(n)}, std::pair{"L", bush::bush_L(n)},
          std::pair{"{", bush::bush_polygons(n)}, std::pair{"[", bush::bush_pairs(n)},
          std::pair{"!", bush::bush_groups(n)}, std::pair{"'", bush::bush_primes(n, print)},
          std::pair{"/", bush::bush_slashes(n, print)}})
      differ += count_of(system, word, letter) != static_cast<std::int64_t>(expected);
    differ += word.size() != bush::bush_letters(n, print);
    if (n != 7) continue;
    const std::string name = fmt::format("primes-{}/n-7/", primes);
    context.record(name + "letters", whole(word.size()), "letters");
    if (primes == 2)
      for (const auto& [letter, its_name] : letter_names())
        context.record(name + its_name, count_of(system, word, letter), "letters");
  }
  context.record(fmt::format("primes-{}/other_than_closed_forms", primes), differ, "counts");
}

/// Angle about an axis from one vector to another, right-handed, in [0, 360).
double turn_about(const Vector3& axis, const Vector3& from, const Vector3& to) {
  const double angle =
      degrees_of_radian *
      std::atan2(dot(axis, cross(from, to)), dot(from, to) - dot(axis, from) * dot(axis, to));
  return angle < -1e-9 ? angle + 360.0 : angle;
}

/// How the branches of one apex stand: about the stem, and from it.
void record_branches(ExperimentContext& context) {
  const LSystem system = thesis_l_system(equation_7_text());
  const Drawing apex = draw(system, derived(system, 1));
  const Vector3 stem{0, 1, 0};
  context.record("apex/branches", whole(apex.segments.size()), "branches");
  for (std::size_t i = 0; i < apex.segments.size(); ++i) {
    const Vector3 heading = apex.segments[i].to - apex.segments[i].from;
    const std::string name = fmt::format("apex/branch-{}/", i + 1);
    context.record(name + "roll",
                   turn_about(stem, apex.segments[0].to - apex.segments[0].from, heading),
                   "degrees");
    context.record(name + "from_stem", degrees_of_radian * std::acos(dot(stem, heading)),
                   "degrees");
  }
  // The groups in brackets of the word after one step.
  const std::string word = word_after(system, 1);
  std::int64_t groups = 0, of_one_each = 0;
  for (std::size_t open = word.find('['); open != std::string::npos;
       open = word.find('[', open + 1)) {
    const std::string group = word.substr(open, word.find(']', open) - open);
    const auto count = [&](char letter) { return std::count(group.begin(), group.end(), letter); };
    ++groups;
    of_one_each += count('F') == 1 && count('L') == 1 && count('A') == 1;
  }
  context.record("apex/groups", groups, "groups");
  context.record("apex/groups_of_one_each", of_one_each, "groups");
}

/// p2 and p3: an internode after two steps, and by how much what follows is rolled.
void record_internode(ExperimentContext& context) {
  const LSystem system = with_axiom(thesis_l_system(equation_7_text()), "F");
  const Drawing straight = draw(system, derived(system, 0));
  for (int n = 1; n <= 4; ++n) {
    const Word word = derived(system, n);
    const std::string name = fmt::format("internode/n-{}/", n);
    if (n <= 2) context.record(name + "word", text_of(system, word));
    context.record(name + "internodes", count_of(system, word, "F"), "letters");
    context.record(name + "leaves", count_of(system, word, "L") + count_of(system, word, "{"),
                   "leaves");
    if (n > 2) continue;
    const Drawing grown = draw(system, word);
    context.record(name + "roll", turn_about({0, 1, 0}, straight.end_frame.up, grown.end_frame.up),
                   "degrees");
  }
}

/// p4: the outline of a leaf, and how it leans against the twig.
void record_leaf(ExperimentContext& context) {
  const LSystem system = with_axiom(thesis_l_system(equation_7_text()), "L");
  const Drawing leaf = draw(system, derived(system, 1));
  context.record("leaf/polygons", whole(leaf.polygons.size()), "polygons");
  const auto corners = corners_of(leaf, leaf.polygons[0]);
  context.record("leaf/edges", whole(corners.size()) - 1, "edges");
  context.record("leaf/different_corners", whole(distinct_point_count(corners, 1e-9)), "corners");
  context.record("leaf/gap", norm(corners.back() - corners.front()), "d");
  const Vector3 area = vector_area(corners.first(corners.size() - 1));
  context.record("leaf/area", norm(area), "d^2");
  double bent = 0.0;  // out of the plane through the first corner
  for (const Vector3& corner : corners)
    bent = std::max(bent, std::abs(dot(area, corner - corners.front())) / norm(area));
  context.record("leaf/out_of_its_plane", bent, "d");
  context.record("leaf/from_twig",
                 degrees_of_radian * std::asin(std::abs(dot(area, {0, 1, 0})) / norm(area)),
                 "degrees");
}

void run(ExperimentContext& context) {
  record_counts(context, 2);
  record_counts(context, 3);
  record_branches(context);
  record_internode(context);
  record_leaf(context);
}

}  // namespace

extern const ExperimentDescriptor bush;
constinit const ExperimentDescriptor bush{
    .id = "brzoska2019/bush",
    .question = "What do the productions of eq. 7 make of an apex, an internode and a leaf?",
    .source = "[Brzoska2019] eq. 7",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
