// SPDX-License-Identifier: MIT
#include "reports/plot/plot_text.hpp"

namespace phytobench {

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string printable(std::string text) {
  for (char& c : text) c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  return text;
}

std::string escaped_for_xml(const std::string& text) {
  const std::string inside = replaced(replaced(printable(text), "&", "&amp;"), "\"", "&quot;");
  return replaced(replaced(inside, "<", "&lt;"), ">", "&gt;");
}

}  // namespace phytobench
