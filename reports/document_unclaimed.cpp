// SPDX-License-Identifier: MIT
#include "reports/document_unclaimed.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "reports/document_costs.hpp"
#include "reports/unclaimed_measurements.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

/// "step-40/duration-80" -> "step-*/duration-*".
std::string without_numbers(const std::string& name) {
  std::string pattern;
  for (const char c : name) {
    const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (!digit) pattern += c;
    if (digit && !pattern.ends_with('*')) pattern += '*';
  }
  return pattern;
}

std::vector<const Claim*> claims_of(const JudgedRun& judged) {
  std::vector<const Claim*> claims;
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements) claims.push_back(judgement.claim);
  return claims;
}

void add_count(ordered_json& part, std::size_t count) {
  part["count"] = part["count"].get<std::size_t>() + count;
}

void add_group(ordered_json& groups, const UnclaimedGroup& group) {
  const std::string name = group.group.empty() ? "(directly)" : without_numbers(group.group);
  const auto found = std::find_if(groups.begin(), groups.end(),
                                  [&](const ordered_json& own) { return own["group"] == name; });
  if (found == groups.end())
    groups.push_back({{"group", name}, {"count", group.count}});
  else
    add_count(*found, group.count);
}

}  // namespace

ordered_json unclaimed_document(const JudgedRun& judged, bool without_varying) {
  RunContents run = judged.run;
  if (without_varying) run.timings.clear();
  std::erase_if(run.timings, is_cost);
  ordered_json experiments = ordered_json::array();
  for (const UnclaimedGroup& group : unclaimed_measurements(run, claims_of(judged))) {
    if (experiments.empty() || experiments.back()["experiment"] != group.experiment)
      experiments.push_back(
          {{"experiment", group.experiment}, {"count", 0}, {"groups", ordered_json::array()}});
    add_count(experiments.back(), group.count);
    add_group(experiments.back()["groups"], group);
  }
  return experiments;
}

}  // namespace phytobench
