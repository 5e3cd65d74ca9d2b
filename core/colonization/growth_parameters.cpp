// SPDX-License-Identifier: MIT
#include "core/colonization/growth_parameters.hpp"

#include <cmath>
#include <string>

#include "core/contract/errors.hpp"

namespace phytobench {

double largest_within(double distance, Boundary boundary) {
  if (boundary == Boundary::inclusive || std::isinf(distance)) return distance;
  return std::nextafter(distance, 0.0);
}

LoopOptions loop_options_named(std::string_view name) {
  using enum KillTiming;
  using enum PointFilter;
  if (name == "s" || name == "S") return {immediate, none};
  if (name == "d" || name == "D") return {deferred, none};
  if (name == "n" || name == "N") return {immediate, bounding_box};
  if (name == "dn" || name == "DN" || name == "d&n" || name == "D&N")
    return {deferred, bounding_box};
  throw InputError("unknown loop option '" + std::string(name) +
                   "'; use s (plain), d (deferred removal), n (bounding box) or dn (both)");
}

}  // namespace phytobench
