// SPDX-License-Identifier: MIT
// Growth of one plant that has no neighbours.
#pragma once

#include <optional>

namespace phytobench {

/// Richards' law in the form dv/dt = k / (1 - delta) v ((v / w)^(delta - 1) - 1), after [Alsweis]
/// (2.1) and Richards 1959. Size is any measure that grows so; units of size and time are the
/// caller's. Shape 0 is monomolecular growth (saturating from the start), 2/3 von Bertalanffy's of
/// a mass, 1 Gompertz' law, which the printed form leaves out and the quotients' limit joins, 2
/// logistic growth. A constant competition factor c slows the clock: the size at t is that of a
/// free plant at c t.
///
/// Beware of the other common form, in which k stands for k / (delta - 1).
struct RichardsGrowth {
  double rate = 0.1;        ///< k > 0, per time: how fast a plant nears its final size in the end
  double final_size = 1.0;  ///< w > 0
  double shape = 2.0;       ///< delta, any finite number
};

/// Size per time; negative above the final size. For sizes > 0.
double richards_rate(const RichardsGrowth& growth, double size);

/// The size that a plant of size `initial` > 0 has after a time >= 0.
double richards_size(const RichardsGrowth& growth, double initial, double time);

/// The size at which growth is fastest, w delta^(1 / (1 - delta)). Nothing for shapes <= 0: such
/// growth slows down from the start.
std::optional<double> richards_inflection_size(const RichardsGrowth& growth);

/// The fastest growth, k w delta^(delta / (1 - delta)), in size per time. For shape 0 the limit for
/// a vanishing plant, k w; nothing for shapes < 0, whose growth has no bound.
std::optional<double> richards_largest_rate(const RichardsGrowth& growth);

/// The limit of growth over size for a vanishing plant, k / (delta - 1), per time. Nothing for
/// shapes <= 1, where there is none: the smaller the plant, the faster it multiplies.
std::optional<double> richards_initial_relative_rate(const RichardsGrowth& growth);

/// Growth of a stem's radius, MGR R / R_max (1 - R / R_max), after [Alsweis] (5.8): logistic. Its
/// "highest rate" MGR is four times the highest rate that it ever has.
RichardsGrowth radius_growth(double printed_highest_rate, double largest_radius);

/// Whether the law has values: k and w > 0, all three finite.
bool is_valid(const RichardsGrowth& growth);

}  // namespace phytobench
