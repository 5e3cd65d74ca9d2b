// SPDX-License-Identifier: MIT
#include "reports/document.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "build_information.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

constexpr const char* left_out = "left out: rests on times";
constexpr const char* bases[] = {"paper", "author-published", "assumed", "fitted"};

/// A word usable as a CSS class and file name part.
std::string slug(std::string text) {
  for (char& c : text)
    if (c == ' ' || c == '/' || c == '.') c = '-';
  return text;
}

std::string with_thousands(double value) {
  std::string digits = fmt::format("{:.0f}", value);
  for (std::size_t place = digits.size(); place > 3;) {
    place -= 3;
    digits.insert(place, ",");
  }
  return digits;
}

std::string outcome_word(CheckOutcome outcome) {
  switch (outcome) {
    case CheckOutcome::holds: return "holds";
    case CheckOutcome::fails: return "fails";
    case CheckOutcome::undecided: return "undecided";
    case CheckOutcome::missing: return "not measured";
  }
  return "";
}

/// Builds the document part by part.
class DocumentBuilder {
 public:
  DocumentBuilder(const JudgedRun& judged, const DocumentSources& sources)
      : judged_(judged), sources_(sources), environment_(ordered_json::parse(sources.environment_json)) {}

  ordered_json build() {
    ordered_json document;
    document["run"] = run_part();
    document["counts"] = counts_part();
    document["bases"] = ordered_json(bases);
    document["attention"] = attention_part();
    document["has_attention"] = !document["attention"].empty();
    for (const JudgedPaper& paper : judged_.papers) document["papers"].push_back(paper_part(paper));
    document["environment"] = environment_part();
    document["has_environment"] = !document["environment"].empty();
    document["repeat"] = repeat_part();
    document["unclaimed"] = unclaimed_part();
    return document;
  }

 private:
  bool hidden(const Judgement& judgement) const { return sources_.without_varying && judgement.varies; }

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
    for_each_judgement([&](const Judgement& judgement) {
      ++claims;
      if (hidden(judgement)) {
        ++hidden_claims;
        return;
      }
      reproduced += judgement.verdict == Verdict::reproduced;
      errata += judgement.verdict == Verdict::reproduced_with_erratum;
      refuted += judgement.verdict == Verdict::not_reproduced;
    });
    decided = reproduced + errata + refuted;
    part["claims"] = claims;
    part["decided"] = decided;
    part["reproduced"] = reproduced;
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

  template <class Use>
  void for_each_judgement(const Use& use) const {
    for (const JudgedPaper& paper : judged_.papers)
      for (const Judgement& judgement : paper.judgements) use(judgement);
  }

  /// Verdicts by basis.
  ordered_json counts_part() const {
    ordered_json rows = ordered_json::array();
    for (const Verdict verdict : all_verdicts) {
      ordered_json row;
      row["verdict"] = name_of(verdict);
      row["class"] = slug(std::string(name_of(verdict)));
      std::size_t total = 0;
      std::map<std::string, std::size_t> by_basis;
      for_each_judgement([&](const Judgement& judgement) {
        if (judgement.verdict != verdict || hidden(judgement)) return;
        ++total;
        ++by_basis[judgement.claim->basis];
      });
      row["total"] = total;
      for (const char* basis : bases) row["by_basis"].push_back({{"count", by_basis[basis]}});
      rows.push_back(row);
    }
    return rows;
  }

  /// What a reader should see first: refuted, undecided and unexpected verdicts.
  ordered_json attention_part() const {
    ordered_json rows = ordered_json::array();
    for_each_judgement([&](const Judgement& judgement) {
      const bool open = judgement.verdict == Verdict::not_reproduced ||
                        judgement.verdict == Verdict::inconclusive || judgement.is_unexpected();
      if (open && !hidden(judgement)) rows.push_back(claim_part(judgement));
    });
    return rows;
  }

  ordered_json claim_part(const Judgement& judgement) const {
    const Claim& claim = *judgement.claim;
    const bool is_hidden = hidden(judgement);
    ordered_json part;
    part["id"] = claim.id;
    part["anchor"] = slug(claim.id);
    part["locator"] = claim.locator;
    part["kind"] = claim.kind;
    part["text"] = claim.text;
    part["published"] = claim.published;
    part["unit"] = claim.unit == "1" ? "" : claim.unit;
    part["basis"] = claim.basis;
    part["erratum"] = claim.erratum;
    part["has_erratum"] = !claim.erratum.empty();
    part["varies"] = judgement.varies;
    part["verdict"] = is_hidden ? left_out : name_of(judgement.verdict);
    part["class"] = is_hidden ? "not-measured" : slug(std::string(name_of(judgement.verdict)));
    part["measured"] = is_hidden ? left_out : judgement.measured;
    part["reason"] = judgement.reason;
    part["unexpected"] = !is_hidden && judgement.is_unexpected();
    part["expected"] = name_of(claim.expected_verdict);
    part["repeat"] = fmt::format("phytobench run {} --tier {} --out results", experiment_of(claim), name_of(claim.tier));
    part["has_repeat"] = !claim.checks.empty();
    part["checks"] = ordered_json::array();
    if (is_hidden) return part;
    for (const JudgedCheck& check : judgement.checks) {
      ordered_json row{{"wanted", check.wanted}, {"why", check.why}, {"outcome", outcome_word(check.outcome)}};
      for (const JudgedTerm& term : check.terms)
        row["terms"].push_back({{"expression", term.expression},
                                {"measured", term.measured},
                                {"outcome", outcome_word(term.outcome)}});
      part["checks"].push_back(row);
    }
    return part;
  }

  /// The experiments whose measurements a claim is judged on.
  static std::string experiment_of(const Claim& claim) {
    std::vector<std::string> experiments;
    for (const ClaimCheck& check : claim.checks)
      for (const auto& term : check.terms)
        for (const std::string& part : term) {
          const std::size_t start = part[0] == '+' || part[0] == '-' ? 1 : 0;
          const std::size_t second = part.find('/', part.find('/') + 1);
          const std::string id = part.substr(start, second - start);
          if (std::find(experiments.begin(), experiments.end(), id) == experiments.end()) experiments.push_back(id);
        }
    return fmt::format("{}", fmt::join(experiments, " "));
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
    for (const JudgedTable& table : judged.tables) part["tables"].push_back(table_part(table));
    part["pictures"] = ordered_json::array();
    for (const auto& [name, svg] : sources_.pictures)
      if (name.starts_with(judged.paper.key + "/")) part["pictures"].push_back({{"name", name}, {"svg", svg}});
    part["claims"] = ordered_json::array();
    for (const Judgement& judgement : judged.judgements) part["claims"].push_back(claim_part(judgement));
    part["errata"] = ordered_json::array();
    for (const Erratum& erratum : judged.errata) part["errata"].push_back(erratum_part(erratum));
    return part;
  }

  ordered_json table_part(const JudgedTable& judged) const {
    const PublishedTable& table = *judged.table;
    ordered_json part;
    part["id"] = table.id;
    part["title"] = table.title;
    part["unit"] = table.unit;
    part["note"] = table.note;
    part["discussion"] = table.discussion;
    part["columns"] = table.column_labels;
    part["timed"] = judged.timed;
    const bool visible = judged.measured && !(judged.timed && sources_.without_varying);
    part["measured"] = visible;
    part["not_measured"] = !visible;
    part["grids"] = ordered_json::array();
    add_grid(part, table, judged.timed ? "Published" : "Expected", "as printed", false,
             [&](auto row, auto column) { return shown(table.values[row][column]); });
    if (visible) {
      add_grid(part, table, "Measured", judged.timed ? "median of all rounds and its 95 % interval" : "", judged.timed,
               [&](auto row, auto column) { return estimate_text(judged.values[row][column], judged.timed); });
    }
    if (judged.timed && visible) {
      add_grid(part, table, "Published, relative", "share of the slowest published cell", false,
               [&](auto row, auto column) { return fmt::format("{:.3f}", judged.published_share[row][column]); });
      add_grid(part, table, "Measured, relative", "share of the slowest measured cell, paired by round", true,
               [&](auto row, auto column) {
                 const Estimate& share = judged.share[row][column];
                 return fmt::format("{:.3f} [{:.3f}, {:.3f}]", share.value, share.low, share.high);
               });
    }
    for (const JudgedCompanion& companion : judged.companions) {
      if (companion.timed && sources_.without_varying) continue;
      std::string name = companion.name;
      std::replace(name.begin(), name.end(), '_', ' ');
      name[0] = static_cast<char>(std::toupper(name[0]));
      add_grid(part, table, name, companion.timed ? "median, seconds" : "exact count", companion.timed,
               [&](auto row, auto column) {
                 const Estimate& value = companion.values[row][column];
                 return companion.timed ? fmt::format("{:.4g}", value.value) : with_thousands(value.value);
               });
    }
    return part;
  }

  static std::string estimate_text(const Estimate& estimate, bool timed) {
    if (!timed) return shown(estimate.value);
    return fmt::format("{:.4f} [{:.4f}, {:.4f}]", estimate.value, estimate.low, estimate.high);
  }

  template <class Text>
  static void add_grid(ordered_json& part, const PublishedTable& table, const std::string& title,
                       const std::string& note, bool varies, const Text& text) {
    ordered_json grid{{"title", title}, {"note", note}, {"varies", varies}, {"columns", table.column_labels}};
    for (std::size_t row = 0; row < table.rows.size(); ++row) {
      ordered_json cells = ordered_json::array();
      for (std::size_t column = 0; column < table.columns.size(); ++column) cells.push_back(text(row, column));
      grid["rows"].push_back({{"label", table.row_labels[row]}, {"cells", cells}});
    }
    part["grids"].push_back(grid);
  }

  static ordered_json erratum_part(const Erratum& erratum) {
    ordered_json part{{"id", erratum.id},           {"locator", erratum.locator},
                      {"printed", erratum.printed}, {"corrected", erratum.corrected},
                      {"consequence", erratum.consequence}, {"confidence", erratum.confidence},
                      {"has_example", erratum.counter_example.has_value()}};
    if (!erratum.counter_example) return part;
    const CounterExample& example = *erratum.counter_example;
    part["example"] = fmt::format("{}({}): printed form {}, corrected form {}", example.oracle,
                                  fmt::join(example.arguments, ", "),
                                  example.printed ? shown(*example.printed) : "undefined", shown(example.corrected));
    return part;
  }

  ordered_json environment_part() const {
    ordered_json rows = ordered_json::array();
    if (sources_.without_varying) return rows;
    for (const auto& [key, value] : environment_.items()) {
      if (key == "schema") continue;
      if (value.is_object())
        for (const auto& [inner, inner_value] : value.items()) add_fact(rows, key + ": " + inner, inner_value);
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
      for (const ordered_json& element : value) text += (text.empty() ? "" : ", ") + element.get<std::string>();
    }
    rows.push_back({{"name", name}, {"value", text}});
  }

  ordered_json repeat_part() const {
    const RunHeader& header = judged_.run.header;
    return {{"run", fmt::format("phytobench run --tier {} --seed {} --out results", name_of(header.tier), header.seed)},
            {"report", "phytobench report results"}};
  }

  /// Measurements that no claim mentions.
  std::size_t unclaimed_part() const {
    std::map<std::string, bool> mentioned;
    for_each_judgement([&](const Judgement& judgement) {
      for (const ClaimCheck& check : judgement.claim->checks)
        for (const auto& term : check.terms)
          for (const std::string& part : term)
            mentioned[check.subject == CheckSubject::sum ? part.substr(1) : part] = true;
    });
    return static_cast<std::size_t>(
        std::count_if(judged_.run.records.begin(), judged_.run.records.end(),
                      [&](const Record& record) { return !mentioned.contains(record.measurement); }));
  }

  const JudgedRun& judged_;
  const DocumentSources& sources_;
  ordered_json environment_;
};

}  // namespace

ordered_json make_document(const JudgedRun& judged, const DocumentSources& sources) {
  return DocumentBuilder(judged, sources).build();
}

}  // namespace phytobench
