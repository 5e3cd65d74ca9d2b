// SPDX-License-Identifier: MIT
// Which vertices of a terrain the sun reaches, hour by hour.
#include <array>
#include <memory>

#include <fmt/format.h>

#include "benchmarks/regression/checks/shadow_checks.hpp"
#include "benchmarks/regression/families/kernel_digest.hpp"
#include "benchmarks/regression/watched_benchmarks.hpp"
#include "benchmarks/shadow/shadow_workload.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"

namespace phytobench::families {

namespace {

/// Of rays, at most: half as much again as sheared_sweep (0.00068) and line_sweep (0.0079) get
/// wrong on this terrain.
double wrong_share_of(const ShadowEngineDescriptor& engine) {
  if (engine.exact) return 0.0;
  return engine.name == "sheared_sweep" ? 0.00102 : 0.0119;
}

/// For one thread.
class ShadowKernel final : public WatchedKernel {
 public:
  ShadowKernel(const ShadowEngineDescriptor& engine, std::shared_ptr<const ShadowWorkload> workload)
      : engine_(engine), caster_(engine.create()), workload_(std::move(workload)) {}

  std::string inputs() const override {
    const HeightField& field = workload_->field;
    KernelDigest digest;
    digest.add(field.heights())
        .add({digest_number(field.columns()), field.cell_width(), field.cell_depth()});
    for (const SunDirection& sun : workload_->suns) digest.add({sun.east, sun.south, sun.up});
    return digest.hex();
  }

  void run() override { work_ = caster_->cast(workload_->field, workload_->suns, setup_, lit_); }

  std::string answer() const override {
    KernelDigest digest;
    for (std::size_t position = 0; position < lit_.positions(); ++position)
      for (int row = 0; row < lit_.rows(); ++row)
        digest.add(std::span(lit_.row(position, row), lit_.words_per_row()));
    return digest.hex();
  }

  WorkCounts work() const override {
    return {{"samples", work_.samples},
            {"blocks", work_.blocks},
            {"rays", work_.rays},
            {"lit", lit_.positions() == 0 ? 0 : lit_.lit()}};
  }

  std::string objection() override {
    return objection_to_shadows(*workload_, lit_, wrong_share_of(engine_));
  }

 private:
  const ShadowEngineDescriptor& engine_;
  std::unique_ptr<ShadowEngine> caster_;
  std::shared_ptr<const ShadowWorkload> workload_;
  ShadowSetup setup_;
  LitMaps lit_;
  ShadowWork work_;
};

/// The slowest would be counted longer than all others together.
bool is_watched(const ShadowEngineDescriptor& engine) {
  return engine.built() && engine.name != "printed_march" && engine.name != "horizon_hull";
}

std::vector<WatchedBenchmark> list_shadows(const FamilyRequest&) {
  const auto workload = std::make_shared<const ShadowWorkload>(
      fractal_shadows({.size = 150, .relief = 400.0, .hours = 13, .seed = 8}));
  std::vector<WatchedBenchmark> all;
  for (const ShadowEngineDescriptor* engine : all_shadow_engines()) {
    if (!is_watched(*engine)) continue;
    all.push_back(
        {.name = fmt::format("shadow/{}", engine->name),
         .summary = fmt::format("Casts shadows on a fractal of {} vertices, {} hours. {}",
                                workload->field.size(), workload->suns.size(), engine->summary),
         .is_own = true,
         .prepare = [engine, workload] {
           return std::make_unique<ShadowKernel>(*engine, workload);
         }});
  }
  return all;
}

}  // namespace

extern const BenchmarkFamily shadow;
constinit const BenchmarkFamily shadow{
    .name = "shadow",
    .summary = "Shadows of a terrain, with engines that are exact and with sweeps.",
    .list = list_shadows,
};

}  // namespace phytobench::families
