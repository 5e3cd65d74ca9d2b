// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace phytobench {

/// Columns X as Q R, by Householder's reflections (Golub and Van Loan, Matrix Computations,
/// sec. 5.2). Sums run in a fixed order: the same bits on every processor.
class HouseholderFactorisation {
 public:
  using Column = std::vector<double>;

  /// Columns of one length, at least as long as there are columns; ContractViolation otherwise.
  explicit HouseholderFactorisation(std::vector<Column> columns);

  /// No column is a sum of those before it, as far as rounding lets that be seen.
  bool is_independent() const;

  /// Q^T y, and its inverse.
  Column turned(Column y) const;
  Column turned_back(Column y) const;

  /// The x with R x = y, and with R^T x = y; the columns must be independent.
  Column solved(Column y) const;
  Column solved_transposed(Column y) const;

  /// Diagonal of the inverse of X^T X.
  Column inverse_diagonal() const;

 private:
  std::size_t size() const { return columns_.size(); }
  void reflect_column(std::size_t k);
  void reflect(std::size_t k, Column& y) const;

  std::vector<Column> columns_;  ///< above the diagonal R, from there on the reflections
  Column diagonal_;              ///< of R
  Column norms_;                 ///< of the columns
};

}  // namespace phytobench
