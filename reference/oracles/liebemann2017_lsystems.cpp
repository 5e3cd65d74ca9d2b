// SPDX-License-Identifier: MIT
#include "reference/oracles/liebemann2017_lsystems.hpp"

#include <map>
#include <sstream>

namespace phytobench::oracles::liebemann2017 {

namespace {

std::map<std::string, Letters> productions_of(const D0LSystem& G) {
  std::map<std::string, Letters> P;
  for (const Rule& rule : G.P) P[rule.a] = rule.b;
  return P;
}

void append(Letters& word, const Letters& more) {
  word.insert(word.end(), more.begin(), more.end());
}

}  // namespace

Letters one_by_one(std::string_view text) {
  Letters letters;
  for (const char character : text)
    if (character != ' ') letters.push_back(std::string(1, character));
  return letters;
}

Letters between_blanks(std::string_view text) {
  std::istringstream stream{std::string(text)};
  Letters letters;
  for (std::string letter; stream >> letter;) letters.push_back(letter);
  return letters;
}

std::string joined(const Letters& word, std::string_view separator) {
  std::string text;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (i > 0) text += separator;
    text += word[i];
  }
  return text;
}

D0LSystem equation_2_1() {
  return {{"ar"}, {{"ar", {"al", "br"}}, {"al", {"bl", "ar"}}, {"br", {"ar"}}, {"bl", {"al"}}}};
}

D0LSystem equation_2_6() {
  return {one_by_one("F - F - F - F"), {{"F", one_by_one("F + F - F - FF + F + F - F")}}};
}

D0LSystem figure_2_5a() {
  return {{"F"}, {{"F", one_by_one("FF - [-F + F + F] + [+F - F - F]")}}};
}

D0LSystem figure_2_5b() {
  return {{"F"}, {{"F", one_by_one("F[-F]F[+F][F]")}}};
}

Letters derive_in_parallel(const D0LSystem& G, int n) {
  const std::map<std::string, Letters> P = productions_of(G);
  Letters w = G.omega;
  for (int i = 0; i < n; ++i) {
    Letters v;
    for (const std::string& a : w) append(v, P.contains(a) ? P.at(a) : Letters{a});
    w = v;
  }
  return w;
}

Letters derive_rule_after_rule(const D0LSystem& G, int n) {
  Letters w = G.omega;
  for (int i = 0; i < n; ++i)
    for (const Rule& rule : G.P) {
      Letters v;
      for (const std::string& a : w) append(v, a == rule.a ? rule.b : Letters{a});
      w = v;
    }
  return w;
}

std::optional<Letters> derive_left_to_right(const D0LSystem& G, int n, GoOn go_on,
                                            std::size_t most) {
  const std::map<std::string, Letters> P = productions_of(G);
  Letters w = G.omega;
  for (int i = 0; i < n; ++i) {
    std::size_t replacements = 0;
    for (std::size_t at = 0; at < w.size();) {
      if (!P.contains(w[at])) {
        ++at;
        continue;
      }
      if (++replacements > most) return std::nullopt;
      const Letters& b = P.at(w[at]);
      const auto place = w.erase(w.begin() + static_cast<std::ptrdiff_t>(at));
      w.insert(place, b.begin(), b.end());
      at += go_on == GoOn::behind_the_successor ? b.size() : 1;
    }
  }
  return w;
}

}  // namespace phytobench::oracles::liebemann2017
