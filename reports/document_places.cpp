// SPDX-License-Identifier: MIT
#include "reports/document_places.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "reports/document_anchors.hpp"
#include "reports/document_claims.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

/// A name in which separators and abbreviations no longer differ.
std::string plain_name(std::string name) {
  std::replace(name.begin(), name.end(), '.', '/');
  const std::string abbreviated = "/fig-";
  const std::size_t at = name.find(abbreviated);
  return at == std::string::npos ? name : name.replace(at, abbreviated.size(), "/figure-");
}

bool is_about_a_table(const std::vector<Place>& places) {
  return std::any_of(places.begin(), places.end(),
                     [](const Place& place) { return place.kind == PlaceKind::table; });
}

/// Links grouped by verdict, in the order of the first of each.
ordered_json groups_of(const std::vector<ClaimLink>& links) {
  ordered_json groups = ordered_json::array();
  for (const ClaimLink& link : links) {
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&](const ordered_json& g) { return g["label"] == link.label; });
    if (group == groups.end()) {
      groups.push_back(
          {{"label", link.label}, {"class", link.look}, {"claims", ordered_json::array()}});
      group = groups.end() - 1;
    }
    (*group)["claims"].push_back({{"anchor", link.anchor}, {"short_id", link.short_id}});
  }
  return groups;
}

}  // namespace

ordered_json link_document(const ClaimLink& link) {
  return {{"anchor", link.anchor},
          {"short_id", link.short_id},
          {"label", link.label},
          {"class", link.look}};
}

ClaimIndex::ClaimIndex(const std::vector<Judgement>& judgements, bool without_varying) {
  for (const Judgement& judgement : judgements) {
    const Claim& claim = *judgement.claim;
    const ShownVerdict shown = shown_verdict(judgement, without_varying);
    const std::vector<Place> places = places_of(claim.locator);
    for (const Place& place : places) by_place_[place].push_back(links_.size());
    by_name_.emplace(plain_name(claim.id), links_.size());
    if (is_about_a_table(places)) by_table_name_.emplace(plain_name(claim.id), links_.size());
    for (const ClaimCheck& check : claim.checks)
      if (check.subject == CheckSubject::value)
        for (const auto& term : check.terms) by_measurement_.emplace(term.at(0), links_.size());
    links_.push_back({claim_anchor(claim.id), short_claim_id(claim.id), shown.label, shown.look});
  }
}

std::vector<ClaimLink> ClaimIndex::at(const Place& place) const {
  std::vector<ClaimLink> links;
  const auto found = by_place_.find(place);
  if (found == by_place_.end()) return links;
  for (const std::size_t claim : found->second) links.push_back(links_[claim]);
  return links;
}

const ClaimLink* ClaimIndex::about(const std::string& measurement) const {
  const std::string name = plain_name(measurement);
  const auto find = [&](const auto& claims, const std::string& key) {
    const auto found = claims.find(key);
    return found == claims.end() ? nullptr : &links_[found->second];
  };
  if (const ClaimLink* link = find(by_name_, name)) return link;
  if (const ClaimLink* link = find(by_table_name_, name.substr(0, name.rfind('/')))) return link;
  return find(by_measurement_, measurement);
}

ordered_json ClaimIndex::document() const {
  ordered_json kinds = ordered_json::array();
  for (const auto& [place, claims] : by_place_) {
    const std::string title(heading_of(place.kind));
    if (kinds.empty() || kinds.back()["title"] != title)
      kinds.push_back({{"title", title}, {"rows", ordered_json::array()}});
    kinds.back()["rows"].push_back({{"place", shown(place)}, {"groups", groups_of(at(place))}});
  }
  return kinds;
}

}  // namespace phytobench
