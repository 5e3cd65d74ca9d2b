// SPDX-License-Identifier: MIT
#include "reports/judge/judge.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include <fmt/format.h>

#include "core/statistics/power_law.hpp"
#include "reports/judge/judge_wording.hpp"

namespace phytobench {

namespace {

std::string id_of(const ClaimCheck& check, const std::string& part) {
  return check.subject == CheckSubject::sum ? part.substr(1) : part;
}

/// Value of one round of a term.
double combine(const ClaimCheck& check, const std::vector<std::string>& term,
               const std::vector<double>& v) {
  switch (check.subject) {
    case CheckSubject::ratio:
      return v[0] / v[1];
    case CheckSubject::ratio_of_ratios:
      return (v[0] / v[1]) / (v[2] / v[3]);
    case CheckSubject::sum: {
      double sum = 0.0;
      for (std::size_t i = 0; i < v.size(); ++i) sum += term[i][0] == '-' ? -v[i] : v[i];
      return sum;
    }
    default:
      return v[0];
  }
}

CheckOutcome outcome_of(const MedianOfRounds& estimate, const ClaimCheck& check) {
  if (estimate.is_only_range()) return CheckOutcome::undecided;
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double low = check.equals.value_or(check.low.value_or(-infinity));
  const double high = check.equals.value_or(check.high.value_or(infinity));
  if (!std::isfinite(estimate.value) || !std::isfinite(estimate.low) ||
      !std::isfinite(estimate.high))
    return CheckOutcome::fails;
  if (estimate.low >= low && estimate.high <= high) return CheckOutcome::holds;
  if (estimate.high < low || estimate.low > high) return CheckOutcome::fails;
  return CheckOutcome::undecided;
}

/// `same` and `different` compare every bit: what is shown may be rounded.
JudgedTerm judge_comparison(const ClaimCheck& check, const std::vector<std::string>& term,
                            const Evidence& evidence, JudgedTerm judged) {
  std::vector<RecordValue> values;
  std::vector<double> numbers;
  for (const std::string& part : term) {
    const auto value = evidence.recorded(part);
    if (!value) return judged;
    values.push_back(*value);
    if (const auto* real = std::get_if<double>(&*value)) numbers.push_back(*real);
  }
  const int digits = digits_to_tell_apart(numbers, numbers);
  std::vector<std::string> texts;
  for (const RecordValue& value : values) texts.push_back(shown(value, digits));
  const bool same =
      std::all_of(values.begin(), values.end(), [&](const auto& v) { return v == values[0]; });
  judged.measured = same ? texts[0] : fmt::format("{}", fmt::join(texts, ", "));
  judged.outcome =
      same == (check.subject == CheckSubject::same) ? CheckOutcome::holds : CheckOutcome::fails;
  return judged;
}

JudgedTerm judge_text(const ClaimCheck& check, const std::string& measurement,
                      const Evidence& evidence, JudgedTerm judged) {
  const auto value = evidence.recorded(measurement);
  if (!value) return judged;
  judged.measured = shown(*value);
  judged.outcome =
      *value == RecordValue(*check.equals_text) ? CheckOutcome::holds : CheckOutcome::fails;
  return judged;
}

/// "15344 20046", or nothing.
std::optional<std::array<double, 2>> two_numbers(const RecordValue& value) {
  const auto* const text = std::get_if<std::string>(&value);
  if (!text) return std::nullopt;
  std::istringstream stream(*text);
  std::array<double, 2> numbers{};
  if (!(stream >> numbers[0] >> numbers[1])) return std::nullopt;
  return numbers;
}

/// How many values would equal a pair of numbers that has nothing to do with them: those nearby, a
/// few steps in each number, over the pairs that lie there. Equal ones do not count.
double expected_accidents(const ClaimCheck& check, const std::vector<RecordValue>& values) {
  constexpr double reach = 10.0;
  const auto wanted = two_numbers(RecordValue(*check.equals_text));
  if (!wanted) return std::numeric_limits<double>::quiet_NaN();
  const auto steps_off = [&](const std::array<double, 2>& pair, std::size_t i) {
    return std::abs(pair[i] - (*wanted)[i]) / check.accident_steps[i];
  };
  double near = 0.0;
  for (const RecordValue& value : values) {
    const auto pair = two_numbers(value);
    near +=
        pair && *pair != *wanted && steps_off(*pair, 0) <= reach && steps_off(*pair, 1) <= reach;
  }
  const double across = 2.0 * reach + 1.0;
  return near / (across * across - 1.0);
}

JudgedTerm judge_matches(const ClaimCheck& check, const std::string& prefix,
                         const Evidence& evidence, JudgedTerm judged) {
  const std::vector<RecordValue> values = evidence.recorded_below(prefix);
  if (values.empty()) return judged;
  const auto count = static_cast<double>(
      std::count(values.begin(), values.end(), RecordValue(*check.equals_text)));
  judged.measured = fmt::format("{:.0f} of {}", count, values.size());
  if (!check.accident_steps.empty())
    judged.measured +=
        fmt::format(", {:.1f} expected by accident", expected_accidents(check, values));
  judged.outcome = outcome_of({{count, count, count}}, check);
  return judged;
}

/// The fit is over the medians: how far the points lie from a power law says more than how far
/// repetitions of one lie apart.
JudgedTerm judge_exponent(const ClaimCheck& check, const std::vector<std::string>& term,
                          const Evidence& evidence, JudgedTerm judged) {
  std::vector<double> x, y;
  for (std::size_t i = 0; i < term.size(); ++i) {
    const auto found = evidence.median_of(term[i]);
    if (!found) return judged;
    (i % 2 == 0 ? y : x).push_back(found->value);
  }
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  judged.outcome = CheckOutcome::fails;
  judged.measured = "no power law";
  if (!std::all_of(x.begin(), x.end(), positive) || !std::all_of(y.begin(), y.end(), positive))
    return judged;
  const auto law = fit_power_law(x, y);
  if (!law) return judged;
  judged.number = MedianOfRounds{law->exponent};
  judged.outcome = outcome_of(*judged.number, check);
  return judged;
}

/// One combined value per round, from times of the same round; recorded values are the same in
/// every round. Empty if something is missing, or if times lack partners.
std::vector<double> combined_by_round(const ClaimCheck& check, const std::vector<std::string>& term,
                                      const Evidence& evidence) {
  std::map<std::int64_t, std::vector<double>> rounds;
  bool timed = false;
  for (const std::string& part : term)
    for (const auto& [round, seconds] : evidence.rounds(id_of(check, part))) {
      timed = true;
      rounds[round];
    }
  if (!timed) rounds[0];
  for (const std::string& part : term) {
    const std::string id = id_of(check, part);
    const std::map<std::int64_t, double> own = evidence.rounds(id);
    const std::vector<double> constant = evidence.samples(id);
    if (constant.empty() || (evidence.is_timing(id) && own.size() != rounds.size())) return {};
    for (auto& [round, values] : rounds) {
      if (evidence.is_timing(id) && !own.contains(round)) return {};
      values.push_back(evidence.is_timing(id) ? own.at(round) : constant[0]);
    }
  }
  if (timed && rounds.size() < 2) return {};
  std::vector<double> combined;
  for (const auto& [round, values] : rounds) combined.push_back(combine(check, term, values));
  return combined;
}

JudgedTerm judge_term(const ClaimCheck& check, const std::vector<std::string>& term,
                      const Evidence& evidence) {
  JudgedTerm judged{expression_of(check, term), "not measured", CheckOutcome::missing};
  if (check.subject == CheckSubject::same || check.subject == CheckSubject::different)
    return judge_comparison(check, term, evidence, judged);
  if (check.subject == CheckSubject::matches)
    return judge_matches(check, term[0], evidence, judged);
  if (check.subject == CheckSubject::exponent) return judge_exponent(check, term, evidence, judged);
  if (check.equals_text) return judge_text(check, term[0], evidence, judged);
  const std::vector<double> combined = combined_by_round(check, term, evidence);
  if (combined.empty()) return judged;
  judged.number = combined.size() == 1 ? MedianOfRounds{{combined[0], combined[0], combined[0]}}
                                       : median_of_rounds(combined);
  judged.outcome = outcome_of(*judged.number, check);
  return judged;
}

JudgedCheck judge_check(const ClaimCheck& check, const Evidence& evidence) {
  JudgedCheck judged{"", check.why, CheckOutcome::missing, {}};
  std::size_t holds = 0, undecided = 0, missing = 0;
  for (const auto& term : check.terms) {
    judged.terms.push_back(judge_term(check, term, evidence));
    const CheckOutcome outcome = judged.terms.back().outcome;
    holds += outcome == CheckOutcome::holds;
    undecided += outcome == CheckOutcome::undecided;
    missing += outcome == CheckOutcome::missing;
  }
  word_numbers(check, judged);
  if (holds + undecided + missing < check.required) {
    judged.outcome = CheckOutcome::fails;  // no evidence that is still missing could save it
  } else if (missing > 0) {
    judged.outcome = CheckOutcome::missing;
  } else {
    judged.outcome = holds >= check.required ? CheckOutcome::holds : CheckOutcome::undecided;
  }
  return judged;
}

/// The worst outcome decides; a failed check needs no other evidence.
Verdict verdict_of(const Claim& claim, const std::vector<JudgedCheck>& checks) {
  const auto any = [&](CheckOutcome outcome) {
    return std::any_of(checks.begin(), checks.end(),
                       [&](const auto& c) { return c.outcome == outcome; });
  };
  if (any(CheckOutcome::fails)) return Verdict::not_reproduced;
  if (any(CheckOutcome::missing)) return Verdict::not_measured;
  if (any(CheckOutcome::undecided)) return Verdict::inconclusive;
  return claim.erratum.empty() ? Verdict::reproduced : Verdict::reproduced_with_erratum;
}

/// Calls use(measurement) for everything a claim rests on.
template <class Use>
void for_each_measurement(const Claim& claim, const Use& use) {
  for (const ClaimCheck& check : claim.checks)
    for (const auto& term : check.terms)
      for (const std::string& part : term) use(id_of(check, part));
}

std::string short_measured(const std::vector<JudgedCheck>& checks) {
  std::string text;
  for (const JudgedCheck& check : checks) {
    if (!text.empty()) text += "; ";
    std::vector<std::string> values;
    for (const JudgedTerm& term : check.terms) values.push_back(term.measured);
    const bool alike =
        std::all_of(values.begin(), values.end(), [&](const auto& v) { return v == values[0]; });
    text += alike ? values[0] : fmt::format("{}", fmt::join(values, ", "));
  }
  return text;
}

}  // namespace

bool Judgement::is_unexpected() const {
  if (varies && !claim->machine_dependence.empty()) return false;
  return verdict != claim->expected_verdict && verdict != Verdict::not_measured &&
         verdict != Verdict::inconclusive;
}

Judgement judge(const Claim& claim, const Evidence& evidence, Tier tier) {
  Judgement judgement{.claim = &claim, .reason = claim.reason};
  if (claim.fixed_verdict) {
    judgement.verdict = *claim.fixed_verdict;
    return judgement;
  }
  for (const ClaimCheck& check : claim.checks)
    judgement.checks.push_back(judge_check(check, evidence));
  judgement.measured = short_measured(judgement.checks);
  std::int64_t threads = 1;
  for_each_measurement(claim, [&](const std::string& measurement) {
    judgement.varies |= evidence.is_timing(measurement);
    threads = std::max(threads, evidence.threads(measurement));
  });
  if (threads > 1) {
    judgement.verdict = Verdict::not_measured;
    judgement.reason =
        "timed with several threads, the thesis' program used one; run with --threads 1";
    return judgement;
  }
  judgement.verdict = verdict_of(claim, judgement.checks);
  if (judgement.verdict == Verdict::not_measured) {
    bool present = true;
    for_each_measurement(claim, [&](const std::string& id) {
      present &= evidence.has(id) || !evidence.recorded_below(id).empty();
    });
    judgement.reason = tier < claim.tier ? fmt::format("needs tier {}, this run is tier {}",
                                                       name_of(claim.tier), name_of(tier))
                       : present         ? "its times lack rounds, or partners in the same round"
                                 : "this run did not include the experiment that measures it";
  }
  return judgement;
}

}  // namespace phytobench
