// SPDX-License-Identifier: MIT
#include "core/component_graph/component_values.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/component_graph/instance_identity.hpp"
#include "core/component_graph/parameter_expression.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

double ComponentValues::resolved(std::size_t key, const InstancePlace& place) const {
  const RangedNumber& kind = std::get<RangedNumber>(keys_[key].kind);
  const auto* range = std::get_if<ParameterRange>(&settings_[key]);
  if (range == nullptr) return kind.default_value;
  const double value = range->resolved(place);
  const double rounded = kind.range.whole ? std::round(value) : value;
  NumberRange limits = kind.range;
  limits.low = std::max(limits.low, -largest_parameter);
  limits.high = std::min(limits.high, largest_parameter);
  if (is_allowed(rounded, limits)) return rounded;
  throw InputError(fmt::format("{} (it is that at i = {}, n = {}, depth = {}, t = {})",
                               out_of_range(range->where, rounded, limits), place.number.i,
                               place.number.n, place.depth, place.time));
}

double ComponentValues::number(std::size_t key) const {
  PHYTOBENCH_EXPECT(std::get<RangedNumber>(keys_[key].kind).over == RangeOver::siblings);
  return resolved(key, place_);
}

double ComponentValues::number_for_child(std::size_t key, const SiblingNumber& child) const {
  PHYTOBENCH_EXPECT(std::get<RangedNumber>(keys_[key].kind).over == RangeOver::children);
  InstancePlace place = place_;
  place.number = child;
  place.identity = identity_of_child(place_.identity, any_link, child.i);
  return resolved(key, place);
}

std::uint64_t ComponentValues::count(std::size_t key) const {
  const double value = number(key);
  PHYTOBENCH_EXPECT(value >= 0.0 && value <= largest_parameter && value == std::floor(value));
  return static_cast<std::uint64_t>(value);
}

std::size_t ComponentValues::choice(std::size_t key) const {
  const auto* word = std::get_if<std::size_t>(&settings_[key]);
  return word != nullptr ? *word : std::get<WordChoice>(keys_[key].kind).default_word;
}

Colour ComponentValues::colour(std::size_t key) const {
  const auto* colour = std::get_if<Colour>(&settings_[key]);
  return colour != nullptr ? *colour
                           : parse_colour(std::get<ColourValue>(keys_[key].kind).default_colour);
}

std::span<const double> ComponentValues::list(std::size_t key) const {
  const auto* given = std::get_if<GivenNumbers>(&settings_[key]);
  if (given != nullptr) return given->numbers;
  return std::get<NumberList>(keys_[key].kind).default_numbers;
}

std::string ComponentValues::place_of_list(std::size_t key) const {
  const auto* given = std::get_if<GivenNumbers>(&settings_[key]);
  return given != nullptr ? given->where : std::string(keys_[key].name);
}

std::shared_ptr<const VectorField> ComponentValues::field(std::size_t key) const {
  const auto* field = std::get_if<std::shared_ptr<const VectorField>>(&settings_[key]);
  if (field != nullptr) return *field;
  const FieldExpressions& kind = std::get<FieldExpressions>(keys_[key].kind);
  return std::make_shared<VectorField>(parse_vector_field(
      {kind.default_x, kind.default_y, kind.default_z}, std::string(keys_[key].name)));
}

}  // namespace phytobench
