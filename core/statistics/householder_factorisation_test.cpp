// SPDX-License-Identifier: MIT
#include "core/statistics/householder_factorisation.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/moments.hpp"

namespace phytobench {
namespace {

using Column = HouseholderFactorisation::Column;

constexpr double column_rounding = 1e-14;

std::vector<Column> random_columns(std::uint64_t stream_index, std::size_t rows,
                                   std::size_t count) {
  CounterStream stream(3, stream_index);
  std::vector<Column> columns(count, Column(rows));
  for (Column& column : columns)
    for (double& value : column) value = stream.next_between(-1, 1);
  return columns;
}

TEST(HouseholderFactorisationLaw, TurningKeepsLengthsAndTurnsBack) {
  const HouseholderFactorisation factorisation(random_columns(0, 7, 3));
  const Column y = random_columns(1, 7, 1)[0];
  const Column turned = factorisation.turned(y);
  EXPECT_NEAR(product_sum(turned, turned), product_sum(y, y), column_rounding);
  const Column back = factorisation.turned_back(turned);
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(back[i], y[i], column_rounding);
}

TEST(HouseholderFactorisationLaw, TurnedColumnsAreTriangular) {
  const std::vector<Column> columns = random_columns(2, 6, 4);
  const HouseholderFactorisation factorisation(columns);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    const Column turned = factorisation.turned(columns[k]);
    for (std::size_t i = k + 1; i < turned.size(); ++i)
      EXPECT_NEAR(turned[i], 0.0, column_rounding);
    const Column unit = factorisation.solved(turned);
    for (std::size_t j = 0; j < unit.size(); ++j)
      EXPECT_NEAR(unit[j], j == k, 10.0 * column_rounding);
  }
}

TEST(HouseholderFactorisationLaw, SolvesBothTriangles) {
  const HouseholderFactorisation factorisation(random_columns(3, 5, 3));
  const Column a = random_columns(4, 3, 1)[0], b = random_columns(5, 3, 1)[0];
  // (R^-T a) . b = a . (R^-1 b)
  EXPECT_NEAR(product_sum(factorisation.solved_transposed(a), b),
              product_sum(a, factorisation.solved(b)), 10.0 * column_rounding);
}

TEST(HouseholderFactorisation, KnowsTheInverseOfOrthogonalColumns) {
  const HouseholderFactorisation factorisation({{2, 0, 0, 0}, {0, 3, 0, 4}});
  const Column diagonal = factorisation.inverse_diagonal();
  EXPECT_NEAR(diagonal[0], 1.0 / 4.0, column_rounding);
  EXPECT_NEAR(diagonal[1], 1.0 / 25.0, column_rounding);
}

TEST(HouseholderFactorisation, SeesDependentColumns) {
  EXPECT_TRUE(HouseholderFactorisation({{1, 2, 3}, {1, 2, 4}}).is_independent());
  EXPECT_FALSE(HouseholderFactorisation({{1, 2, 3}, {3, 6, 9}}).is_independent());
  EXPECT_FALSE(HouseholderFactorisation({{1, 2, 3}, {0, 0, 0}}).is_independent());
  EXPECT_FALSE(HouseholderFactorisation({{0.1, 0.7, 0.3, 0.2}, {1, 1, 1, 5}, {1.3, 3.1, 1.9, 5.6}})
                   .is_independent());
}

TEST(HouseholderFactorisation, RefusesTooFewRowsAndUnequalColumns) {
  EXPECT_THROW(HouseholderFactorisation({{1}, {2}}), ContractViolation);
  EXPECT_THROW(HouseholderFactorisation({{1, 2, 3}, {1, 2}}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
