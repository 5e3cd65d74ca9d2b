// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace phytobench {

/// Text or attribute with what XML reserves written out.
std::string escaped_for_svg(const std::string& text);

/// A line of text; `anchor` is start, middle or end, `more` further attributes with a leading
/// space.
std::string svg_text(double x, double y, const char* anchor, const std::string& text,
                     const std::string& more = "");

}  // namespace phytobench
