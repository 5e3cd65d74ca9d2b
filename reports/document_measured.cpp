// SPDX-License-Identifier: MIT
#include "reports/document_measured.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

namespace phytobench {

namespace {

constexpr std::size_t most_values_shown = 4;  ///< that a reader takes in at once
constexpr std::size_t most_checks = 3;        ///< that are summed up one by one

struct Number {
  double value = 0.0;
  std::string text;
};

/// The number that a measured text holds: an interval or a range behind it is left out, while
/// "3 of 7" and "15344 20046" are no numbers.
std::optional<Number> number_of(const std::string& measured) {
  Number number;
  const char* const end = measured.data() + measured.size();
  const auto [rest, error] = std::from_chars(measured.data(), end, number.value);
  if (error != std::errc{} || !std::isfinite(number.value)) return std::nullopt;
  const std::string_view behind(rest, end);
  if (!behind.empty() && !behind.starts_with(" [") && !behind.starts_with(",")) return std::nullopt;
  number.text.assign(measured.data(), rest);
  return number;
}

std::size_t count_of(const JudgedCheck& check, CheckOutcome outcome) {
  return static_cast<std::size_t>(
      std::count_if(check.terms.begin(), check.terms.end(),
                    [&](const JudgedTerm& term) { return term.outcome == outcome; }));
}

/// "all hold", "1 holds".
std::string holding_words(const JudgedCheck& check) {
  const std::size_t holding = count_of(check, CheckOutcome::holds);
  if (holding == check.terms.size()) return "all hold";
  if (holding == 0) return "none holds";
  return holding == 1 ? "1 holds" : fmt::format("{} hold", holding);
}

/// The term that is named where a check does not hold: one that fails before one that is missing,
/// if the check fails.
std::string first_that_fails(const JudgedCheck& check) {
  if (check.outcome == CheckOutcome::holds) return "";
  for (const JudgedTerm& term : check.terms)
    if (term.outcome == check.outcome)
      return fmt::format("; the first that does not: {} is {}", shown_expression(term),
                         term.measured);
  return "";
}

/// "from 1.68 to 1.88" of what was measured; nothing if the values are not all numbers.
std::string range_of(const JudgedCheck& check) {
  std::vector<Number> numbers;
  for (const JudgedTerm& term : check.terms) {
    if (term.outcome == CheckOutcome::missing) continue;
    const auto number = number_of(term.measured);
    if (!number) return "";
    numbers.push_back(*number);
  }
  if (numbers.empty()) return "";
  const auto [least, most] =
      std::minmax_element(numbers.begin(), numbers.end(),
                          [](const Number& a, const Number& b) { return a.value < b.value; });
  return least->text == most->text ? "all " + least->text
                                   : "from " + least->text + " to " + most->text;
}

/// "5", or "4 of 5" where some are missing.
std::string count_text(std::size_t values, std::size_t missing) {
  return missing == 0 ? std::to_string(values) : fmt::format("{} of {}", values - missing, values);
}

std::string few_values(const JudgedCheck& check) {
  std::vector<std::string> values;
  for (const JudgedTerm& term : check.terms) values.push_back(term.measured);
  const bool alike = std::set<std::string>(values.begin(), values.end()).size() == 1;
  return alike ? values[0] : fmt::format("{}", fmt::join(values, ", "));
}

std::string many_values(const JudgedCheck& check) {
  const bool compares =
      check.wanted.starts_with("all the same") || check.wanted.starts_with("not all the same");
  const std::string text = count_text(check.terms.size(), count_of(check, CheckOutcome::missing)) +
                           (compares ? " comparisons" : " values");
  const std::string range = compares ? "" : range_of(check);
  return range.empty() ? text : text + ", " + range;
}

std::string check_text(const JudgedCheck& check) {
  const bool few = check.terms.size() <= 2;
  if (few && check.outcome == CheckOutcome::holds) return few_values(check);
  return fmt::format("{} (wanted {}; {}){}", few ? few_values(check) : many_values(check),
                     check.wanted, holding_words(check), first_that_fails(check));
}

/// The first of the checks that decide the verdict, the worst outcome before all others; null if
/// all hold.
const JudgedCheck* deciding(const std::vector<JudgedCheck>& checks) {
  for (const auto outcome : {CheckOutcome::fails, CheckOutcome::missing, CheckOutcome::undecided})
    for (const JudgedCheck& check : checks)
      if (check.outcome == outcome) return &check;
  return nullptr;
}

std::string many_checks_text(const std::vector<JudgedCheck>& checks, const std::string& values) {
  const auto holding = std::count_if(checks.begin(), checks.end(), [](const auto& check) {
    return check.outcome == CheckOutcome::holds;
  });
  const JudgedCheck* const check = deciding(checks);
  const std::string text = fmt::format("{} values in {} checks, ", values, checks.size());
  if (check == nullptr) return text + "all as wanted";
  return fmt::format("{}{} as wanted{} (wanted {})", text, holding, first_that_fails(*check),
                     check->wanted);
}

}  // namespace

std::string shown_measured(const Judgement& judgement) {
  std::size_t values = 0, missing = 0;
  for (const JudgedCheck& check : judgement.checks) {
    values += check.terms.size();
    missing += count_of(check, CheckOutcome::missing);
  }
  if (values > 0 && missing == values) return "not measured";
  if (judgement.contradicted || values <= most_values_shown) return judgement.measured;
  const std::string count = count_text(values, missing);
  // What fails needs no other evidence, and must not hide behind what is missing.
  if (missing > 0 && judgement.verdict == Verdict::not_measured) return count + " values";
  if (judgement.checks.size() > most_checks) return many_checks_text(judgement.checks, count);
  std::string text;
  for (const JudgedCheck& check : judgement.checks)
    text += (text.empty() ? "" : "; ") + check_text(check);
  return text;
}

std::string shown_expression(const JudgedTerm& term) {
  return term.expression.starts_with("+ ") ? term.expression.substr(2) : term.expression;
}

}  // namespace phytobench
