// SPDX-License-Identifier: MIT
#include "reference/oracles/lsystem_counts.hpp"

#include <limits>

namespace phytobench::oracles {

namespace {

// A column for each letter that has one: what it becomes. Other letters become themselves.
using CountMatrix = std::map<std::string, LetterCounts>;

LetterCounts counted(const std::vector<std::string>& word) {
  LetterCounts counts;
  for (const std::string& letter : word) counts[letter] += Natural(1);
  return counts;
}

Natural product(const Natural& a, const Natural& b) {
  // Digit by digit of b, as on paper.
  Natural sum;
  for (const char digit : b.text()) {
    Natural tenfold;
    for (int i = 0; i < 10; ++i) tenfold += sum;
    sum = tenfold;
    for (int i = 0; i < digit - '0'; ++i) sum += a;
  }
  return sum;
}

LetterCounts product(const CountMatrix& M, const LetterCounts& counts) {
  LetterCounts next;
  for (const auto& [letter, count] : counts) {
    const auto column = M.find(letter);
    if (column == M.end())
      next[letter] += count;
    else
      for (const auto& [successor, times] : column->second)
        next[successor] += product(count, times);
  }
  return next;
}

}  // namespace

LetterCounts letter_counts(const D0LStructure& system, int n) {
  return *letter_counts_within(system, n, std::numeric_limits<double>::infinity());
}

std::optional<LetterCounts> letter_counts_within(const D0LStructure& system, int n,
                                                 double most_work) {
  LetterCounts counts = counted(system.axiom);
  double work = 0.0;
  for (int i = 0; i < n; ++i) {
    LetterCounts next;
    for (const auto& [letter, count] : counts) {
      const auto rule = system.successors.find(letter);
      if (rule == system.successors.end())
        next[letter] += count;
      else
        for (const std::string& successor : rule->second) next[successor] += count;
      const std::size_t additions = rule == system.successors.end() ? 1 : rule->second.size();
      work += (20.0 + static_cast<double>(count.digits())) * static_cast<double>(additions);
      if (work > most_work) return std::nullopt;
    }
    counts = next;
  }
  return counts;
}

LetterCounts letter_counts_by_powers(const D0LStructure& system, int n) {
  CountMatrix square;
  for (const auto& [letter, successor] : system.successors) square[letter] = counted(successor);
  LetterCounts counts = counted(system.axiom);
  for (int bits = n; bits > 0; bits /= 2) {
    if (bits % 2 == 1) counts = product(square, counts);
    CountMatrix next;
    for (const auto& [letter, column] : square) next[letter] = product(square, column);
    square = next;
  }
  return counts;
}

Natural count_of(const LetterCounts& counts, const std::string& letter) {
  const auto found = counts.find(letter);
  return found == counts.end() ? Natural(0) : found->second;
}

Natural word_length(const LetterCounts& counts) {
  Natural length;
  for (const auto& [letter, count] : counts) length += count;
  return length;
}

Natural drawn_segments(const LetterCounts& counts, std::string_view draws) {
  Natural segments;
  for (const char letter : draws) segments += count_of(counts, std::string(1, letter));
  return segments;
}

}  // namespace phytobench::oracles
