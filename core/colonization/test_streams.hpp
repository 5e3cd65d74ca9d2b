// SPDX-License-Identifier: MIT
// A stream of numbers that a test chooses.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "core/random/unit_stream.hpp"

namespace phytobench {

/// Hands out given numbers and knows how many were taken.
class ScriptedStream final : public UnitStream {
 public:
  explicit ScriptedStream(std::vector<double> numbers) : numbers_(std::move(numbers)) {}
  double next_unit() override { return numbers_.at(used_++); }
  std::size_t used() const { return used_; }

 private:
  std::vector<double> numbers_;
  std::size_t used_ = 0;
};

}  // namespace phytobench
