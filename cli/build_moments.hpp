// SPDX-License-Identifier: MIT
// The moments of time that `phytobench build` makes a plant for, and the names of their files.
#pragma once

#include <string>
#include <vector>

namespace phytobench::cli {

/// `--time`: "2.5", or "0:1:25" for 25 frames from time 0 to time 1. InputError for anything else.
std::vector<double> moments_from(const std::string& text);

/// The name of a frame, from 0: "frame-%03d.png" becomes "frame-007.png". InputError naming the
/// option unless there is just one such place.
std::string frame_name(const std::string& pattern, std::size_t frame, const std::string& option);

/// Whether a name has a place for the number of a frame.
bool has_frame_number(const std::string& name);

}  // namespace phytobench::cli
