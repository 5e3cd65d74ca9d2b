// SPDX-License-Identifier: MIT
// Who says what is right while an engine grows a tree.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/colonization/growth.hpp"
#include "reference/oracles/brzoska2019_grid_colonization.hpp"
#include "reference/oracles/brzoska2019_space_colonization.hpp"

namespace phytobench {

/// Follows one growth and gives the right answer to every call an engine gets. restart() begins
/// with the next growth of the same seedling.
class GrowthJudge {
 public:
  virtual ~GrowthJudge() = default;

  virtual void restart() = 0;

  /// Node per point, -1 for none. Empty if there should have been no such call. A view, valid until
  /// the next call.
  virtual std::span<const int> associate(std::span<const SearchableNode> new_nodes) = 0;

  /// Removed points, ascending. `expected` says whether there should have been such a call.
  virtual std::vector<int> remove(std::span<const SearchableNode> killers, double distance,
                                  bool& expected) = 0;

  /// Hash of the right tree; empty if not known beforehand.
  virtual std::string tree_hash() const = 0;

  /// What is judged by, in words.
  virtual std::string name() const = 0;
};

/// The oracle's problem for a seedling: the same inputs in the oracle's own words.
oracles::brzoska2019::GrowthProblem oracle_problem(const Seedling& seedling);

/// The literal answer for one seedling, computed once. Time and memory grow with points x nodes:
/// for up to 100,000 points.
class GrowthOracle {
 public:
  static constexpr std::size_t most_points = 100'000;

  explicit GrowthOracle(const Seedling& seedling);

  const oracles::brzoska2019::GrownTree& tree() const { return tree_; }

  /// Hash of the whole skeleton, stem included, as tree_hash() would give it.
  const std::string& hash() const { return hash_; }

 private:
  oracles::brzoska2019::GrownTree tree_;
  std::string hash_;
};

/// Judges by the literal oracle. Must not outlive it.
std::unique_ptr<GrowthJudge> make_literal_judge(const GrowthOracle& oracle);

/// Judges larger clouds: by the grid oracle for every point, and by looking at every node for a
/// sample of points chosen with `seed`; throws ContractViolation if these two ever differ. Must not
/// outlive the seedling.
std::unique_ptr<GrowthJudge> make_grid_judge(const Seedling& seedling, std::uint64_t seed,
                                             std::size_t sampled_points = 10'000);

}  // namespace phytobench
