// SPDX-License-Identifier: MIT
// XML read by a library, for tests of what writes it. Not for the suite itself: libxml2 may be
// missing.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <libxml/parser.h>
#include <libxml/tree.h>

namespace phytobench::xml_fixture {

using Document = std::unique_ptr<xmlDoc, decltype(&xmlFreeDoc)>;

/// Null for a text that is not well-formed.
inline Document parsed(const std::string& xml) {
  return {xmlReadMemory(xml.data(), static_cast<int>(xml.size()), "tested.xml", nullptr,
                        XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_NONET),
          xmlFreeDoc};
}

inline std::string attribute(const xmlNode* node, const char* name) {
  const std::unique_ptr<xmlChar, void (*)(xmlChar*)> value(
      xmlGetProp(node, reinterpret_cast<const xmlChar*>(name)),
      [](xmlChar* text) { xmlFree(text); });
  return value ? reinterpret_cast<const char*>(value.get()) : "(none)";
}

inline std::string name_of(const xmlNode* node) {
  return reinterpret_cast<const char*>(node->name);
}

inline std::vector<const xmlNode*> children(const xmlNode* node) {
  std::vector<const xmlNode*> found;
  for (const xmlNode* child = node->children; child != nullptr; child = child->next)
    if (child->type == XML_ELEMENT_NODE) found.push_back(child);
  return found;
}

inline std::vector<const xmlNode*> children(const xmlNode* node, const std::string& name) {
  std::vector<const xmlNode*> found;
  for (const xmlNode* child : children(node))
    if (name_of(child) == name) found.push_back(child);
  return found;
}

}  // namespace phytobench::xml_fixture
