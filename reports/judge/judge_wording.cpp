// SPDX-License-Identifier: MIT
#include "reports/judge/judge_wording.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace phytobench {

namespace {

/// "brzoska2019/table-1/voxel.s/seconds" -> "voxel.s/seconds": the experiment is clear from the
/// claim.
std::string short_name(const std::string& measurement) {
  const std::size_t first = measurement.find('/');
  const std::size_t second = first == std::string::npos ? first : measurement.find('/', first + 1);
  return second == std::string::npos ? measurement : measurement.substr(second + 1);
}

std::string wanted_of(const ClaimCheck& check, int digits) {
  std::string text;
  if (check.subject == CheckSubject::same)
    text = "all the same";
  else if (check.subject == CheckSubject::different)
    text = "not all the same";
  else if (check.equals_text && check.subject != CheckSubject::matches)
    text = "= " + *check.equals_text;
  else if (check.equals)
    text = "= " + shown(*check.equals, digits);
  else if (check.low && check.high)
    text = shown_range(*check.low, *check.high, digits);
  else if (check.low)
    text = ">= " + shown(*check.low, digits);
  else
    text = "<= " + shown(*check.high, digits);
  if (check.subject == CheckSubject::matches) text += " equal to " + *check.equals_text;
  if (check.terms.size() > 1)
    text += fmt::format(" in {} of {}", check.required, check.terms.size());
  return text;
}

/// An interval says itself how few of its digits mean anything.
constexpr int least_digits_of_intervals = 4;

std::vector<double> bounds_of(const ClaimCheck& check) {
  std::vector<double> bounds;
  for (const auto& bound : {check.low, check.high, check.equals})
    if (bound) bounds.push_back(*bound);
  return bounds;
}

/// With which all values of a check are shown so that one sees on which side of its bounds each
/// lies.
int digits_of(const ClaimCheck& check, const JudgedCheck& judged) {
  std::vector<double> ends;
  int least = least_digits_of_intervals;
  for (const JudgedTerm& term : judged.terms) {
    if (!term.number) continue;
    ends.insert(ends.end(), {term.number->value, term.number->low, term.number->high});
    if (term.number->low == term.number->high) least = shown_digits;
  }
  return digits_to_tell_apart(ends, bounds_of(check), least);
}

std::string shown_number(const MedianOfRounds& number, int digits) {
  if (number.is_only_range())
    return fmt::format("{}, {} to {} in {} rounds, {} needed", shown(number.value, digits),
                       shown(number.low, digits), shown(number.high, digits), number.rounds,
                       fewest_rounds);
  if (number.low == number.high) return shown(number.value, digits);
  return fmt::format("{} [{}, {}]", shown(number.value, digits), shown(number.low, digits),
                     shown(number.high, digits));
}

}  // namespace

std::string expression_of(const ClaimCheck& check, const std::vector<std::string>& term) {
  switch (check.subject) {
    case CheckSubject::ratio:
      return short_name(term[0]) + " : " + short_name(term[1]);
    case CheckSubject::ratio_of_ratios:
      return "(" + short_name(term[0]) + " : " + short_name(term[1]) + ") : (" +
             short_name(term[2]) + " : " + short_name(term[3]) + ")";
    case CheckSubject::exponent:
      return fmt::format("exponent of {} against {} and {} more pairs", short_name(term[0]),
                         short_name(term[1]), term.size() / 2 - 1);
    case CheckSubject::sum: {
      std::string text;
      for (const std::string& part : term)
        text += (text.empty() ? "" : " ") + part.substr(0, 1) + " " + short_name(part.substr(1));
      return text;
    }
    default:
      break;
  }
  std::string text;
  for (const std::string& part : term) text += (text.empty() ? "" : ", ") + short_name(part);
  return text;
}

void word_numbers(const ClaimCheck& check, JudgedCheck& judged) {
  const int digits = digits_of(check, judged);
  for (JudgedTerm& term : judged.terms)
    if (term.number) term.measured = shown_number(*term.number, digits);
  judged.wanted = wanted_of(check, std::max(digits, shown_digits));
}

}  // namespace phytobench
