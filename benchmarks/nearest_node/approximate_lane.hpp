// SPDX-License-Identifier: MIT
// Engines that only come close to the nearest node, beside the race and never ranked in it: what is
// gained in time is shown against what is lost of the tree.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "benchmarks/nearest_node/flann_randomised.hpp"
#include "benchmarks/nearest_node/growth_trace.hpp"
#include "benchmarks/nearest_node/workload.hpp"

namespace phytobench {

/// One approximate engine with one loop option. Where the engine is not built the rest is empty.
/// Nothing but the order repeats: the engines' answers differ from run to run.
struct ApproximateEntry {
  const EngineDescriptor* engine = nullptr;  ///< one of approximate_engines()
  std::string option;                        ///< one of loop_option_names

  /// Times of whole growths, one per round. Their trees are not verified: that they differ is the
  /// point.
  std::vector<PhaseSeconds> rounds;

  /// Of the tree of the last round, stem included.
  std::size_t nodes = 0;

  /// tree_difference() from the exact tree, of the last round alone: other rounds grew other trees.
  double tree_difference = 0.0;

  /// wrong_answer_share() in one replay of the exact growth, with an index of its own.
  double wrong_answers = 0.0;

  std::string name() const { return std::string(engine->name) + " " + option; }
};

/// Share of edges, of all those in either tree, that are not in both: 1 - |A n B| / |A u B|, from 0
/// (the same edges) to 1 (none in common). An edge is the positions of parent and child, equal if
/// all bits are, whatever the order in which nodes were made; repeated edges count once. Stem
/// included. Two trees without edges do not differ.
///
/// A strict measure, in closed loop: one wrong answer moves a node, and with it everything that
/// grows from there.
double tree_difference(const Skeleton& exact, const Skeleton& other);

/// How often `other` answers another node than `exact`, from 0 to 1, where every answer counts that
/// is a node in at least one of both: of each point in each association of the trace. 0 if there is
/// none. Open loop: both are asked what the exact growth asked, so that no mistake causes others.
double wrong_answer_share(const GrowthTrace& trace, const EngineDescriptor& exact,
                          const EngineDescriptor& other, std::span<const Vector3> points,
                          int threads = 1);

/// All approximate_engines() with each option: `rounds` (at least 1) timed growths each, in turns.
/// `exact` is trusted, and must be built. Entries are in the order of engines, then options.
/// `show_progress` is called before each step; it may be empty, and may throw to stop.
std::vector<ApproximateEntry> run_approximate_lane(
    const Workload& workload, const EngineDescriptor& exact,
    const std::vector<std::string>& options, int rounds,
    const std::function<void(const std::string&)>& show_progress, int threads = 1);

}  // namespace phytobench
