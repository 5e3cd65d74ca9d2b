// SPDX-License-Identifier: MIT
// The oracles that counter-examples of errata are evaluated with: printed and corrected form.
#pragma once

#include <functional>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace phytobench {

using Arguments = std::vector<double>;

/// The printed and the corrected form of one equation.
struct OraclePair {
  std::size_t arguments;
  std::function<double(const Arguments&)> printed;
  std::function<double(const Arguments&)> corrected;
};

/// Keys are "<paper>/<oracle>".
using OracleTable = std::map<std::string, OraclePair>;

/// Where a form has no value.
inline constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

#define ERRATA_ORACLES(name) OracleTable name##_oracles();
#include "reference/errata_oracles.def"
#undef ERRATA_ORACLES

}  // namespace phytobench
