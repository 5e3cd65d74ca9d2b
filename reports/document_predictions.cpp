// SPDX-License-Identifier: MIT
#include "reports/document_predictions.hpp"

#include <map>
#include <string>

#include <nlohmann/json.hpp>

#include "reports/document_anchors.hpp"
#include "reports/document_claims.hpp"
#include "reports/expectation.hpp"
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
      : without_varying_(without_varying), by_machine_(machine_dependent(judged, without_varying)) {
    for (const JudgedPaper& paper : judged.papers)
      for (const Judgement& judgement : paper.judgements) add(judgement);
  }

  ordered_json build() const {
    ordered_json document{{"predicted", total_of(predicted_)},
                          {"same", same_},
                          {"differ", differences_.size()},
                          {"undecided", undecided_},
                          {"fixed", total_of(fixed_)},
                          {"fixed_same", fixed_same_},
                          {"fixed_differ", fixed_differences_.size()},
                          {"not_seen", total_of(not_seen_)},
                          {"not_built", total_of(not_built_)},
                          {"unpredicted", unpredicted_},
                          {"has_unpredicted", unpredicted_ > 0},
                          {"columns", ordered_json::array()},
                          {"rows", ordered_json::array()},
                          {"differences", differences_},
                          {"has_differences", !differences_.empty()},
                          {"fixed_differences", fixed_differences_},
                          {"has_fixed_differences", !fixed_differences_.empty()},
                          {"by_machine", by_machine_},
                          {"by_machine_count", by_machine_.size()},
                          {"has_by_machine", !by_machine_.empty()},
                          {"waiting", waiting()},
                          {"has_waiting", !waiting_.empty()}};
    for (const Verdict found : all_verdicts)
      if (count_in(found_, found) > 0)
        document["columns"].push_back(
            {{"label", label_of(found)}, {"class", verdict_class(found)}});
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
    else if (claim.fixed_verdict)
      add_fixed(judgement, predicted);
    else
      add_found(judgement, predicted);
  }

  void add_waiting(const Claim& claim, Verdict predicted) {
    ++not_built_[predicted];
    waiting_[claim.missing_model].push_back(
        {{"anchor", claim_anchor(claim.id)}, {"short_id", short_claim_id(claim.id)}});
  }

  /// Verdict and prediction stand side by side in the claim's file: no run can confirm either.
  void add_fixed(const Judgement& judgement, Verdict predicted) {
    ++fixed_[predicted];
    if (judgement.verdict == predicted)
      ++fixed_same_;
    else
      fixed_differences_.push_back(difference(judgement, predicted));
  }

  void add_found(const Judgement& judgement, Verdict predicted) {
    ++found_[judgement.verdict];
    ++cells_[predicted][judgement.verdict];
    if (judgement.verdict == Verdict::inconclusive)
      ++undecided_;
    else if (judgement.verdict == predicted)
      ++same_;
    else
      differences_.push_back(difference(judgement, predicted));
  }

  ordered_json difference(const Judgement& judgement, Verdict predicted) const {
    ordered_json difference = claim_brief(judgement, without_varying_);
    difference["predicted_class"] = verdict_class(predicted);
    return difference;
  }

  ordered_json row(Verdict predicted) const {
    ordered_json row{{"predicted", label_of(predicted)},
                     {"class", verdict_class(predicted)},
                     {"cells", ordered_json::array()},
                     {"fixed", count_in(fixed_, predicted)},
                     {"not_seen", count_in(not_seen_, predicted)},
                     {"not_built", count_in(not_built_, predicted)},
                     {"total", count_in(predicted_, predicted)}};
    const auto cells = cells_.find(predicted);
    for (const auto& [found, any] : found_) {
      const std::size_t count = cells == cells_.end() ? 0 : count_in(cells->second, found);
      const bool decided = found != Verdict::inconclusive && count > 0;
      row["cells"].push_back({{"count", count},
                              {"same", decided && found == predicted},
                              {"other", decided && found != predicted}});
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
  Counts predicted_, not_seen_, not_built_, found_, fixed_;
  std::map<Verdict, Counts> cells_;  ///< by predicted, then found verdict
  std::size_t same_ = 0, undecided_ = 0, fixed_same_ = 0, unpredicted_ = 0;
  ordered_json differences_ = ordered_json::array(), fixed_differences_ = ordered_json::array();
  ordered_json by_machine_;
  std::map<std::string, ordered_json> waiting_;  ///< claims by the model they wait for
};

}  // namespace

ordered_json machine_dependent(const JudgedRun& judged, bool without_varying) {
  ordered_json claims = ordered_json::array();
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements)
      if (expectation_of(judgement) == Expectation::depends_on_machine &&
          !shown_verdict(judgement, without_varying).hidden)
        claims.push_back(claim_brief(judgement, without_varying));
  return claims;
}

ordered_json predictions_document(const JudgedRun& judged, bool without_varying) {
  return PredictionsDocument(judged, without_varying).build();
}

}  // namespace phytobench
