// SPDX-License-Identifier: MIT
#include "reference/oracles/exact_kolmogorov.hpp"

#include <cmath>
#include <vector>

namespace phytobench::oracles {

namespace {

using DurbinMatrix = std::vector<std::vector<double>>;

DurbinMatrix product(const DurbinMatrix& a, const DurbinMatrix& b) {
  DurbinMatrix c(a.size(), std::vector<double>(a.size(), 0.0));
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < a.size(); ++j)
      for (std::size_t k = 0; k < a.size(); ++k) c[i][j] += a[i][k] * b[k][j];
  return c;
}

/// Durbin's H for d = (k - h) / n with 0 <= h < 1; of size 2 k - 1.
DurbinMatrix durbin_matrix(int k, double h) {
  const auto m = static_cast<std::size_t>(2 * k - 1);
  DurbinMatrix H(m, std::vector<double>(m, 0.0));
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < m && j <= i + 1; ++j) H[i][j] = 1.0;
  for (std::size_t i = 0; i < m; ++i) {
    H[i][0] -= std::pow(h, static_cast<double>(i + 1));
    H[m - 1][i] -= std::pow(h, static_cast<double>(m - i));
  }
  if (2.0 * h - 1.0 > 0.0) H[m - 1][0] += std::pow(2.0 * h - 1.0, static_cast<double>(m));
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t j = 0; j < m; ++j)
      for (std::size_t g = 1; g + j <= i + 1; ++g) H[i][j] /= static_cast<double>(g);
  return H;
}

}  // namespace

double kolmogorov_distribution(int n, double d) {
  const int k = static_cast<int>(std::floor(n * d)) + 1;
  const DurbinMatrix H = durbin_matrix(k, k - n * d);
  // n! / n^n is spread over the factors, or the powers would leave the range of doubles.
  DurbinMatrix Q = H;
  for (auto& row : Q)
    for (double& value : row) value *= 1.0 / n;
  for (int i = 2; i <= n; ++i) {
    Q = product(Q, H);
    for (auto& row : Q)
      for (double& value : row) value *= static_cast<double>(i) / n;
  }
  const auto middle = static_cast<std::size_t>(k - 1);
  return Q[middle][middle];
}

}  // namespace phytobench::oracles
