// SPDX-License-Identifier: MIT
#include "reports/document_measured.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>

namespace phytobench {

namespace {

constexpr std::size_t most_values = 4;  ///< that a reader takes in at once
constexpr std::size_t most_checks = 3;  ///< that are summed up one by one

struct Number {
  double value = 0.0;
  std::string text;
};

/// The number that a measured text begins with: an interval or a range behind it is left out.
std::optional<Number> number_of(const std::string& measured) {
  Number number;
  const char* const end = measured.data() + measured.size();
  const auto [rest, error] = std::from_chars(measured.data(), end, number.value);
  if (error != std::errc{} || (rest != end && *rest != ' ' && *rest != ',')) return std::nullopt;
  number.text.assign(measured.data(), rest);
  return number;
}

std::size_t count_holding(const JudgedCheck& check) {
  return static_cast<std::size_t>(
      std::count_if(check.terms.begin(), check.terms.end(),
                    [](const auto& term) { return term.outcome == CheckOutcome::holds; }));
}

/// The term that is named where a check does not hold.
std::string first_that_fails(const JudgedCheck& check) {
  if (check.outcome == CheckOutcome::holds) return "";
  for (const JudgedTerm& term : check.terms)
    if (term.outcome != CheckOutcome::holds)
      return fmt::format("; the first that does not: {} is {}", shown_expression(term),
                         term.measured);
  return "";
}

/// "1.68 to 1.88"; nothing if the values are not all numbers.
std::string range_of(const JudgedCheck& check) {
  std::vector<Number> numbers;
  for (const JudgedTerm& term : check.terms) {
    const auto number = number_of(term.measured);
    if (!number) return "";
    numbers.push_back(*number);
  }
  const auto [least, most] =
      std::minmax_element(numbers.begin(), numbers.end(),
                          [](const Number& a, const Number& b) { return a.value < b.value; });
  return least->text == most->text ? "all " + least->text
                                   : "from " + least->text + " to " + most->text;
}

std::string few_values(const JudgedCheck& check) {
  std::vector<std::string> values;
  for (const JudgedTerm& term : check.terms) values.push_back(term.measured);
  const bool alike = std::set<std::string>(values.begin(), values.end()).size() == 1;
  return alike ? values[0] : fmt::format("{}", fmt::join(values, ", "));
}

std::string check_text(const JudgedCheck& check) {
  if (check.terms.size() <= 2) return few_values(check);
  const std::string range = range_of(check);
  const bool compares =
      check.wanted.starts_with("all the same") || check.wanted.starts_with("not all the same");
  const std::string what =
      range.empty() || compares
          ? fmt::format("{} {}", check.terms.size(), compares ? "comparisons" : "values")
          : fmt::format("{} values, {}", check.terms.size(), range);
  return fmt::format("{} (wanted {}; {}){}", what, check.wanted,
                     count_holding(check) == check.terms.size()
                         ? "all hold"
                         : fmt::format("{} hold", count_holding(check)),
                     first_that_fails(check));
}

std::string many_checks_text(const std::vector<JudgedCheck>& checks, std::size_t values) {
  const auto holding = std::count_if(checks.begin(), checks.end(), [](const auto& check) {
    return check.outcome == CheckOutcome::holds;
  });
  const bool all = holding == static_cast<std::ptrdiff_t>(checks.size());
  std::string text = fmt::format("{} values in {} checks, ", values, checks.size());
  text += all ? "all as wanted" : fmt::format("{} as wanted", holding);
  for (const JudgedCheck& check : checks)
    if (check.outcome != CheckOutcome::holds)
      return text + first_that_fails(check) + fmt::format(" (wanted {})", check.wanted);
  return text;
}

}  // namespace

std::string shown_measured(const Judgement& judgement) {
  std::size_t values = 0, missing = 0;
  for (const JudgedCheck& check : judgement.checks)
    for (const JudgedTerm& term : check.terms) {
      ++values;
      missing += term.outcome == CheckOutcome::missing;
    }
  if (values > 0 && missing == values) return "not measured";
  if (judgement.contradicted || values <= most_values) return judgement.measured;
  if (missing > 0) return fmt::format("{} of {} values", values - missing, values);
  if (judgement.checks.size() > most_checks) return many_checks_text(judgement.checks, values);
  std::string text;
  for (const JudgedCheck& check : judgement.checks)
    text += (text.empty() ? "" : "; ") + check_text(check);
  return text;
}

std::string shown_expression(const JudgedTerm& term) {
  return term.expression.starts_with("+ ") ? term.expression.substr(2) : term.expression;
}

}  // namespace phytobench
