// SPDX-License-Identifier: MIT
// What a key of a population file can be: how it is read, checked and shown.
#pragma once

#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "core/contract/parameter_keys.hpp"
#include "core/population/population_parameters.hpp"

namespace phytobench {

/// Of the ground, m: its sides, and its lower left corner. Where they differ more, rounding eats
/// the distances between plants.
inline constexpr NumberRange ground_side{.low = 0.001, .high = 1e6};
inline constexpr NumberRange ground_corner{.low = -1e9, .high = 1e9};

/// One [[influence]] of a file: of all plants of one species on those of another.
struct InfluenceEntry {
  std::string of, on;  ///< names of species, or "*"
  Influence above = Influence::harms, below = Influence::harms;
};

/// What stands in a file. Of the lists it holds the entry that is being read or looked at.
struct PopulationFileValues {
  PopulationParameters parameters;
  Point2 ground_size{200.0, 200.0}, ground_corner;
  std::string plants, nutrients, light;  ///< file names, "" for none
  Species species;
  double root_factor = 15.0, crown_factor = 15.0;  ///< on any soil, in any light
  InfluenceEntry influence;
  PopulationEvent event;
  std::string event_species;  ///< a name, "" for all
};

struct PopulationNumber {
  NumberRange range;
  std::function<double(const PopulationFileValues&)> value;
  std::function<void(PopulationFileValues&, double)> assign;
};

/// Two numbers, as in [3.0, 5.0].
struct PopulationPair {
  NumberRange range;
  std::function<Point2(const PopulationFileValues&)> value;
  std::function<void(PopulationFileValues&, const Point2&)> assign;
};

/// One of a few words, by its position.
struct PopulationChoice {
  std::vector<std::string_view> words;
  std::function<std::size_t(const PopulationFileValues&)> chosen;
  std::function<void(PopulationFileValues&, std::size_t)> choose;
};

struct PopulationSwitch {
  bool& (*place)(PopulationFileValues&) = nullptr;
};

struct PopulationText {
  std::string_view allowed;  ///< in words
  std::string& (*place)(PopulationFileValues&) = nullptr;
};

/// A file, seen from the folder of the parameter file; "" is none.
struct PopulationFileName {
  std::string& (*place)(PopulationFileValues&) = nullptr;
};

struct PopulationIds {
  std::vector<PlantId>& (*place)(PopulationFileValues&) = nullptr;
};

using PopulationKeyKind =
    std::variant<PopulationNumber, PopulationPair, PopulationChoice, PopulationSwitch,
                 PopulationText, PopulationFileName, PopulationIds>;

namespace population_key {

/// `place` takes values, constant or not, and returns the number there. Whole numbers are whole in
/// the file too; the largest of their type stands for infinity where that is allowed.
template <class Place>
PopulationNumber number(NumberRange range, Place place) {
  using Values = PopulationFileValues;
  using Number = std::remove_reference_t<decltype(place(std::declval<Values&>()))>;
  range.whole = std::is_integral_v<Number>;
  const bool may_be_infinite = range.infinity_is_allowed && range.whole;
  const auto value = [place, may_be_infinite](const Values& values) {
    const Number number = place(values);
    return may_be_infinite && number == std::numeric_limits<Number>::max()
               ? std::numeric_limits<double>::infinity()
               : static_cast<double>(number);
  };
  const auto assign = [place, may_be_infinite](Values& values, double number) {
    place(values) = may_be_infinite && std::isinf(number) ? std::numeric_limits<Number>::max()
                                                          : static_cast<Number>(number);
  };
  return {range, value, assign};
}

/// Choice between consecutive enumerators in the order of the words, the first of which is `first`.
template <class Place>
PopulationChoice choice(std::vector<std::string_view> words, Place place, int first = 0) {
  using Values = PopulationFileValues;
  using Word = std::remove_reference_t<decltype(place(std::declval<Values&>()))>;
  const auto chosen = [place, first](const Values& values) {
    return static_cast<std::size_t>(static_cast<int>(place(values)) - first);
  };
  const auto choose = [place, first](Values& values, std::size_t word) {
    place(values) = static_cast<Word>(static_cast<int>(word) + first);
  };
  return {std::move(words), chosen, choose};
}

}  // namespace population_key

}  // namespace phytobench
