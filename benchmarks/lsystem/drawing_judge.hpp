// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "benchmarks/lsystem/bench_systems.hpp"
#include "benchmarks/lsystem/drawing_digest.hpp"

namespace phytobench {

/// Knows what a system draws: how much by the matrix of its letters, and what by a literal turtle
/// on long doubles that goes through the productions letter by letter. Shares nothing with the
/// engines but the system.
class DrawingJudge {
 public:
  /// The workload must outlive the judge. Takes about a second for ten million segments.
  explicit DrawingJudge(const LSystemWorkload& workload);

  /// What is wrong with a drawing; empty if nothing.
  std::string disagreement(const DrawingDigest& found) const;

  /// By how much a coordinate may be off; 0 where all numbers are exact in doubles.
  double bound() const { return bound_; }
  bool planar() const { return planar_; }

 private:
  const LSystemWorkload& workload_;
  DrawingDigest right_;
  double bound_ = 0.0;
  bool planar_ = false;
};

}  // namespace phytobench
