// SPDX-License-Identifier: MIT
#include "core/tree/skeleton_svg.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::HasSubstr;

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

/// A trunk of two edges under two branches.
Skeleton forked_trunk() {
  Skeleton skeleton{Vector3{0.3, -1.0, 5.0}};
  skeleton.append(0, {0.3, 0.0, 5.0});
  skeleton.append(1, {0.3, 1.0, 5.0});
  skeleton.append(2, {1.3, 2.0, 5.0});
  skeleton.append(2, {-0.7, 2.0, 4.0});
  return skeleton;
}

void expect_well_formed(const std::string& svg) {
  EXPECT_THAT(svg, testing::StartsWith("<svg "));
  EXPECT_THAT(svg, testing::EndsWith("</svg>\n"));
  EXPECT_EQ(occurrences(svg, "<svg"), 1u);
  EXPECT_EQ(occurrences(svg, "<title>"), 1u);
  EXPECT_EQ(occurrences(svg, "</title>"), 1u);
  // Every element is closed, every attribute quoted on both sides.
  EXPECT_EQ(occurrences(svg, "<"), occurrences(svg, ">"));
  EXPECT_EQ(occurrences(svg, "<path"), occurrences(svg, "/>"));
  EXPECT_EQ(occurrences(svg, "\"") % 2, 0u);
  for (const char* no_number : {"nan", "inf"})
    EXPECT_EQ(occurrences(svg, no_number), 0u) << no_number;
}

TEST(SkeletonSvg, IsWellFormed) {
  expect_well_formed(skeleton_svg(forked_trunk(), "a tree"));
  expect_well_formed(skeleton_svg(Skeleton{Vector3{}}, "a root"));
}

TEST(SkeletonSvg, CarriesItsTitle) {
  EXPECT_THAT(skeleton_svg(forked_trunk(), "figure 51"), HasSubstr("<title>figure 51</title>"));
}

TEST(SkeletonSvg, RefersToNothingOutside) {
  const std::string svg = skeleton_svg(forked_trunk(), "a tree");
  EXPECT_EQ(occurrences(svg, "http"), 1u);  // the name space, which nobody fetches
  EXPECT_THAT(svg, HasSubstr("xmlns=\"http://www.w3.org/2000/svg\""));
  for (const char* reference : {"href", "url(", "<image", "<style", "<script", "@import"})
    EXPECT_EQ(occurrences(svg, reference), 0u) << reference;
}

TEST(SkeletonSvg, FollowsTheColourOfThePage) {
  EXPECT_THAT(skeleton_svg(forked_trunk(), "a tree"), HasSubstr("stroke=\"currentColor\""));
}

TEST(SkeletonSvg, DrawsYUpwards) {
  Skeleton skeleton{Vector3{}};
  skeleton.append(0, {0, 1, 0});
  // From the bottom of a grid of 1000 units to its top.
  EXPECT_THAT(skeleton_svg(skeleton, "a stick"), HasSubstr("d=\"M0 1000l0-1000\""));
}

TEST(SkeletonSvg, DrawsEveryEdgeAndTheTrunkWider) {
  const std::string svg = skeleton_svg(forked_trunk(), "a tree");
  EXPECT_EQ(occurrences(svg, "<path"), 2u);  // one width for the trunk, one for both branches
  EXPECT_THAT(svg, HasSubstr("d=\"M333 1000l0-333 0-334\""));  // its two edges as one line
  EXPECT_THAT(svg, HasSubstr("d=\"M333 333l334-333M333 333l-333-333\""));
}

TEST(SkeletonSvgLaw, SameTreeGivesTheSameBytes) {
  EXPECT_EQ(skeleton_svg(forked_trunk(), "a tree"), skeleton_svg(forked_trunk(), "a tree"));
}

TEST(SkeletonSvgLaw, DepthIsNotSeen) {
  Skeleton flat{Vector3{}}, deep{Vector3{}};
  flat.append(0, {1, 2, 0});
  deep.append(0, {1, 2, 7});
  EXPECT_EQ(skeleton_svg(flat, "t"), skeleton_svg(deep, "t"));
}

TEST(SkeletonSvgLaw, DoubledTreeGivesTheSamePicture) {
  const Skeleton tree = forked_trunk();
  Skeleton doubled{2.0 * tree.position(0)};
  for (std::size_t i = 1; i < tree.node_count(); ++i)
    doubled.append(tree.parents()[i], 2.0 * tree.positions()[i]);
  EXPECT_EQ(skeleton_svg(doubled, "t"), skeleton_svg(tree, "t"));
}

}  // namespace
}  // namespace phytobench
