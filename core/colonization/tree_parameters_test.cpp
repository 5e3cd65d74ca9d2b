// SPDX-License-Identifier: MIT
#include "core/colonization/tree_parameters.hpp"

#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/colonization/test_growth.hpp"
#include "core/nearest_node/engine_registry.hpp"

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

constexpr double seedling_rounding =
    1e-9;  // sums of some hundred floating-point operations on numbers near 1

/// Summed length of the stem inside the crown.
double crown_stem_length(const Seedling& seedling) {
  const Skeleton& skeleton = seedling.skeleton;
  double length = 0.0;
  for (auto i = static_cast<std::size_t>(seedling.crown_root) + 1; i < skeleton.node_count(); ++i)
    length += norm(skeleton.positions()[i] - skeleton.position(skeleton.parents()[i]));
  return length;
}

TEST(TropismDampingWeight, IsTheSquaredRatioOfHeightToWidthAtMostOne) {
  EXPECT_EQ(tropism_damping_weight({2, 1, 2}), 0.25);
  EXPECT_EQ(tropism_damping_weight({4, 3, 2}), 0.5625);
  EXPECT_EQ(tropism_damping_weight({2, 3, 4}), 0.5625);
  EXPECT_EQ(tropism_damping_weight({1, 2, 1}), 1.0);
  EXPECT_EQ(tropism_damping_weight({1, 1, 1}), 1.0);
}

TEST(TropismDampingWeight, OfACloudWithoutWidthIsOne) {
  EXPECT_EQ(tropism_damping_weight({0, 1, 0}), 1.0);
  EXPECT_EQ(tropism_damping_weight({0, 0, 0}), 1.0);
}

TEST(MakeSeedling, FollowsItsParameters) {
  const TreeParameters parameters = small_tree();
  const Seedling seedling = make_seedling(parameters);
  EXPECT_EQ(seedling.attraction_points.size(), attraction_point_count(parameters.cloud, 26.4));
  EXPECT_EQ(seedling.crown_root, 8);  // length 2 in pieces of 0.25
  EXPECT_EQ(seedling.skeleton.edge_count(), 8u);
  EXPECT_EQ(seedling.growth.iterations, 30);
  EXPECT_EQ(seedling.growth.step_length, 0.25);
  EXPECT_EQ(seedling.growth.influence_distance, 0.66);
  EXPECT_NEAR(seedling.growth.perception_angle_rad, 160.0 * std::numbers::pi / 180.0,
              seedling_rounding);
}

TEST(MakeSeedling, PutsTheCloudOnTheCrownRoot) {
  const Seedling seedling = make_seedling(small_tree());
  const Vector3 crown_root = seedling.skeleton.position(seedling.crown_root);
  const BoundingBox box = extent_of(seedling.attraction_points);
  EXPECT_GE(box.low().y, crown_root.y - seedling_rounding);
  EXPECT_LT(box.low().y, crown_root.y + 0.5);
  EXPECT_GE(box.low().x, crown_root.x - 2.0 - seedling_rounding);
  EXPECT_LE(box.high().x, crown_root.x + 2.0 + seedling_rounding);
}

TEST(MakeSeedling, CrownRootLooksAlongTheLastStemPiece) {
  const Seedling seedling = make_seedling(small_tree());
  EXPECT_NEAR(norm(seedling.crown_root_direction), 1.0, seedling_rounding);
  const Vector3 last = seedling.skeleton.position(8) - seedling.skeleton.position(7);
  EXPECT_NEAR(norm(last - 0.25 * seedling.crown_root_direction), 0.0, seedling_rounding);
}

TEST(MakeSeedling, WithoutStemStartsUpwardsAtTheRoot) {
  TreeParameters parameters = small_tree();
  parameters.stem_length = 0.0;
  const Seedling seedling = make_seedling(parameters);
  EXPECT_EQ(seedling.crown_root, 0);
  EXPECT_EQ(seedling.skeleton.node_count(), 1u);
  EXPECT_EQ(seedling.crown_root_direction, (Vector3{0, 1, 0}));
}

TEST(MakeSeedling, CrownStemRunsThroughItsShareOfTheCloud) {
  for (const double ratio : {0.0, 0.5, 1.0}) {
    TreeParameters parameters = small_tree();
    parameters.crown_stem_ratio = ratio;
    const Seedling seedling = make_seedling(parameters);
    EXPECT_EQ(seedling.crown_root, 8);
    const double height = extent_of(seedling.attraction_points).extent().y;
    EXPECT_NEAR(crown_stem_length(seedling), ratio * height, seedling_rounding)
        << "ratio " << ratio;
  }
}

TEST(MakeSeedling, WeighsTropismComponentByComponent) {
  TreeParameters parameters = small_tree();
  parameters.tropism_damping = TropismDamping::none;
  parameters.tropism_direction = {0, 2, 1};
  parameters.tropism_weights = {1, 0.5, 3};
  EXPECT_EQ(make_seedling(parameters).growth.tropism, (Vector3{0, 1, 3}));
}

TEST(MakeSeedling, DampsUpwardTropismUnderAFlatCloud) {
  TreeParameters parameters;
  parameters.cloud.radii = {3, 1, 3};
  const Seedling seedling = make_seedling(parameters);
  const double weight = tropism_damping_weight(extent_of(seedling.attraction_points).extent());
  EXPECT_LT(weight, 0.2);  // 1.6 units high and 6 wide
  EXPECT_EQ(seedling.growth.tropism, (Vector3{0, weight, 0}));
  parameters.tropism_damping = TropismDamping::none;
  EXPECT_EQ(make_seedling(parameters).growth.tropism, (Vector3{0, 1, 0}));
}

TEST(MakeSeedling, MeasuresAnotherDensityForDampingButKeepsTheCloud) {
  TreeParameters parameters;
  parameters.cloud.radii = {3, 1, 3};
  const Seedling own = make_seedling(parameters);
  parameters.tropism_damping_density = parameters.cloud_density;
  EXPECT_EQ(make_seedling(parameters).growth.tropism, own.growth.tropism);
  parameters.tropism_damping_density = 2.0;
  const Seedling sparse = make_seedling(parameters);
  EXPECT_NE(sparse.growth.tropism, own.growth.tropism);
  EXPECT_EQ(sparse.attraction_points, own.attraction_points);
}

TEST(MakeSeedling, AbsurdStemIsAnInputError) {
  TreeParameters parameters = small_tree();
  parameters.stem_length = 1e9;
  EXPECT_THROW(make_seedling(parameters), InputError);
  parameters.stem_length = 2.0;
  parameters.step_length = 1e-9;
  EXPECT_THROW(make_seedling(parameters), InputError);
}

TEST(MakeSeedling, AbsurdCrownStemIsAnInputError) {
  TreeParameters parameters;
  parameters.cloud.radii = {1, 1e9, 1};
  parameters.cloud_density = 1e-8;  // 40 points
  parameters.crown_stem_ratio = 1.0;
  EXPECT_THROW(make_seedling(parameters), InputError);
}

TEST(MakeSeedling, AbsurdCloudIsAnInputError) {
  TreeParameters parameters = small_tree();
  parameters.cloud_density = 1e12;
  EXPECT_THROW(make_seedling(parameters), InputError);
}

TEST(MakeSeedlingLaw, IsAFunctionOfItsParameters) {
  for (const StreamKind kind : {StreamKind::subtractive, StreamKind::counter}) {
    TreeParameters parameters = small_tree();
    parameters.random = kind;
    parameters.crown_stem_ratio = 0.5;
    const Seedling first = make_seedling(parameters);
    const Seedling again = make_seedling(parameters);
    EXPECT_EQ(first.attraction_points, again.attraction_points);
    EXPECT_EQ(tree_hash(first.skeleton), tree_hash(again.skeleton));
    EXPECT_EQ(first.growth.tropism, again.growth.tropism);
    parameters.seed = 1;
    const Seedling other = make_seedling(parameters);
    EXPECT_NE(first.attraction_points, other.attraction_points);
    EXPECT_NE(tree_hash(first.skeleton), tree_hash(other.skeleton));
  }
}

Seedling one_point(const Vector3& point) {
  Seedling seedling;
  seedling.attraction_points = {point};
  seedling.growth.influence_distance = 1.0;
  seedling.growth.perception_angle_rad = 160.0 * std::numbers::pi / 180.0;
  return seedling;
}

TEST(WhyGrowthCannotStart, NamesTheInfluenceDistanceAndTheGap) {
  const std::string reason = why_growth_cannot_start(one_point({0, 3, 0}));
  EXPECT_THAT(reason, testing::HasSubstr("growth.influence_distance = 1;"));
  EXPECT_THAT(reason, testing::HasSubstr("is 3 away"));
  EXPECT_THAT(reason, testing::Not(testing::HasSubstr("perception")));
  EXPECT_EQ(reason.find('\n'), std::string::npos);
}

TEST(WhyGrowthCannotStart, NamesThePerceptionAngleIfPointsAreNear) {
  const std::string reason = why_growth_cannot_start(one_point({0, -0.5, 0}));
  EXPECT_THAT(reason, testing::HasSubstr("growth.perception_angle_deg = 160 "));
  EXPECT_THAT(reason, testing::HasSubstr("nearest 0.5"));
  EXPECT_EQ(reason.find('\n'), std::string::npos);
}

TEST(WhyGrowthCannotStart, MeasuresFromTheStemInsideTheCrownToo) {
  Seedling seedling = one_point({0, 3, 0});
  seedling.skeleton.append(0, {0, 1, 0});
  EXPECT_THAT(why_growth_cannot_start(seedling), testing::HasSubstr("is 2 away"));
}

TEST(RegrowStemLaw, MovesTheCrownAndChangesNoEdge) {
  TreeParameters parameters;
  parameters.cloud.radii = {2.0, 2.5, 1.5};
  const Seedling seedling = make_seedling(parameters);
  const auto engine = engine_named("squared_scan").create();
  const TreeOnStem tree{grow_crown(seedling, *engine).skeleton, seedling.crown_root};
  for (const double length : {0.0, 0.6, 2.0, 5.0}) {
    parameters.stem_length = length;
    const TreeOnStem regrown = regrow_stem(tree, parameters);
    const std::int32_t shift = regrown.crown_root - tree.crown_root;
    ASSERT_EQ(regrown.skeleton.node_count() - static_cast<std::size_t>(regrown.crown_root),
              tree.skeleton.node_count() - static_cast<std::size_t>(tree.crown_root));
    for (auto i = tree.crown_root + 1; i < static_cast<std::int32_t>(tree.skeleton.node_count());
         ++i) {
      const std::int32_t parent = tree.skeleton.parents()[static_cast<std::size_t>(i)];
      ASSERT_EQ(regrown.skeleton.parents()[static_cast<std::size_t>(i + shift)], parent + shift);
      const Vector3 before = tree.skeleton.position(i) - tree.skeleton.position(parent);
      const Vector3 after =
          regrown.skeleton.position(i + shift) - regrown.skeleton.position(parent + shift);
      EXPECT_LE(norm(after - before), 1e-14);
    }
  }
  parameters.stem_length = TreeParameters().stem_length;
  EXPECT_LE(norm(regrow_stem(tree, parameters).skeleton.positions().back() -
                 tree.skeleton.positions().back()),
            1e-14);
}

}  // namespace
}  // namespace phytobench
