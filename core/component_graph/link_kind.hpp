// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string_view>

namespace phytobench {

/// How a link of the graph makes instances of its target ([Lintermann1997] sec. 4.1).
enum class LinkKind : std::uint8_t {
  child,   ///< one, or as many as its source multiplies
  branch,  ///< as many as its source bears along itself
  leaf,    ///< one, where the recursion of its source has ended
};

std::string_view name_of(LinkKind kind);

}  // namespace phytobench
