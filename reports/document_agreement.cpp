// SPDX-License-Identifier: MIT
#include "reports/document_agreement.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/statistics/log_relative_error.hpp"
#include "reports/document_numbers.hpp"

namespace phytobench {

namespace {

/// The single check whose bounds hold the published number, if the claim has no other.
const ClaimCheck* check_on(const Claim& claim, double published) {
  if (claim.checks.size() != 1) return nullptr;
  const ClaimCheck& check = claim.checks.front();
  const bool one_number =
      check.subject == CheckSubject::value || check.subject == CheckSubject::ratio;
  if (!one_number || check.terms.size() != 1 || check.why == "sampling error") return nullptr;
  if (check.equals) return *check.equals == published ? &check : nullptr;
  const bool holds_it =
      check.low && check.high && *check.low <= published && published <= *check.high;
  return holds_it ? &check : nullptr;
}

/// A computed number: times differ between equal runs, and samples have errors instead.
std::optional<double> computed_number(const std::string& measurement, const Evidence& evidence) {
  const auto found = evidence.median_of(measurement);
  if (!found || found->rounds > 0 || evidence.sample_size(measurement) > 1) return std::nullopt;
  return found->value;
}

std::optional<double> computed_number(const ClaimCheck& check, const Evidence& evidence) {
  const std::vector<std::string>& term = check.terms.front();
  const auto first = computed_number(term.at(0), evidence);
  if (!first || check.subject == CheckSubject::value) return first;
  const auto second = computed_number(term.at(1), evidence);
  if (!second || *second == 0.0) return std::nullopt;
  return *first / *second;
}

/// How a number is printed: "0.50" has two digits, the last of which counts hundredths.
struct Printed {
  int digits = 0;
  double last_place = 1.0;
};

Printed printed_in(const std::string& text) {
  Printed printed;
  const std::size_t exponent = text.find_first_of("eE"), point = text.find_first_of(".,");
  const std::string mantissa = text.substr(0, exponent);
  const std::size_t first = mantissa.find_first_of("123456789");
  for (std::size_t i = first; i < mantissa.size(); ++i)
    printed.digits += std::isdigit(static_cast<unsigned char>(mantissa[i])) != 0;
  int place = exponent == std::string::npos ? 0 : std::stoi(text.substr(exponent + 1));
  if (point != std::string::npos) place -= static_cast<int>(mantissa.size() - point - 1);
  printed.last_place = std::pow(10.0, place);
  return printed;
}

}  // namespace

std::optional<double> number_in(const std::string& text) {
  std::string plain = text;
  std::replace(plain.begin(), plain.end(), ',', '.');
  if (plain.empty() || plain.find_first_not_of("+-.0123456789eE") != std::string::npos)
    return std::nullopt;
  std::istringstream stream(plain);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  if (!(stream >> number) || !stream.eof()) return std::nullopt;
  return number;
}

std::string shown_agreement(const Claim& claim, const Evidence& evidence) {
  const auto published = number_in(claim.published);
  if (!published || *published == 0.0) return "";
  const ClaimCheck* const check = check_on(claim, *published);
  const auto computed = check ? computed_number(*check, evidence) : std::nullopt;
  if (!computed || !std::isfinite(*computed)) return "";
  const Printed printed = printed_in(claim.published);
  if (std::abs(*computed - *published) <= printed.last_place / 2.0) return "all digits";
  const int agreeing = static_cast<int>(log_relative_error(*computed, *published));
  return fmt::format("{} of {}", std::min(agreeing, printed.digits - 1),
                     counted(static_cast<std::size_t>(printed.digits), "digit"));
}

}  // namespace phytobench
