// SPDX-License-Identifier: MIT
// Global tests of a whole summary function at once: one p-value for all distances together, where
// an envelope drawn distance by distance would be left far too often by chance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace phytobench {

/// One function of the data and the same of simulations of the null model, at the same distances.
/// Distances at which any of the curves is not finite are left out of the tests; as all curves have
/// the same say in this, the tests stay exact.
struct Curves {
  std::vector<double> observed;
  std::vector<std::vector<double>> simulated;
};

/// The curve of the simulation with this index; it must depend on the index alone and may run on
/// several threads at once.
using SimulatedCurve = std::function<std::vector<double>(std::uint64_t index)>;

/// Curves of simulations 0 ... count - 1; the same for any number of threads.
Curves curves_with_simulations(std::vector<double> observed, std::size_t count,
                               const SimulatedCurve& curve, int threads = 1);

struct EnvelopeTest {
  /// As rank_p_value(): at most the nominal share of null patterns gets a p-value below any level,
  /// exactly that share if level * (1 + simulations) is a whole number and curves do not tie.
  double p_value = 1.0;
  /// Per distance; NaN at distances left out. Where curves do not tie, the observed curve leaves
  /// the envelope somewhere if and only if p_value <= level.
  std::vector<double> low, high;
  std::vector<double> centre;  ///< mean of all curves, the observed one among them
};

/// Maximum absolute deviation from the mean of all curves (Ripley 1977, with the data among the
/// curves as in Baddeley et al. 2014, so that all are exchangeable). Envelope of constant width: it
/// suits functions whose spread does not depend on the distance, such as L. All curves of equal
/// length; `level` in (0, 1).
EnvelopeTest mad_test(const Curves& curves, double level = 0.05);

/// Extreme rank length test (Myllymaki et al. 2017, J. R. Stat. Soc. B 79): curves are compared by
/// their most extreme rank over all distances, those with equal ones by how often they take it,
/// then by the next rank, and so on. Suits any function, as spread and skewness at each distance
/// drop out. Equal values at a distance share their mean rank.
EnvelopeTest extreme_rank_length_test(const Curves& curves, double level = 0.05);

}  // namespace phytobench
