// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "core/component_graph/vector_field.hpp"
#include "core/lsystem/expression.hpp"

namespace phytobench {

/// A function of value, i, n, depth and t (see parameter_range.hpp), with random(low, high).
/// `where` begins messages. Throws InputError with the column of the text.
Expression parse_parameter_function(std::string_view text, const std::string& where);

/// Three functions of x, y, z and t, without random().
VectorField parse_vector_field(const std::array<std::string_view, 3>& texts,
                               const std::string& where);

}  // namespace phytobench
