// SPDX-License-Identifier: MIT
// The node-driven engine as a whole: what it allocates, what it holds, which search it takes. That
// it is exact is tested with all other engines.
#include <atomic>
#include <cstdlib>
#include <new>
#include <numbers>

#include <gtest/gtest.h>

#include "core/colonization/growth.hpp"
#include "core/colonization/tree_parameters.hpp"
#include "core/nearest_node/engine_registry.hpp"

namespace {

std::atomic<std::uint64_t> allocations{0};

}  // namespace

// Counts every allocation of this test program. GCC sees free() in an inlined delete and misses
// that new is ours, too.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++allocations;
  return std::malloc(size > 0 ? size : 1);
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}

namespace phytobench {
namespace {

/// Counts what an engine allocates after its reset().
class CountingEngine final : public NearestNodeEngine {
 public:
  explicit CountingEngine(NearestNodeEngine& inner) : inner_(inner) {}

  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    inner_.reset(points, setup);
    in_iterations = 0;
  }
  Assignment associate(std::span<const SearchableNode> nodes) override {
    const std::uint64_t before = allocations;
    const Assignment assignment = inner_.associate(nodes);
    in_iterations += allocations - before;
    return assignment;
  }
  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double distance) override {
    const std::uint64_t before = allocations;
    const auto removed = inner_.kill(killers, distance);
    in_iterations += allocations - before;
    return removed;
  }
  std::size_t live_points() const override { return inner_.live_points(); }
  WorkCounters counters() const override { return inner_.counters(); }

  std::uint64_t in_iterations = 0;

 private:
  NearestNodeEngine& inner_;
};

Seedling small_tree() {
  TreeParameters parameters;
  parameters.cloud.radii = {4.0, 5.0, 4.0};
  return make_seedling(parameters);
}

TEST(NodeDriven, AllocatesNothingInAnIterationOnceItsListsHaveTheirSize) {
  const Seedling seedling = small_tree();
  const auto engine = engine_named("node_driven").create();
  CountingEngine counting(*engine);
  const GrowthResult first = grow_crown(seedling, counting);
  const std::uint64_t while_lists_grow = counting.in_iterations;
  const GrowthResult second = grow_crown(seedling, counting);
  EXPECT_EQ(counting.in_iterations, 0u);
  EXPECT_EQ(tree_hash(second.skeleton), tree_hash(first.skeleton));
  // Lists double: a few allocations each in the first growth, not some per iteration or node.
  EXPECT_LT(while_lists_grow, 4 * first.passes.size());
  EXPECT_GT(while_lists_grow, 0u) << "allocations are not counted";
}

TEST(NodeDriven, IgnoresOptionN) {
  const Seedling seedling = small_tree();
  const auto engine = engine_named("node_driven").create();
  const WorkCounters plain = grow_crown(seedling, *engine).work;
  const WorkCounters filtered =
      grow_crown(seedling, *engine, {.options = loop_options_named("n")}).work;
  EXPECT_EQ(plain, filtered);
  EXPECT_FALSE(engine_named("node_driven").uses_point_filter);
}

}  // namespace
}  // namespace phytobench
