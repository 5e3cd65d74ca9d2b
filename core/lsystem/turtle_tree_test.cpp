// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/drawing.hpp"
#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/test_words.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {
namespace {

using Counts = std::map<std::size_t, std::size_t>;

TEST(TurtleTree, BranchesWhereBracketsAre) {
  const TurtleTree tree = TestWords(test_turtle(90.0)).tree("F[+F]F");
  ASSERT_EQ(tree.skeleton.node_count(), 4u);
  EXPECT_EQ(tree.skeleton.parents()[1], 0);
  EXPECT_EQ(tree.skeleton.parents()[2], 1);
  EXPECT_EQ(tree.skeleton.parents()[3], 1);
  EXPECT_EQ(tree.skeleton.positions()[2], (Vector3{-1, 1, 0}));
  EXPECT_EQ(tree.skeleton.positions()[3], (Vector3{0, 2, 0}));
}

TEST(TurtleTree, KeepsWidthsAndColours) {
  const TurtleTree tree = TestWords().tree("!(3)'F[!(2)'F]F");
  EXPECT_EQ(tree.widths, (std::vector<float>{3, 3, 2, 3}));
  EXPECT_EQ(tree.colours, (std::vector<std::uint16_t>{1, 1, 2, 1}));
}

TEST(TurtleTree, OfNothingIsARoot) {
  const TurtleTree tree = TestWords().tree("A");
  EXPECT_EQ(tree.skeleton.node_count(), 1u);
  EXPECT_EQ(tree.widths.size(), 1u);
  EXPECT_EQ(tree.colours.size(), 1u);
}

TEST(TurtleTree, HasNoNodesOfMovesAroundPolygons) {
  TestWords words(test_turtle(22.5));
  const TurtleTree tree = words.tree("F[{-f+f+f-|-f+f+f}]F");
  EXPECT_EQ(tree.skeleton.node_count(), 3u);
  // Back where it began, the turtle may go on without a bracket.
  EXPECT_EQ(words.tree("F{-f+f+f-|-f+f+f}F").skeleton.node_count(), 3u);
}

/// F draws inside braces, too, so that drawing and tree have the same segments.
TEST(TurtleTree, HasTheLinesThatOutlinePolygons) {
  TestWords words(test_turtle(90.0));
  for (const char* text : {"F[{-F+F}]F", "{F+F+F+F}", "{F+F}F", "F{-F}[+F{F}]F"}) {
    const Drawing drawing = words.drawn(text);
    const TurtleTree tree = words.tree(text);
    ASSERT_EQ(tree.skeleton.edge_count(), drawing.segments.size()) << text;
    for (std::size_t i = 0; i < drawing.segments.size(); ++i) {
      EXPECT_EQ(tree.skeleton.positions()[i + 1], drawing.segments[i].to) << text;
      EXPECT_EQ(tree.skeleton.position(tree.skeleton.parents()[i + 1]), drawing.segments[i].from);
    }
  }
  EXPECT_THROW(words.tree("F{fF}"), InputError);
}

TEST(TurtleTree, MayMoveAwayIfItComesBack) {
  TestWords words(test_turtle(90.0));
  EXPECT_EQ(words.tree("F[f]F").skeleton.node_count(), 3u);
  EXPECT_EQ(words.tree("Ff|f|F").skeleton.node_count(), 3u);
  EXPECT_EQ(words.tree("Ff").skeleton.node_count(), 2u);
}

TEST(TurtleTree, RefusesLinesThatAreNotConnected) {
  TestWords words;
  EXPECT_THAT([&] { words.tree("FfF"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("no connected tree")));
  EXPECT_THROW(words.tree("fF"), InputError);
  EXPECT_THROW(words.tree("{f}F"), InputError);
}

TEST(TurtleTree, OfLiebemannsFirstBranching) {  // fig. 2.5a: 2 * 8^(n-1) tips, degree 2n
  const TurtleTree tree =
      TestWords(test_turtle(25.0, 18.0)).tree(rewritten("F", {{'F', "FF-[-F+F+F]+[+F-F-F]"}}, 4));
  EXPECT_EQ(tree.skeleton.node_count(), 4097u);
  EXPECT_EQ(tip_count(tree.skeleton), 1024u);
  EXPECT_EQ(child_counts(tree.skeleton).rbegin()->first, 8u);
  EXPECT_EQ(edge_depth(tree.skeleton), 61u);
  EXPECT_EQ(branch_radii(tree.skeleton, 1.0, 2.0).front(), 32.0);
}

TEST(TurtleTree, OfLiebemannsSecondBranching) {  // fig. 2.5b: 3 * 5^(n-1) tips, degree 2n
  const TurtleTree tree =
      TestWords(test_turtle(25.0, 15.0)).tree(rewritten("F", {{'F', "F[-F]F[+F][F]"}}, 5));
  EXPECT_EQ(tree.skeleton.node_count(), 3126u);
  EXPECT_EQ(tip_count(tree.skeleton), 1875u);
  EXPECT_EQ(child_counts(tree.skeleton).rbegin()->first, 10u);
  EXPECT_EQ(edge_depth(tree.skeleton), 63u);
  EXPECT_NEAR(branch_radii(tree.skeleton, 1.0, 2.0).front(), std::sqrt(1875.0), 1e-12);
}

TEST(TurtleTree, OfTheTernaryTree) {  // [Liebemann2017] eq. 2.17
  const TurtleTree tree =
      TestWords(test_turtle(90.0, 1.0, TurtleStart::local)).tree(ternary_word(8, 18.95));
  const Skeleton& skeleton = tree.skeleton;
  EXPECT_EQ(skeleton.node_count(), 13121u);
  EXPECT_EQ(tip_count(skeleton), 6561u);
  EXPECT_EQ(child_counts(skeleton), (Counts{{0, 6561}, {1, 3280}, {3, 3280}}));
  EXPECT_EQ(edge_depth(skeleton), 16u);
  EXPECT_EQ(branch_radii(skeleton, 1.0, 2.0).front(), 81.0);
  // All tips are as far from the root: 100 (1.3^8 - 1) / 0.3 along the branches, 16 edges.
  const double way = 100.0 * (std::pow(1.3, 8) - 1.0) / 0.3;
  EXPECT_NEAR(way, 2385.76907, 1e-5);
  const std::vector<double> lengths = path_lengths(skeleton);
  const std::vector<std::int32_t> depths = node_depths(skeleton);
  const ChildLists children(skeleton);
  for (std::size_t node = 0; node < skeleton.node_count(); ++node) {
    if (!children.of(static_cast<std::int32_t>(node)).empty()) continue;
    ASSERT_NEAR(lengths[node], way, 1e-9);
    ASSERT_EQ(depths[node], 16);
  }
}

TEST(TurtleTree, OfBrzoskasPlant) {  // eq. 6
  const std::map<char, std::string> rules{{'X', "F[+++FX]F[---FX]F[++F-FX][F-FX]"}, {'F', "FF"}};
  const auto grown = [&](int n) {
    return TestWords(test_turtle(10.0)).tree(rewritten("X", rules, n)).skeleton;
  };
  const Skeleton first = grown(1);  // fig. 14, left
  EXPECT_EQ(first.node_count(), 10u);
  EXPECT_EQ(tip_count(first), 4u);
  EXPECT_EQ(edge_depth(first), 5u);
  const Skeleton last = grown(7);
  EXPECT_EQ(last.node_count(), 73153u);
  EXPECT_EQ(child_counts(last), (Counts{{0, 16384}, {1, 40386}, {2, 16383}}));
  EXPECT_EQ(edge_depth(last), 635u);
  EXPECT_EQ(branch_radii(last, 1.0, 2.0).front(), 128.0);
}

TEST(TurtleTree, OfTheBushHasAsManyTipsAsItsReading) {  // [Lintermann1997] sec. 2.1
  constexpr double rounding = 1e-9;
  const auto tips = [](std::string word) {
    return tip_positions(TestWords(test_turtle(22.5)).tree(word).skeleton);
  };
  EXPECT_EQ(distinct_point_count(tips(bush_word(5, 5, 7, 5)), rounding), 243u);
  EXPECT_EQ(tips(bush_word(5, 8, 8, 8)).size(), 243u);
  EXPECT_EQ(distinct_point_count(tips(bush_word(5, 8, 8, 8)), rounding), 32u);
}

}  // namespace
}  // namespace phytobench
