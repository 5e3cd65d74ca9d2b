// SPDX-License-Identifier: MIT
// What a build depends on besides its sources, so that a build that was made otherwise is not
// taken for what would be made now.
#pragma once

#include <string>

namespace phytobench {

/// Of what CMake would build with in this environment: a line "NAME: value" for each of the
/// compiler, as it identifies itself, and the variables by which CMake and compilers take flags,
/// headers and libraries. Starts the compiler. What is unset is an empty value, and so is a
/// compiler that cannot be started.
std::string build_inputs();

/// The first line in which both differ: "CXXFLAGS was '-O1' and is '-O3'"; empty if they are equal.
/// Of nothing before: "nobody knows what it was built with".
std::string change_of_inputs(const std::string& before, const std::string& now);

}  // namespace phytobench
