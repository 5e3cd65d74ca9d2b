// SPDX-License-Identifier: MIT
#include "reports/document_comparison.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "reports/document_claims.hpp"
#include "reports/document_differing_records.hpp"
#include "reports/document_run_origins.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

/// Builds the document part by part.
class ComparisonDocument {
 public:
  ComparisonDocument(const JudgedRun& merged, const RunComparison& comparison,
                     std::span<const std::string> environments, bool without_varying)
      : comparison_(comparison), environments_(environments), without_varying_(without_varying) {
    for (const JudgedPaper& paper : merged.papers)
      for (const Judgement& judgement : paper.judgements) judgements_.push_back(&judgement);
  }

  ordered_json build() const {
    ordered_json document;
    document["labels"] = ordered_json::array();
    for (std::size_t run = 0; run < comparison_.runs.size(); ++run)
      document["labels"].push_back(run_letter(run));
    document["runs"] = comparison_.runs.size();
    const RunOrigins origins{comparison_.runs, environments_, without_varying_};
    document["facts"] = run_facts(origins);
    document["warnings"] = run_warnings(origins);
    document["has_warnings"] = !document["warnings"].empty();
    document["verdicts"] = verdicts();
    document["contradicted"] = claims([](const ComparedClaim& c) { return c.contradicted; });
    document["has_contradicted"] = !document["contradicted"].empty();
    document["decided_by_all"] = number_decided_by([](auto some, auto all) { return some == all; });
    document["decided_by_some"] =
        number_decided_by([](auto some, auto all) { return some > 0 && some < all; });
    document["records"] = differing_records_document(comparison_);
    document["timings"] = claims([](const ComparedClaim& claim) {
      return claim.varies && !std::all_of(claim.measured.begin(), claim.measured.end(),
                                          [](const auto& text) { return text.empty(); });
    });
    document["has_timings"] = !document["timings"].empty();
    return document;
  }

 private:
  bool hidden(const ComparedClaim& claim) const { return without_varying_ && claim.varies; }

  /// Number of claims by verdict, in each run and merged.
  ordered_json verdicts() const {
    ordered_json rows = ordered_json::array();
    for (const Verdict verdict : all_verdicts) {
      ordered_json row{{"verdict", label_of(verdict)},
                       {"class", verdict_class(verdict)},
                       {"cells", ordered_json::array()}};
      for (std::size_t run = 0; run < comparison_.runs.size(); ++run)
        row["cells"].push_back(
            number_of([&](const auto& c) { return c.verdicts[run] == verdict; }));
      row["merged"] = number_of([&](const auto& claim) { return claim.merged == verdict; });
      rows.push_back(row);
    }
    return rows;
  }

  template <class Counts>
  std::size_t number_of(const Counts& counts) const {
    return static_cast<std::size_t>(
        std::count_if(comparison_.claims.begin(), comparison_.claims.end(),
                      [&](const auto& claim) { return !hidden(claim) && counts(claim); }));
  }

  template <class Counts>
  std::size_t number_decided_by(const Counts& counts) const {
    return number_of([&](const ComparedClaim& claim) {
      const auto some = std::count_if(claim.verdicts.begin(), claim.verdicts.end(), is_decided);
      return counts(static_cast<std::size_t>(some), claim.verdicts.size());
    });
  }

  /// Claims with what each run says of them.
  template <class Belongs>
  ordered_json claims(const Belongs& belongs) const {
    ordered_json rows = ordered_json::array();
    for (std::size_t i = 0; i < comparison_.claims.size(); ++i) {
      const ComparedClaim& claim = comparison_.claims[i];
      if (hidden(claim) || !belongs(claim)) continue;
      ordered_json row = claim_brief(*judgements_[i], without_varying_);
      ordered_json cells = ordered_json::array();
      for (std::size_t run = 0; run < claim.verdicts.size(); ++run)
        cells.push_back({{"run", run_letter(run)},
                         {"verdict", label_of(claim.verdicts[run])},
                         {"class", verdict_class(claim.verdicts[run])},
                         {"measured", claim.measured[run]}});
      row["cells"] = cells;
      rows.push_back(row);
    }
    return rows;
  }

  const RunComparison& comparison_;
  std::span<const std::string> environments_;
  bool without_varying_;
  std::vector<const Judgement*> judgements_;
};

}  // namespace

ordered_json comparison_document(const JudgedRun& merged, const RunComparison& comparison,
                                 std::span<const std::string> environments, bool without_varying) {
  return ComparisonDocument(merged, comparison, environments, without_varying).build();
}

}  // namespace phytobench
