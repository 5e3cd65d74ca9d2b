// SPDX-License-Identifier: MIT
#include "reports/document_agreement.hpp"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// The single check whose bounds hold the published number, if the claim has no other.
const ClaimCheck* check_on(const Claim& claim, double published) {
  if (claim.checks.size() != 1) return nullptr;
  const ClaimCheck& check = claim.checks.front();
  const bool one_number =
      check.subject == CheckSubject::value || check.subject == CheckSubject::ratio;
  if (!one_number || check.terms.size() != 1) return nullptr;
  if (check.equals) return *check.equals == published ? &check : nullptr;
  const bool holds_it =
      check.low && check.high && *check.low <= published && published <= *check.high;
  return holds_it ? &check : nullptr;
}

/// A recorded number: times differ between equal runs and have intervals instead.
std::optional<double> recorded_number(const std::string& measurement, const Evidence& evidence) {
  const std::vector<double> samples = evidence.samples(measurement);
  if (evidence.is_timing(measurement) || samples.size() != 1) return std::nullopt;
  return samples.front();
}

std::optional<double> measured_number(const ClaimCheck& check, const Evidence& evidence) {
  const std::vector<std::string>& term = check.terms.front();
  const auto first = recorded_number(term.at(0), evidence);
  if (!first || check.subject == CheckSubject::value) return first;
  const auto second = recorded_number(term.at(1), evidence);
  if (!second || *second == 0.0) return std::nullopt;
  return *first / *second;
}

}  // namespace

double digits_of_agreement(double measured, double published) {
  PHYTOBENCH_EXPECT(published != 0.0);
  constexpr double most = 15.0;  // of a double
  if (measured == published) return most;
  const double error = std::abs(measured - published) / std::abs(published);
  return std::clamp(-std::log10(error), 0.0, most);
}

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
  const auto measured = check ? measured_number(*check, evidence) : std::nullopt;
  if (!measured || !std::isfinite(*measured)) return "";
  if (*measured == *published) return "all digits";
  return fmt::format("{:.1f} digits", digits_of_agreement(*measured, *published));
}

}  // namespace phytobench
