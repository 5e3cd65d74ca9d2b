// SPDX-License-Identifier: MIT
#include "core/component_graph/vector_field.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

VectorField::VectorField(const Vector3& everywhere)
    : components_{Expression(everywhere.x), Expression(everywhere.y), Expression(everywhere.z)} {}

VectorField::VectorField(std::array<Expression, 3> components, std::string where)
    : components_(std::move(components)), where_(std::move(where)) {}

Vector3 VectorField::at(const Vector3& place, double time) const {
  const double parameters[] = {place.x, place.y, place.z, time};
  const Vector3 vector{components_[0].evaluate(parameters), components_[1].evaluate(parameters),
                       components_[2].evaluate(parameters)};
  if (!is_finite(vector))
    throw InputError(
        fmt::format("{}: the field is not finite at x = {:.6g}, y = {:.6g}, z = "
                    "{:.6g}, t = {:.6g}; give functions that are finite everywhere",
                    where_, place.x, place.y, place.z, time));
  return vector;
}

Vector3 direction_of(const VectorField& field, const Vector3& place, double time) {
  const Vector3 vector = field.at(place, time);
  const double largest = std::max({std::abs(vector.x), std::abs(vector.y), std::abs(vector.z)});
  constexpr double no_pull = 1e-12;
  if (largest < no_pull) return {};
  // Divided first, so that no square overflows.
  const Vector3 shrunk = vector / largest;
  return shrunk / norm(shrunk);
}

}  // namespace phytobench
