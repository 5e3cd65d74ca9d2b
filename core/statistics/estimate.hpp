// SPDX-License-Identifier: MIT
#pragma once

namespace phytobench {

struct Estimate {
  double value = 0.0;
  double low = 0.0;   ///< lower end of the confidence interval
  double high = 0.0;  ///< upper end
};

}  // namespace phytobench
