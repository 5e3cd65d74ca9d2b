// SPDX-License-Identifier: MIT
#include "benchmarks/regression/growth_kernel.hpp"

#include "benchmarks/nearest_node/checked_growth.hpp"
#include "benchmarks/regression/families/kernel_digest.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

namespace {

void add_parameters(KernelDigest& digest, const GrowthParameters& growth) {
  const KillDistanceSchedule& kill = growth.kill_distance;
  const GrowthVariant& variant = growth.variant;
  digest
      .add({digest_number(growth.iterations), growth.step_length, growth.influence_distance,
            growth.perception_angle_rad})
      .add({kill.begin, kill.end, kill.sigmoid_begin, kill.sigmoid_end,
            digest_number(kill.interpolation)})
      .add({growth.tropism.x, growth.tropism.y, growth.tropism.z})
      .add({digest_number(variant.tropism_order), digest_number(variant.attraction_sum),
            digest_number(variant.perception_test), digest_number(variant.repeat_guard),
            digest_number(variant.start_killers), digest_number(variant.deferred_kill_distance),
            digest_number(variant.deferred_first_pass)});
}

class GrowthKernel final : public WatchedKernel {
 public:
  explicit GrowthKernel(const WatchedGrowth& growth)
      : descriptor_(*growth.engine),
        subject_(growth.subject),
        seedling_(subject_->seedling()),
        option_(growth.option),
        run_{.options = loop_options_named(option_), .count_work = counts_inner_loop},
        engine_(descriptor_.create()) {}

  std::string inputs() const override {
    KernelDigest digest;
    digest.add(seedling_.attraction_points)
        .add(seedling_.skeleton.positions())
        .add(seedling_.skeleton.parents())
        .add({digest_number(seedling_.crown_root), seedling_.crown_root_direction.x,
              seedling_.crown_root_direction.y, seedling_.crown_root_direction.z})
        .add(option_);
    add_parameters(digest, seedling_.growth);
    return digest.hex();
  }

  void run() override { result_ = grow_crown(seedling_, *engine_, run_); }

  std::string answer() const override {
    return KernelDigest().add(tree_hash(result_.skeleton)).hex();
  }

  WorkCounts work() const override {
    const WorkCounters& work = result_.work;
    WorkCounts counts{{"search_evaluations", work.search_evaluations},
                      {"kill_evaluations", work.kill_evaluations},
                      {"cells_visited", work.cells_visited},
                      {"index_updates", work.index_updates},
                      {"queries", work.queries}};
    if (counts_inner_loop) counts["angle_tests"] = work.angle_tests;
    return counts;
  }

  std::string objection() override {
    const GrowthOracle& oracle = subject_->oracle();
    const CheckedGrowth checked = grow_checked(descriptor_, seedling_, oracle, run_);
    if (!checked.verified) return checked.disagreement;
    if (tree_hash(result_.skeleton) != oracle.hash())
      return "every assignment agrees while it is checked, but the last run grew another tree";
    return {};
  }

 private:
  const EngineDescriptor& descriptor_;
  std::shared_ptr<GrowthSubject> subject_;
  const Seedling& seedling_;
  std::string option_;
  GrowthRun run_;
  std::unique_ptr<NearestNodeEngine> engine_;
  GrowthResult result_;
};

}  // namespace

const Seedling& GrowthSubject::seedling() {
  if (!seedling_) seedling_ = make_();
  return *seedling_;
}

const GrowthOracle& GrowthSubject::oracle() {
  if (!oracle_) oracle_ = std::make_unique<GrowthOracle>(seedling());
  return *oracle_;
}

WatchedBenchmark growth_benchmark(const WatchedGrowth& growth) {
  PHYTOBENCH_EXPECT(growth.engine != nullptr && growth.engine->built() && growth.subject);
  return {
      .name = growth.name, .summary = growth.summary, .is_own = growth.is_own, .prepare = [growth] {
        return std::make_unique<GrowthKernel>(growth);
      }};
}

}  // namespace phytobench
