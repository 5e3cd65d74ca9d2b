// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

namespace phytobench {

/// The sentence that an SVG says of itself: its root's aria-label, else its root's title, as plain
/// text. Empty where it says none.
std::string svg_caption(const std::string& svg);

/// Width in CSS pixels at which a picture is to be shown, from its root's viewBox; 0 where it has
/// none. A narrow picture without letters counts in units of its model, and is shown wider.
double svg_width(const std::string& svg);

/// Whether the artifact `a` is shown before `b`: figures by the number in their name
/// (`figure-4.7-step-40`, `figures-7.6-7.7`), then all others by name.
bool is_figure_before(const std::string& a, const std::string& b);

/// The figures of one work, in order, for the templates: name, caption, svg, widths in pixels.
nlohmann::ordered_json figures_of(const std::string& paper,
                                  const std::map<std::string, std::string>& pictures);

}  // namespace phytobench
