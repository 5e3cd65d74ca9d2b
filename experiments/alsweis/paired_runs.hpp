// SPDX-License-Identifier: MIT
// Populations that start from the same plants and live by different rules: how often, and by how
// much, one has more of something than the other.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "core/parallel/for_blocks.hpp"
#include "core/population/population.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

/// Each question has plants of its own, so that one unlucky draw does not answer several.
enum class Question : std::uint64_t {
  size_inequality = 1,
  halves,
  bands,
  first_test,
  near_and_far,
  crowded_deaths,
  largest_age,
  all_events,
  removed_plants,
  seed_bank,
  density,
  thinning,
  figures,
};

/// The seed of run number `run`, below 1000, of a question.
std::uint64_t seed_of_run(const ExperimentContext& context, Question question, std::size_t run);

/// As sown, or from the plants given. On one thread: runs go side by side.
Population population_of(const PopulationParameters& parameters,
                         std::span<const StartPlant> plants = {});
/// The same after so many steps.
Population lived(const PopulationParameters& parameters, int steps,
                 std::span<const StartPlant> plants = {});

/// One value for each plant that lives: runs keep their plants in orders of their own.
using ByPlant = std::map<PlantId, double>;
ByPlant by_plant(const Stand& stand, std::span<const double> values);

/// Calls body(run) for runs 0 ... count - 1, as many at a time as the context has threads, and says
/// between them how far it is. Bodies write to places of their own.
template <class Body>
void for_runs(ExperimentContext& context, const std::string& what, std::size_t count,
              const Body& body) {
  const auto together = static_cast<std::size_t>(std::max(1, context.threads()));
  for (std::size_t first = 0; first < count; first += together) {
    context.progress(what + ", run " + std::to_string(first + 1) + " of " + std::to_string(count));
    const std::size_t now = std::min(together, count - first);
    for_tasks(now, context.threads(), [&](std::size_t i) { body(first + i); });
  }
}

/// `<name>`, the mean over the runs, with its spread.
void record_mean(ExperimentContext& context, const std::string& name,
                 std::span<const double> values, const std::string& unit = "1");

/// How much more one run of each pair has than the other:
///   <group>/wins             pairs with a difference above 0
///   <group>/mean_difference  with its spread over the pairs
///   <group>/standard_errors  mean difference over its standard error; 0 without any difference,
///                            and at most `certain` where all pairs differ by the same
/// At least two pairs, both spans of one length; ContractViolation otherwise.
void record_paired(ExperimentContext& context, const std::string& group,
                   std::span<const double> more, std::span<const double> less,
                   const std::string& unit = "1");

inline constexpr double certain = 1e6;

}  // namespace phytobench::experiments::alsweis
