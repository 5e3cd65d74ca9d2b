// SPDX-License-Identifier: MIT
// A scaling experiment whose every number a test chooses.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "reports/judge/scaling.hpp"

namespace phytobench {

/// A run of an experiment "p/s", written measurement by measurement.
class MadeUpRun {
 public:
  explicit MadeUpRun(int rounds = 6) : rounds_(rounds) {}
  void count(const std::string& name, std::int64_t value) {
    run_.records.push_back({.experiment = "p/s", .measurement = "p/s/" + name, .value = value});
  }
  void size(int points) {
    const std::string at = std::to_string(points);
    count(at + "/points", points);
    count(at + "/nodes", points / 5);
    count(at + "/iterations", 10);
    count(at + "/floor/association_pairs", points);
    count(at + "/floor/removal_pairs", points / 4);
  }
  /// An exact entry that took about `seconds` in each round.
  void entry(int points, const std::string& name, double seconds, std::int64_t evaluations) {
    const std::string at = std::to_string(points) + "/" + name;
    count(at + "/exact", 1);
    count(at + "/evaluations", evaluations);
    for (int round = 0; round < rounds_; ++round) {
      sample(at + "/seconds", round, seconds * (1.0 + 0.01 * round));
      sample(at + "/growth_seconds", round, 0.5 * seconds);
    }
  }
  void sample(const std::string& name, std::int64_t round, double value) {
    run_.timings.push_back({.experiment = "p/s",
                            .measurement = "p/s/" + name,
                            .round = round,
                            .position = 0,
                            .value = value,
                            .threads = 1});
  }
  JudgedScaling judged(std::vector<Aim> aims = {}) const {
    const Evidence evidence(run_);
    return judge_scaling({.id = "s", .experiment = "p/s", .title = {}, .intro = {}, .aims = aims},
                         run_, evidence);
  }

 private:
  int rounds_;
  RunContents run_;
};

/// Time as points, and as points squared but cheaper at first.
inline MadeUpRun two_engines(int rounds = 6) {
  MadeUpRun run(rounds);
  for (const int points : {1000, 10000, 100000}) {
    run.size(points);
    run.entry(points, "fast.dn", 1e-6 * points, 3 * points);
    run.entry(points, "simple.dn", 1e-10 * points * points, std::int64_t{points} * points);
  }
  return run;
}

}  // namespace phytobench
