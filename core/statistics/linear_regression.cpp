// SPDX-License-Identifier: MIT
#include "core/statistics/linear_regression.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"
#include "core/statistics/householder_factorisation.hpp"
#include "core/statistics/moments.hpp"

namespace phytobench {

namespace {

using Column = HouseholderFactorisation::Column;

/// A sum of products as if in doubled precision: it keeps what each operation loses (Ogita, Rump
/// and Oishi 2005, SIAM J. Sci. Comput. 26:1955). std::fma is exact with and without an instruction
/// for it.
class CompensatedSum {
 public:
  void add_product(double a, double b) {
    const double product = a * b;
    const double sum = sum_ + product;
    const double added = sum - sum_;
    lost_ += (sum_ - (sum - added)) + (product - added) + std::fma(a, b, -product);
    sum_ = sum;
  }

  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0.0;
  double lost_ = 0.0;
};

/// Coefficients b and residuals r, which solve r + X b = y and X^T r = 0 together.
struct Fit {
  Column coefficients;
  Column residuals;
};

class LeastSquares {
 public:
  LeastSquares(const std::vector<Column>& columns, std::span<const double> y)
      : columns_(columns), y_(y), factorisation_(columns) {}

  bool is_determined() const { return factorisation_.is_independent(); }
  Column inverse_diagonal() const { return factorisation_.inverse_diagonal(); }

  Fit fit() const {
    Fit fit = solution(Column(y_.begin(), y_.end()), Column(columns_.size(), 0.0));
    for (int step = 0; step < 2; ++step) {
      const Fit correction = solution(rest_of_values(fit), rest_of_normals(fit));
      add(correction.coefficients, fit.coefficients);
      add(correction.residuals, fit.residuals);
    }
    return fit;
  }

 private:
  /// The fit with r + X b = values and X^T r = normals.
  Fit solution(Column values, Column normals) const {
    const Column h = factorisation_.solved_transposed(std::move(normals));
    Column turned = factorisation_.turned(std::move(values));
    Column right(turned.begin(), turned.begin() + static_cast<std::ptrdiff_t>(h.size()));
    for (std::size_t j = 0; j < h.size(); ++j) right[j] -= h[j];
    std::copy(h.begin(), h.end(), turned.begin());
    return {factorisation_.solved(std::move(right)), factorisation_.turned_back(std::move(turned))};
  }

  /// y - r - X b.
  Column rest_of_values(const Fit& fit) const {
    Column rest;
    for (std::size_t i = 0; i < y_.size(); ++i) {
      CompensatedSum sum;
      sum.add_product(y_[i], 1.0);
      sum.add_product(fit.residuals[i], -1.0);
      for (std::size_t j = 0; j < columns_.size(); ++j)
        sum.add_product(columns_[j][i], -fit.coefficients[j]);
      rest.push_back(sum.value());
    }
    return rest;
  }

  /// -X^T r.
  Column rest_of_normals(const Fit& fit) const {
    Column rest;
    for (const Column& column : columns_) {
      CompensatedSum sum;
      for (std::size_t i = 0; i < column.size(); ++i) sum.add_product(column[i], -fit.residuals[i]);
      rest.push_back(sum.value());
    }
    return rest;
  }

  static void add(const Column& more, Column& sums) {
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += more[i];
  }

  const std::vector<Column>& columns_;
  std::span<const double> y_;
  HouseholderFactorisation factorisation_;
};

std::vector<Column> with_constant(std::span<const Column> terms, std::size_t rows) {
  std::vector<Column> columns{Column(rows, 1.0)};
  for (const Column& term : terms) {
    PHYTOBENCH_EXPECT(term.size() == rows);
    for (const double value : term) PHYTOBENCH_EXPECT(std::isfinite(value));
    columns.push_back(term);
  }
  return columns;
}

}  // namespace

std::optional<LinearRegression> linear_regression(std::span<const std::vector<double>> terms,
                                                  std::span<const double> y) {
  const std::vector<Column> columns = with_constant(terms, y.size());
  if (y.size() <= columns.size()) return std::nullopt;
  const Column around_mean = centred(y).deviations;
  const double scatter = product_sum(around_mean, around_mean);
  const LeastSquares problem(columns, y);
  if (scatter == 0.0 || !problem.is_determined()) return std::nullopt;

  const Fit fit = problem.fit();
  const double squares = product_sum(fit.residuals, fit.residuals);
  const double variance = squares / static_cast<double>(y.size() - columns.size());
  const Column inverse = problem.inverse_diagonal();
  LinearRegression result{.coefficients = {},
                          .residual_deviation = std::sqrt(variance),
                          .r_squared = 1.0 - squares / scatter};
  for (std::size_t j = 0; j < columns.size(); ++j)
    result.coefficients.push_back({fit.coefficients[j], std::sqrt(variance * inverse[j])});
  return result;
}

std::optional<LinearRegression> polynomial_regression(std::span<const double> x,
                                                      std::span<const double> y, int degree) {
  PHYTOBENCH_EXPECT(degree >= 1 && x.size() == y.size());
  std::vector<Column> powers{Column(x.begin(), x.end())};
  for (int d = 2; d <= degree; ++d) {
    powers.push_back(powers.back());
    for (std::size_t i = 0; i < x.size(); ++i) powers.back()[i] *= x[i];
  }
  return linear_regression(powers, y);
}

}  // namespace phytobench
