// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/instrument_verdict.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/statistics/binomial_interval.hpp"

namespace phytobench {

namespace {

/// Comparisons that must find nothing, and those that did.
int equal_sides(const InstrumentCheck& check) {
  return check.alike.all() + check.usual.all();
}
int alarms_among(const InstrumentCheck& check) {
  return check.alike.slower + check.alike.faster + check.usual.slower + check.usual.faster;
}

class InstrumentJudge {
 public:
  explicit InstrumentJudge(const InstrumentCheck& check) : check_(check) {}

  InstrumentVerdict verdict() {
    judge_refusals();
    judge_completeness();
    if (equal_sides(check_) > 0) judge_false_alarms();
    if (check_.handicapped.all() > 0) judge_power();
    return std::move(verdict_);
  }

 private:
  void object(InstrumentState state, const std::string& reason) {
    if (verdict_.state != InstrumentState::broken) verdict_.state = state;
    verdict_.reasons.push_back(reason);
  }

  void judge_refusals() {
    for (const RefusalCheck& refusal : check_.refusals)
      if (!refusal.is_refused)
        object(InstrumentState::broken,
               fmt::format("{}: demanded was '{}', found was '{}'.", refusal.benchmark,
                           refusal.demanded, refusal.found));
  }

  void judge_completeness() {
    const int made = equal_sides(check_) + check_.handicapped.all();
    const int wanted = check_.wanted_alike + check_.wanted_usual + check_.wanted_handicapped;
    if (made < wanted)
      object(InstrumentState::unproven,
             fmt::format("Time ended after {} of {} comparisons.", made, wanted));
    const int untimed = check_.alike.other + check_.usual.other + check_.handicapped.other;
    if (untimed > 0)
      object(InstrumentState::broken,
             fmt::format("{} comparisons of right answers were not timed.", untimed));
  }

  void judge_false_alarms() {
    const Estimate alarms = false_alarms(check_);
    if (alarms.value > most_false_alarms)
      object(alarms.low > most_false_alarms ? InstrumentState::broken : InstrumentState::unproven,
             fmt::format("Equal sides were told apart {} times of {}, more than {:.0f} %{}.",
                         alarms_among(check_), equal_sides(check_), 100.0 * most_false_alarms,
                         alarms.low > most_false_alarms ? "" : ", which may be chance"));
    if (check_.alike.all() > 0 && 2 * check_.alike.same <= check_.alike.all())
      object(
          InstrumentState::unproven,
          fmt::format("This machine is too noisy: of {} comparisons of equal sides only {} could "
                      "tell that they are the same.",
                      check_.alike.all(), check_.alike.same));
  }

  void judge_power() {
    const Estimate found = found_handicaps(check_);
    if (found.value >= least_found) return;
    const bool is_by_chance = found.high >= least_found;
    const bool is_noise = only_noise_hides_losses();
    object(is_by_chance || is_noise ? InstrumentState::unproven : InstrumentState::broken,
           fmt::format("A loss of {:.0f} % was found {} times of {}, less than {:.0f} %{}.",
                       100.0 * check_.handicap, check_.handicapped.slower, check_.handicapped.all(),
                       100.0 * least_found,
                       is_by_chance ? ", which may be chance"
                       : is_noise   ? "; the others drowned in noise"
                                    : ""));
  }

  /// Whether losses were missed only in so far as nothing could be said, for a reason.
  bool only_noise_hides_losses() const {
    return check_.handicapped.same == 0 && check_.handicapped.faster == 0 &&
           check_.noise_floor > 0.5 * check_.handicap;
  }

  const InstrumentCheck& check_;
  InstrumentVerdict verdict_{.state = InstrumentState::proven, .reasons = {}};
};

}  // namespace

std::string_view name_of(InstrumentState state) {
  switch (state) {
    case InstrumentState::proven:
      return "proven";
    case InstrumentState::unproven:
      return "not proven";
    case InstrumentState::broken:
      return "broken";
  }
  return "";
}

Estimate false_alarms(const InstrumentCheck& check) {
  PHYTOBENCH_EXPECT(equal_sides(check) > 0);
  return share_estimate(alarms_among(check), equal_sides(check));
}

Estimate found_handicaps(const InstrumentCheck& check) {
  PHYTOBENCH_EXPECT(check.handicapped.all() > 0);
  return share_estimate(check.handicapped.slower, check.handicapped.all());
}

InstrumentVerdict judge_instrument(const InstrumentCheck& check) {
  return InstrumentJudge(check).verdict();
}

}  // namespace phytobench
