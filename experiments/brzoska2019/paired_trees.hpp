// SPDX-License-Identifier: MIT
// Trends over many trees: the same seeds grown with different settings, compared seed by seed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/colonization/tree_parameters.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

/// A trend is judged on as many pairs of trees. A fair coin agrees with a direction in 15 or more
/// of 20 throws in 2 % of all cases.
inline constexpr std::size_t trees_per_trend = 20;
/// For a trend that about six trees in seven follow: of 20 trees fewer than three quarters would do
/// so by chance under one seed of the run in twenty, of 100 under one in a thousand.
inline constexpr std::size_t trees_per_weak_trend = 100;

/// One value per tree, in the order of the seeds.
using ByTree = std::vector<double>;

/// The parameters with the suite's own random numbers and the seed of tree `number`, below 1000;
/// another --seed of the run means other trees.
TreeParameters tree_of_trend(TreeParameters parameters, const ExperimentContext& context,
                             std::size_t number);

/// Grown with the default engine, each removal done in its own iteration.
GrowthResult grow_seedling(const Seedling& seedling, const ExperimentContext& context);

struct GrownTree {
  Seedling seedling;
  Skeleton skeleton{Vector3{}};
};

/// Trees of one setting that reach their last iteration. Now and then growth stops while a tree is
/// small (sec. 6.2); the next seed takes its place then, as the thesis advises.
class FullTrees {
 public:
  FullTrees(TreeParameters parameters, const ExperimentContext& context)
      : parameters_(std::move(parameters)), context_(context) {}

  /// ContractViolation if a thousand seeds do not grow enough trees.
  GrownTree next();
  /// The seed of the tree that next() gave as that number, from 0. It is not that of
  /// tree_of_trend() once a tree was left out.
  std::uint64_t seed(std::size_t number) const;
  std::int64_t left_out() const { return left_out_; }

 private:
  TreeParameters parameters_;
  const ExperimentContext& context_;
  std::vector<std::uint64_t> seeds_;
  std::size_t number_ = 0;
  std::int64_t left_out_ = 0;
};

/// The seed with which the tree of a number was grown.
using SeedOfTree = std::function<std::uint64_t(std::size_t)>;

/// The values of trees 0 ... trees - 1, recorded as "<name>/tree-07" and "<name>/mean".
/// `seed_of_tree` is asked after the value; without it trees are those of tree_of_trend().
ByTree record_trees(ExperimentContext& context, const std::string& name, const std::string& unit,
                    const std::function<double(std::size_t)>& value_of_tree,
                    std::size_t trees = trees_per_trend, const SeedOfTree& seed_of_tree = {});

/// In how many trees `more` is greater than `less`: "<name>/wins", with the mean difference beside
/// it.
void record_trend(ExperimentContext& context, const std::string& name, const ByTree& more,
                  const ByTree& less);

/// The same for each value of a setting against the next: "<name>/0.2-to-0.4/wins" says how many
/// trees have less with the second. Names and values in order.
void record_falling(ExperimentContext& context, const std::string& name,
                    const std::vector<std::string>& settings, const std::vector<ByTree>& values);

}  // namespace phytobench::experiments::brzoska2019
