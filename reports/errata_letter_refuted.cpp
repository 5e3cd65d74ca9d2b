// SPDX-License-Identifier: MIT
#include "reports/errata_letter_refuted.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "reports/document_anchors.hpp"
#include "reports/errata_letter_text.hpp"
#include "reports/replace_all.hpp"

namespace phytobench {

namespace {

/// "(text-4.6-badyears)" -> "(sec. 4.6)": other statements by their places.
std::string with_places(std::string text, const JudgedPaper& work) {
  for (const Judgement& other : work.judgements) {
    const std::string id = short_claim_id(other.claim->id);
    std::string with_hyphens = id;
    std::replace(with_hyphens.begin(), with_hyphens.end(), '/', '-');
    for (const std::string& name : {id, with_hyphens})
      if (!name.empty()) replace_all(text, "(" + name + ")", "(" + other.claim->locator + ")");
  }
  return text;
}

/// Without what the suite says of itself: "(The expected verdict was set after a full run.)".
std::string without_remarks(std::string text) {
  const std::size_t from = text.find(" (The expected verdict");
  const std::size_t to = text.find(')', from);
  if (from != std::string::npos && to != std::string::npos) text.erase(from, to + 1 - from);
  return text;
}

/// "9.448 [9.17, 9.692]" -> "9.448 (9.17 to 9.692)". Numbers keep the digits that the judge gave
/// them: with fewer, one that misses its bound might look equal to it.
std::string measured_words(const std::string& measured) {
  double value = 0.0;
  const char* const end = measured.data() + measured.size();
  const auto [rest, error] = std::from_chars(measured.data(), end, value);
  constexpr double smallest_told = 1e-9;
  if (error == std::errc() && rest == end && value != 0.0 && std::abs(value) < smallest_told)
    return fmt::format("practically 0 ({})", measured);
  std::string text = measured;
  if (!text.ends_with(']')) return text;
  replace_all(text, "[", "(");
  replace_all(text, ", ", " to ");
  replace_all(text, "]", ")");
  return text;
}

/// ">= 4 in 3 of 3" -> "at least 4 in 3 of 3 cases".
std::string wanted_words(const std::string& wanted) {
  constexpr std::array<std::array<std::string_view, 2>, 3> words{
      {{">= ", "at least "}, {"<= ", "at most "}, {"= ", "exactly "}}};
  std::string text = wanted;
  for (const auto& [sign, word] : words)
    if (text.starts_with(sign)) {
      text.replace(0, sign.size(), word);
      break;
    }
  return text + (wanted.find(" in ") == std::string::npos ? "" : " cases");
}

/// "Measured in this way: 0.9; needed: at least 1.", for each check that fails.
std::string measured_sentences(const Judgement& judgement) {
  constexpr std::size_t most_values = 3;  // beyond them it is a table of numbers
  std::string text;
  for (const JudgedCheck& check : judgement.checks) {
    if (check.outcome != CheckOutcome::fails) continue;
    std::string values;
    std::size_t failing = 0;
    for (const JudgedTerm& term : check.terms) {
      if (term.outcome != CheckOutcome::fails) continue;
      values += (failing++ == 0 ? "" : ", ") + measured_words(term.measured);
    }
    if (check.terms.size() > most_values)
      text += fmt::format(" Of {} comparisons {} fail{}.", check.terms.size(), failing,
                          failing == 1 ? "s" : "");
    else
      text += fmt::format(" {}: {}; needed: {}.", text.empty() ? "Measured in this way" : "Also",
                          values, wanted_words(check.wanted));
  }
  return text;
}

/// A number that is only derived from print must not be taken for a printed one.
std::string printed_sentence(const std::string& published) {
  constexpr std::string_view derived = "derived";
  if (published.empty() || published == "-") return "";
  if (!published.starts_with(derived)) return " Printed: " + as_sentence(published);
  std::string source = published.substr(derived.size());
  if (source.starts_with(": ")) return " Follows from print: " + as_sentence(source.substr(2));
  return " Follows" + as_sentence(source);
}

}  // namespace

std::string refuted_entry(const Judgement& judgement, const JudgedPaper& work) {
  const Claim& claim = *judgement.claim;
  const std::string machines =
      claim.machine_dependence.empty()
          ? ""
          : " It depends on the machine: " + as_sentence(claim.machine_dependence);
  return fmt::format("- {}: {}{} {}{}{}\n", with_literal_markdown(claim.locator),
                     as_sentence(claim.text), printed_sentence(claim.published),
                     as_sentence(without_remarks(with_places(claim.reason, work))),
                     with_literal_markdown(measured_sentences(judgement)), machines);
}

}  // namespace phytobench
