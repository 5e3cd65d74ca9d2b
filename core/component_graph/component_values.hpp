// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/component_graph/component_key.hpp"
#include "core/component_graph/parameter_range.hpp"
#include "core/component_graph/sibling_number.hpp"
#include "core/component_graph/vector_field.hpp"
#include "core/picture/image.hpp"

namespace phytobench {

/// A list of numbers, and where it was given, for messages: "file:12: box.moves". Two are equal
/// where their numbers are.
struct GivenNumbers {
  std::vector<double> numbers;
  std::string where;
  friend bool operator==(const GivenNumbers& a, const GivenNumbers& b) {
    return a.numbers == b.numbers;
  }
};

/// What a prototype has set for one key; monostate: the default of the key. Word choices are kept
/// as the position of the word.
using ComponentSetting = std::variant<std::monostate, ParameterRange, std::size_t, Colour,
                                      GivenNumbers, std::shared_ptr<const VectorField>>;

/// The values of one instance: the settings of its prototype, resolved for its place in the tree
/// and the time. `key` is the position in the kind's list of keys. Cheap to make and to copy.
class ComponentValues {
 public:
  ComponentValues(std::span<const ComponentKey> keys, std::span<const ComponentSetting> settings,
                  const InstancePlace& place)
      : keys_(keys), settings_(settings), place_(place) {}

  const InstancePlace& place() const { return place_; }

  /// A number over siblings, within its range. Throws InputError if a function leaves the range.
  double number(std::size_t key) const;
  /// A number over children, for the i-th of n children.
  double number_for_child(std::size_t key, const SiblingNumber& child) const;
  /// number() of a key whose numbers are whole.
  std::uint64_t count(std::size_t key) const;
  std::size_t choice(std::size_t key) const;
  Colour colour(std::size_t key) const;
  std::span<const double> list(std::size_t key) const;
  /// Where the list was given, for messages that refuse it; the key's name if nowhere.
  std::string place_of_list(std::size_t key) const;
  std::shared_ptr<const VectorField> field(std::size_t key) const;

 private:
  double resolved(std::size_t key, const InstancePlace& place) const;

  std::span<const ComponentKey> keys_;
  std::span<const ComponentSetting> settings_;
  InstancePlace place_;
};

}  // namespace phytobench
