// SPDX-License-Identifier: MIT
#include "core/point_pattern/point_limit.hpp"

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

void refuse_too_many_points(double expected, std::string_view advice) {
  if (expected <= most_points) return;
  throw InputError(
      fmt::format("the pattern would need {:.4g} points, more than the {:.4g} that are allowed; {}",
                  expected, most_points, advice));
}

}  // namespace phytobench
