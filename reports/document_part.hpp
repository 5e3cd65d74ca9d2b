// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <utility>

#include <nlohmann/json.hpp>

namespace phytobench {

/// A part of the document, and whether there is anything in it: templates cannot ask.
inline void add_part(nlohmann::ordered_json& document, const std::string& key,
                     nlohmann::ordered_json part) {
  document["has_" + key] = !part.empty();
  document[key] = std::move(part);
}

}  // namespace phytobench
