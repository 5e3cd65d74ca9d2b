// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_lsystems.hpp"

#include <compare>
#include <optional>

namespace phytobench::oracles::alsweis {

namespace {

FifthsProbability in_lowest_terms(FifthsProbability p) {
  while (p.denominator > 1 && p.numerator % 5 == 0) {
    p.numerator /= 5;
    p.denominator /= 5;
  }
  return p;
}

// A(x) or B(y); brackets have no number.
struct Module {
  char letter;
  int x = 0;
  friend auto operator<=>(const Module&, const Module&) = default;
};
using Word = std::vector<Module>;
using Outcomes = std::map<Word, FifthsProbability>;

// The module that w[i] grows on: branches that end before it do not count.
std::optional<Module> left_of(const Word& w, std::size_t i) {
  int inside = 0;
  while (i-- > 0) {
    if (w[i].letter == ']') ++inside;
    if (w[i].letter == '[' && inside > 0)
      --inside;
    else if (w[i].letter != '[' && w[i].letter != ']' && inside == 0)
      return w[i];
  }
  return std::nullopt;
}

// The next module of the same branch: branches in between do not count.
std::optional<Module> right_of(const Word& w, std::size_t i) {
  int inside = 0;
  for (++i; i < w.size(); ++i) {
    if (w[i].letter == '[') ++inside;
    if (w[i].letter == ']' && inside-- == 0) return std::nullopt;
    if (w[i].letter != '[' && w[i].letter != ']' && inside == 0) return w[i];
  }
  return std::nullopt;
}

// The successors of one module, each with its probability.
std::vector<std::pair<Word, FifthsProbability>> successors(const Word& w, std::size_t i) {
  const Module module = w[i];
  if (module.letter == 'A')
    return {{{{'A', module.x + 1}}, {2, 5}}, {{{'B', module.x - 1}}, {3, 5}}};  // p1, p2
  if (module.letter == 'B') {
    const std::optional<Module> left = left_of(w, i), right = right_of(w, i);
    if (left && right && left->letter == 'A' && right->letter == 'A' && module.x < 4)
      return {{{{'B', left->x + right->x}, {'['}, {'A', module.x}, {']'}}, {1, 1}}};  // p3
  }
  return {{{module}, {1, 1}}};
}

Outcomes step(const Outcomes& outcomes) {
  Outcomes next;
  for (const auto& [word, probability] : outcomes) {
    Outcomes beginnings{{{}, probability}};
    for (std::size_t i = 0; i < word.size(); ++i) {
      Outcomes longer;
      for (const auto& [beginning, p] : beginnings)
        for (const auto& [successor, q] : successors(word, i)) {
          Word w = beginning;
          w.insert(w.end(), successor.begin(), successor.end());
          longer[w] = sum(longer[w], product(p, q));
        }
      beginnings = longer;
    }
    for (const auto& [w, p] : beginnings) next[w] = sum(next[w], p);
  }
  return next;
}

std::string text_of(const Word& word) {
  std::string text;
  for (const Module& module : word) {
    text += module.letter;
    if (module.letter == 'A' || module.letter == 'B') text += "(" + std::to_string(module.x) + ")";
  }
  return text;
}

// F(k), ?P, - and A of L-System2; ?P is written P.
Word derived_lsystem_2(int steps) {
  Word word{{'A'}};
  for (int i = 0; i < steps; ++i) {
    Word next;
    for (const Module& module : word) {
      if (module.letter == 'A')
        next.insert(next.end(), {{'F', 1}, {'P'}, {'-'}, {'A'}});
      else
        next.push_back({module.letter, module.x + (module.letter == 'F' ? 1 : 0)});
    }
    word = next;
  }
  return word;
}

}  // namespace

FifthsProbability sum(FifthsProbability a, FifthsProbability b) {
  while (a.denominator < b.denominator) a = {a.numerator * 5, a.denominator * 5};
  while (b.denominator < a.denominator) b = {b.numerator * 5, b.denominator * 5};
  return in_lowest_terms({a.numerator + b.numerator, a.denominator});
}

FifthsProbability product(FifthsProbability a, FifthsProbability b) {
  return in_lowest_terms({a.numerator * b.numerator, a.denominator * b.denominator});
}

std::map<std::string, FifthsProbability> outcomes_of_lsystem_1(int steps) {
  Outcomes outcomes{{{{'A', 1}, {'B', 3}, {'A', 5}}, {1, 1}}};
  for (int i = 0; i < steps; ++i) outcomes = step(outcomes);
  std::map<std::string, FifthsProbability> texts;
  for (const auto& [word, probability] : outcomes) texts[text_of(word)] = probability;
  return texts;
}

std::vector<std::pair<int, int>> queries_of_lsystem_2(int steps) {
  std::vector<std::pair<int, int>> answers;
  int x = 0, y = 0, heading_x = 0, heading_y = 1;
  for (const Module& module : derived_lsystem_2(steps)) {
    if (module.letter == 'F') {
      x += heading_x * module.x;
      y += heading_y * module.x;
    } else if (module.letter == '-') {  // to the right
      const int before = heading_x;
      heading_x = heading_y;
      heading_y = -before;
    } else if (module.letter == 'P') {
      answers.push_back({x, y});
    }
  }
  return answers;
}

std::string word_of_lsystem_2(int steps) {
  const std::vector<std::pair<int, int>> answers = queries_of_lsystem_2(steps);
  std::string text;
  std::size_t query = 0;
  for (const Module& module : derived_lsystem_2(steps)) {
    if (module.letter == 'F') {
      text += "F(" + std::to_string(module.x) + ")";
    } else if (module.letter == 'P') {
      const auto [x, y] = answers[query++];
      text += "?P(" + std::to_string(x) + "," + std::to_string(y) + ")";
    } else {
      text += module.letter;
    }
  }
  return text;
}

}  // namespace phytobench::oracles::alsweis
