// SPDX-License-Identifier: MIT
#include "reports/document_errata.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_anchors.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

/// Links to those of the named claims that this report holds.
ordered_json claim_links(const JudgedPaper& judged, const std::vector<std::string>& ids) {
  std::set<std::string> known;
  for (const Judgement& judgement : judged.judgements) known.insert(judgement.claim->id);
  ordered_json links = ordered_json::array();
  for (const std::string& id : ids)
    if (known.contains(id))
      links.push_back({{"anchor", claim_anchor(id)}, {"short_id", short_claim_id(id)}});
  return links;
}

ordered_json example_part(const CounterExample& example) {
  ordered_json part{{"oracle", example.oracle},
                    {"inputs", ordered_json::array()},
                    {"result", example.result},
                    {"has_result", !example.result.empty()},
                    {"printed", example.printed ? shown(*example.printed) : "no value"},
                    {"corrected", shown(example.corrected)},
                    {"why", example.why},
                    {"tolerance", fmt::format("{:g}", example.tolerance)},
                    {"tolerance_reason", example.tolerance_reason},
                    {"has_tolerance", !example.tolerance_reason.empty() && example.tolerance > 0}};
  for (std::size_t i = 0; i < example.arguments.size(); ++i) {
    const std::string name = i < example.inputs.size() ? example.inputs[i] : "";
    part["inputs"].push_back({{"name", name.empty() ? fmt::format("input {}", i + 1) : name},
                              {"value", shown(example.arguments[i])}});
  }
  return part;
}

ordered_json erratum_part(const JudgedPaper& judged, const Erratum& erratum) {
  const bool of_program = erratum.kind == ErratumKind::program;
  ordered_json part{{"id", erratum.id},
                    {"anchor", erratum_anchor(judged.paper.key, erratum.id)},
                    {"locator", erratum.locator},
                    {"kind", erratum.kind ? name_of(*erratum.kind) : ""},
                    {"has_kind", erratum.kind.has_value()},
                    {"printed", erratum.printed},
                    {"corrected", erratum.corrected},
                    {"of_program", of_program},
                    {"other_form", of_program ? "What the program does" : "Corrected"},
                    {"other_form_short", of_program ? "in the program" : "corrected"},
                    {"consequence", erratum.consequence},
                    {"check", erratum.check},
                    {"has_check", !erratum.check.empty()},
                    {"confidence", erratum.confidence},
                    {"has_example", erratum.counter_example.has_value()},
                    {"claims", claim_links(judged, erratum.claims)}};
  part["has_claims"] = !part["claims"].empty();
  part["example"] =
      erratum.counter_example ? example_part(*erratum.counter_example) : ordered_json::object();
  return part;
}

}  // namespace

ordered_json errata_document(const JudgedPaper& judged) {
  std::vector<const Erratum*> sorted;
  for (const Erratum& erratum : judged.errata) sorted.push_back(&erratum);
  std::stable_sort(sorted.begin(), sorted.end(), [](const Erratum* a, const Erratum* b) {
    return section_is_before(a->section, b->section);
  });
  ordered_json errata = ordered_json::array();
  for (const Erratum* erratum : sorted) errata.push_back(erratum_part(judged, *erratum));
  return errata;
}

ordered_json assumptions_document(const JudgedPaper& judged) {
  ordered_json assumptions = ordered_json::array();
  for (const Assumption& assumption : judged.assumptions) {
    ordered_json part{{"id", assumption.id},
                      {"anchor", assumption_anchor(judged.paper.key, assumption.id)},
                      {"locator", assumption.locator},
                      {"question", assumption.question},
                      {"reading", assumption.reading},
                      {"alternatives", assumption.alternatives},
                      {"claims", claim_links(judged, assumption.claims)}};
    part["has_claims"] = !part["claims"].empty();
    assumptions.push_back(part);
  }
  return assumptions;
}

}  // namespace phytobench
