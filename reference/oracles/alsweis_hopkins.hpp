// SPDX-License-Identifier: MIT
// (2.8) of [Alsweis], literally. Shares no code with core/.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace phytobench::oracles::alsweis {

struct Plant {
  double x, y;
};

inline double distance(const Plant& a, const Plant& b) {
  return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

// The numerator: mean over places x of min_i |x - p_i|.
inline double equation_2_8_numerator(const std::vector<Plant>& places,
                                     const std::vector<Plant>& plants) {
  double sum = 0.0;
  for (const Plant& x : places) {
    double least = INFINITY;
    for (const Plant& p : plants) least = std::fmin(least, distance(x, p));
    sum += least;
  }
  return sum / static_cast<double>(places.size());
}

// The denominator: mean over j of min_i |p_j - p_i|. As printed i runs over all plants, j itself
// among them.
inline double equation_2_8_denominator(const std::vector<Plant>& plants, bool as_printed) {
  double sum = 0.0;
  for (std::size_t j = 0; j < plants.size(); ++j) {
    double least = INFINITY;
    for (std::size_t i = 0; i < plants.size(); ++i)
      if (as_printed || i != j) least = std::fmin(least, distance(plants[j], plants[i]));
    sum += least;
  }
  return sum / static_cast<double>(plants.size());
}

}  // namespace phytobench::oracles::alsweis
