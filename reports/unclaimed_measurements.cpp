// SPDX-License-Identifier: MIT
#include "reports/unclaimed_measurements.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace phytobench {

namespace {

/// Names and starts of names that claims rest on.
class ClaimedNames {
 public:
  explicit ClaimedNames(const std::vector<const Claim*>& claims) {
    for (const Claim* claim : claims)
      for (const ClaimCheck& check : claim->checks)
        for (const auto& term : check.terms)
          for (const std::string& part : term)
            (check.subject == CheckSubject::matches ? starts_ : names_)
                .insert(measurement_of(check, part));
  }

  bool contain(const std::string& measurement) const {
    return names_.contains(measurement) ||
           std::any_of(starts_.begin(), starts_.end(),
                       [&](const std::string& start) { return measurement.starts_with(start); });
  }

 private:
  std::set<std::string> names_;
  std::set<std::string> starts_;
};

/// "brzoska2019/table-1/euclid.s/edges" below "brzoska2019/table-1" -> "euclid.s".
std::string group_of(const std::string& measurement, const std::string& experiment) {
  const std::size_t first = experiment.size() + 1;
  const std::size_t last = measurement.rfind('/');
  const bool is_below = measurement.starts_with(experiment + "/") && last >= first;
  return is_below ? measurement.substr(first, last - first) : "";
}

}  // namespace

std::vector<UnclaimedGroup> unclaimed_measurements(const RunContents& run,
                                                   const std::vector<const Claim*>& claims) {
  const ClaimedNames claimed(claims);
  std::map<std::pair<std::string, std::string>, std::set<std::string>> groups;
  const auto add = [&](const std::string& experiment, const std::string& measurement) {
    if (!claimed.contain(measurement))
      groups[{experiment, group_of(measurement, experiment)}].insert(measurement);
  };
  for (const Record& record : run.records) add(record.experiment, record.measurement);
  for (const TimingSample& sample : run.timings) add(sample.experiment, sample.measurement);
  std::vector<UnclaimedGroup> unclaimed;
  for (const auto& [place, measurements] : groups)
    unclaimed.push_back({place.first, place.second, measurements.size()});
  return unclaimed;
}

std::vector<UnclaimedGroup> unclaimed_measurements(const JudgedRun& judged) {
  std::vector<const Claim*> claims;
  for (const JudgedPaper& paper : judged.papers)
    for (const Claim& claim : paper.claims.claims) claims.push_back(&claim);
  return unclaimed_measurements(judged.run, claims);
}

}  // namespace phytobench
