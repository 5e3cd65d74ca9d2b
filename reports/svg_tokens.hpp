// SPDX-License-Identifier: MIT
// An SVG as a row of tags and texts, for passes over it that keep what they do not know.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

/// Tags and the text between them; put together they are the SVG again.
using SvgTokens = std::vector<std::string>;

/// With one space between attributes, colours as "#rrggbb", and without the space that is between
/// elements or needless in the data of paths. Space within letters and descriptions stays.
SvgTokens svg_tokens(const std::string& svg);

/// Whether a token is an opening tag of that name, not one that closes itself.
bool opens(const std::string& token, std::string_view name);

/// The value of an attribute in double quotes; empty if the tag has none.
std::string attribute_of(const std::string& tag, const std::string& name);

}  // namespace phytobench
