// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "core/lsystem/lsystem.hpp"

namespace phytobench {

using SymbolHistogram = std::array<std::uint64_t, most_symbols>;

/// How often each symbol occurs in a piece of a word.
SymbolHistogram histogram_of(std::span<const SymbolIndex> symbols);

}  // namespace phytobench
