// SPDX-License-Identifier: MIT
#include "benchmarks/regression/drawing_kernel.hpp"

#include <fmt/format.h>

#include "benchmarks/lsystem/derivation_case.hpp"
#include "benchmarks/lsystem/engine_drawing.hpp"
#include "benchmarks/regression/families/kernel_digest.hpp"
#include "core/contract/check.hpp"
#include "core/contract/work_counting.hpp"
#include "core/lsystem/turtle.hpp"

namespace phytobench {

namespace {

template <class Segment>
class DrawingKernel final : public WatchedKernel {
 public:
  DrawingKernel(const DerivationEngine& engine, std::shared_ptr<DrawnSystem> system,
                DrawingLane lane)
      : engine_(engine), system_(std::move(system)), writes_(lane == DrawingLane::memory) {
    segments_.resize(workload().segments);
    PHYTOBENCH_EXPECT(!writes_ || write_function<Segment>(engine_) != nullptr);
  }

  std::string inputs() const override { return system_->digest(); }

  void run() override {
    if (writes_) {
      work_ = write_function<Segment>(engine_)(workload().system, workload().steps, 1, segments_);
      count_ = segments_.size();
      return;
    }
    const CopiedDrawing copied =
        copy_drawing(engine_, workload(), 1, std::span<Segment>(segments_));
    work_ = copied.work;
    count_ = copied.segments;
    blocks_ = copied.blocks;
  }

  std::string answer() const override {
    return KernelDigest().add(segments_).add({digest_number(count_)}).hex();
  }

  WorkCounts work() const override {
    WorkCounts counts{{"segments", count_},
                      {"bytes_held", work_.bytes_held},
                      {"modules_made", work_.modules_made}};
    if (!writes_) counts["blocks"] = blocks_;
    if (counts_inner_loop) counts["parts_taken"] = work_.parts_taken;
    return counts;
  }

  std::string objection() override {
    if (count_ != segments_.size())
      return fmt::format("{} segments instead of {}", count_, segments_.size());
    DrawingDigest digest;
    digest.add(std::span<const Segment>(segments_));
    return system_->judge().disagreement(digest);
  }

 private:
  const LSystemWorkload& workload() const { return system_->workload(); }

  const DerivationEngine& engine_;
  std::shared_ptr<DrawnSystem> system_;
  bool writes_;
  std::vector<Segment> segments_;
  std::uint64_t count_ = 0;
  std::uint64_t blocks_ = 0;
  DrawingWork work_;
};

}  // namespace

const DrawingJudge& DrawnSystem::judge() {
  if (!judge_) judge_ = std::make_unique<DrawingJudge>(workload_);
  return *judge_;
}

bool DrawnSystem::planar() const {
  return is_planar(workload_.system);
}

std::string DrawnSystem::digest() const {
  const LSystem& system = workload_.system;
  const auto add_letters = [&](KernelDigest& digest, const auto& modules) {
    std::string letters;
    for (const auto& module : modules) letters += system.symbols[module.symbol].letter + ' ';
    digest.add(letters);
  };
  KernelDigest digest;
  add_letters(digest, system.axiom);
  for (const Production& production : system.productions) {
    add_letters(digest, std::span(&production.predecessor, 1));
    add_letters(digest, production.successor);
  }
  const TurtleSettings& turtle = system.turtle;
  return digest.add(turtle.draws)
      .add(turtle.moves)
      .add({turtle.angle_deg, turtle.step, digest_number(turtle.convention),
            digest_number(turtle.start), digest_number(workload_.steps)})
      .hex();
}

LSystemWorkload bush_in_space(int steps) {
  LSystemWorkload workload;
  workload.name = "bush-in-space";
  workload.system = bush_derivation(steps, false).system;
  workload.steps = steps;
  const auto counts = oracles::letter_counts(structure_of(workload.system), steps);
  const auto segments = oracles::drawn_segments(counts, workload.system.turtle.draws).in_64_bits();
  PHYTOBENCH_EXPECT(segments.has_value());
  workload.segments = *segments;
  workload.modules = modules_by_matrix(workload.system, steps);
  return workload;
}

std::unique_ptr<WatchedKernel> drawing_kernel(const DerivationEngine& engine,
                                              std::shared_ptr<DrawnSystem> system,
                                              DrawingLane lane) {
  PHYTOBENCH_EXPECT(engine.built());
  if (system->planar())
    return std::make_unique<DrawingKernel<PlanarSegment>>(engine, std::move(system), lane);
  return std::make_unique<DrawingKernel<SpatialSegment>>(engine, std::move(system), lane);
}

}  // namespace phytobench
