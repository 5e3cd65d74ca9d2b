// SPDX-License-Identifier: MIT
#include "reports/errata_letter.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "reports/errata_letter_counts.hpp"
#include "reports/errata_letter_strongest.hpp"
#include "reports/errata_letter_text.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

std::string number_text(double value) {
  return fmt::format("{:.7g}", value);
}

/// "radius r_i = 3; radius r_j = 5".
std::string inputs_of(const CounterExample& example) {
  std::string text;
  for (std::size_t i = 0; i < example.arguments.size(); ++i) {
    if (i > 0) text += "; ";
    if (!example.inputs.empty()) text += example.inputs[i] + " = ";
    text += fmt::format("{}", example.arguments[i]);
  }
  return text;
}

bool is_of_program(const Erratum& erratum) {
  return erratum.kind == ErratumKind::program;
}

/// How sure an entry is, for a reader who does not know what is meant by the word.
std::string confidence_of(const Erratum& erratum) {
  if (erratum.confidence == "certain") return "certain";
  if (is_of_program(erratum)) return "probable: the text may be meant less strictly";
  return "probable: something seems wrong here, and the correction is our inference";
}

/// One letter, part after part.
class Letter {
 public:
  Letter(const JudgedPaper& judged, bool without_varying)
      : judged_(judged), without_varying_(without_varying), strongest_(strongest_errata(judged)) {
    for (const Judgement& judgement : judged.judgements)
      judgements_[judgement.claim->id] = &judgement;
  }

  std::string text() {
    add_head();
    add_strongest();
    out_ += "## Where the text contradicts itself or leaves a case out\n\n";
    add_errata(false);
    add_differences_from_program();
    add_questions();
    out_ += confirmed_part(judged_, without_varying_);
    return out_;
  }

 private:
  void add_head() {
    const Paper& paper = judged_.paper;
    const auto of_program =
        std::count_if(judged_.errata.begin(), judged_.errata.end(), is_of_program);
    const auto certain = std::count_if(
        judged_.errata.begin(), judged_.errata.end(),
        [](const Erratum& e) { return e.confidence == "certain" && !is_of_program(e); });
    out_ += fmt::format("# Notes on \"{}\"\n\n", with_literal_markdown(paper.title));
    out_ += fmt::format("{}, {}, {}.\n\n", with_literal_markdown(paper.author), paper.year,
                        with_literal_markdown(paper.kind));
    out_ += fmt::format(
        "The models of this work were built again from its text, and its statements were tested "
        "one by one. These notes say where the text contradicts itself or leaves a case out ({}, "
        "of which {} are certain),{} where it can be read in more than one way ({}), and what was "
        "confirmed. They use the numbering of the work, name its statements in other words than "
        "its own, and can be read and checked without the software that they come from. In "
        "formulas x^2 is a power, sqrt a root, |x| a length or an absolute value, and Greek "
        "letters are written out.\n\n",
        std::ssize(judged_.errata) - of_program, certain,
        of_program == 0
            ? ""
            : fmt::format(" where it differs from the published program ({}),", of_program),
        judged_.assumptions.size());
  }

  void add_strongest() {
    if (strongest_.empty()) return;
    out_ +=
        "## Those that weigh most\n\nChosen by a rule: certain before probable; with a worked "
        "example before without; a formula or a number before a case left out, and that before "
        "wording and labels; then by how many statements they concern; then in the order of the "
        "work.\n\n";
    for (std::size_t i = 0; i < strongest_.size(); ++i) {
      const Erratum& erratum = *strongest_[i];
      out_ += fmt::format("{}. [{}](#{}), {}. Printed: {} Corrected: {} {}\n", i + 1, erratum.id,
                          anchor_of(erratum), place_of(erratum), as_sentence(erratum.printed),
                          as_sentence(erratum.corrected),
                          as_sentence(first_sentence(erratum.consequence)));
    }
    out_ += '\n';
  }

  static std::string anchor_of(const Erratum& erratum) { return "erratum-" + erratum.id; }

  /// Those of the program, or all others, in the order of the work.
  void add_errata(bool of_program) {
    std::vector<const Erratum*> in_order;
    for (const Erratum& erratum : judged_.errata)
      if (is_of_program(erratum) == of_program) in_order.push_back(&erratum);
    if (in_order.empty()) out_ += "Nothing was found.\n\n";
    std::stable_sort(in_order.begin(), in_order.end(), [](const Erratum* a, const Erratum* b) {
      return section_is_before(a->section, b->section);
    });
    for (const Erratum* erratum : in_order) add_erratum(*erratum);
  }

  void add_differences_from_program() {
    if (std::none_of(judged_.errata.begin(), judged_.errata.end(), is_of_program)) return;
    out_ +=
        "## Where the text differs from the published program\n\nThese places are sound as "
        "printed, but the plants of the work are grown otherwise: with the parameters that its "
        "author published they come out, count for count, only as told here.\n\n";
    add_errata(true);
  }

  void add_erratum(const Erratum& erratum) {
    if (std::find(strongest_.begin(), strongest_.end(), &erratum) != strongest_.end())
      out_ += fmt::format("<a id=\"{}\"></a>\n\n", anchor_of(erratum));
    out_ += fmt::format("### {}: {}\n\n", erratum.id, place_of(erratum));
    add_point("Printed", with_literal_markdown(erratum.printed));
    add_point(is_of_program(erratum) ? "In the program" : "Corrected",
              with_literal_markdown(erratum.corrected));
    if (erratum.counter_example)
      add_example(*erratum.counter_example,
                  is_of_program(erratum) ? "in the program" : "corrected");
    add_point("What follows", as_sentence(erratum.consequence));
    if (const std::string verdicts = verdicts_of(erratum); !verdicts.empty())
      add_point("Claims that it concerns", verdicts);
    if (!erratum.check.empty()) add_point("To check it", as_sentence(erratum.check));
    if (erratum.kind) add_point("Kind", name_of(*erratum.kind));
    add_point("Confidence", confidence_of(erratum));
    out_ += '\n';
  }

  /// The locator, with the section where it does not say it.
  std::string place_of(const Erratum& erratum) const {
    std::string place = with_literal_markdown(erratum.locator);
    const bool has_chapter = !erratum.section.empty() &&
                             std::isdigit(static_cast<unsigned char>(erratum.section.front()));
    const bool names_place = erratum.locator.find("sec. ") != std::string::npos ||
                             erratum.locator.find("section ") != std::string::npos ||
                             erratum.locator.find("chapter") != std::string::npos;
    if (has_chapter && !names_place) place += " (section " + erratum.section + ")";
    return place;
  }

  void add_example(const CounterExample& example, const char* other_form) {
    const std::string printed =
        example.printed ? number_text(*example.printed) : std::string("no value");
    const std::string result = example.result.empty() ? "result" : example.result;
    add_point("Example",
              with_literal_markdown(fmt::format("{}. Sought: {}.", inputs_of(example), result)) +
                  fmt::format(" As printed: **{}**; {}: **{}**. ", printed, other_form,
                              number_text(example.corrected)) +
                  as_sentence(example.why));
  }

  /// The named claims with their verdicts, one a line; of a long list the first ones.
  std::string verdicts_of(const Erratum& erratum) const {
    constexpr std::size_t most_listed = 6;
    std::vector<std::string> lines;
    for (const std::string& id : erratum.claims)
      if (const auto found = judgements_.find(id); found != judgements_.end())
        lines.push_back(verdict_line(erratum, *found->second));
    std::string text;
    for (std::size_t i = 0; i < lines.size() && i < most_listed; ++i) text += lines[i];
    if (lines.size() > most_listed)
      text += fmt::format("\n  - and {} more", lines.size() - most_listed);
    return text;
  }

  std::string verdict_line(const Erratum& erratum, const Judgement& judgement) const {
    const Claim& claim = *judgement.claim;
    std::string verdict = plain_verdict(judgement, without_varying_);
    const bool is_left_out = without_varying_ && judgement.varies;
    if (is_of_program(erratum) && judgement.verdict == Verdict::reproduced_with_erratum &&
        !is_left_out)
      verdict = "holds for the program";
    return fmt::format("\n  - {} *({})*", as_sentence(claim.locator + ": " + claim.text), verdict);
  }

  void add_questions() {
    out_ += "## Where the text can be read in more than one way\n\n";
    if (judged_.assumptions.empty()) out_ += "Nothing was assumed.\n\n";
    for (const Assumption& assumption : judged_.assumptions) {
      out_ +=
          fmt::format("### {}: {}\n\n", assumption.id, with_literal_markdown(assumption.locator));
      add_point("Question", as_sentence(assumption.question));
      add_point("Our reading", as_sentence(assumption.reading));
      add_point("Otherwise", as_sentence(assumption.alternatives));
      if (const std::string rests = outcome_counts(assumption.claims); !rests.empty())
        add_point("Statements that rest on it", rests);
      out_ += '\n';
    }
  }

  /// "4 hold under our reading of a question above, 1 does not hold".
  std::string outcome_counts(const std::vector<std::string>& claims) const {
    std::vector<const Judgement*> named;
    for (const std::string& id : claims)
      if (const auto found = judgements_.find(id); found != judgements_.end())
        named.push_back(found->second);
    std::string text;
    for (const std::string& count : verdict_counts(named, without_varying_))
      text += (text.empty() ? "" : ", ") + count;
    return text;
  }

  void add_point(const char* name, const std::string& text) {
    out_ += fmt::format("- **{}:**{}{}\n", name, text.starts_with('\n') ? "" : " ", text);
  }

  const JudgedPaper& judged_;
  bool without_varying_;
  std::vector<const Erratum*> strongest_;
  std::map<std::string, const Judgement*> judgements_;
  std::string out_;
};

}  // namespace

std::string errata_letter(const JudgedPaper& judged, bool without_varying) {
  return Letter(judged, without_varying).text();
}

}  // namespace phytobench
