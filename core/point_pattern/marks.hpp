// SPDX-License-Identifier: MIT
// How the marks of two points (heights, diameters) depend on their distance. Conventions as in
// pair_correlation.hpp. Each function is the kernel mean of some f(m_i, m_j) over the pairs at
// distance r, edge weights and all, so that it estimates E f at distance r; NaN at distances that
// no pair is near. Marks are finite and as many as points (ContractViolation otherwise).
#pragma once

#include <span>
#include <vector>

#include "core/point_pattern/pair_correlation.hpp"
#include "core/point_pattern/window.hpp"

namespace phytobench {

/// Stoyan's mark correlation k_mm(r): mean of m_i m_j over the squared mean mark (Stoyan and Stoyan
/// 1994, sec. 14.4). 1 for independent marks, below it where neighbours keep each other small. For
/// given marks the mean over random labellings is ((sum m)^2 - sum m^2) / (n (n - 1)) over the
/// squared mean: 1 up to squared coefficient of variation / (n - 1). Meant for marks above 0; NaN
/// if their mean is 0.
std::vector<double> mark_correlation(std::span<const Point2> points, std::span<const double> marks,
                                     const Window& window, std::span<const double> distances,
                                     const SmoothingOptions& options);

/// Mark variogram: mean of (m_i - m_j)^2 / 2, in squared units of the marks. The marks' variance
/// (with n - 1) for independent marks, below it where neighbours resemble each other.
std::vector<double> mark_variogram(std::span<const Point2> points, std::span<const double> marks,
                                   const Window& window, std::span<const double> distances,
                                   const SmoothingOptions& options);

/// Moran-like index (Shimatani 2002, J. For. Res. 7): mean of (m_i - mean)(m_j - mean) over the
/// variance (with n). The mean over random labellings is -1 / (n - 1); above it where neighbours
/// resemble each other. NaN if all marks are equal.
std::vector<double> mark_moran_index(std::span<const Point2> points, std::span<const double> marks,
                                     const Window& window, std::span<const double> distances,
                                     const SmoothingOptions& options);

}  // namespace phytobench
