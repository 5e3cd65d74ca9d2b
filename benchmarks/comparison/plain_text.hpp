// SPDX-License-Identifier: MIT
// Names and reasons come from the programs that are compared: whatever stands in them, a document
// stays a document.
#pragma once

#include <cstddef>
#include <string>

namespace phytobench {

/// With spaces for control characters, at most `most_bytes` long, cut between characters of UTF-8.
std::string one_line(const std::string& text, std::size_t most_bytes = 300);

/// one_line() with what Markdown would read as markup written as text.
std::string markdown_text(const std::string& text, std::size_t most_bytes = 300);

}  // namespace phytobench
