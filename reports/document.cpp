// SPDX-License-Identifier: MIT
#include "reports/document.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "build_information.hpp"
#include "reports/base64.hpp"
#include "reports/document_claims.hpp"
#include "reports/document_scaling.hpp"
#include "reports/document_tables.hpp"
#include "reports/repeat_commands.hpp"
#include "reports/run_figures.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

constexpr const char* bases[] = {"paper", "author-published", "assumed", "fitted"};

/// Builds the document part by part.
class DocumentBuilder {
 public:
  DocumentBuilder(const JudgedRun& judged, const DocumentSources& sources)
      : judged_(judged),
        sources_(sources),
        environment_(ordered_json::parse(sources.environment_json)) {}

  ordered_json build() {
    ordered_json document;
    document["run"] = run_part();
    document["counts"] = counts_part();
    document["bases"] = ordered_json(bases);
    document["attention"] = attention_part();
    document["has_attention"] = !document["attention"].empty();
    for (const bool in_run : {true, false})
      for (const JudgedPaper& paper : judged_.papers)
        if (has_run(paper.paper.key) == in_run) document["papers"].push_back(paper_part(paper));
    document["has_studies"] = judged_.scaling.measured();
    document["studies"] = ordered_json::array();
    if (judged_.scaling.measured())
      document["studies"].push_back(
          scaling_document(judged_.scaling, sources_.plots, sources_.without_varying));
    document["environment"] = environment_part();
    document["has_environment"] = !document["environment"].empty();
    document["repeat"] = repeat_part();
    document["unclaimed"] = unclaimed_part();
    return document;
  }

 private:
  bool hidden(const Judgement& judgement) const {
    return sources_.without_varying && judgement.varies;
  }

  ordered_json run_part() const {
    const RunHeader& header = judged_.run.header;
    ordered_json part;
    part["tier"] = name_of(header.tier);
    part["seed"] = header.seed;
    part["experiments"] = judged_.run.complete_experiments.size();
    part["measurements"] = judged_.run.records.size();
    part["timings"] = sources_.without_varying ? 0 : judged_.run.timings.size();
    part["version"] = build_information::version;
    std::size_t claims = 0, decided = 0, reproduced = 0, errata = 0, refuted = 0, hidden_claims = 0;
    std::size_t measured = 0, fitted = 0;
    for_each_judgement([&](const Judgement& judgement) {
      ++claims;
      measured += has_measurement(judgement);
      if (hidden(judgement)) {
        ++hidden_claims;
        return;
      }
      fitted += is_fitted(judgement);
      reproduced += judgement.verdict == Verdict::reproduced && !is_fitted(judgement);
      errata += judgement.verdict == Verdict::reproduced_with_erratum;
      refuted += judgement.verdict == Verdict::not_reproduced;
    });
    decided = reproduced + fitted + errata + refuted;
    part["claims"] = claims;
    part["measured_claims"] = measured;
    part["decided"] = decided;
    part["reproduced"] = reproduced;
    part["fitted"] = fitted;
    part["has_fitted"] = fitted > 0;
    part["errata"] = errata;
    part["refuted"] = refuted;
    part["open"] = claims - decided - hidden_claims;
    part["hidden"] = hidden_claims;
    part["has_hidden"] = hidden_claims > 0;
    part["has_varying"] = !sources_.without_varying;
    if (!sources_.without_varying) {
      part["date"] = environment_.value("date_utc", "unknown");
      part["commit"] = environment_.value("commit", "unknown");
      part["source_changed"] = environment_.value("source_changed", false);
    }
    return part;
  }

  /// Whether any experiment of that work is in this run.
  bool has_run(const std::string& paper) const {
    const auto& experiments = judged_.run.complete_experiments;
    const auto first = experiments.lower_bound(paper + "/");
    return first != experiments.end() && first->starts_with(paper + "/");
  }

  template <class Use>
  void for_each_judgement(const Use& use) const {
    for (const JudgedPaper& paper : judged_.papers)
      for (const Judgement& judgement : paper.judgements) use(judgement);
  }

  /// Verdicts by basis.
  ordered_json counts_part() const {
    ordered_json rows = ordered_json::array();
    const auto add_row = [&](const std::string& name, Verdict verdict, const auto& belongs) {
      ordered_json row{{"verdict", name}, {"class", verdict_class(verdict)}};
      std::size_t total = 0;
      std::map<std::string, std::size_t> by_basis;
      for_each_judgement([&](const Judgement& judgement) {
        if (hidden(judgement) || judgement.verdict != verdict || !belongs(judgement)) return;
        ++total;
        ++by_basis[judgement.claim->basis];
      });
      row["total"] = total;
      for (const char* basis : bases) row["by_basis"].push_back({{"count", by_basis[basis]}});
      rows.push_back(row);
    };
    const auto has_checks = [](const Judgement& judgement) {
      return judgement.claim->fixed_verdict != Verdict::not_measured;
    };
    for (const Verdict verdict : all_verdicts) {
      add_row(std::string(name_of(verdict)), verdict, [&](const Judgement& judgement) {
        return has_checks(judgement) && !is_fitted(judgement);
      });
      if (verdict == Verdict::reproduced) add_row(fitted_row, verdict, is_fitted);
    }
    add_row("not measured: no check, with a reason", Verdict::not_measured,
            [&](const Judgement& judgement) { return !has_checks(judgement); });
    return rows;
  }

  /// What a reader should see first: refuted, undecided and unexpected verdicts.
  ordered_json attention_part() const {
    ordered_json rows = ordered_json::array();
    for_each_judgement([&](const Judgement& judgement) {
      const bool open = judgement.verdict == Verdict::not_reproduced ||
                        judgement.verdict == Verdict::inconclusive || judgement.is_unexpected();
      if (open && !hidden(judgement)) rows.push_back(claim_document(judgement, false));
    });
    return rows;
  }

  ordered_json paper_part(const JudgedPaper& judged) const {
    ordered_json part;
    part["key"] = judged.paper.key;
    part["title"] = judged.paper.title;
    part["author"] = judged.paper.author;
    part["year"] = judged.paper.year;
    part["kind"] = judged.paper.kind;
    part["summary"] = judged.paper.summary;
    part["tables"] = ordered_json::array();
    for (const JudgedTable& table : judged.tables)
      part["tables"].push_back(table_document(table, sources_.without_varying));
    part["in_run"] = has_run(judged.paper.key);
    part["pictures"] = figures_of(judged.paper.key, sources_.pictures);
    part["has_pictures"] = !part["pictures"].empty();
    part["gallery"] = gallery_part(judged.paper.key);
    part["has_gallery"] = !part["gallery"].empty();
    part["claims"] = ordered_json::array();
    for (const Judgement& judgement : judged.judgements)
      part["claims"].push_back(claim_document(judgement, hidden(judgement)));
    part["errata"] = ordered_json::array();
    for (const Erratum& erratum : judged.errata) part["errata"].push_back(erratum_part(erratum));
    return part;
  }

  /// Pictures of a paper's figures, inside the page.
  ordered_json gallery_part(const std::string& paper) const {
    ordered_json gallery = ordered_json::array();
    for (const auto& [name, bytes] : sources_.photographs) {
      if (!name.starts_with(paper + "/")) continue;
      std::string label = std::filesystem::path(name).stem().string();
      std::replace(label.begin(), label.end(), '-', ' ');
      label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
      gallery.push_back({{"label", label},
                         {"file", figure_file(name)},
                         {"source", "data:image/jpeg;base64," + to_base64(bytes)}});
    }
    return gallery;
  }

  static ordered_json erratum_part(const Erratum& erratum) {
    ordered_json part{{"id", erratum.id},
                      {"locator", erratum.locator},
                      {"printed", erratum.printed},
                      {"corrected", erratum.corrected},
                      {"consequence", erratum.consequence},
                      {"confidence", erratum.confidence},
                      {"has_example", erratum.counter_example.has_value()}};
    if (!erratum.counter_example) return part;
    const CounterExample& example = *erratum.counter_example;
    part["example"] = fmt::format("{}({}): printed form {}, corrected form {}", example.oracle,
                                  fmt::join(example.arguments, ", "),
                                  example.printed ? shown(*example.printed) : "undefined",
                                  shown(example.corrected));
    return part;
  }

  ordered_json environment_part() const {
    ordered_json rows = ordered_json::array();
    if (sources_.without_varying) return rows;
    for (const auto& [key, value] : environment_.items()) {
      if (key == "schema") continue;
      if (value.is_object())
        for (const auto& [inner, inner_value] : value.items())
          add_fact(rows, key + ": " + inner, inner_value);
      else
        add_fact(rows, key, value);
    }
    return rows;
  }

  static void add_fact(ordered_json& rows, std::string name, const ordered_json& value) {
    std::replace(name.begin(), name.end(), '_', ' ');
    std::string text = value.is_string() ? value.get<std::string>() : value.dump();
    if (value.is_array()) {
      text.clear();
      for (const ordered_json& element : value)
        text += (text.empty() ? "" : ", ") + element.get<std::string>();
    }
    rows.push_back({{"name", name}, {"value", text}});
  }

  ordered_json repeat_part() const {
    const RunHeader& header = judged_.run.header;
    const auto selection = selection_of(environment_.value("command_line", ""));
    return {{"run", repeat_run(selection, header.tier, header.seed)},
            {"report", "phytobench report results/again"}};
  }

  /// Measurements that no claim mentions.
  std::size_t unclaimed_part() const {
    std::set<std::string> mentioned, prefixes;
    for_each_judgement([&](const Judgement& judgement) {
      for (const ClaimCheck& check : judgement.claim->checks)
        for (const auto& term : check.terms)
          for (const std::string& part : term)
            (check.subject == CheckSubject::matches ? prefixes : mentioned)
                .insert(check.subject == CheckSubject::sum ? part.substr(1) : part);
    });
    const auto backs_a_claim = [&](const std::string& measurement) {
      return mentioned.contains(measurement) ||
             std::any_of(prefixes.begin(), prefixes.end(), [&](const std::string& prefix) {
               return measurement.starts_with(prefix);
             });
    };
    return static_cast<std::size_t>(
        std::count_if(judged_.run.records.begin(), judged_.run.records.end(),
                      [&](const Record& record) { return !backs_a_claim(record.measurement); }));
  }

  const JudgedRun& judged_;
  const DocumentSources& sources_;
  ordered_json environment_;
};

}  // namespace

ordered_json make_document(const JudgedRun& judged, const DocumentSources& sources) {
  return DocumentBuilder(judged, sources).build();
}

std::string figure_file(const std::string& artifact) {
  return "figures/" + std::filesystem::path(artifact).filename().string();
}

}  // namespace phytobench
