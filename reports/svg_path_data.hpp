// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace phytobench {

/// Whether a character is white space of ASCII.
bool is_space(char c);

/// A path's data without the space that nothing needs: before and after letters, and at its ends.
std::string spaceless_path_data(std::string_view data);

/// Whether no number has more than one decimal; one with an exponent counts as having more.
bool is_in_tenths(std::string_view data);

/// A path of corners ("M1.23,4.56L7.89,4.56") by steps from corner to corner, rounded to a tenth of
/// a unit, without adding up what is rounded ("M1.2 4.6h6.7"). Steps of nothing are left out where
/// a line goes on. Data with other commands than M, L, h and z stay as they are.
std::string stepwise_path_data(const std::string& data);

}  // namespace phytobench
