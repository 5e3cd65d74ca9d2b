// SPDX-License-Identifier: MIT
#include "core/statistics/householder_factorisation.hpp"

#include <cmath>

#include "core/contract/check.hpp"
#include "core/statistics/moments.hpp"

namespace phytobench {

namespace {

using Column = HouseholderFactorisation::Column;

/// The part of a column from row k on.
std::span<const double> below(const Column& column, std::size_t k) {
  return std::span(column).subspan(k);
}

double norm(std::span<const double> values) {
  return std::sqrt(product_sum(values, values));
}

}  // namespace

HouseholderFactorisation::HouseholderFactorisation(std::vector<Column> columns)
    : columns_(std::move(columns)) {
  for (const Column& column : columns_) {
    PHYTOBENCH_EXPECT(column.size() == columns_[0].size() && column.size() >= size());
    norms_.push_back(norm(column));
  }
  for (std::size_t k = 0; k < size(); ++k) reflect_column(k);
}

void HouseholderFactorisation::reflect_column(std::size_t k) {
  Column& column = columns_[k];
  const double length = norm(below(column, k));
  diagonal_.push_back(column[k] > 0.0 ? -length : length);  // no cancellation in the next line
  column[k] -= diagonal_[k];
  for (std::size_t j = k + 1; j < size(); ++j) reflect(k, columns_[j]);
}

/// Mirrors y at the plane that reflection k stands on.
void HouseholderFactorisation::reflect(std::size_t k, Column& y) const {
  const Column& v = columns_[k];
  const double square = product_sum(below(v, k), below(v, k));
  if (square == 0.0) return;
  const double share = 2.0 * product_sum(below(v, k), below(y, k)) / square;
  for (std::size_t i = k; i < y.size(); ++i) y[i] -= share * v[i];
}

bool HouseholderFactorisation::is_independent() const {
  constexpr double rounding = 1e-13;  // leaves about 1e-16 of a column for each row
  for (std::size_t k = 0; k < size(); ++k)
    if (!(std::abs(diagonal_[k]) > rounding * norms_[k])) return false;
  return true;
}

Column HouseholderFactorisation::turned(Column y) const {
  for (std::size_t k = 0; k < size(); ++k) reflect(k, y);
  return y;
}

Column HouseholderFactorisation::turned_back(Column y) const {
  for (std::size_t k = size(); k-- > 0;) reflect(k, y);
  return y;
}

Column HouseholderFactorisation::solved(Column y) const {
  y.resize(size());
  for (std::size_t k = size(); k-- > 0;) {
    for (std::size_t j = k + 1; j < size(); ++j) y[k] -= columns_[j][k] * y[j];
    y[k] /= diagonal_[k];
  }
  return y;
}

Column HouseholderFactorisation::solved_transposed(Column y) const {
  y.resize(size());
  for (std::size_t k = 0; k < size(); ++k) {
    for (std::size_t j = 0; j < k; ++j) y[k] -= columns_[k][j] * y[j];
    y[k] /= diagonal_[k];
  }
  return y;
}

/// (X^T X)^-1 = R^-1 R^-T: column k of R^-T is what solves R^T x = e_k.
Column HouseholderFactorisation::inverse_diagonal() const {
  Column diagonal;
  for (std::size_t k = 0; k < size(); ++k) {
    Column unit(size(), 0.0);
    unit[k] = 1.0;
    const Column inverse = solved_transposed(std::move(unit));
    diagonal.push_back(product_sum(inverse, inverse));
  }
  return diagonal;
}

}  // namespace phytobench
