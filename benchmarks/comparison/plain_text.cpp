// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/plain_text.hpp"

#include <string_view>

namespace phytobench {

std::string one_line(const std::string& text, std::size_t most_bytes) {
  const auto continues = [&](std::size_t at) {
    return (static_cast<unsigned char>(text[at]) & 0xC0u) == 0x80u;
  };
  std::size_t length = text.size();
  if (length > most_bytes) {
    length = most_bytes;
    while (length > 0 && continues(length)) --length;
  }
  std::string line = text.substr(0, length);
  for (char& c : line)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7f') c = ' ';
  return length < text.size() ? line + "..." : line;
}

std::string markdown_text(const std::string& text, std::size_t most_bytes) {
  constexpr std::string_view markup = "\\`*_[]|#~!";
  std::string safe;
  for (const char c : one_line(text, most_bytes)) {
    if (c == '<')
      safe += "&lt;";
    else if (c == '>')
      safe += "&gt;";
    else if (c == '&')
      safe += "&amp;";
    else if (c == '@')
      safe += "&#64;";  // names nobody
    else {
      if (markup.find(c) != std::string_view::npos) safe += '\\';
      safe += c;
    }
  }
  return safe;
}

}  // namespace phytobench
