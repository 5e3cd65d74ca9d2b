// SPDX-License-Identifier: MIT
// How commands show a bounding box.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/geometry/bounding_box.hpp"

namespace phytobench::cli {

/// {"low": [x, y, z], "high": [x, y, z]}; null if it is empty.
nlohmann::ordered_json box_json(const BoundingBox& box);

/// "1 x 2 x 0.5, from (0, 0, 0) to (1, 2, 0.5)", of a box that is not empty. Numbers below
/// 1e-12 of the largest coordinate are what rounding left, and shown as 0.
std::string box_text(const BoundingBox& box);

}  // namespace phytobench::cli
