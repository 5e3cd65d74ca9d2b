// SPDX-License-Identifier: MIT
#include "reports/errata_letter_text.hpp"

#include <cctype>

namespace phytobench {

namespace {

bool is_space_or_edge(const std::string& text, std::size_t i) {
  return i >= text.size() || std::isspace(static_cast<unsigned char>(text[i])) != 0;
}

bool is_in_word(const std::string& text, std::size_t i) {
  return i < text.size() && std::isalnum(static_cast<unsigned char>(text[i])) != 0;
}

/// Whether Markdown would read the character at i as markup.
bool is_markup(const std::string& text, std::size_t i) {
  const std::size_t before = i - 1, behind = i + 1;  // before wraps around at the edge
  switch (text[i]) {
    case '`':
    case '\\':
      return true;
    case '*':
      return !(is_space_or_edge(text, before) && is_space_or_edge(text, behind));
    case '_':
      return !(is_in_word(text, before) && is_in_word(text, behind));
    case '<':
      return is_in_word(text, behind) ||
             (behind < text.size() && (text[behind] == '/' || text[behind] == '!'));
    case ']':
      return behind < text.size() && text[behind] == '(';
    default:
      return false;
  }
}

/// Whether a full stop at i ends a sentence: behind "eq." and "sec." a digit or small letter
/// follows.
bool ends_sentence(const std::string& text, std::size_t i) {
  if (text[i] != '.' && text[i] != '?' && text[i] != '!') return false;
  return i + 1 == text.size() || (i + 2 < text.size() && text[i + 1] == ' ' &&
                                  std::isupper(static_cast<unsigned char>(text[i + 2])) != 0);
}

}  // namespace

std::string with_literal_markdown(const std::string& text) {
  std::string literal;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (is_markup(text, i)) literal += '\\';
    literal += text[i] == '\n' ? ' ' : text[i];
  }
  return literal;
}

std::string as_sentence(const std::string& text) {
  const bool ends =
      text.ends_with('.') || text.ends_with('?') || text.ends_with('!') || text.ends_with(".)");
  return with_literal_markdown(text) + (ends ? "" : ".");
}

std::string first_sentence(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (ends_sentence(text, i)) return text.substr(0, i + 1);
  return text;
}

}  // namespace phytobench
