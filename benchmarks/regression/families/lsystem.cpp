// SPDX-License-Identifier: MIT
// Deriving words, and drawing systems without parameters with every engine.
#include <fmt/format.h>

#include "benchmarks/lsystem/drawing_judge.hpp"
#include "benchmarks/lsystem/watched_derivations.hpp"
#include "benchmarks/regression/drawing_kernel.hpp"
#include "benchmarks/regression/families/kernel_digest.hpp"
#include "benchmarks/regression/watched_benchmarks.hpp"
#include "core/contract/work_counting.hpp"
#include "core/lsystem/derive.hpp"

namespace phytobench::families {

namespace {

class DerivationKernel final : public WatchedKernel {
 public:
  explicit DerivationKernel(DerivationCase derivation) : case_(std::move(derivation)) {
    options_.steps = case_.steps;
    options_.seed = case_.system.seed;
    options_.work = &work_;
    if (case_.every_word) options_.each_word = [](int, const Word&) {};
  }

  std::string inputs() const override {
    KernelDigest digest;
    digest.add(case_.text)
        .add({digest_number(case_.steps), digest_number(case_.every_word),
              digest_number(case_.system.seed)});
    for (const AxiomModule& module : case_.system.axiom)
      digest.add(case_.system.symbols[module.symbol].letter).add(module.parameters);
    return digest.hex();
  }

  void run() override { word_ = derive(case_.system, options_); }

  std::string answer() const override {
    return KernelDigest()
        .add(std::span(word_.symbols.data(), word_.symbols.size()))
        .add(std::span(word_.parameters.data(), word_.parameters.size()))
        .hex();
  }

  WorkCounts work() const override {
    WorkCounts counts{{"modules_read", work_.modules_read},
                      {"modules_written", work_.modules_written},
                      {"parameters_written", work_.parameters_written}};
    if (counts_inner_loop) counts["productions_tried"] = work_.productions_tried;
    return counts;
  }

  std::string objection() override { return case_.objection(word_); }

 private:
  DerivationCase case_;
  DeriveOptions options_;
  DerivationWork work_;
  Word word_;
};

/// Right angles and no branches; branches; space.
std::vector<std::shared_ptr<DrawnSystem>> drawn_systems() {
  constexpr double segments = 140'000;
  std::vector<std::shared_ptr<DrawnSystem>> all;
  for (const char* name : {"koch_island", "plant"})
    all.push_back(std::make_shared<DrawnSystem>(lsystem_workload(name, segments)));
  all.push_back(std::make_shared<DrawnSystem>(bush_in_space(9)));
  return all;
}

WatchedBenchmark drawing_by(const DerivationEngine& engine,
                            const std::shared_ptr<DrawnSystem>& system, DrawingLane lane) {
  const bool streams = lane == DrawingLane::stream;
  return {.name = fmt::format("lsystem/{}/{}{}", engine.name, system->workload().name,
                              streams ? "" : "-into-memory"),
          .summary = fmt::format("Draws {} segments{}. {}", system->workload().segments,
                                 streams ? "" : ", which the engine itself writes into an array",
                                 engine.summary),
          .is_own = true,
          .prepare = [&engine, system, lane] { return drawing_kernel(engine, system, lane); }};
}

std::vector<WatchedBenchmark> list_derivations(const FamilyRequest&) {
  std::vector<WatchedBenchmark> all;
  for (const WatchedDerivation& watched : watched_derivations())
    all.push_back(
        {.name = "lsystem/" + watched.name,
         .summary = watched.summary,
         .is_own = true,
         .prepare = [make = watched.make] { return std::make_unique<DerivationKernel>(make()); }});
  const auto systems = drawn_systems();
  for (const DerivationEngine* engine : all_derivation_engines())
    for (const auto& system : systems) {
      if (!engine->built() || !engine->objection(system->workload().system).empty()) continue;
      all.push_back(drawing_by(*engine, system, DrawingLane::stream));
      if (engine->write != nullptr) all.push_back(drawing_by(*engine, system, DrawingLane::memory));
    }
  return all;
}

}  // namespace

extern const BenchmarkFamily lsystem;
constinit const BenchmarkFamily lsystem{
    .name = "lsystem",
    .summary = "Deriving words, and drawing with every engine.",
    .list = list_derivations,
};

}  // namespace phytobench::families
