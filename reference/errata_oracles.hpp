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

OracleTable brzoska2019_oracles();
OracleTable alsweis_pattern_oracles();      ///< appendix A and section 2.4.1
OracleTable alsweis_growth_oracles();       ///< growth of plants, laws of density
OracleTable alsweis_population_oracles();   ///< cells, seed bank, dispersal
OracleTable alsweis_competition_oracles();  ///< chapters 4, 5 and 7

// Words that numbers contradict, and cases that words leave out.
OracleTable brzoska2019_wording_oracles();
OracleTable alsweis_wording_oracles();
OracleTable tiles_and_noise_oracles();  ///< [Alsweis] ch. 3, 6, appendices; L-systems of both
OracleTable brzoska2019_mesh_oracles();
OracleTable brzoska2019_growth_trend_oracles();

}  // namespace phytobench
