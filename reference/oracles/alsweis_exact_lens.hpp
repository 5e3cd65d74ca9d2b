// SPDX-License-Identifier: MIT
#pragma once

namespace phytobench::oracles::alsweis {

/// Relative error of `area` for the common area of two discs, from the textbook's form with a
/// hundred digits, where cancellation does no harm. Infinite if only one of them is zero.
double lens_relative_error(double r, double s, double distance, double area);

/// A distance where formulas go wrong, of six kinds: just inside outer contact, just outside inner
/// contact, at either radius, beyond where the chord passes the smaller disc's center, or anywhere
/// between the contacts. `unit` in [0, 1) says how near.
double hard_distance(double r, double s, int kind, double unit);

}  // namespace phytobench::oracles::alsweis
