// SPDX-License-Identifier: MIT
// What holds for every kind of component, whatever it makes.
#include <cmath>
#include <set>
#include <string>
#include <type_traits>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/component_graph/build_plant.hpp"
#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/component_registry.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

/// Fields are compared at one place.
bool same_setting(const ComponentSetting& a, const ComponentSetting& b) {
  if (a.index() != b.index()) return false;
  return std::visit(
      [&]<class Setting>(const Setting& setting) {
        const Setting& other = std::get<Setting>(b);
        if constexpr (std::is_same_v<Setting, ParameterRange>) {
          return setting.frames[0].value == other.frames[0].value;
        } else if constexpr (std::is_same_v<Setting, std::shared_ptr<const VectorField>>) {
          return setting->at({1.0, 2.0, 3.0}, 0.5) == other->at({1.0, 2.0, 3.0}, 0.5);
        } else {
          return setting == other;
        }
      },
      a);
}

class ComponentLaw : public testing::TestWithParam<const ComponentKind*> {
 protected:
  const ComponentKind& kind() const { return *GetParam(); }
};

/// A prototype with random numbers within the ranges of its keys, not too many of anything.
Prototype random_prototype(const ComponentKind& kind, std::uint64_t seed) {
  Prototype prototype = make_prototype("some", kind);
  CounterStream random(seed, 3);
  for (std::size_t i = 0; i < kind.keys.size(); ++i) {
    const auto* number = std::get_if<RangedNumber>(&kind.keys[i].kind);
    if (number == nullptr || random.next_unit() < 0.3) continue;
    const double reach = 2.0 * std::abs(number->default_value) + 1.0;
    const double low = std::max(number->range.low, number->default_value - reach);
    const double high = std::min(number->range.high, number->default_value + reach);
    double value = random.next_between(low, high);
    if (number->range.whole) value = std::round(value);
    if (is_allowed(value, number->range)) prototype.settings[i] = ParameterRange::of(value);
  }
  return prototype;
}

struct Tried {
  explicit Tried(Prototype given)
      : prototype(std::move(given)),
        values(prototype.kind->keys, prototype.settings, InstancePlace{}) {}

  std::vector<Frame> frames(const Frame& frame, LinkKind link, std::size_t n) const {
    std::vector<Frame> frames(n);
    prototype.kind->place_children({values, frame, context}, link, frames);
    return frames;
  }

  std::vector<MeshPart> parts(const Frame& frame) const {
    std::vector<MeshPart> parts;
    if (prototype.kind->make_geometry != nullptr)
      prototype.kind->make_geometry({values, frame, context}, parts);
    return parts;
  }

  Prototype prototype;
  BuildContext context;
  ComponentValues values;
};

Frame parent_frame() {
  Frame frame = Frame{}.turned(Rotation::uniform(0.2, 0.4, 0.6));
  frame.origin = {1.0, 2.0, 3.0};
  frame.scale = 1.5;
  return frame;
}

TEST_P(ComponentLaw, SaysWhatItIs) {
  EXPECT_EQ(&component_kind_named(kind().name), &kind());
  EXPECT_TRUE(kind().summary.ends_with('.')) << kind().summary;
  EXPECT_FALSE(kind().source.empty());
  EXPECT_EQ(kind().is_multiplier, kind().child_count != nullptr);
  EXPECT_EQ(kind().carries_branches, kind().branch_count != nullptr);
  std::set<std::string_view> names{"kind", "most_recursions"};
  for (const ComponentKey& key : kind().keys) {
    EXPECT_TRUE(names.insert(key.name).second) << key.name;
    EXPECT_EQ(key.name.find('.'), std::string_view::npos);
    ASSERT_FALSE(key.meaning.empty());
    EXPECT_FALSE(key.meaning.ends_with('.')) << key.meaning;
    EXPECT_FALSE(key.unit.empty() || key.source.empty()) << key.name;
  }
}

TEST_P(ComponentLaw, TheTextOfEveryDefaultIsTheDefault) {
  for (std::size_t i = 0; i < kind().keys.size(); ++i) {
    const ComponentKey& key = kind().keys[i];
    const std::string text =
        fmt::format("[graph]\nroot = \"it\"\n[component.it]\nkind = \"{}\"\n{} = {}\n", kind().name,
                    key.name, key.default_text);
    const ComponentGraph graph = parse_component_graph(text, "default.toml");
    const ComponentSetting &read = graph.prototypes[0].settings[i],
                           given = make_prototype("it", kind()).settings[i];
    EXPECT_TRUE(same_setting(read, given)) << key.name;
    if (const auto* number = std::get_if<RangedNumber>(&key.kind)) {
      EXPECT_TRUE(is_allowed(number->default_value, number->range)) << key.name;
      EXPECT_FALSE(std::get<ParameterRange>(read).function.has_value()) << key.name;
    }
  }
}

TEST_P(ComponentLaw, TheExampleCanBeReadAndBuilt) {
  const std::string text = example_component_graph(kind());
  const ComponentGraph graph = parse_component_graph(text, "example.toml");
  const BuiltPlant plant = build_plant(graph);
  EXPECT_GT(plant.triangle_count, 0u) << text;
  for (const ComponentKey& key : kind().keys)
    EXPECT_NE(text.find(fmt::format("\n{} = ", key.name)), std::string::npos) << key.name;
  EXPECT_NE(text.find("rounded to the nearest"), std::string::npos) << "of whole numbers";
}

TEST_P(ComponentLaw, ChildrenStandInRightFrames) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Tried tried(seed == 0 ? make_prototype("it", kind()) : random_prototype(kind(), seed));
    for (const LinkKind link : {LinkKind::child, LinkKind::branch, LinkKind::leaf}) {
      if (link == LinkKind::branch && !kind().carries_branches) continue;
      for (const std::size_t n : {1u, 2u, 17u}) {
        if (n > 1 && link != LinkKind::branch && !kind().is_multiplier) continue;
        for (const Frame& frame : tried.frames(parent_frame(), link, n)) {
          EXPECT_TRUE(is_finite(frame.origin)) << seed;
          EXPECT_GT(frame.scale, 0.0) << seed;
          EXPECT_NEAR(norm(frame.x), 1.0, 1e-9) << seed;
          EXPECT_NEAR(norm(frame.y), 1.0, 1e-9) << seed;
          EXPECT_NEAR(dot(frame.x, frame.y), 0.0, 1e-9) << seed;
          EXPECT_LT(norm(cross(frame.x, frame.y) - frame.z), 1e-9) << seed;
        }
      }
    }
  }
}

TEST_P(ComponentLaw, MeshesAreWhole) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Tried tried(seed == 0 ? make_prototype("it", kind()) : random_prototype(kind(), seed));
    for (const MeshPart& part : tried.parts(parent_frame())) {
      const TriangleMesh& mesh = part.mesh;
      ASSERT_EQ(mesh.normals.size(), mesh.vertex_count());
      ASSERT_EQ(mesh.texture_points.size(), mesh.vertex_count());
      for (const Vector3& place : mesh.positions) EXPECT_TRUE(is_finite(place)) << seed;
      for (const Vector3& normal : mesh.normals) EXPECT_NEAR(norm(normal), 1.0, 1e-9) << seed;
      for (const Triangle& triangle : mesh.triangles)
        for (const std::uint32_t vertex : triangle) ASSERT_LT(vertex, mesh.vertex_count());
    }
  }
}

/// Nothing but fields and deformations depends on where in the world an instance stands.
TEST_P(ComponentLaw, TheSameEverywhereAndEveryTime) {
  const Tried tried(random_prototype(kind(), 5));
  Frame shifted = parent_frame();
  shifted.origin = {-70.0, 30.0, 11.0};
  const auto here = tried.parts(parent_frame()), there = tried.parts(shifted);
  ASSERT_EQ(here.size(), there.size());
  for (std::size_t i = 0; i < here.size(); ++i)
    EXPECT_EQ(here[i].mesh.positions, there[i].mesh.positions);
  EXPECT_EQ(tried.frames(parent_frame(), LinkKind::child, kind().is_multiplier ? 5 : 1),
            tried.frames(shifted, LinkKind::child, kind().is_multiplier ? 5 : 1));
}

TEST_P(ComponentLaw, DetailDoesNotMoveTheChildrenOfAMultiplier) {
  if (!kind().is_multiplier) return;
  Tried tried(make_prototype("it", kind()));
  const auto coarse = tried.frames(Frame{}, LinkKind::child, 5);
  tried.context.resolution = 4.0;
  const auto fine = tried.frames(Frame{}, LinkKind::child, 5);
  EXPECT_EQ(coarse, fine);
}

INSTANTIATE_TEST_SUITE_P(AllKinds, ComponentLaw,
                         testing::ValuesIn(all_component_kinds().begin(),
                                           all_component_kinds().end()),
                         [](const auto& kind) { return std::string(kind.param->name); });

}  // namespace
}  // namespace phytobench
