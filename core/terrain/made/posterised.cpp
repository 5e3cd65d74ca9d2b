// SPDX-License-Identifier: MIT
#include "core/terrain/made/posterised.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

NumberMap posterised(const HeightField& field, std::span<const std::int16_t> ids) {
  PHYTOBENCH_EXPECT(!ids.empty());
  const HeightRange range = height_range(field);
  const double extent = range.highest - range.lowest;
  const double count = static_cast<double>(ids.size());
  NumberMap map{.columns = field.columns(), .rows = field.rows()};
  map.numbers.reserve(field.size());
  for (const double height : field.heights()) {
    if (std::isnan(height)) {
      map.numbers.push_back(-1);
      continue;
    }
    // The product first: a height in the middle of two whole ones is met exactly.
    const double interval =
        extent > 0.0 ? std::floor((height - range.lowest) * count / extent) : 0.0;
    map.numbers.push_back(ids[std::min(static_cast<std::size_t>(interval), ids.size() - 1)]);
  }
  return map;
}

}  // namespace phytobench
