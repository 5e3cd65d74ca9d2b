// SPDX-License-Identifier: MIT
// What an SVG says of itself, and what makes it fit to stand in a page beside others.
#pragma once

#include <string>

namespace phytobench {

/// Width in CSS pixels at which a picture without letters is shown at least.
inline constexpr double plain_picture_width = 544.0;

/// The sentence that an SVG says of itself: its root's aria-label, else its root's title, as plain
/// text. Empty where it says none.
std::string svg_caption(const std::string& svg);

/// What an SVG's root says in its description, as plain text. Empty where it says nothing.
std::string svg_description(const std::string& svg);

/// Width in CSS pixels at which a picture is to be shown, from its root's viewBox; 0 where it has
/// none. A narrow picture without letters counts in units of its model, and is shown wider.
double svg_width(const std::string& svg);

/// An SVG whose ids, and references to them, begin with `prefix`: several stand in one page.
std::string with_own_ids(const std::string& svg, const std::string& prefix);

}  // namespace phytobench
