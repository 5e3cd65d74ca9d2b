// SPDX-License-Identifier: MIT
#include "cli/box_output.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/contract/check.hpp"

namespace phytobench::cli {

nlohmann::ordered_json box_json(const BoundingBox& box) {
  if (box.empty()) return nullptr;
  const Vector3 &low = box.low(), &high = box.high();
  return {{"low", {low.x, low.y, low.z}}, {"high", {high.x, high.y, high.z}}};
}

std::string box_text(const BoundingBox& box) {
  PHYTOBENCH_EXPECT(!box.empty());
  const Vector3 &low = box.low(), &high = box.high(), size = box.extent();
  return fmt::format(
      "{:.4g} x {:.4g} x {:.4g}, from ({:.4g}, {:.4g}, {:.4g}) to ({:.4g}, {:.4g}, {:.4g})", size.x,
      size.y, size.z, low.x, low.y, low.z, high.x, high.y, high.z);
}

}  // namespace phytobench::cli
