// SPDX-License-Identifier: MIT
#include "core/component_graph/recursions.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/component_graph/overlapping_recursions.hpp"
#include "core/component_graph/test_components.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using namespace test_components;

/// Components are single letters, each with a limit; links are pairs of them.
std::string problem_of(const std::vector<std::string>& links) {
  GraphMaker maker;
  std::string letters;
  for (const std::string& link : links)
    for (const char letter : link)
      if (letters.find(letter) == std::string::npos) letters += letter;
  for (const char letter : letters) maker.add(std::string(1, letter), plain, 3);
  for (const std::string& link : links) maker.link(link.substr(0, 1), link.substr(1, 1));
  const auto problem = recursion_problem(maker.graph());
  return problem ? problem->text : "";
}

bool mentions(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(Recursions, NestedOnesAndThoseApartAreAllowed) {
  EXPECT_EQ(problem_of({"ab", "bc"}), "");
  EXPECT_EQ(problem_of({"aa"}), "");
  EXPECT_EQ(problem_of({"ab", "ba", "bb"}), "");
  EXPECT_EQ(problem_of({"ab", "bc", "ca", "aa", "bb", "cc"}), "");
  EXPECT_EQ(problem_of({"ab", "bc", "cd", "dc", "da"}), "");        // cd within abcd
  EXPECT_EQ(problem_of({"ab", "bc", "cb", "cd", "da"}), "");        // bc within abcd
  EXPECT_EQ(problem_of({"ab", "ba", "bc", "cd", "dc"}), "");        // ab, then cd
  EXPECT_EQ(problem_of({"ab", "bc", "ca", "bd", "dc"}), "");        // abc within abdc
  EXPECT_EQ(problem_of({"ab", "ba", "ab", "ba"}), "");              // links given twice
  EXPECT_EQ(problem_of({"ab", "bc", "cb", "cd", "db", "da"}), "");  // bc within bcd within all
}

TEST(Recursions, OverlappingOnesAreRefusedByName) {
  EXPECT_TRUE(mentions(problem_of({"ab", "ba", "bc", "cb"}), "a -> b -> a and c -> b -> c overlap"))
      << problem_of({"ab", "ba", "bc", "cb"});
  EXPECT_TRUE(mentions(problem_of({"ab", "bc", "ca", "cd", "db"}), "overlap"));
  EXPECT_TRUE(mentions(problem_of({"ab", "ba", "ac", "ca"}), "overlap"));
  // Two ways round the same loop, which only share it as a whole.
  EXPECT_TRUE(mentions(problem_of({"ab", "ba", "bc", "ca", "bd", "da"}), "overlap"));
}

TEST(Recursions, TheProblemPointsToALinkOfTheSecondLoop) {
  GraphMaker maker;
  maker.add("a", plain, 2).add("b", plain, 2).add("c", plain, 2);
  maker.link("a", "b").link("b", "a").link("b", "c").link("c", "b");
  const auto problem = recursion_problem(maker.graph());
  ASSERT_TRUE(problem.has_value());
  EXPECT_GE(problem->link, 2u);
}

TEST(Recursions, LeafLinksThatNeverMakeAnythingAreRefused) {
  GraphMaker apart;
  apart.add("a").add("b").link("a", "b", LinkKind::leaf);
  EXPECT_TRUE(mentions(recursion_problem(apart.graph())->text, "a is in no recursion"));

  GraphMaker middle;
  middle.add("a", plain, 3).add("b").add("l");
  middle.link("a", "b").link("b", "a").link("a", "l", LinkKind::leaf);
  EXPECT_TRUE(mentions(recursion_problem(middle.graph())->text, "has most_recursions"));

  GraphMaker back;
  back.add("a", plain, 3).add("b");
  back.link("a", "a").link("a", "b", LinkKind::leaf).link("b", "a");
  EXPECT_TRUE(mentions(recursion_problem(back.graph())->text, "leads back"));

  GraphMaker right;
  right.add("a", plain, 3).add("b").add("l");
  right.link("a", "b").link("b", "a").link("b", "l", LinkKind::leaf);
  EXPECT_FALSE(recursion_problem(right.graph()).has_value());
}

/// All elementary cycles, by trying every way: the oracle for small graphs.
void extend(const PrototypeEdges& edges, std::vector<std::size_t>& way,
            std::vector<unsigned>& cycles) {
  for (const std::size_t next : edges.from(way.back())) {
    if (next == way.front()) {
      unsigned nodes = 0;
      for (const std::size_t node : way) nodes |= 1u << node;
      cycles.push_back(nodes);
    } else if (next > way.front() && std::find(way.begin(), way.end(), next) == way.end()) {
      way.push_back(next);
      extend(edges, way, cycles);
      way.pop_back();
    }
  }
}

bool some_overlap(const PrototypeEdges& edges) {
  std::vector<unsigned> cycles;
  for (std::size_t start = 0; start < edges.size(); ++start) {
    std::vector<std::size_t> way{start};
    extend(edges, way, cycles);
  }
  for (const unsigned a : cycles)
    for (const unsigned b : cycles)
      if ((a & b) != 0 && (a & ~b) != 0 && (b & ~a) != 0) return true;
  return false;
}

TEST(RecursionsOracle, ShrinkingFindsWhatTryingAllCyclesFinds) {
  int overlapping = 0, nested = 0;
  for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
    CounterStream random(seed, 2);
    const auto size = static_cast<std::size_t>(2.0 + 5.0 * random.next_unit());
    const double density = random.next_unit() * 0.5;
    PrototypeEdges all(size);
    for (std::size_t from = 0; from < size; ++from)
      for (std::size_t to = 0; to < size; ++to)
        if (random.next_unit() < density) all.add(from, to);
    PrototypeEdges on_cycles(size);
    for (std::size_t from = 0; from < size; ++from)
      for (const std::size_t to : all.from(from))
        if (all.reached_from(to)[from]) on_cycles.add(from, to);
    const bool expected = some_overlap(all);
    const auto found = overlapping_cycles(on_cycles);
    ASSERT_EQ(found.has_value(), expected) << "seed " << seed;
    expected ? ++overlapping : ++nested;
    if (!found) continue;
    unsigned a = 0, b = 0;
    for (const std::size_t node : found->first) a |= 1u << node;
    for (const std::size_t node : found->second) b |= 1u << node;
    EXPECT_TRUE((a & b) != 0 && (a & ~b) != 0 && (b & ~a) != 0) << "seed " << seed;
  }
  EXPECT_GT(overlapping, 1000);
  EXPECT_GT(nested, 1000);
}

}  // namespace
}  // namespace phytobench
