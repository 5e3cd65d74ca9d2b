// SPDX-License-Identifier: MIT
#include "core/lsystem/production_choice.hpp"

#include <cmath>

#include "core/lsystem/derive.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

OutcomeIndex ProductionChoice::outcome_of(const ModuleSite& site, double* gathered,
                                          const Production*& unfit) {
  if (!table_->has_choice(site.symbol)) return site.symbol;
  for (const Candidate& candidate : table_->candidates(site.symbol)) {
    tried_.add(1);
    const double* parameters = site.parameters;
    if (candidate.condition_sees_contexts) parameters = gathered;
    if (candidate.pattern != nullptr &&
        !contexts_->fits(*candidate.pattern, site.position,
                         candidate.condition_sees_contexts ? gathered : nullptr))
      continue;
    if (candidate.condition) {
      const double value =
          candidate.condition->evaluate(parameters, random_place_of(seed_, step_, site.position));
      if (!std::isfinite(value)) {
        unfit = candidate.production;
        return no_outcome;
      }
      if (value == 0.0) continue;
    }
    return candidate.alternatives.size() == 1 ? candidate.alternatives.front().outcome
                                              : drawn(candidate, site.position);
  }
  return site.symbol;
}

OutcomeIndex ProductionChoice::drawn(const Candidate& candidate, std::size_t position) const {
  const double unit = random_unit(seed_, 2 * static_cast<std::uint64_t>(step_), position);
  for (const Alternative& alternative : candidate.alternatives)
    if (unit < alternative.below) return alternative.outcome;
  return candidate.alternatives.back().outcome;  // where the sum of probabilities is rounded down
}

}  // namespace phytobench
