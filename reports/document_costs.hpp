// SPDX-License-Identifier: MIT
// What it costs to repeat an experiment: as this run measured it, or as its author expects.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/record/run_files.hpp"

namespace phytobench {

/// What a report says about an experiment besides its measurements. Reports do not include
/// experiments; the program hands these over.
struct ExperimentFacts {
  std::string question;    ///< one sentence
  std::string source;      ///< "[Key] where"
  double seconds[3] = {};  ///< rough expectation on a two-core machine: smoke, quick, full
};

/// Ready texts; empty where nothing is known.
struct CostOfRepeat {
  std::string time;     ///< "12 s"
  std::string memory;   ///< "45 MiB", of one run's peak; measured only
  bool varies = false;  ///< measured in this run, and so different in each
};

/// The timings "<experiment>/cost/seconds" and "<experiment>/cost/peak_memory" of a run say what
/// the run itself cost. Another tier costs what is expected of it.
class ExperimentCosts {
 public:
  ExperimentCosts(const RunContents& run, std::map<std::string, ExperimentFacts> facts,
                  bool without_varying);

  /// Of all these experiments together at a tier: sum of their times, largest memory. Nothing if
  /// the time of one of them is not known.
  CostOfRepeat of(const std::vector<std::string>& experiments, Tier tier) const;

  /// Total time of the run's experiments; 0 where the run does not say.
  double measured_seconds() const;

  const std::map<std::string, ExperimentFacts>& facts() const { return facts_; }

 private:
  Tier tier_;
  std::map<std::string, ExperimentFacts> facts_;
  std::map<std::string, double> seconds_;
  std::map<std::string, double> peak_mib_;
};

/// Whether a timing is one of those that an experiment's own cost rests on.
bool is_cost(const TimingSample& sample);

}  // namespace phytobench
