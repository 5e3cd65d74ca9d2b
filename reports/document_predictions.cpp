// SPDX-License-Identifier: MIT
#include "reports/document_predictions.hpp"

#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "reports/document_anchors.hpp"
#include "reports/document_claims.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

using Counts = std::map<Verdict, std::size_t>;

std::size_t count_in(const Counts& counts, Verdict verdict) {
  const auto count = counts.find(verdict);
  return count == counts.end() ? 0 : count->second;
}

std::size_t total_of(const Counts& counts) {
  std::size_t total = 0;
  for (const auto& [verdict, count] : counts) total += count;
  return total;
}

class PredictionsDocument {
 public:
  PredictionsDocument(const JudgedRun& judged, bool without_varying)
      : without_varying_(without_varying) {
    for (const JudgedPaper& paper : judged.papers)
      for (const Judgement& judgement : paper.judgements) add(judgement);
  }

  ordered_json build() const {
    ordered_json document{{"predicted", total_of(predicted_)},
                          {"same", same_},
                          {"differ", differences_.size()},
                          {"not_seen", total_of(not_seen_)},
                          {"not_built", total_of(not_built_)},
                          {"unpredicted", unpredicted_},
                          {"has_unpredicted", unpredicted_ > 0},
                          {"columns", ordered_json::array()},
                          {"rows", ordered_json::array()},
                          {"differences", differences_},
                          {"has_differences", !differences_.empty()},
                          {"waiting", waiting()},
                          {"has_waiting", !waiting_.empty()}};
    for (const Verdict found : all_verdicts)
      if (count_in(found_, found) > 0)
        document["columns"].push_back({{"label", name_of(found)}, {"class", verdict_class(found)}});
    for (const Verdict predicted : all_verdicts)
      if (count_in(predicted_, predicted) > 0) document["rows"].push_back(row(predicted));
    return document;
  }

 private:
  void add(const Judgement& judgement) {
    const Claim& claim = *judgement.claim;
    if (!claim.predicted_verdict) {
      ++unpredicted_;
      return;
    }
    const Verdict predicted = *claim.predicted_verdict;
    ++predicted_[predicted];
    if (lacks_evidence(judgement) || shown_verdict(judgement, without_varying_).hidden)
      ++not_seen_[predicted];
    else if (!claim.missing_model.empty())
      add_waiting(claim, predicted);
    else
      add_found(judgement, predicted);
  }

  void add_waiting(const Claim& claim, Verdict predicted) {
    ++not_built_[predicted];
    waiting_[claim.missing_model].push_back(
        {{"anchor", claim_anchor(claim.id)}, {"short_id", short_claim_id(claim.id)}});
  }

  void add_found(const Judgement& judgement, Verdict predicted) {
    ++found_[judgement.verdict];
    ++cells_[predicted][judgement.verdict];
    if (judgement.verdict == predicted) {
      ++same_;
      return;
    }
    ordered_json difference = claim_brief(judgement, without_varying_);
    difference["predicted_class"] = verdict_class(predicted);
    differences_.push_back(std::move(difference));
  }

  ordered_json row(Verdict predicted) const {
    ordered_json row{{"predicted", name_of(predicted)},
                     {"class", verdict_class(predicted)},
                     {"cells", ordered_json::array()},
                     {"not_seen", count_in(not_seen_, predicted)},
                     {"not_built", count_in(not_built_, predicted)},
                     {"total", count_in(predicted_, predicted)}};
    const auto cells = cells_.find(predicted);
    for (const auto& [found, any] : found_) {
      const std::size_t count = cells == cells_.end() ? 0 : count_in(cells->second, found);
      row["cells"].push_back({{"count", count},
                              {"same", found == predicted && count > 0},
                              {"other", found != predicted && count > 0}});
    }
    return row;
  }

  ordered_json waiting() const {
    ordered_json models = ordered_json::array();
    for (const auto& [model, claims] : waiting_)
      models.push_back({{"model", model}, {"claim_count", claims.size()}, {"claims", claims}});
    return models;
  }

  bool without_varying_;
  Counts predicted_, not_seen_, not_built_, found_;
  std::map<Verdict, Counts> cells_;  ///< by predicted, then found verdict
  std::size_t same_ = 0, unpredicted_ = 0;
  ordered_json differences_ = ordered_json::array();
  std::map<std::string, ordered_json> waiting_;  ///< claims by the model they wait for
};

}  // namespace

ordered_json predictions_document(const JudgedRun& judged, bool without_varying) {
  return PredictionsDocument(judged, without_varying).build();
}

}  // namespace phytobench
