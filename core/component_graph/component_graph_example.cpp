// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/component_setting_reader.hpp"

namespace phytobench {

namespace {

constexpr std::string_view introduction =
    "# A graph of components for `phytobench build`. Every key of a component may be left out; "
    "the\n"
    "# values here are the defaults. Lengths share one free unit.\n"
    "#\n"
    "# A number may also be a range over siblings or children, [first, last]; a function of value, "
    "i,\n"
    "# n, depth and t, \"value * random(0.9, 1.1)\"; both, {{ value = [1.0, 0.5], function = "
    "\"value^2\" }};\n"
    "# or key frames, {{ frames = [{{ time = 0, value = 0.1 }}, {{ time = 10, value = 2.0 }}] }}.\n"
    "# What comes out of these is rounded to the nearest where a number must be whole, halves up; "
    "a\n"
    "# number that stands there alone, or ends a range, must be whole itself.\n"
    "\n"
    "[graph]\n"
    "root = \"my_{0}\"  # the component that hangs on the camera\n"
    "seed = 0  # of random() in functions\n"
    "time = 0.0  # of key frames\n"
    "\n"
    "# {1}\n"
    "[component.my_{0}]\n"
    "kind = \"{0}\"\n"
    "# How many of it may lie on one way from the root, if links lead back to it; all loops "
    "through it\n"
    "# share them, so that an inner loop does not start anew in each turn of an outer one.\n"
    "# most_recursions = 3\n";

constexpr std::string_view something_below =
    "\n"
    "[component.shape]\n"
    "kind = \"simple\"\n"
    "\n"
    "[[link]]\n"
    "from = \"my_{0}\"\n"
    "to = \"shape\"\n"
    "kind = \"{1}\"  # child, branch, or leaf: where a recursion has ended\n";

}  // namespace

std::string example_component_graph(const ComponentKind& kind) {
  std::string text = fmt::format(introduction, kind.name, kind.summary);
  for (const ComponentKey& key : kind.keys)
    text += example_lines({.name = key.name,
                           .unit = key.unit,
                           .meaning = key.meaning,
                           .source = key.source,
                           .allowed = allowed_setting(key),
                           .value = key.default_text});
  if (kind.make_geometry == nullptr || kind.carries_branches)
    text += fmt::format(something_below, kind.name, kind.carries_branches ? "branch" : "child");
  return text;
}

}  // namespace phytobench
