// SPDX-License-Identifier: MIT
// For tests: a comparison with a benchmark of every verdict.
#pragma once

#include <string>
#include <utility>

#include "benchmarks/comparison/comparison_report.hpp"

namespace phytobench {

inline void add_example(ComparisonReport& report, const std::string& name, SpeedVerdict verdict,
                        double ratio = 0.0) {
  ConcludedBenchmark concluded{
      .name = name, .verdict = verdict, .reason = "because of this", .blocks = 8};
  MeasuredBenchmark measured{.name = name};
  if (ratio > 0.0) {
    concluded.ratio = Estimate{ratio, 0.99 * ratio, 1.01 * ratio};
    concluded.control = Estimate{1.0, 0.995, 1.005};
    concluded.noise_floor = 0.005;
    for (int block = 0; block < 8; ++block) {
      const BlockTimes times{.block = block,
                             .order = block % 2 == 0 ? "ABBA" : "BAAB",
                             .base = {1e-3, 1e-3},
                             .other = {ratio * 1e-3, ratio * 1e-3}};
      measured.blocks.push_back(times);
      measured.control.push_back(times);
      for (const bool is_control : {true, false})
        for (int position = 0; position < 4; ++position)
          report.timing.samples.push_back(
              {name,
               is_control,
               block,
               position,
               times.order[static_cast<std::size_t>(position)] == 'B',
               {.name = name, .samples = {{10, 1e-2, 1.1e-2}}, .involuntary_switches = 1}});
    }
    report.timing.calibrated.push_back({name, 10, 1e-3});
  } else {
    measured.objection = concluded.reason;
  }
  report.concluded.push_back(std::move(concluded));
  report.timing.measured.benchmarks.push_back(std::move(measured));
}

inline ComparisonReport example_report() {
  ComparisonReport report;
  report.timing.measured.base = {.given = "HEAD~1", .kind = "revision", .commit = "1a2b3c4d5e6f"};
  report.timing.measured.other = {
      .given = "build", .kind = "build", .commit = "f6e5d4c3b2a1", .changed = true};
  report.timing.measured.seed = 8;
  report.timing.seconds = 90.0;
  add_example(report, "engine/same", SpeedVerdict::same, 1.001);
  add_example(report, "engine/faster", SpeedVerdict::faster, 0.8);
  add_example(report, "engine/slower", SpeedVerdict::slower, 1.1);
  add_example(report, "engine/noisy", SpeedVerdict::inconclusive, 1.02);
  add_example(report, "engine/wrong", SpeedVerdict::wrong_answer);
  add_example(report, "engine/absent", SpeedVerdict::nothing_measured);
  return report;
}

}  // namespace phytobench
