// SPDX-License-Identifier: MIT
#include "reports/judge/smallest_refutation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract/check.hpp"
#include "reports/judge/record_paths.hpp"

namespace phytobench {

namespace {

using Names = std::vector<std::string>;

bool is_text(const RecordValue& value) {
  return std::holds_alternative<std::string>(value);
}

double scale_of(const RecordValue& value) {
  const double size = std::abs(number_of(value).value());
  return size > 0.0 ? size : 1.0;
}

/// Moved by a share of its size, at least by its last place. A whole number stays one.
RecordValue moved(const RecordValue& value, double share) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text + " and more";
  const double step = share * scale_of(value);
  if (const auto* whole = std::get_if<std::int64_t>(&value)) {
    const std::int64_t steps = std::llround(std::clamp(step, -1e18, 1e18));
    return *whole + (steps != 0 ? steps : share < 0.0 ? -1 : 1);
  }
  const double real = std::get<double>(value);
  const double far = real + step;
  if (far != real) return far;
  return std::nextafter(real, std::copysign(std::numeric_limits<double>::infinity(), share));
}

/// Tries changes and remembers the smallest that refuted the claim.
class RefutationSearch {
 public:
  RefutationSearch(const Claim& claim, const Measurements& measurements)
      : claim_(claim), measurements_(measurements) {}

  /// All of `names` moved alike, up and down.
  void try_moving(const Names& names) {
    const RecordValue& before = measurements_.at(names[0]);
    if (is_text(before)) {
      try_values(names, [](const RecordValue& value) { return moved(value, 1.0); });
      return;
    }
    constexpr double closeness = 0.01;  // of the exponents, and so of the changes
    for (const double sign : {1.0, -1.0}) {
      // Binary exponents of the share: beyond the first that refutes, all do. What is less than 1
      // moves as far as 1 would.
      double low = -52.0, high = 64.0 - std::min(std::log2(scale_of(before)), 0.0);
      if (best_) high = std::min(high, std::log2(best_->relative_change) - closeness);
      if (high < low) continue;
      if (!try_share(names, sign * std::exp2(high))) continue;
      while (high - low > closeness) {
        const double middle = (low + high) / 2.0;
        (try_share(names, sign * std::exp2(middle)) ? high : low) = middle;
      }
      try_share(names, sign * std::exp2(-52.0));
    }
  }

  void try_equal_to(const std::string& name, const std::string& other) {
    if (measurements_.contains(name) && measurements_.contains(other))
      try_values({name}, [&](const RecordValue&) { return measurements_.at(other); });
  }

  const std::optional<Refutation>& best() const { return best_; }

 private:
  bool try_share(const Names& names, double share) {
    return try_values(names, [&](const RecordValue& value) { return moved(value, share); });
  }

  template <class Change>
  bool try_values(const Names& names, const Change& change) {
    Measurements changed = measurements_;
    for (const std::string& name : names) changed.at(name) = change(measurements_.at(name));
    if (verdict_on(claim_, changed) != Verdict::not_reproduced) return false;
    Refutation found{names, measurements_.at(names[0]), changed.at(names[0]), 0.0};
    if (!is_text(found.before) && !is_text(found.after))
      found.relative_change =
          std::abs(number_of(found.after).value() - number_of(found.before).value()) /
          scale_of(found.before);
    if (!best_ || found.relative_change < best_->relative_change) best_ = found;
    return true;
  }

  const Claim& claim_;
  const Measurements& measurements_;
  std::optional<Refutation> best_;
};

/// The measurements that stand at the same place of each term of a check; of counted ones, all that
/// match.
std::vector<Names> moved_together(const ClaimCheck& check, const Measurements& measurements) {
  std::vector<Names> groups;
  for (const auto& term : check.terms) {
    groups.resize(std::max(groups.size(), term.size()));
    for (std::size_t i = 0; i < term.size(); ++i) {
      const std::string name = measurement_of(check, term[i]);
      if (measurements.contains(name)) groups[i].push_back(name);
      if (check.subject != CheckSubject::matches) continue;
      for (auto found = measurements.lower_bound(name);
           found != measurements.end() && found->first.starts_with(name); ++found)
        if (found->second == RecordValue(*check.equals_text)) groups[i].push_back(found->first);
    }
  }
  std::erase_if(groups, [](const Names& names) { return names.empty(); });
  return groups;
}

}  // namespace

std::optional<Refutation> smallest_refutation(const Claim& claim,
                                              const Measurements& measurements) {
  PHYTOBENCH_EXPECT(holds(claim, measurements));
  RefutationSearch search(claim, measurements);
  for (const auto& [name, value] : measurements) search.try_moving({name});
  for (const ClaimCheck& check : claim.checks)
    if (check.subject == CheckSubject::different)
      for (const auto& term : check.terms)
        for (std::size_t i = 1; i < term.size(); ++i) search.try_equal_to(term[i], term[0]);
  if (search.best()) return search.best();
  for (const ClaimCheck& check : claim.checks)
    for (const Names& names : moved_together(check, measurements)) search.try_moving(names);
  return search.best();
}

}  // namespace phytobench
