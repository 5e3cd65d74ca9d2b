// SPDX-License-Identifier: MIT
#include "core/component_graph/component_graph_file.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "core/component_graph/component_registry.hpp"
#include "core/component_graph/instance_tree.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

/// A multiplier with a whole number as its key, whatever the kinds call it.
struct Known {
  std::string kind;
  std::string count;  // a key that takes whole numbers
  std::size_t count_position = 0;
};

Known known_multiplier() {
  for (const ComponentKind* kind : all_component_kinds())
    for (std::size_t i = 0; kind->is_multiplier && i < kind->keys.size(); ++i) {
      const auto* number = std::get_if<RangedNumber>(&kind->keys[i].kind);
      if (number != nullptr && number->range.whole && number->over == RangeOver::siblings)
        return {std::string(kind->name), std::string(kind->keys[i].name), i};
    }
  return {};
}

const ComponentKind& kind_that_bears() {
  for (const ComponentKind* kind : all_component_kinds())
    if (kind->carries_branches) return *kind;
  throw InputError("no kind bears branches");
}

/// A ball of shapes; COUNT, BALL stand for names of the kind.
std::string with_names(std::string text) {
  const Known known = known_multiplier();
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"COUNT", known.count},
                                 {"BALL", known.kind},
                                 {"BEARER", std::string(kind_that_bears().name)}})
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from))
      text.replace(at, from.size(), to);
  return text;
}

std::string ball(const std::string& count, const std::string& more = "") {
  return with_names(
      "[graph]\nroot = \"ball\"\n[component.ball]\nkind = \"BALL\"\nCOUNT = " + count +
      "\n[component.part]\nkind = \"simple\"\n[[link]]\nfrom = \"ball\"\nto = "
      "\"part\"\n" +
      more);
}

ComponentGraph parse(const std::string& text) {
  return parse_component_graph(with_names(text), "p.toml");
}

std::string file_refusal(const std::string& text) {
  try {
    parse(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

const ParameterRange& count_of(const ComponentGraph& graph) {
  return std::get<ParameterRange>(graph.prototypes[0].settings[known_multiplier().count_position]);
}

TEST(ComponentGraphFile, ReadsComponentsInTheOrderOfTheFileAndLinks) {
  const ComponentGraph graph = parse(
      "[component.z]\nkind = \"BALL\"\nmost_recursions = 4\n[component.a]\nkind = \"simple\"\n"
      "[graph]\nroot = \"z\"\nseed = 7\ntime = 2.5\n"
      "[[link]]\nfrom = \"z\"\nto = \"z\"\n[[link]]\nfrom = \"z\"\nto = \"a\"\nkind = "
      "\"leaf\"\n");
  ASSERT_EQ(graph.prototypes.size(), 2u);
  EXPECT_EQ(graph.prototypes[0].name, "z");
  EXPECT_EQ(graph.prototypes[0].most_recursions, 4u);
  EXPECT_FALSE(graph.prototypes[1].most_recursions.has_value());
  EXPECT_EQ(graph.root, 0u);
  EXPECT_EQ(graph.seed, 7u);
  EXPECT_EQ(graph.time, 2.5);
  ASSERT_EQ(graph.links.size(), 2u);
  EXPECT_EQ(graph.links[0].kind, LinkKind::child);
  EXPECT_EQ(graph.links[1].kind, LinkKind::leaf);
}

TEST(ComponentGraphFile, ANumberCanBeWrittenInFiveWays) {
  const auto spans = [](const std::string& text) { return count_of(parse(ball(text))).frames; };
  EXPECT_EQ(spans("5")[0].value, (NumberSpan{5.0, 5.0}));
  EXPECT_EQ(spans("[2, 6]")[0].value, (NumberSpan{2.0, 6.0}));
  EXPECT_EQ(spans("{ value = [2, 6] }")[0].value, (NumberSpan{2.0, 6.0}));
  const auto frames = spans("{ frames = [{ time = 0, value = 1 }, { time = 2, value = [2, 3] }] }");
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames[1].time, 2.0);
  EXPECT_EQ(frames[1].value, (NumberSpan{2.0, 3.0}));
  InstancePlace place;
  EXPECT_EQ(count_of(parse(ball("\"3 + i\""))).resolved(place), 4.0);
  EXPECT_EQ(count_of(parse(ball("{ value = 7, function = \"2 * value\" }"))).resolved(place), 14.0);
}

TEST(ComponentGraphFile, WhatItReadsUnfolds) {
  EXPECT_EQ(count_instances(parse(ball("6"))), 7u);
  EXPECT_EQ(count_instances(parse(ball("\"2 + 3\""))), 6u);
}

struct Wrong {
  std::string text;
  std::string message;  // a part of it
};

TEST(ComponentGraphFile, EveryWrongValueIsRefusedWithItsPlace) {
  const std::vector<Wrong> values{
      {"\"7 *\"", "p.toml:5: ball.COUNT: in its function at column"},
      {"\"valeu\"", "did you mean 'value'?"},
      {"-1", "ball.COUNT = -1 is not allowed"},
      {"2.5", "is not allowed; give a number"},
      {"nan", "is not allowed"},
      {"inf", "is not allowed"},
      {"1e300", "is not allowed"},
      {"true", "must be a number"},
      {"[1]", "must be two numbers"},
      {"[1, 2, 3]", "must be two numbers"},
      {"[1, \"2\"]", "must be a number"},
      {"[]", "must be two numbers"},
      {"{}", "is empty; give value, frames or function"},
      {"{ value = 1, valeu = 2 }", "did you mean 'ball.COUNT.value'?"},
      {"{ value = 1, frames = [] }", "set the same"},
      {"{ frames = [] }", "key frames"},
      {"{ frames = 3 }", "key frames"},
      {"{ frames = [3] }", "no key frame"},
      {"{ frames = [{ time = 1 }] }", "no key frame"},
      {"{ frames = [{ time = 1, value = 1, x = 2 }] }", "unknown key"},
      {"{ frames = [{ time = \"a\", value = 1 }] }", "time must be a number"},
      {"{ frames = [{ time = 1, value = 1 }, { time = 1, value = 2 }] }", "order the key frames"},
      {"{ frames = [{ time = 0, value = -3 }] }", "is not allowed"},
      {"{ function = 3 }", "must be a text"},
      {"1979-05-27", "must be a number"}};
  for (const Wrong& wrong : values) {
    const std::string message = file_refusal(ball(wrong.text));
    EXPECT_EQ(message.substr(0, 9), "p.toml:5:") << wrong.text << ": " << message;
    EXPECT_NE(message.find(with_names(wrong.message)), std::string::npos)
        << wrong.text << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

std::string two(const std::string& link, const std::string& graph = "root = \"a\"") {
  return "[graph]\n" + graph +
         "\n[component.a]\nkind = \"simple\"\n[component.b]\nkind = "
         "\"simple\"\n" +
         link;
}

const std::string a_to_b = "[[link]]\nfrom = \"a\"\nto = \"b\"\n";

TEST(ComponentGraphFile, EveryWrongStructureIsRefusedWithItsPlace) {
  const std::vector<Wrong> texts{
      {"", "no table [component]"},
      {"[graph]\nroot = \"a\"\n", "no table [component]"},
      {"nonsense", "p.toml:1:9: not valid TOML"},
      {two(a_to_b) + "[grahp]\n", "did you mean 'graph'?"},
      {two(a_to_b, ""), "graph has no root"},
      {two(a_to_b, "root = 3"), "graph.root must be a text"},
      {two(a_to_b, "root = \"aa\""), "there is no component 'aa'; did you mean 'a'?"},
      {two(a_to_b, "root = \"a\"\nsede = 1"), "did you mean 'seed'?"},
      {two(a_to_b, "root = \"a\"\nseed = -1"), "graph.seed = -1 is not allowed"},
      {two(a_to_b, "root = \"a\"\nseed = 0.5"), "whole"},
      {two(a_to_b, "root = \"a\"\ntime = \"x\""), "graph.time must be a number"},
      {two(""), "no links lead from the root 'a' to component 'b'"},
      {two("[link]\nfrom = \"a\"\n"), "written as [[link]]"},
      {two("[[link]]\nto = \"b\"\n"), "link has no from"},
      {two("[[link]]\nfrom = \"a\"\n"), "link has no to"},
      {two("[[link]]\nfrom = \"a\"\nto = \"c\"\n"), "there is no component 'c'"},
      {two(a_to_b + "kind = \"branche\"\n"), "must be one of \"child\", \"branch\", \"leaf\""},
      {two(a_to_b + "knd = \"child\"\n"), "did you mean 'kind'?"},
      {two(a_to_b + "kind = \"branch\"\n"), "bears no branches"},
      {two(a_to_b + "kind = \"leaf\"\n"), "a is in no recursion"},
      {two(a_to_b + "[[link]]\nfrom = \"b\"\nto = \"a\"\n"), "never ends"},
      {two(a_to_b + "[component]\nc = 3\n"), "p.toml:11: component.c is no table"},
      {two(a_to_b + "[component.a]\nkind = \"simple\"\n"), "not valid TOML"},
      {"[component.a]\nkind = \"simple\"\n", "no table [graph]"},
      {"component = 3\n[graph]\nroot = \"a\"\n", "no table [component]"},
      {"[component]\n[graph]\nroot = \"a\"\n", "there are 0 components"},
      {"[component]\na = 3\n[graph]\nroot = \"a\"\n", "write [component.a]"},
      {"[component.\"a b\"]\nkind = \"simple\"\n[graph]\nroot = \"a b\"\n", "no name for"},
      {"[component.\"a.b\"]\nkind = \"simple\"\n[graph]\nroot = \"a.b\"\n", "no name for"},
      {"[component.a]\n[graph]\nroot = \"a\"\n", "component 'a' has no kind; give one of simple"},
      {"[component.a]\nkind = 3\n[graph]\nroot = \"a\"\n", "a.kind must be a text"},
      {"[component.a]\nkind = \"simpel\"\n[graph]\nroot = \"a\"\n", "did you mean 'simple'?"},
      {"[component.a]\nkind = \"BALL\"\nCOUNTT = 3\n[graph]\nroot = \"a\"\n",
       "unknown key 'a.COUNTT'; did you mean 'a.COUNT'? (phytobench build --example "},
      {"[component.a]\nkind = \"BALL\"\nmost_recursions = 0\n[graph]\nroot = \"a\"\n",
       "a.most_recursions = 0 is not allowed; give a number >= 1 and <= 1000, whole"},
      {"[component.a]\nkind = \"BALL\"\n\"x.y\" = 0\n[graph]\nroot = \"a\"\n", "in quotes"}};
  for (const Wrong& wrong : texts) {
    const std::string message = file_refusal(wrong.text);
    EXPECT_EQ(message.substr(0, 7), "p.toml:") << wrong.text << ": " << message;
    EXPECT_NE(message.find(with_names(wrong.message)), std::string::npos)
        << wrong.text << ": " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST(ComponentGraphFile, TheMessageNamesTheLine) {
  EXPECT_EQ(file_refusal(two(a_to_b + "[[link]]\nfrom = \"b\"\nto = \"a\"\n")).substr(0, 9),
            "p.toml:10");
}

TEST(ComponentGraphFile, TooManyComponentsOrLinksAreRefused) {
  std::string many = "[graph]\nroot = \"c0\"\n";
  for (std::size_t i = 0; i <= most_components; ++i)
    many += fmt::format("[component.c{}]\nkind = \"simple\"\n", i);
  EXPECT_NE(file_refusal(many).find("give 1 to 256"), std::string::npos) << file_refusal(many);
  std::string links = two("");
  for (std::size_t i = 0; i <= most_links; ++i) links += a_to_b;
  EXPECT_NE(file_refusal(links).find("at most 1000"), std::string::npos);
}

TEST(ComponentGraphFile, AMissingFileIsNamed) {
  EXPECT_THROW(read_component_graph("/nowhere/graph.toml"), InputError);
}

}  // namespace
}  // namespace phytobench
