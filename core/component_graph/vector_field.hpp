// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <memory>
#include <string>

#include "core/geometry/vector3.hpp"
#include "core/lsystem/expression.hpp"

namespace phytobench {

/// A vector for every place of space ([Lintermann1997] sec. 4, World: photo- and gravitropism
/// follow vector-valued functions that the user may replace).
class VectorField {
 public:
  /// The same vector everywhere.
  explicit VectorField(const Vector3& everywhere);
  /// Three expressions of the parameters x, y, z and t, in that order. `where` begins messages.
  VectorField(std::array<Expression, 3> components, std::string where);

  /// Not necessarily of unit length. Throws InputError where a function gives no finite number.
  Vector3 at(const Vector3& place, double time) const;

 private:
  std::array<Expression, 3> components_;
  std::string where_;
};

/// Unit vector of a field, or the zero vector where no component reaches 1e-12: no pull there.
Vector3 direction_of(const VectorField& field, const Vector3& place, double time);

}  // namespace phytobench
