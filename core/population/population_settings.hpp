// SPDX-License-Identifier: MIT
// The parameters of a population as a list of texts, to tell whether two runs are the same.
#pragma once

#include <string>
#include <vector>

#include "core/population/population_parameters.hpp"

namespace phytobench {

struct Setting {
  std::string key;    ///< "seed", "species.oak.growth_rate"
  std::string value;  ///< numbers as short as they can be read back

  friend bool operator==(const Setting&, const Setting&) = default;
};

/// All that the steps of a population depend on, key by key: with the same settings and the same
/// plants to start with, the same happens. Not the number of steps, which may be raised later, nor
/// most_plants, which ends a run or does nothing.
std::vector<Setting> settings_of(const PopulationParameters& parameters);

/// 64 bits of FNV-1a (Fowler, Noll and Vo), which notice every change of a single byte. Goes on
/// from `before`.
inline constexpr std::uint64_t digest_of_nothing = 0xcbf29ce484222325ULL;
std::uint64_t digest(std::string_view bytes, std::uint64_t before = digest_of_nothing);

}  // namespace phytobench
