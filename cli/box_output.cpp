// SPDX-License-Identifier: MIT
#include "cli/box_output.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/contract/check.hpp"

namespace phytobench::cli {

namespace {

double largest_coordinate(const BoundingBox& box) {
  const Vector3 &low = box.low(), &high = box.high();
  return std::max({std::abs(low.x), std::abs(low.y), std::abs(low.z), std::abs(high.x),
                   std::abs(high.y), std::abs(high.z)});
}

/// What rounding leaves of a zero, and its sign. Sums of a million steps are good to 12 digits.
Vector3 without_noise(const Vector3& v, const BoundingBox& box) {
  const double noise = 1e-12 * largest_coordinate(box);
  const auto clean = [noise](double number) { return std::abs(number) <= noise ? 0.0 : number; };
  return {clean(v.x), clean(v.y), clean(v.z)};
}

}  // namespace

nlohmann::ordered_json box_json(const BoundingBox& box) {
  if (box.empty()) return nullptr;
  const Vector3 &low = box.low(), &high = box.high();
  return {{"low", {low.x, low.y, low.z}}, {"high", {high.x, high.y, high.z}}};
}

std::string box_text(const BoundingBox& box) {
  PHYTOBENCH_EXPECT(!box.empty());
  const Vector3 low = without_noise(box.low(), box), high = without_noise(box.high(), box);
  const Vector3 size = without_noise(box.extent(), box);
  return fmt::format(
      "{:.4g} x {:.4g} x {:.4g}, from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g})", size.x,
      size.y, size.z, low.x, low.y, low.z, high.x, high.y, high.z);
}

}  // namespace phytobench::cli
