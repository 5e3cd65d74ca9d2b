// SPDX-License-Identifier: MIT
// For tests: two builds on a machine whose every whim is known. No time passes but on its clock.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "benchmarks/comparison/paired_timing.hpp"
#include "benchmarks/comparison/timed_side.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

struct SimulatedMachine {
  double clock_s = 0.0;
  double noise = 0.01;       ///< largest log change of a process's speed, drawn for each
  double drift = 0.0;        ///< log change of the speed from one process to the next
  std::set<int> busy;        ///< processes, by number, that others push off the processor
  std::set<int> stolen;      ///< processes during which another virtual machine takes 10 %
  std::set<int> dead = {};   ///< processes, by number, that somebody kills
  std::string started = {};  ///< names of the sides, one letter for each process that was timed
  std::vector<SamplePlan> plans = {};  ///< what these were asked
  double stolen_share = 0.0;           ///< since it was asked last

  double take_stolen_share() {
    const double share = stolen_share;
    stolen_share = 0.0;
    return share;
  }
};

struct SimulatedBenchmark {
  double seconds = 1e-3;  ///< of one iteration
  std::string inputs = "inputs";
  std::string answer = "answer";
  std::string objection = {};           ///< of the oracle
  std::string sampling_objection = {};  ///< found while it is timed
  std::uint64_t iterations = 10;
  int deaths = 0;              ///< so many processes that time it die of it, first
  int calibration_deaths = 0;  ///< likewise
};

class SimulatedSide final : public TimedSide {
 public:
  SimulatedSide(SimulatedMachine& machine, char name,
                std::map<std::string, SimulatedBenchmark> benchmarks)
      : machine_(machine), name_(name), benchmarks_(std::move(benchmarks)) {}

  std::vector<std::string> names() override {
    std::vector<std::string> names;
    for (const auto& [name, benchmark] : benchmarks_) names.push_back(name);
    return names;
  }

  std::vector<VerifiedBenchmark> verify(const std::vector<std::string>& names) override {
    std::vector<VerifiedBenchmark> verified;
    for (const std::string& name : names) {
      const SimulatedBenchmark& own = benchmarks_.at(name);
      verified.push_back({name, own.inputs, own.answer, own.objection, {}});
    }
    return verified;
  }

  std::vector<CalibratedBenchmark> calibrate(const std::vector<std::string>& names,
                                             double) override {
    for (const std::string& name : names) die_of(benchmarks_.at(name).calibration_deaths);
    std::vector<CalibratedBenchmark> calibrated;
    for (const std::string& name : names)
      calibrated.push_back({name, benchmarks_.at(name).iterations, benchmarks_.at(name).seconds});
    return calibrated;
  }

  std::vector<SampledBenchmark> sample(const SamplePlan& plan) override {
    const int process = static_cast<int>(machine_.started.size());
    machine_.started += name_;
    machine_.plans.push_back(plan);
    if (machine_.stolen.contains(process)) machine_.stolen_share = 0.1;
    if (machine_.dead.contains(process)) die();
    for (const SamplePlan::Benchmark& planned : plan.benchmarks)
      die_of(benchmarks_.at(planned.name).deaths);
    std::vector<SampledBenchmark> sampled;
    for (const SamplePlan::Benchmark& planned : plan.benchmarks)
      sampled.push_back(sample(planned, plan.samples, process));
    return sampled;
  }

 private:
  [[noreturn]] static void die() {
    throw WorkerDied("a simulated worker died", {.reason = "its worker was killed"});
  }
  static void die_of(int& deaths_left) {
    if (deaths_left <= 0) return;
    --deaths_left;
    die();
  }

  SampledBenchmark sample(const SamplePlan::Benchmark& planned, int samples, int process) {
    const SimulatedBenchmark& own = benchmarks_.at(planned.name);
    SampledBenchmark sampled{.name = planned.name, .objection = own.sampling_objection};
    if (machine_.busy.contains(process)) sampled.involuntary_switches = 1000;
    if (!sampled.objection.empty()) return sampled;
    const double toss = random_unit(20, static_cast<std::uint64_t>(process), planned.name.size());
    const double factor = std::exp(machine_.noise * (2.0 * toss - 1.0) + machine_.drift * process);
    for (int i = 0; i < samples; ++i) {
      const double seconds = own.seconds * factor * static_cast<double>(planned.iterations);
      sampled.samples.push_back({planned.iterations, seconds, seconds});
      machine_.clock_s += seconds;
    }
    return sampled;
  }

  SimulatedMachine& machine_;
  char name_;
  std::map<std::string, SimulatedBenchmark> benchmarks_;
};

/// A comparison of two simulated sides by the simulated clock.
inline PairRequest simulated_pair(SimulatedMachine& machine, TimedSide& base, TimedSide& other,
                                  std::vector<std::string> names) {
  return {.base = &base,
          .other = &other,
          .names = std::move(names),
          .settings = {.seed = 8},
          .stolen_share = [&] { return machine.take_stolen_share(); },
          .clock_s = [&] { return machine.clock_s; }};
}

}  // namespace phytobench
