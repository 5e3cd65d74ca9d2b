// SPDX-License-Identifier: MIT
#include "reports/document_papers.hpp"

#include <vector>

#include <nlohmann/json.hpp>

#include "reports/document_anchors.hpp"
#include "reports/document_claims.hpp"
#include "reports/document_errata.hpp"
#include "reports/document_errata_kinds.hpp"
#include "reports/document_places.hpp"
#include "reports/document_tables.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

/// How often each verdict occurs, for the line below a heading.
ordered_json tally_of(const std::vector<const Judgement*>& judgements, bool without_varying) {
  std::map<std::string, std::size_t> counts;
  for (const Judgement* judgement : judgements)
    ++counts[shown_verdict(*judgement, without_varying).label];
  ordered_json tally = ordered_json::array();
  const auto add = [&](const std::string& label, const std::string& look) {
    if (const auto count = counts.find(label); count != counts.end())
      tally.push_back({{"label", label}, {"class", look}, {"count", count->second}});
  };
  for (const VerdictRow& row : verdict_rows()) add(std::string(row.name), row_class(row));
  add(left_out_row, left_out_class);
  return tally;
}

class PaperDocument {
 public:
  PaperDocument(const JudgedPaper& judged, const PaperSources& sources)
      : judged_(judged),
        sources_(sources),
        key_(judged.paper.key),
        index_(judged.judgements, sources.without_varying),
        context_{
            sources.evidence, sources.costs, sources.without_varying, sources.run.header.seed, {}} {
    for (const Assumption& assumption : judged.assumptions)
      for (const std::string& claim : assumption.claims)
        context_.assumptions[claim].push_back(assumption.id);
  }

  ordered_json build() {
    add_header();
    document_["places"] = index_.document();
    document_["has_places"] = !document_["places"].empty();
    document_["tables"] = ordered_json::array();
    for (const JudgedTable& table : judged_.tables)
      document_["tables"].push_back(table_document(table, index_, sources_.without_varying));
    document_["has_tables"] = !document_["tables"].empty();
    document_["pictures"] = figures_of(key_, sources_.figures, index_);
    document_["has_pictures"] = !document_["pictures"].empty();
    document_["gallery"] = photographs_of(key_, sources_.photographs, index_);
    document_["gallery_note"] = judged_.paper.pictures;
    document_["has_gallery"] = !document_["gallery"].empty();
    document_["topics"] = topics();
    document_["errata"] = errata_document(judged_);
    document_["has_errata"] = !document_["errata"].empty();
    document_["errata_kinds"] = errata_kinds_document(judged_, sources_.without_varying);
    document_["has_errata_kinds"] = !document_["errata_kinds"].empty();
    document_["assumptions"] = assumptions_document(judged_);
    document_["has_assumptions"] = !document_["assumptions"].empty();
    return document_;
  }

 private:
  void add_header() {
    document_["key"] = key_;
    document_["title"] = judged_.paper.title;
    document_["author"] = judged_.paper.author;
    document_["year"] = judged_.paper.year;
    document_["kind"] = judged_.paper.kind;
    document_["summary"] = judged_.paper.summary;
    document_["in_run"] = is_in_run(sources_.run, key_);
    document_["claim_count"] = judged_.judgements.size();
    std::vector<const Judgement*> all;
    for (const Judgement& judgement : judged_.judgements) all.push_back(&judgement);
    document_["tally"] = tally_of(all, sources_.without_varying);
  }

  /// Claims under their topics, both in the order of the files.
  ordered_json topics() const {
    std::vector<std::string> order;
    std::map<std::string, std::vector<const Judgement*>> by_topic;
    for (const Judgement& judgement : judged_.judgements) {
      const std::string& topic = judgement.claim->topic;
      if (!by_topic.contains(topic)) order.push_back(topic);
      by_topic[topic].push_back(&judgement);
    }
    ordered_json topics = ordered_json::array();
    for (const std::string& topic : order) topics.push_back(topic_part(topic, by_topic[topic]));
    return topics;
  }

  ordered_json topic_part(const std::string& topic,
                          const std::vector<const Judgement*>& judgements) const {
    const std::string title = topic.empty() ? "Claims" : topic;
    ordered_json part{{"title", title},
                      {"anchor", topic_anchor(key_, title)},
                      {"claim_count", judgements.size()},
                      {"tally", tally_of(judgements, sources_.without_varying)},
                      {"claims", ordered_json::array()}};
    for (const Judgement* judgement : judgements)
      part["claims"].push_back(claim_document(*judgement, context_));
    return part;
  }

  const JudgedPaper& judged_;
  const PaperSources& sources_;
  const std::string& key_;
  ClaimIndex index_;
  ClaimContext context_;
  ordered_json document_;
};

}  // namespace

bool is_in_run(const RunContents& run, const std::string& paper) {
  const auto first = run.complete_experiments.lower_bound(paper + "/");
  return first != run.complete_experiments.end() && first->starts_with(paper + "/");
}

ordered_json paper_document(const JudgedPaper& judged, const PaperSources& sources) {
  return PaperDocument(judged, sources).build();
}

}  // namespace phytobench
