// SPDX-License-Identifier: MIT
#include "reports/browser/accessibility_checks.hpp"

#include <map>
#include <set>

namespace phytobench {

namespace {

using nlohmann::json;

struct AccessibleNode {
  std::string role;
  std::string name;
  int level = 0;  ///< of a heading
};

AccessibleNode node_of(const json& node) {
  AccessibleNode found;
  if (node.value("ignored", false)) return found;
  if (node.contains("role")) found.role = node["role"].value("value", "");
  if (node.contains("name")) found.name = node["name"].value("value", "");
  if (node.contains("properties"))
    for (const json& property : node["properties"])
      if (property["name"] == "level") found.level = property["value"]["value"].get<int>();
  return found;
}

/// In the order of reading; nodes that a screen reader does not get have no role.
std::vector<AccessibleNode> accessibility_tree(Page& page) {
  const json nodes = page.call("Accessibility.getFullAXTree")["nodes"];
  std::map<std::string, const json*> by_id;
  for (const json& node : nodes) by_id[node["nodeId"].get<std::string>()] = &node;
  std::vector<AccessibleNode> tree;
  std::vector<const json*> waiting = {&nodes.at(0)};
  while (!waiting.empty()) {
    const json& node = *waiting.back();
    waiting.pop_back();
    tree.push_back(node_of(node));
    const json children = node.value("childIds", json::array());
    for (auto child = children.rbegin(); child != children.rend(); ++child)
      if (const auto found = by_id.find(child->get<std::string>()); found != by_id.end())
        waiting.push_back(found->second);
  }
  return tree;
}

Problems heading_problems(const std::vector<AccessibleNode>& tree) {
  Problems problems;
  int level = 0, first_level = 0;
  for (const AccessibleNode& node : tree) {
    if (node.role != "heading") continue;
    if (node.level > level + 1)
      problems.push_back("heading of level " + std::to_string(node.level) + " after one of level " +
                         std::to_string(level) + ": " + node.name);
    level = node.level;
    first_level += level == 1;
  }
  if (first_level != 1)
    problems.push_back(std::to_string(first_level) + " headings of level 1, not one");
  return problems;
}

Problems landmark_problems(const std::vector<AccessibleNode>& tree) {
  std::map<std::string, int> count;
  for (const AccessibleNode& node : tree) ++count[node.role];
  Problems problems;
  for (const char* once : {"main", "banner"})
    if (count[once] != 1)
      problems.push_back(std::to_string(count[once]) + " landmarks " + once + ", not one");
  if (count["navigation"] == 0) problems.push_back("no landmark navigation");
  return problems;
}

}  // namespace

Problems name_problems(Page& page) {
  return page.texts(R"js((() => {
    const named = e => e.getAttribute('aria-label') || e.getAttribute('aria-labelledby') ||
                       e.closest('[aria-hidden="true"]');
    const title = svg => [...svg.children].some(e => e.tagName === 'title' && e.textContent.trim());
    const nameless = (selector, has_name) => [...document.querySelectorAll(selector)]
      .filter(e => !named(e) && !has_name(e)).map(e => 'no name: ' + e.outerHTML.slice(0, 160));
    return [...nameless('table', e => e.caption && e.caption.textContent.trim()),
            ...nameless('img', e => e.hasAttribute('alt')),
            ...nameless('svg:not(svg svg)', title),
            ...nameless('figure', e => e.querySelector('figcaption')),
            ...(document.documentElement.lang ? [] : ['the page says no language'])];
  })())js");
}

Problems accessibility_problems(Page& page) {
  const std::set<std::string> need_names = {
      "heading", "table",   "image",      "SvgRoot",  "link",
      "button",  "textbox", "searchbox",  "combobox", "checkbox",
      "radio",   "form",    "navigation", "search",   "graphics-document"};
  const std::vector<AccessibleNode> tree = accessibility_tree(page);
  Problems problems = heading_problems(tree);
  const Problems landmarks = landmark_problems(tree);
  problems.insert(problems.end(), landmarks.begin(), landmarks.end());
  for (const AccessibleNode& node : tree)
    if (need_names.contains(node.role) && node.name.empty())
      problems.push_back("nameless: " + node.role);
  return problems;
}

}  // namespace phytobench
