// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "core/random/unit_stream.hpp"
#include "core/tree/skeleton.hpp"

namespace phytobench {

/// Appends a procedural stem of the given length above `foot`: pieces of `piece_length` (the last
/// one may be shorter), each tilted from the vertical by up to +-tilt_rad about a random horizontal
/// axis
/// ([Brzoska2019] sec. 5.2.1). Returns the topmost node: `foot` itself if length is 0.
std::int32_t append_stem(Skeleton& skeleton, std::int32_t foot, double length, double piece_length,
                         double tilt_rad, UnitStream& stream);

}  // namespace phytobench
