// SPDX-License-Identifier: MIT
#include "reports/latex_text.hpp"

#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

namespace phytobench {

namespace {

struct LatexLetter {
  char32_t code;
  std::string_view latex;
};

constexpr LatexLetter letters[] = {
    {U'ä', R"({\"a})"},
    {U'ö', R"({\"o})"},
    {U'ü', R"({\"u})"},
    {U'Ä', R"({\"A})"},
    {U'Ö', R"({\"O})"},
    {U'Ü', R"({\"U})"},
    {U'ß', R"({\ss})"},
    {U'é', R"({\'e})"},
    {U'è', R"({\`e})"},
    {U'–', "{--}"},
    {U'—', "{---}"},
    {U'…', R"({\ldots})"},
    {U'“', "{``}"},
    {U'”', "{''}"},
    {U'„', "{``}"},
    {U'‘', "{`}"},
    {U'’', "{'}"},
    {U'§', R"({\S})"},
    {U'\u00a0', "~"},
    {U'°', R"(\ensuremath{^\circ})"},
    {U'²', R"(\ensuremath{^2})"},
    {U'³', R"(\ensuremath{^3})"},
    {U'±', R"(\ensuremath{\pm})"},
    {U'×', R"(\ensuremath{\times})"},
    {U'·', R"(\ensuremath{\cdot})"},
    {U'÷', R"(\ensuremath{\div})"},
    {U'−', R"(\ensuremath{-})"},
    {U'≤', R"(\ensuremath{\leq})"},
    {U'≥', R"(\ensuremath{\geq})"},
    {U'≠', R"(\ensuremath{\neq})"},
    {U'≈', R"(\ensuremath{\approx})"},
    {U'∝', R"(\ensuremath{\propto})"},
    {U'∞', R"(\ensuremath{\infty})"},
    {U'√', R"(\ensuremath{\surd})"},
    {U'∑', R"(\ensuremath{\sum})"},
    {U'∈', R"(\ensuremath{\in})"},
    {U'→', R"(\ensuremath{\rightarrow})"},
    {U'α', R"(\ensuremath{\alpha})"},
    {U'β', R"(\ensuremath{\beta})"},
    {U'γ', R"(\ensuremath{\gamma})"},
    {U'δ', R"(\ensuremath{\delta})"},
    {U'Δ', R"(\ensuremath{\Delta})"},
    {U'ε', R"(\ensuremath{\varepsilon})"},
    {U'η', R"(\ensuremath{\eta})"},
    {U'θ', R"(\ensuremath{\theta})"},
    {U'κ', R"(\ensuremath{\kappa})"},
    {U'λ', R"(\ensuremath{\lambda})"},
    {U'µ', R"(\ensuremath{\mu})"},
    {U'μ', R"(\ensuremath{\mu})"},
    {U'ν', R"(\ensuremath{\nu})"},
    {U'π', R"(\ensuremath{\pi})"},
    {U'ρ', R"(\ensuremath{\rho})"},
    {U'σ', R"(\ensuremath{\sigma})"},
    {U'Σ', R"(\ensuremath{\Sigma})"},
    {U'τ', R"(\ensuremath{\tau})"},
    {U'φ', R"(\ensuremath{\varphi})"},
    {U'ω', R"(\ensuremath{\omega})"},
    {U'Ω', R"(\ensuremath{\Omega})"},
};

std::string letter_text(char32_t code) {
  for (const LatexLetter& letter : letters)
    if (letter.code == code) return std::string(letter.latex);
  return fmt::format("U+{:04X}", static_cast<std::uint32_t>(code));
}

/// Takes one code point from the front of `text`; a byte that starts none stands for itself.
char32_t take_code_point(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text.front());
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : first >= 0xC0 ? 2 : 1;
  if (length == 1 || text.size() < length) {
    text.remove_prefix(1);
    return first;
  }
  char32_t code = first & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i)
    code = (code << 6) | (static_cast<unsigned char>(text[i]) & 0x3Fu);
  text.remove_prefix(length);
  return code;
}

/// What an ASCII character becomes; `before` is the character in front of it, or 0.
std::string ascii_text(char c, char before) {
  switch (c) {
    case '\\':
      return R"(\textbackslash{})";
    case '{':
    case '}':
    case '#':
    case '$':
    case '%':
    case '&':
    case '_':
      return {'\\', c};
    case '^':
      return R"(\textasciicircum{})";
    case '~':
      return R"(\textasciitilde{})";
    case '<':
      return R"(\textless{})";
    case '>':
      return R"(\textgreater{})";
    case '|':
      return R"(\textbar{})";
    case '"':
      return before == 0 || before == ' ' || before == '(' || before == '[' ? "{``}" : "{''}";
    case '-':  // two of them would become a dash
    case '`':
    case '\'':
    case '[':  // after the end of a row it would start an argument
    case ']':
    case '*':
      return {'{', c, '}'};
    default:
      return std::string(1, static_cast<unsigned char>(c) < ' ' ? ' ' : c);
  }
}

bool is_plain_number(std::string_view text) {
  double value = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
  return result.ec == std::errc() && result.ptr == text.data() + text.size() &&
         text.find_first_not_of("0123456789.e+-") == std::string_view::npos;
}

}  // namespace

std::string latex_text(std::string_view utf8) {
  std::string latex;
  for (char before = 0; !utf8.empty();) {
    const char c = utf8.front();
    if (static_cast<unsigned char>(c) >= 0x80) {
      latex += letter_text(take_code_point(utf8));
    } else {
      latex += ascii_text(c, before);
      utf8.remove_prefix(1);
    }
    before = c;
  }
  return latex;
}

std::string latex_value(std::string_view text) {
  if (!is_plain_number(text)) return latex_text(text);
  const std::size_t e = text.find('e');
  if (e == std::string_view::npos)
    return text.starts_with('-') ? fmt::format("${}$", text) : std::string(text);
  std::string_view exponent = text.substr(e + 1);
  const bool negative = exponent.starts_with('-');
  exponent.remove_prefix(exponent.find_first_not_of("+-0") == std::string_view::npos
                             ? exponent.size() - 1
                             : exponent.find_first_not_of("+-0"));
  return fmt::format(R"(${}\times 10^{{{}{}}}$)", text.substr(0, e), negative ? "-" : "", exponent);
}

std::string latex_id(std::string_view id) {
  std::string latex = R"(\texttt{)";
  for (const char c : id) {
    latex += ascii_text(c, 0);
    if (c == '/' || c == '-') latex += R"(\allowbreak{})";
  }
  return latex + "}";
}

}  // namespace phytobench
