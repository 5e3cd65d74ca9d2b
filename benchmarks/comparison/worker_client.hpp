// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/comparison/child_process.hpp"
#include "benchmarks/comparison/side.hpp"
#include "benchmarks/comparison/timed_side.hpp"
#include "benchmarks/regression/worker_protocol.hpp"

namespace phytobench {

struct WorkerClientOptions {
  std::function<bool()> is_interrupted = {};  ///< may be empty
  /// The worker's processor while it measures time; see processor_split.hpp. Nothing: any.
  std::optional<int> processor = std::nullopt;
  double sample_ms = 10.0;        ///< planned length of a sample; only its limit depends on it
  double verify_limit_s = 600.0;  ///< of a process that judges, counts or lists
  double sample_limit_s = 600.0;  ///< of one that times, besides ten times what is planned: a
                                  ///< sample is at least one run, however long that takes
  /// Seconds that one answer may take; > 0. Both limits are replaced by what the answers may take
  /// that a process is asked for. Nothing: they stand.
  std::optional<double> answer_limit_s = std::nullopt;
};

/// How the worker of a side is called, for programs that run it as well (callgrind). Both sides of
/// a comparison get equal environments. Their size, with that of the arguments, is made equal, too:
/// it moves the stack, and times with it (Mytkowicz et al. 2009, "Producing wrong data without
/// doing anything obviously wrong").
ChildOptions worker_call(const Side& side, const std::string& verb,
                         const std::vector<std::string>& arguments);

/// Asks the worker of a side, each time in a fresh process. A worker has died if a signal or its
/// limit ended it, or if it ended by itself with neither an answer nor a refusal in its own words:
/// a plugin may end it, too. One that dies while it judges or counts is asked again for one
/// benchmark at a time; the one that this happens to has an objection then. Throws InputError, with
/// the side's title, for what the worker refuses and for answers that cannot be read;
/// NothingSelected; Interrupted; WorkerDied where it died of anything else; EnvironmentError for
/// all else.
class WorkerClient : public TimedSide {
 public:
  /// The side must have a worker.
  explicit WorkerClient(Side side, WorkerClientOptions options = {});

  const Side& side() const { return side_; }

  WorkerDescription describe() const;

  std::vector<std::string> names() override;

  /// Without names: all benchmarks. So with the others.
  std::vector<VerifiedBenchmark> verify(const std::vector<std::string>& names) override;
  std::vector<VerifiedBenchmark> counters(const std::vector<std::string>& names);

  std::vector<CalibratedBenchmark> calibrate(const std::vector<std::string>& names,
                                             double sample_ms) override;

  std::vector<SampledBenchmark> sample(const SamplePlan& plan) override;

 private:
  ChildResult run(ChildOptions call, double limit_s) const;
  ChildResult run_timed(ChildOptions call, double limit_s) const;
  std::vector<VerifiedBenchmark> judge(const std::string& verb,
                                       const std::vector<std::string>& names) const;
  std::string answer_of(const ChildResult& result, const std::string& verb, double limit_s) const;

  /// Seconds for a process that gives so many answers; `otherwise` without a limit of answers.
  double limit_of(std::size_t answers, double otherwise) const;

  Side side_;
  WorkerClientOptions options_;
};

}  // namespace phytobench
