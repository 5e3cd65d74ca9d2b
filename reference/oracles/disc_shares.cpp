// SPDX-License-Identifier: MIT
#include "reference/oracles/disc_shares.hpp"

#include <algorithm>
#include <cmath>

namespace phytobench::oracles {

namespace {

/// The discs, and behind them all images of theirs.
std::vector<OracleDisc> with_images(const std::vector<OracleDisc>& discs,
                                    const OracleGround& ground) {
  std::vector<OracleDisc> all = discs;
  for (int ky = -1; ky <= 1; ++ky)
    for (int kx = -1; kx <= 1; ++kx) {
      if (kx == 0 && ky == 0) continue;
      if ((kx != 0 && ground.period_x <= 0.0) || (ky != 0 && ground.period_y <= 0.0)) continue;
      for (const OracleDisc& d : discs)
        all.push_back({d.x + kx * ground.period_x, d.y + ky * ground.period_y, d.r});
    }
  return all;
}

/// Share of disc i at a place that `others` cover as well as i itself.
double share_of(std::size_t i, const std::vector<std::size_t>& covering,
                const std::vector<OracleDisc>& discs, double exponent) {
  double sum = 0.0;
  for (const std::size_t j : covering) {
    const double r = discs[i].r, s = discs[j].r;
    sum += r == s ? 1.0 : std::pow((s * s) / (r * r), exponent);
  }
  return 1.0 / sum;
}

struct Arc {
  double middle;  ///< height in the middle of the strip
  double area;    ///< below it, within the strip
  std::size_t disc;
  bool is_lower;
};

/// Integral of the half circle's height from its middle to x.
double below_circle(double x, double r) {
  const double t = std::fmax(-1.0, std::fmin(x / r, 1.0));
  return 0.5 * r * r * (t * std::sqrt((1 - t) * (1 + t)) + std::asin(t));
}

/// Where strips end: both ends of every disc, every crossing of two circles.
std::vector<double> cuts_of(const std::vector<OracleDisc>& discs) {
  std::vector<double> cuts;
  for (const OracleDisc& a : discs) {
    if (a.r <= 0.0) continue;
    cuts.insert(cuts.end(), {a.x - a.r, a.x + a.r});
    for (const OracleDisc& b : discs) {
      const double dx = b.x - a.x, dy = b.y - a.y, squared = dx * dx + dy * dy;
      if (squared == 0.0) continue;
      const double along = (squared + a.r * a.r - b.r * b.r) / (2 * squared);
      const double across_squared = a.r * a.r / squared - along * along;
      if (across_squared <= 0.0) continue;
      const double across = std::sqrt(across_squared);
      cuts.insert(cuts.end(), {a.x + along * dx - across * dy, a.x + along * dx + across * dy});
    }
  }
  std::sort(cuts.begin(), cuts.end());
  return cuts;
}

/// All arcs of a strip, from below.
std::vector<Arc> arcs_of(double left, double right, const std::vector<OracleDisc>& discs) {
  const double middle = 0.5 * (left + right), width = right - left;
  std::vector<Arc> arcs;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const auto [x, y, r] = discs[i];
    if (middle <= x - r || middle >= x + r) continue;
    const double up = std::sqrt((r - (middle - x)) * (r + (middle - x)));
    const double half = below_circle(right - x, r) - below_circle(left - x, r);
    arcs.push_back({y - up, y * width - half, i, true});
    arcs.push_back({y + up, y * width + half, i, false});
  }
  std::sort(arcs.begin(), arcs.end(),
            [](const Arc& a, const Arc& b) { return a.middle < b.middle; });
  return arcs;
}

void share_strip(const std::vector<Arc>& arcs, const std::vector<OracleDisc>& discs,
                 double exponent, std::vector<double>& won) {
  std::vector<std::size_t> covering;
  for (std::size_t a = 0; a + 1 < arcs.size(); ++a) {
    if (arcs[a].is_lower)
      covering.push_back(arcs[a].disc);
    else
      std::erase(covering, arcs[a].disc);
    for (const std::size_t i : covering)
      if (i < won.size())
        won[i] += share_of(i, covering, discs, exponent) * (arcs[a + 1].area - arcs[a].area);
  }
}

}  // namespace

std::vector<double> disc_shares_by_strips(const std::vector<OracleDisc>& discs,
                                          const OracleGround& ground, double exponent) {
  const std::vector<OracleDisc> all = with_images(discs, ground);
  const std::vector<double> cuts = cuts_of(all);
  std::vector<double> won(discs.size(), 0.0);
  for (std::size_t c = 0; c + 1 < cuts.size(); ++c)
    if (cuts[c + 1] > cuts[c]) share_strip(arcs_of(cuts[c], cuts[c + 1], all), all, exponent, won);
  return won;
}

std::vector<double> disc_shares_by_squares(const std::vector<OracleDisc>& discs,
                                           const OracleGround& ground, double exponent, int steps) {
  const std::vector<OracleDisc> all = with_images(discs, ground);
  std::vector<double> won(discs.size(), 0.0);
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const double side = 2.0 * discs[i].r / steps;
    std::vector<std::size_t> covering;
    for (int row = 0; row < steps; ++row)
      for (int column = 0; column < steps; ++column) {
        const double x = discs[i].x - discs[i].r + (column + 0.5) * side;
        const double y = discs[i].y - discs[i].r + (row + 0.5) * side;
        covering.clear();
        for (std::size_t j = 0; j < all.size(); ++j)
          if (std::hypot(x - all[j].x, y - all[j].y) < all[j].r) covering.push_back(j);
        if (std::hypot(x - discs[i].x, y - discs[i].y) < discs[i].r)
          won[i] += share_of(i, covering, all, exponent) * side * side;
      }
  }
  return won;
}

}  // namespace phytobench::oracles
