// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/result_document.hpp"

#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"

namespace phytobench {

using nlohmann::ordered_json;

namespace {

/// The text with NaN and Infinity, signed or not, replaced by null where they stand outside of
/// strings.
std::string without_bare_words(const std::string& text) {
  std::string result;
  result.reserve(text.size());
  bool is_string = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const std::string_view rest = std::string_view(text).substr(i);
    std::size_t length = 0;
    for (const std::string_view word : {"NaN", "-NaN", "Infinity", "-Infinity"})
      if (!is_string && rest.starts_with(word)) length = word.size();
    if (length > 0) {
      result += "null";
      i += length - 1;
      continue;
    }
    result += text[i];
    if (text[i] == '"') is_string = !is_string;
    if (is_string && text[i] == '\\' && i + 1 < text.size()) result += text[++i];
  }
  return result;
}

std::string text_or_nothing(const ordered_json& json, const char* key) {
  return json.contains(key) ? json.at(key).get<std::string>() : std::string();
}

}  // namespace

ordered_json parsed_document(const std::string& text, const std::string& whose) {
  ordered_json document;
  try {
    document = ordered_json::parse(without_bare_words(text));
  } catch (const ordered_json::exception& error) {
    throw InputError(whose + ": is no JSON or is damaged (" + error.what() +
                     "); write the file again");
  }
  if (!document.is_object())
    throw InputError(whose + ": holds JSON, but no object; give the whole file");
  return document;
}

std::string schema_of(const ordered_json& document) {
  const auto found = document.find("schema");
  return found != document.end() && found->is_string() ? found->get<std::string>() : std::string();
}

ordered_json origin_json(const SideOrigin& origin) {
  return {{"given", origin.given},
          {"kind", origin.kind},
          {"commit", origin.commit},
          {"changed", origin.changed},
          {"compiler", origin.compiler},
          {"flags", origin.flags},
          {"program_digest", origin.program_digest}};
}

SideOrigin origin_from(const ordered_json& json) {
  return {.given = text_or_nothing(json, "given"),
          .kind = text_or_nothing(json, "kind"),
          .commit = json.at("commit"),
          .changed = json.contains("changed") && json.at("changed").get<bool>(),
          .compiler = json.at("compiler"),
          .flags = text_or_nothing(json, "flags"),
          .program_digest = text_or_nothing(json, "program_digest")};
}

ResultMachine result_machine_from(const ordered_json& json) {
  ResultMachine machine{.processor = json.at("processor"),
                        .logical_processors = json.at("logical_processors"),
                        .kernel = json.at("kernel")};
  machine.text = fmt::format("{}, {} logical processors, {}", machine.processor,
                             machine.logical_processors, machine.kernel);
  return machine;
}

}  // namespace phytobench
