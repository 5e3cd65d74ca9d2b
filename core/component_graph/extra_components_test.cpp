// SPDX-License-Identifier: MIT
// One line and one file are all that a component needs: this program's list holds one more than the
// suite's. It also joins the laws that hold for every kind (component_laws_test.cpp).
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/component_graph/build_plant.hpp"
#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/component_registry.hpp"
#include "core/contract/errors.hpp"
#include "core/geometry/bounding_box.hpp"

namespace phytobench {
namespace {

constexpr std::string_view hedge = R"(
[graph]
root = "hedge"
[component.hedge]
kind = "row"
count = 7
distance = 2.0
[component.shrub]
kind = "simple"
shape = "box"
[[link]]
from = "hedge"
to = "shrub"
)";

TEST(ExtraComponents, CanBeNamedInAGraphThatIsBuilt) {
  const ComponentGraph graph = parse_component_graph(hedge, "hedge.toml");
  const BuiltPlant plant = build_plant(graph);
  EXPECT_EQ(plant.instances, (std::vector<std::uint64_t>{1, 7}));
  ASSERT_EQ(plant.parts.size(), 1u);
  BoundingBox box;
  for (const Vector3& place : plant.parts[0].mesh.positions) box.extend(place);
  EXPECT_NEAR(box.high().x - box.low().x, 6 * 2.0 + 1.0, 1e-12);  // boxes with edges of 1
}

TEST(ExtraComponents, StandLastInTheListsOfKinds) {
  EXPECT_EQ(all_component_kinds().back()->name, "row");
  EXPECT_THAT(known_component_kind_names(), testing::EndsWith(", world, row"));
  EXPECT_EQ(&component_kind_named("row"), all_component_kinds().back());
}

TEST(ExtraComponents, AreSuggestedAndExplained) {
  try {
    component_kind_named("rows");
    ADD_FAILURE() << "an unknown kind was found";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("did you mean 'row'?"));
  }
  EXPECT_THAT(example_component_graph(component_kind_named("row")),
              testing::HasSubstr("distance = 1.5"));
}

}  // namespace
}  // namespace phytobench
