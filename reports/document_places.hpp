// SPDX-License-Identifier: MIT
// Ways to a claim for a reader who knows only its work: by place, and by cell of a printed table.
#pragma once

#include <map>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "reports/document_locators.hpp"
#include "reports/judge/judge.hpp"

namespace phytobench {

/// A claim as the target of a link.
struct ClaimLink {
  std::string anchor;
  std::string short_id;
  std::string label;  ///< its verdict in words
  std::string look;   ///< and as a CSS class
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

  /// Everything by kind of place, in the order of the work, each place's claims by verdict.
  nlohmann::ordered_json document() const;

 private:
  std::vector<ClaimLink> links_;
  std::map<Place, std::vector<std::size_t>> by_place_;
  std::map<std::string, std::size_t> by_name_, by_table_name_, by_measurement_;
};

}  // namespace phytobench
