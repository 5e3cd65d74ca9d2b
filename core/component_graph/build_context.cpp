// SPDX-License-Identifier: MIT
#include "core/component_graph/build_context.hpp"

#include <algorithm>
#include <cmath>

namespace phytobench {

int BuildContext::pieces(double wanted, int fewest) const {
  constexpr double most = 10000.0;
  const double scaled = std::min(std::round(wanted * resolution), most);
  return std::max(fewest, static_cast<int>(std::max(scaled, 0.0)));
}

}  // namespace phytobench
