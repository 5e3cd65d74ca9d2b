// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace phytobench {

std::string replaced(std::string text, const std::string& from, const std::string& to);

/// With spaces for control characters, which neither gnuplot's strings nor XML can hold.
std::string printable(std::string text);

std::string escaped_for_xml(const std::string& text);

}  // namespace phytobench
