// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/lsystem/source_lines.hpp"

namespace phytobench {

/// Follows [ ] and { } through a word. Both must match, but may cross: a polygon can begin in a
/// branch and end after it.
class BracketBalance {
 public:
  explicit BracketBalance(const SourceLine& line) : line_(line) {}

  void add(std::string_view letter, std::size_t place) {
    if (letter == "[") branches_.push_back(place);
    if (letter == "{") polygons_.push_back(place);
    if (letter == "]") close(branches_, '[', ']', place);
    if (letter == "}") close(polygons_, '{', '}', place);
  }

  /// At the end of the word.
  void finish() const {
    refuse_open(branches_, '[', ']');
    refuse_open(polygons_, '{', '}');
  }

 private:
  void close(std::vector<std::size_t>& open, char opening, char closing, std::size_t place) {
    if (open.empty())
      line_.fail(place, fmt::format("'{}' without a '{}' before it; remove it or add the other",
                                    closing, opening));
    open.pop_back();
  }

  void refuse_open(const std::vector<std::size_t>& open, char opening, char closing) const {
    if (!open.empty())
      line_.fail(open.back(), fmt::format("'{}' is never closed; add a '{}'", opening, closing));
  }

  const SourceLine& line_;
  std::vector<std::size_t> branches_;
  std::vector<std::size_t> polygons_;
};

}  // namespace phytobench
