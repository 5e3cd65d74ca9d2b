// SPDX-License-Identifier: MIT
#include "reports/junit_xml.hpp"

#include <fmt/format.h>

#include "reports/document_anchors.hpp"
#include "reports/expectation.hpp"
#include "reports/judge/run_comparison.hpp"

namespace phytobench {

namespace {

/// Text of an attribute or element. XML has no way to write other control characters.
std::string escaped(const std::string& text) {
  std::string xml;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '&')
      xml += "&amp;";
    else if (c == '<')
      xml += "&lt;";
    else if (c == '>')
      xml += "&gt;";
    else if (c == '"')
      xml += "&quot;";
    else if (c == '\n' || c == '\t' || c == '\r')
      xml += fmt::format("&#{};", byte);
    else
      xml += byte < 0x20 ? '?' : c;
  }
  return xml;
}

std::string property(const std::string& name, std::string_view value) {
  return fmt::format("        <property name=\"{}\" value=\"{}\"/>\n", name,
                     escaped(std::string(value)));
}

std::string properties_of(const Judgement& judgement, bool hidden) {
  const Claim& claim = *judgement.claim;
  std::string xml = "      <properties>\n";
  if (!hidden) xml += property("verdict", name_of(judgement.verdict));
  xml += property("basis", claim.basis);
  xml += property("expected", name_of(claim.expected_verdict));
  if (!hidden) xml += property("expectation", name_of(expectation_of(judgement)));
  if (claim.predicted_verdict) xml += property("predicted", name_of(*claim.predicted_verdict));
  xml += property("locator", claim.locator);
  xml += property("published", claim.published);
  if (!hidden) xml += property("measured", judgement.measured);
  return xml + "      </properties>\n";
}

enum class Outcome { passed, failed, skipped };

Outcome outcome_of(const Judgement& judgement, bool hidden) {
  if (hidden) return Outcome::skipped;
  if (judgement.is_unexpected()) return Outcome::failed;
  return is_decided(judgement.verdict) ? Outcome::passed : Outcome::skipped;
}

std::string failure_of(const Judgement& judgement) {
  const Claim& claim = *judgement.claim;
  const std::string message =
      fmt::format("{}, expected {}", name_of(judgement.verdict), name_of(claim.expected_verdict));
  const std::string details = fmt::format("{}\nPublished: {}\nMeasured: {}\n{}", claim.text,
                                          claim.published, judgement.measured, judgement.reason);
  return fmt::format("      <failure message=\"{}\" type=\"unexpected verdict\">{}</failure>\n",
                     escaped(message), escaped(details));
}

std::string skipped_of(const Judgement& judgement, bool hidden) {
  const std::string message =
      hidden ? "left out: rests on times"
             : fmt::format("{}: {}", name_of(judgement.verdict), judgement.reason);
  return fmt::format("      <skipped message=\"{}\"/>\n", escaped(message));
}

/// No failure: the verdict is known to come out otherwise on other machines.
std::string machine_note(const Judgement& judgement) {
  const Claim& claim = *judgement.claim;
  return fmt::format(
      "      <system-out>{}</system-out>\n",
      escaped(fmt::format("{}, expected {}; depends on the machine: {}", name_of(judgement.verdict),
                          name_of(claim.expected_verdict), claim.machine_dependence)));
}

/// Test runners split names of classes at dots.
std::string class_of(const Claim& claim) {
  return claim.paper + "." + (claim.topic.empty() ? "claims" : slug(claim.topic));
}

std::string case_of(const Judgement& judgement, bool hidden) {
  std::string xml = fmt::format("    <testcase classname=\"{}\" name=\"{}\">\n",
                                escaped(class_of(*judgement.claim)),
                                escaped(short_claim_id(judgement.claim->id)));
  xml += properties_of(judgement, hidden);
  const Outcome outcome = outcome_of(judgement, hidden);
  if (outcome == Outcome::failed) xml += failure_of(judgement);
  if (outcome == Outcome::skipped) xml += skipped_of(judgement, hidden);
  if (!hidden && expectation_of(judgement) == Expectation::depends_on_machine)
    xml += machine_note(judgement);
  return xml + "    </testcase>\n";
}

struct Totals {
  std::size_t tests = 0, failures = 0, skipped = 0;
  Totals& operator+=(const Totals& other) {
    tests += other.tests;
    failures += other.failures;
    skipped += other.skipped;
    return *this;
  }
  std::string attributes() const {
    return fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\"", tests, failures,
                       skipped);
  }
};

/// The runs by the letters by which reasons and measured values call them.
std::string properties_of(const RunComparison& comparison) {
  std::string xml = "    <properties>\n";
  for (std::size_t run = 0; run < comparison.runs.size(); ++run)
    xml += fmt::format("      <property name=\"run {}\" value=\"{}\"/>\n", run_letter(run),
                       escaped(comparison.runs[run].label));
  return xml + "    </properties>\n";
}

/// `properties` stand before the cases.
std::string suite_of(const JudgedPaper& paper, const std::string& properties, bool without_varying,
                     Totals& all) {
  Totals totals;
  std::string cases;
  for (const Judgement& judgement : paper.judgements) {
    const bool hidden = without_varying && judgement.varies;
    const Outcome outcome = outcome_of(judgement, hidden);
    totals += {1, outcome == Outcome::failed, outcome == Outcome::skipped};
    cases += case_of(judgement, hidden);
  }
  all += totals;
  return fmt::format("  <testsuite name=\"{}\" {}>\n{}{}  </testsuite>\n", escaped(paper.paper.key),
                     totals.attributes(), properties, cases);
}

}  // namespace

std::string junit_xml(const JudgedRun& judged, bool without_varying,
                      const RunComparison* comparison) {
  const std::string properties = comparison ? properties_of(*comparison) : "";
  Totals totals;
  std::string suites;
  for (const JudgedPaper& paper : judged.papers)
    suites += suite_of(paper, properties, without_varying, totals);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"phytobench\" {}>\n{}"
      "</testsuites>\n",
      totals.attributes(), suites);
}

}  // namespace phytobench
