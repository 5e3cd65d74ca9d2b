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
    paper_ = claim.paper;
    const ShownVerdict shown = shown_verdict(judgement, without_varying);
    const std::vector<Place> places = places_of(claim.locator);
    for (const Place& place : places) by_place_[place].push_back(links_.size());
    by_name_.emplace(plain_name(claim.id), links_.size());
    if (is_about_a_table(places)) by_table_name_.emplace(plain_name(claim.id), links_.size());
    for (const ClaimCheck& check : claim.checks)
      if (check.subject == CheckSubject::value)
        for (const auto& term : check.terms) by_measurement_.emplace(term.at(0), links_.size());
    links_.push_back({claim_anchor(claim.id), short_claim_id(claim.id), shown.label, shown.look,
                      claim.digits, claim.published});
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

std::vector<std::string> ClaimIndex::table_names_from(const std::string& start) const {
  std::map<std::size_t, std::string> names;
  for (auto at = by_table_name_.lower_bound(start);
       at != by_table_name_.end() && at->first.starts_with(start); ++at)
    names[at->second] = at->first.substr(start.size());
  std::vector<std::string> ordered;
  for (const auto& [claim, name] : names) ordered.push_back(name);
  return ordered;
}

/// It or, of a section, anything in it.
bool ClaimIndex::has_claims(const Place& place, const std::vector<KnownPlace>& known) const {
  if (by_place_.contains(place)) return true;
  return place.kind == PlaceKind::section &&
         std::any_of(known.begin(), known.end(), [&](const KnownPlace& other) {
           return other.section == place.number && has_claims(other.place, known);
         });
}

/// What a reader finds who looks for a place that no claim names.
std::string ClaimIndex::without_claims(const KnownPlace& place,
                                       const std::vector<KnownPlace>& known) const {
  if (place.place.kind != PlaceKind::section) {
    const Place section{PlaceKind::section, place.section};
    return "No checkable statement of its own found" +
           (has_claims(section, known) ? "; there are claims on " + shown(section) : "");
  }
  std::string parts;
  for (const KnownPlace& other : known)
    if (other.section == place.place.number && has_claims(other.place, known))
      parts += (parts.empty() ? "" : ", ") + shown(other.place);
  return parts.empty() ? "No checkable statement found"
                       : "No claim on it as a whole; there are claims on " + parts;
}

ordered_json ClaimIndex::document() const {
  const std::vector<KnownPlace> known =
      paper_.empty() ? std::vector<KnownPlace>{} : known_places(paper_);
  std::map<Place, const KnownPlace*> places;
  for (const auto& [place, claims] : by_place_) places[place] = nullptr;
  for (const KnownPlace& each : known) places[each.place] = &each;
  ordered_json kinds = ordered_json::array();
  for (const auto& [place, where] : places) {
    const std::string title(heading_of(place.kind)), token = search_token(place);
    if (kinds.empty() || kinds.back()["title"] != title)
      kinds.push_back({{"title", title}, {"rows", ordered_json::array()}});
    const bool has_claim = by_place_.contains(place);
    kinds.back()["rows"].push_back(
        {{"place", shown(place)},
         {"token", token},
         {"has_token", !token.empty()},
         {"has_pages", where != nullptr},
         {"pages", where ? shown_pages(*where) : ""},
         {"first_page", where ? where->first_page : 0},
         {"last_page", where ? where->last_page : 0},
         {"groups", groups_of(at(place))},
         {"has_claims", has_claim},
         {"without_claims", has_claim ? "" : without_claims(*where, known)}});
  }
  return kinds;
}

}  // namespace phytobench
