// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/component_graph/sibling_number.hpp"
#include "core/lsystem/expression.hpp"

namespace phytobench {

/// Parameters stay where their sums and products are finite, and whole ones exact.
inline constexpr double largest_parameter = 1e15;

/// Where in the plant, and when, a parameter is asked for.
struct InstancePlace {
  SiblingNumber number;
  std::uint32_t depth =
      1;  ///< recursion depth: how many of its prototype lie on the way, itself included
  double time = 0.0;
  std::uint64_t seed = 0;      ///< of the graph
  std::uint64_t identity = 0;  ///< names the instance whatever stands beside it: its random stream
};

/// A number (first = last), or a range over siblings.
struct NumberSpan {
  double first = 0.0;
  double last = 0.0;
  friend bool operator==(const NumberSpan&, const NumberSpan&) = default;

  /// first + (i - 1) (last - first) / (n - 1), exact at both ends; `first` for n = 1. What
  /// [Lintermann1997] sec. 3.2 prints lacks first and counts i from 0 or 1 (erratum).
  double at(const SiblingNumber& number) const;
};

struct KeyFrame {
  double time = 0.0;
  NumberSpan value;
};

/// How a prototype sets a number ([Lintermann1997] sec. 3.2 and 6): key frames over time (one for
/// what never changes), interpolated over siblings, then put through a function of the user.
struct ParameterRange {
  /// At least one, times increasing. Linear between them, constant before and after.
  std::vector<KeyFrame> frames;
  /// Of value, i, n, depth and t, in that order; absent: value itself.
  std::optional<Expression> function;
  std::string where;                ///< "willow.toml:12: twig.length", for messages
  std::uint64_t random_stream = 0;  ///< tells the parameters of a prototype apart

  /// A constant.
  static ParameterRange of(double value);

  /// The number at that place, perhaps not finite.
  double resolved(const InstancePlace& place) const;

  /// The range at that time.
  NumberSpan at_time(double time) const;

  /// Whether instances of one prototype may get different numbers at one time.
  bool varies() const;
};

}  // namespace phytobench
