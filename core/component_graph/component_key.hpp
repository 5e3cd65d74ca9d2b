// SPDX-License-Identifier: MIT
// What a kind of component lets its users set: the one list that the file reader, the commented
// example and the component itself share.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <variant>

#include "core/contract/parameter_keys.hpp"

namespace phytobench {

/// What a range [first, last] of a number is interpolated over, and what i and n mean.
enum class RangeOver {
  siblings,  ///< the instance's own number among its siblings
  children,  ///< the children or branches that it makes: the component asks for each of them
};

/// A number, a range, a function or key frames (parameter_range.hpp). Those that must be whole are
/// rounded to the nearest after all of that.
struct RangedNumber {
  NumberRange range;
  double default_value = 0.0;
  RangeOver over = RangeOver::siblings;
};

/// One of these words.
struct WordChoice {
  std::span<const std::string_view> words;
  std::size_t default_word = 0;
};

/// "#rrggbb".
struct ColourValue {
  std::string_view default_colour;
};

/// Numbers that stay as they are: a profile, an outline, the points of a lattice.
struct NumberList {
  NumberRange range;
  std::span<const double> default_numbers;
  std::size_t fewest = 0;
  std::size_t most = 1000;
};

/// A vector for every place, as three expressions of x, y, z and t: ["0", "1", "0"].
struct FieldExpressions {
  std::string_view default_x, default_y, default_z;
};

/// A key of a component. All of it is constant data in the component's file, in the order of its
/// enum: a component asks for its values by position.
struct ComponentKey {
  std::string_view name;          ///< snake_case, without dots
  std::string_view unit;          ///< "length", "degrees", "1"
  std::string_view meaning;       ///< begins with a small letter, without a full stop
  std::string_view source;        ///< "[Lintermann1997] sec. 4", or "own"
  std::string_view default_text;  ///< as in a file: "2.0", "[1.0, 0.5]", "\"sphere\""
  std::variant<RangedNumber, WordChoice, ColourValue, NumberList, FieldExpressions> kind;
};

}  // namespace phytobench
