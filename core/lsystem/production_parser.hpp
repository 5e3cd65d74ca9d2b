// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string_view>

#include "core/lsystem/module_parser.hpp"

namespace phytobench {

/// Where the first arrow of a line is, and how many bytes it has.
struct Arrow {
  std::size_t offset = 0;
  std::size_t length = 0;
};
/// ->, ::= or →; none: the line is no production.
std::optional<Arrow> find_arrow(std::string_view text);

/// The production in that line; group is left to number_groups(). Throws InputError with line and
/// column.
Production parse_production(const SourceLine& line, const Arrow& arrow,
                            const ModuleContext& context);

}  // namespace phytobench
