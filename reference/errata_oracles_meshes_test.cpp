// SPDX-License-Identifier: MIT
#include <cmath>

#include "reference/errata_oracles.hpp"

namespace phytobench {

namespace {

/// A stem of three nodes whose top gets tips of radius 1, one by one. Each new node makes its
/// parent work out its radius anew (eq. 12) and, on the whole path, every node below too. The
/// root's radius in the end.
double radius_of_root(int tips, double n, bool whole_path) {
  std::vector<std::size_t> parents{0};
  std::vector<double> radii{1.0};
  const auto add = [&](std::size_t parent) {
    parents.push_back(parent);
    radii.push_back(1.0);
    for (std::size_t at = parent;; at = parents[at]) {
      double powers = 0.0;
      for (std::size_t child = 1; child < parents.size(); ++child)
        if (parents[child] == at) powers += std::pow(radii[child], n);
      radii[at] = std::pow(powers, 1.0 / n);
      if (at == 0 || !whole_path) return;
    }
  };
  add(0);
  add(1);
  for (int i = 0; i < tips; ++i) add(2);
  return radii[0];
}

}  // namespace

OracleTable brzoska2019_mesh_oracles() {
  return {
      // Tips that are added two nodes above the root, exponent; radius of the root.
      {"brzoska2019/radius-below-added-tips",
       {2, [](const Arguments& a) { return radius_of_root(static_cast<int>(a[0]), a[1], false); },
        [](const Arguments& a) { return radius_of_root(static_cast<int>(a[0]), a[1], true); }}},
  };
}

}  // namespace phytobench
