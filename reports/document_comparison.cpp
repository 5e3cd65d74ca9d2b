// SPDX-License-Identifier: MIT
#include "reports/document_comparison.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_claims.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t most_records = 20;  // named in the report; all stand in its CSV file

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
    for (const ComparedRun& run : comparison_.runs) document["labels"].push_back(run.label);
    document["runs"] = comparison_.runs.size();
    document["facts"] = facts();
    document["notes"] = notes();
    document["verdicts"] = verdicts();
    document["contradicted"] = claims([](const ComparedClaim& c) { return c.contradicted; });
    document["has_contradicted"] = !document["contradicted"].empty();
    document["decided_by_all"] = number_decided_by([](auto some, auto all) { return some == all; });
    document["decided_by_some"] =
        number_decided_by([](auto some, auto all) { return some > 0 && some < all; });
    document["records"] = records();
    document["timings"] = claims([](const ComparedClaim& claim) {
      return claim.varies && !std::all_of(claim.measured.begin(), claim.measured.end(),
                                          [](const auto& text) { return text.empty(); });
    });
    document["has_timings"] = !document["timings"].empty();
    return document;
  }

 private:
  using Fact = std::string (*)(const ComparedRun&, const ordered_json&);

  static std::string environment_text(const ordered_json& environment, const char* key) {
    const auto found = environment.find(key);
    if (found == environment.end()) return "not recorded";
    return found->is_string() ? found->get<std::string>() : found->dump();
  }

  ordered_json fact(const char* name, bool varies, Fact text) const {
    ordered_json row{{"name", name}, {"cells", ordered_json::array()}, {"varies", varies}};
    for (std::size_t run = 0; run < comparison_.runs.size(); ++run)
      row["cells"].push_back(text(comparison_.runs[run], ordered_json::parse(environments_[run])));
    row["differs"] = std::any_of(row["cells"].begin(), row["cells"].end(),
                                 [&](const auto& cell) { return cell != row["cells"][0]; });
    return row;
  }

  /// What is known of each run, a row per fact.
  ordered_json facts() const {
    ordered_json rows = {
        fact("tier", false,
             [](const auto& run, const auto&) {
               return std::string(name_of(run.contents.header.tier));
             }),
        fact("seed", false,
             [](const auto& run, const auto&) { return std::to_string(run.contents.header.seed); }),
        fact("experiments", false,
             [](const auto& run, const auto&) {
               return std::to_string(run.contents.complete_experiments.size());
             }),
        fact("measurements", false, [](const auto& run, const auto&) {
          return std::to_string(run.contents.records.size());
        })};
    if (without_varying_) return rows;
    rows.push_back(fact("raw samples of times and memory", true, [](const auto& run, const auto&) {
      return std::to_string(run.contents.timings.size());
    }));
    rows.push_back(fact("compiler", true, [](const auto&, const auto& environment) {
      return environment_text(environment, "compiler");
    }));
    rows.push_back(fact("flags", true, [](const auto&, const auto& environment) {
      return environment_text(environment, "flags");
    }));
    rows.push_back(fact("processor", true, [](const auto&, const auto& environment) {
      return environment.contains("machine") ? environment_text(environment["machine"], "processor")
                                             : std::string("not recorded");
    }));
    rows.push_back(fact("commit", true, [](const auto&, const auto& environment) {
      return environment_text(environment, "commit");
    }));
    rows.push_back(fact("date", true, [](const auto&, const auto& environment) {
      return environment_text(environment, "date_utc");
    }));
    return rows;
  }

  /// What a reader must know before comparing.
  ordered_json notes() const {
    ordered_json texts = ordered_json::array();
    const RunHeader& first = comparison_.runs.front().contents.header;
    const auto any = [&](const auto& differs) {
      return std::any_of(comparison_.runs.begin(), comparison_.runs.end(),
                         [&](const auto& run) { return differs(run.contents.header); });
    };
    if (any([&](const RunHeader& header) { return header.tier != first.tier; }))
      texts.push_back(
          "The runs are of different tiers: a claim of a higher tier is decided by the others "
          "alone, and measurements that depend on the tier differ.");
    if (any([&](const RunHeader& header) { return header.seed != first.seed; }))
      texts.push_back(
          "The runs have different seeds: measurements that rest on random numbers differ.");
    return texts;
  }

  bool hidden(const ComparedClaim& claim) const { return without_varying_ && claim.varies; }

  /// Number of claims by verdict, in each run and merged.
  ordered_json verdicts() const {
    ordered_json rows = ordered_json::array();
    for (const Verdict verdict : all_verdicts) {
      ordered_json row{{"verdict", name_of(verdict)},
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
        cells.push_back({{"run", comparison_.runs[run].label},
                         {"verdict", name_of(claim.verdicts[run])},
                         {"class", verdict_class(claim.verdicts[run])},
                         {"measured", claim.measured[run]}});
      row["cells"] = cells;
      rows.push_back(row);
    }
    return rows;
  }

  ordered_json records() const {
    const RecordComparison& records = comparison_.records;
    ordered_json part{{"in_all", records.in_all},
                      {"shared", records.shared},
                      {"equal", records.equal},
                      {"differing", records.differing.size()},
                      {"all_equal", records.differing.empty() && records.shared > 0},
                      {"has_differing", !records.differing.empty()},
                      {"only_in", ordered_json::array()},
                      {"first", ordered_json::array()}};
    for (std::size_t run = 0; run < records.only_in.size(); ++run)
      if (records.only_in[run] > 0)
        part["only_in"].push_back(
            {{"label", comparison_.runs[run].label}, {"count", records.only_in[run]}});
    for (const DifferingRecord& record : records.differing) {
      if (part["first"].size() == most_records) break;
      ordered_json cells = ordered_json::array();
      for (const auto& value : record.values) cells.push_back(value.value_or("-"));
      part["first"].push_back(
          {{"measurement", record.measurement},
           {"cells", cells},
           {"relative", record.relative ? fmt::format("{:.2g}", *record.relative) : "-"}});
    }
    part["more"] = records.differing.size() - part["first"].size();
    part["has_more"] = part["more"] > 0;
    return part;
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
