// SPDX-License-Identifier: MIT
// Ways to a claim for a reader who knows only its work: by place, and by cell of a printed table.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "reports/document_locators.hpp"
#include "reports/document_places_known.hpp"
#include "reports/judge/judge.hpp"

namespace phytobench {

/// A claim as the target of a link.
struct ClaimLink {
  std::string anchor;
  std::string short_id;
  std::string label;               ///< its verdict in words
  std::string look;                ///< and as a CSS class
  std::optional<int> digits = {};  ///< of the number it is about, as printed
  std::string published = {};      ///< as the claim has it
};

nlohmann::ordered_json link_document(const ClaimLink& link);

/// Claims of one work by place and by measurement.
class ClaimIndex {
 public:
  ClaimIndex() = default;
  ClaimIndex(const std::vector<Judgement>& judgements, bool without_varying);

  /// In the order of the claims; none for a place that no locator names.
  std::vector<ClaimLink> at(const Place& place) const;

  /// The claim about one cell of a printed table: the one of the same name, else the first that
  /// judges the measurement itself. A cell's name and a claim's may differ in the separator, in
  /// "fig-" for "figure-", and, for claims about a table, in a last part such as "seconds".
  const ClaimLink* about(const std::string& measurement) const;

  /// What follows `start` in the names of claims about tables, in the order of the claims:
  /// "figure-40-left/seconds" from "key/appendix/".
  std::vector<std::string> table_names_from(const std::string& start) const;

  /// Everything by kind of place, in the order of the work, each place's claims by verdict. A place
  /// that the work has and no claim names is there, too, and says so.
  nlohmann::ordered_json document() const;

 private:
  bool has_claims(const Place& place, const std::vector<KnownPlace>& known) const;
  std::string without_claims(const KnownPlace& place, const std::vector<KnownPlace>& known) const;

  std::string paper_;  ///< of the claims; empty: none
  std::vector<ClaimLink> links_;
  std::map<Place, std::vector<std::size_t>> by_place_;
  std::map<std::string, std::size_t> by_name_, by_table_name_, by_measurement_;
};

}  // namespace phytobench
