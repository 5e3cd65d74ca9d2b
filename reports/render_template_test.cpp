// SPDX-License-Identifier: MIT
#include "reports/render_template.hpp"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using nlohmann::ordered_json;

ordered_json document_with(const std::string& text) {
  ordered_json document;
  document["x"] = text;
  return document;
}

std::string html(const std::string& text, const ordered_json& document) {
  return render_template(text, document, EscapeFor::html);
}

std::string markdown(const std::string& text, const ordered_json& document) {
  return render_template(text, document, EscapeFor::markdown);
}

TEST(RenderTemplate, EscapesWhatStartsMarkupInHtml) {
  const ordered_json document = document_with("a < b & \"c\" > d");
  EXPECT_EQ(html("<p>{{x}}</p>", document), "<p>a &lt; b &amp; &quot;c&quot; &gt; d</p>");
}

TEST(RenderTemplate, EscapesAnEntityAgain) {
  EXPECT_EQ(html("{{x}}", document_with("&lt;")), "&amp;lt;");
}

TEST(RenderTemplate, EscapesWhatStartsMarkupOrEndsACellInMarkdown) {
  EXPECT_EQ(markdown("| {{x}} |", document_with("a|b")), "| a\\|b |");
  EXPECT_EQ(markdown("{{x}}", document_with("*a* _b_ `c` [d] <e")),
            "\\*a\\* \\_b\\_ \\`c\\` \\[d\\] \\<e");
  EXPECT_EQ(markdown("| {{x}} |", document_with("two\nlines")), "| two lines |");
}

TEST(RenderTemplate, LeavesTripleBracesRaw) {
  const std::string raw = "<b>*a* | \"b\" & c</b>";
  EXPECT_EQ(html("{{{x}}}", document_with(raw)), raw);
  EXPECT_EQ(markdown("{{{x}}}", document_with(raw)), raw);
}

TEST(RenderTemplate, TakesValuesForTextAndNeverForATemplate) {
  ordered_json document = document_with("{{y}} {{#y}}");
  document["y"] = "secret";
  EXPECT_EQ(html("{{x}}", document), "{{y}} {{#y}}");
  EXPECT_EQ(html("{{{x}}}", document), "{{y}} {{#y}}");
}

TEST(RenderTemplate, RepeatsAListAndSkipsAnEmptyOne) {
  ordered_json document;
  document["rows"] = ordered_json::array();
  EXPECT_EQ(html("[{{#rows}}{{name}};{{/rows}}]", document), "[]");
  EXPECT_EQ(html("[{{^rows}}none{{/rows}}]", document), "[none]");
  ordered_json row;
  row["name"] = "a";
  document["rows"].push_back(row);
  row["name"] = "<";
  document["rows"].push_back(row);
  EXPECT_EQ(html("[{{#rows}}{{name}};{{/rows}}]", document), "[a;&lt;;]");
  EXPECT_EQ(html("[{{^rows}}none{{/rows}}]", document), "[]");
}

TEST(RenderTemplate, ShowsABooleanSectionOnlyIfTrue) {
  ordered_json document;
  document["yes"] = true;
  document["no"] = false;
  EXPECT_EQ(html("{{#yes}}a{{/yes}}{{#no}}b{{/no}}{{^no}}c{{/no}}", document), "ac");
}

TEST(RenderTemplate, ShowsNumbersAndObjects) {
  ordered_json document;
  document["n"] = 2243;
  document["paper"]["key"] = "brzoska2019";
  EXPECT_EQ(html("{{n}} {{#paper}}{{key}}{{/paper}}", document), "2243 brzoska2019");
}

TEST(RenderTemplate, RefusesABrokenTemplate) {
  const ordered_json document = document_with("a");
  for (const char* broken :
       {"{{#x}} never closed", "{{x", "{{{x}}", "closed {{/x}} only", "{{#x}}{{#y}}{{/x}}{{/y}}"}) {
    EXPECT_THROW(html(broken, document), ContractViolation) << broken;
    EXPECT_THROW(markdown(broken, document), ContractViolation) << broken;
  }
}

TEST(Partials, StandInPlaceOfTheirNames) {
  const Partials partials = {{"a", "[{{> b }}]\n"}, {"b", "{{x}}\n"}};
  EXPECT_EQ(with_partials("1{{> a}}2\n{{>a}}\n", partials), "1[{{x}}]2\n[{{x}}]\n");
}

TEST(Partials, LeaveNoLineWhereTheyAreAbsent) {
  EXPECT_EQ(with_partials("1\n{{> absent}}\n2", {}), "1\n2");
  EXPECT_EQ(with_partials("{{#x}}{{> absent}}{{/x}}\n2", {}), "{{#x}}{{/x}}\n2");
}

TEST(Partials, MayNotContainThemselves) {
  EXPECT_THROW(with_partials("{{> a}}", {{"a", "{{> b}}"}, {"b", "{{> a}}"}}), ContractViolation);
}

TEST(Partials, LeaveTheRestAlone) {
  EXPECT_EQ(with_partials("{{x}} {{{y}}} {{> open", {}), "{{x}} {{{y}}} {{> open");
}

TEST(RenderReport, NeedsItsTemplate) {
  EXPECT_THROW(render_report("no/such/folder", ordered_json::object(), EscapeFor::html),
               InputError);
}

}  // namespace
}  // namespace phytobench
