// SPDX-License-Identifier: MIT
// Which discs overlap, by how much, and what ground all of them cover together.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "benchmarks/overlap/overlap_judge.hpp"
#include "benchmarks/regression/checks/area_checks.hpp"
#include "benchmarks/regression/families/kernel_digest.hpp"
#include "benchmarks/regression/watched_benchmarks.hpp"
#include "core/overlap/lens.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench::families {

namespace {

constexpr std::uint64_t seed = 8;

/// Discs and, once asked for, the right pairs: the double loop takes a hundred times as long as a
/// run, so all engines share it. For one thread.
class Scene {
 public:
  explicit Scene(const RandomDiscs& request) : workload_(random_discs(request)) {}

  const OverlapWorkload& workload() const { return workload_; }

  const OverlapJudge& judge() {
    if (!judge_) judge_ = std::make_unique<OverlapJudge>(workload_, seed);
    return *judge_;
  }

  /// The judge expects the areas that lens_area() gives, to the last bit; whether those are right,
  /// an oracle says of all of them.
  const std::string& objection_to_areas() {
    if (!areas_objection_)
      areas_objection_ =
          objection_to_pair_areas(judge().pairs(), judge().distances(), workload_, seed);
    return *areas_objection_;
  }

  std::string digest() const {
    return KernelDigest()
        .add(workload_.x)
        .add(workload_.y)
        .add(workload_.radius)
        .add({workload_.ground.period_x(), workload_.ground.period_y()})
        .hex();
  }

 private:
  OverlapWorkload workload_;
  std::unique_ptr<OverlapJudge> judge_;
  std::optional<std::string> areas_objection_;
};

class SearchKernel final : public WatchedKernel {
 public:
  SearchKernel(const OverlapEngineDescriptor& engine, std::shared_ptr<Scene> scene)
      : engine_(engine.create()), scene_(std::move(scene)) {}

  std::string inputs() const override { return scene_->digest(); }

  void run() override {
    const OverlapWorkload& workload = scene_->workload();
    work_ = engine_->find(workload.discs(), workload.ground, setup_, pairs_);
  }

  std::string answer() const override {
    const OverlapPairs pairs = sorted();
    return KernelDigest().add(pairs.first()).add(pairs.second()).add(pairs.area()).hex();
  }

  WorkCounts work() const override {
    return {{"candidates", work_.candidates}, {"places", work_.places}, {"pairs", pairs_.size()}};
  }

  std::string objection() override {
    OverlapPairs pairs = sorted();
    const std::string wrong = scene_->judge().disagreement(pairs);
    return wrong.empty() ? scene_->objection_to_areas() : wrong;
  }

 private:
  OverlapPairs sorted() const {
    OverlapPairs copy;
    copy.append_all(std::span(&pairs_, 1), 1);
    copy.sort(scene_->workload().x.size());
    return copy;
  }

  std::unique_ptr<OverlapEngine> engine_;
  std::shared_ptr<Scene> scene_;
  OverlapSetup setup_;
  OverlapPairs pairs_;
  OverlapWork work_;
};

/// Areas of given pairs: one in eight apart, one in eight a disc within the other. The rest cross
/// far enough from contact for the textbook's form to have twelve digits.
class LensKernel final : public WatchedKernel {
 public:
  LensKernel() {
    for (std::size_t p = 0; p < count; ++p) add_pair(p);
    area_.resize(count);
  }

  std::string inputs() const override {
    return KernelDigest().add(r_).add(s_).add(distance_).hex();
  }
  void run() override { lens_areas(r_, s_, distance_, area_); }
  std::string answer() const override { return KernelDigest().add(area_).hex(); }

  WorkCounts work() const override {
    const auto apart = std::count(area_.begin(), area_.end(), 0.0);
    return {{"pairs", area_.size()},
            {"overlaps", area_.size() - static_cast<std::uint64_t>(apart)}};
  }

  std::string objection() override {
    return objection_to_lens_areas(r_, s_, distance_, area_, seed);
  }

  static constexpr std::size_t count = 20'000;

 private:
  void add_pair(std::size_t p) {
    const double r = 1.0 + 2.0 * random_unit(seed, 10, p), s = 1.0 + 2.0 * random_unit(seed, 11, p);
    const double unit = random_unit(seed, 12, p), margin = 0.1 * std::min(r, s);
    const double inner = std::abs(r - s), outer = r + s;
    double distance = inner + margin + unit * (outer - inner - 2.0 * margin);
    if (p % 8 == 0) distance = outer * (1.0 + unit);
    if (p % 8 == 1) distance = inner * unit;
    r_.push_back(r);
    s_.push_back(s);
    distance_.push_back(distance);
  }

  std::vector<double> r_, s_, distance_, area_;
};

class CoverageKernel final : public WatchedKernel {
 public:
  explicit CoverageKernel(std::shared_ptr<Scene> scene) : scene_(std::move(scene)) {}

  std::string inputs() const override { return scene_->digest(); }

  void run() override {
    const OverlapWorkload& workload = scene_->workload();
    coverage_ = coverage(workload.discs(), workload.ground);
  }

  std::string answer() const override {
    return KernelDigest().add(coverage_.by_times).add(coverage_.covered).hex();
  }

  WorkCounts work() const override {
    return {{"discs", coverage_.covered.size()},
            {"most_at_a_place", coverage_.by_times.size() - 1},
            {"pairs", scene_->judge().pairs().size()}};
  }

  std::string objection() override {
    return objection_to_coverage(coverage_, scene_->workload(), seed);
  }

 private:
  std::shared_ptr<Scene> scene_;
  Coverage coverage_;
};

WatchedBenchmark search_by(const OverlapEngineDescriptor& engine,
                           const std::shared_ptr<Scene>& scene) {
  return {.name = fmt::format("overlap/{}", engine.name),
          .summary = fmt::format("Finds all overlaps among {} discs of mixed size on a torus. {}",
                                 scene->workload().x.size(), engine.summary),
          .is_own = engine.library.empty(),
          .prepare = [&engine, scene] { return std::make_unique<SearchKernel>(engine, scene); }};
}

std::vector<WatchedBenchmark> list_overlaps(const FamilyRequest&) {
  const auto mixed = [](std::size_t count) {
    return std::make_shared<Scene>(
        RandomDiscs{.count = count, .sizes = DiscSizes::mixed, .is_torus = true, .seed = seed});
  };
  const auto scene = mixed(4000), small_scene = mixed(1000);
  std::vector<WatchedBenchmark> all;
  for (const OverlapEngineDescriptor* engine : all_overlap_engines())
    if (engine->built())  // the one that looks at everything would take a quarter of a second
      all.push_back(search_by(*engine, engine->name == "all_pairs" ? small_scene : scene));
  all.push_back({.name = "overlap/lens-areas",
                 .summary = fmt::format("Common areas of {} given pairs of discs, in vectors.",
                                        LensKernel::count),
                 .is_own = true,
                 .prepare = [] { return std::make_unique<LensKernel>(); }});
  const auto ground = std::make_shared<Scene>(
      RandomDiscs{.count = 3000, .sizes = DiscSizes::uniform, .is_torus = true, .seed = seed});
  all.push_back({.name = "overlap/covered-ground",
                 .summary = "How often 3,000 discs on a torus cover its ground, and each other.",
                 .is_own = true,
                 .prepare = [ground] { return std::make_unique<CoverageKernel>(ground); }});
  return all;
}

}  // namespace

extern const BenchmarkFamily overlap;
constinit const BenchmarkFamily overlap{
    .name = "overlap",
    .summary = "Overlaps of discs with every engine, their areas, and the ground they cover.",
    .list = list_overlaps,
};

}  // namespace phytobench::families
