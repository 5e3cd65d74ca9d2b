// SPDX-License-Identifier: MIT
#include "reports/judge/fulfilled_claim.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "reports/judge/judge.hpp"

namespace phytobench {

namespace {

using Term = std::vector<std::string>;

double number_or(const Measurements& measurements, const std::string& name, double otherwise) {
  const auto found = measurements.find(name);
  if (found == measurements.end()) return otherwise;
  if (const auto* whole = std::get_if<std::int64_t>(&found->second))
    return static_cast<double>(*whole);
  const auto* real = std::get_if<double>(&found->second);
  return real ? *real : otherwise;
}

/// A number well within the bounds of a check.
double number_within(const ClaimCheck& check) {
  if (check.equals) return *check.equals;
  if (check.low && check.high) return *check.low + (*check.high - *check.low) / 2.0;
  if (check.low) return *check.low + std::max(std::abs(*check.low), 1.0) / 2.0;
  return *check.high > 0.0 ? *check.high / 2.0
                           : *check.high - std::max(std::abs(*check.high), 1.0) / 2.0;
}

Claim claim_on_term(const ClaimCheck& check, const Term& term) {
  Claim claim;
  claim.checks = {check};
  claim.checks[0].terms = {term};
  claim.checks[0].required = 1;
  return claim;
}

void make_same(const Term& term, Measurements& measurements) {
  const auto known = std::find_if(term.begin(), term.end(),
                                  [&](const auto& name) { return measurements.contains(name); });
  const RecordValue value =
      known == term.end() ? RecordValue(std::int64_t{1}) : measurements.at(*known);
  for (const std::string& name : term) measurements[name] = value;
}

void make_different(const Term& term, Measurements& measurements) {
  for (const std::string& name : term) measurements.try_emplace(name, std::int64_t{1});
  RecordValue& last = measurements.at(term.back());
  if (auto* text = std::get_if<std::string>(&last))
    *text += " and more";
  else
    last = number_or(measurements, term.back(), 0.0) + 1.0;
}

/// As many texts that match as the bounds ask for, and one that does not.
void make_matches(const ClaimCheck& check, const std::string& start, Measurements& measurements) {
  const auto first = measurements.lower_bound(start);
  auto last = first;
  while (last != measurements.end() && last->first.starts_with(start)) ++last;
  measurements.erase(first, last);
  const double count = std::ceil(number_within(check));
  for (int i = 0; i < static_cast<int>(count); ++i)
    measurements[fmt::format("{}match-{}", start, i)] = *check.equals_text;
  measurements[start + "other"] = "other than " + *check.equals_text;
}

/// Changes the first measurement of a term so that the combined value has the wanted one.
void make_number(const ClaimCheck& check, const Term& term, Measurements& measurements) {
  const double wanted = number_within(check);
  std::vector<double> v;
  for (const std::string& part : term) {
    v.push_back(number_or(measurements, measurement_of(check, part), 1.0));
    if (v.size() > 1 && v.back() == 0.0 && check.subject != CheckSubject::sum) v.back() = 1.0;
    measurements[measurement_of(check, part)] = v.back();
  }
  double& first = v[0];
  if (check.subject == CheckSubject::ratio) {
    first = wanted * v[1];
  } else if (check.subject == CheckSubject::ratio_of_ratios) {
    first = wanted * v[1] * v[2] / v[3];
  } else if (check.subject == CheckSubject::sum) {
    double sum = 0.0;
    for (std::size_t i = 0; i < v.size(); ++i) sum += term[i][0] == '-' ? -v[i] : v[i];
    first += term[0][0] == '-' ? sum - wanted : wanted - sum;
  } else {
    first = wanted;
  }
  measurements[measurement_of(check, term[0])] = first;
}

/// A power law without scatter over the x that are known, or over 1, 2, 3 and so on.
void make_power_law(const ClaimCheck& check, const Term& term, Measurements& measurements) {
  for (std::size_t i = 0; i + 1 < term.size(); i += 2) {
    const double x = number_or(measurements, term[i + 1], 1.0 + static_cast<double>(i) / 2.0);
    measurements[term[i + 1]] = x;
    measurements[term[i]] = std::pow(x, number_within(check));
  }
}

void make_hold(const ClaimCheck& check, const Term& term, Measurements& measurements) {
  if (check.subject == CheckSubject::same) return make_same(term, measurements);
  if (check.subject == CheckSubject::different) return make_different(term, measurements);
  if (check.subject == CheckSubject::matches) return make_matches(check, term[0], measurements);
  if (check.subject == CheckSubject::exponent) return make_power_law(check, term, measurements);
  if (check.equals_text)
    measurements[term[0]] = *check.equals_text;
  else
    make_number(check, term, measurements);
}

}  // namespace

Measurements measurements_of(const Claim& claim, const Evidence& evidence) {
  Measurements measurements;
  const auto add_counted = [&](const ClaimCheck& check, const std::string& start) {
    int number = 0;
    bool has_other = false;
    for (const RecordValue& value : evidence.recorded_below(start)) {
      const bool matches = value == RecordValue(*check.equals_text);
      if (matches || !std::exchange(has_other, true))
        measurements[fmt::format("{}{}", start, number++)] = value;
    }
  };
  const auto add = [&](const std::string& name) {
    if (evidence.is_timing(name))
      measurements[name] = evidence.median_of(name)->value;
    else if (const auto value = evidence.recorded(name))
      measurements[name] = *value;
  };
  for (const ClaimCheck& check : claim.checks)
    for (const Term& term : check.terms)
      for (const std::string& part : term)
        if (check.subject == CheckSubject::matches)
          add_counted(check, part);
        else
          add(measurement_of(check, part));
  return measurements;
}

Verdict verdict_on(const Claim& claim, const Measurements& measurements) {
  RunContents run;
  for (const auto& [name, value] : measurements)
    run.records.push_back({.experiment = "", .measurement = name, .value = value});
  return judge(claim, Evidence(run), Tier::full).verdict;
}

bool holds(const Claim& claim, const Measurements& measurements) {
  const Verdict verdict = verdict_on(claim, measurements);
  return verdict == Verdict::reproduced || verdict == Verdict::reproduced_with_erratum;
}

std::optional<Measurements> fulfilled(const Claim& claim, Measurements measurements) {
  // To make one term hold may break another that shares a measurement; orders of many are settled
  // after as many sweeps as they have members.
  constexpr int sweeps = 100;
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    if (holds(claim, measurements)) return measurements;
    for (const ClaimCheck& check : claim.checks)
      for (const Term& term : check.terms)
        if (!holds(claim_on_term(check, term), measurements)) make_hold(check, term, measurements);
  }
  return std::nullopt;
}

}  // namespace phytobench
