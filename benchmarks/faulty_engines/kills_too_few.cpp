// SPDX-License-Identifier: MIT
// Wrong on purpose: answers correctly, but leaves the first point of every removal alive.
#include <memory>

#include "core/nearest_node/engine_registry.hpp"

namespace phytobench::engines {

namespace {

class KillsTooFew final : public NearestNodeEngine {
 public:
  void reset(std::span<const Vector3> points, const EngineSetup& setup) override {
    inner_ = engine_named("squared_scan").create();
    inner_->reset(points, setup);
  }
  Assignment associate(std::span<const SearchableNode> new_nodes) override {
    return inner_->associate(new_nodes);
  }
  std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                   double distance) override {
    const auto removed = inner_->kill(killers, distance);
    return removed.empty() ? removed : removed.subspan(1);
  }
  std::size_t live_points() const override { return inner_->live_points(); }
  WorkCounters counters() const override { return inner_->counters(); }

 private:
  std::unique_ptr<NearestNodeEngine> inner_;
};

std::unique_ptr<NearestNodeEngine> create() {
  return std::make_unique<KillsTooFew>();
}

}  // namespace

extern const EngineDescriptor kills_too_few;
constinit const EngineDescriptor kills_too_few{
    .name = "kills_too_few",
    .summary = "Wrong on purpose: claims one point less in every removal.",
    .source = "an off-by-one",
    .create = create,
};

}  // namespace phytobench::engines
