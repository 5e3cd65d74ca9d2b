// SPDX-License-Identifier: MIT
// Texts of population files, and what is said against them.
#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/population_file.hpp"
#include "core/population/population_keys.hpp"

namespace phytobench {

inline PopulationParameters parse_stand(std::string_view text) {
  return parse_population(text, "stand.toml").parameters;
}

/// The message of the InputError that the text ends with.
inline std::string complaint_on(std::string_view text) {
  try {
    parse_stand(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// One line that begins with file and line and holds `part`.
inline void expect_complaint(std::string_view text, int line, std::string_view part) {
  const std::string message = complaint_on(text);
  EXPECT_THAT(message, testing::StartsWith(fmt::format("stand.toml:{}:", line))) << "for\n" << text;
  EXPECT_THAT(message, testing::HasSubstr(std::string(part))) << "for\n" << text;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

/// A file with a species, in which nothing else is given but one key, in its last line; what is
/// required besides it comes before.
inline std::string file_with(std::string_view name, std::string_view value) {
  const std::string_view section = section_of(name);
  std::string text = section.empty() ? fmt::format("{} = {}\n", name, value) : "";
  text += name == "species.name" ? "[[species]]\n" : "[[species]]\nname = \"oak\"\n";
  if (section.empty()) return text;
  if (!section.starts_with("species"))
    text +=
        fmt::format(fmt::runtime(is_list_of_population(section) ? "[[{}]]\n" : "[{}]\n"), section);
  if (section == "species.reproduction") text += "[species.reproduction]\n";
  for (const PopulationKey& key : population_keys())
    if (section_of(key.name) == section && key.is_required && key.name != name &&
        section != "species")
      text += fmt::format("{} = {}\n", short_name_of(key.name), key.example_text);
  return text + fmt::format("{} = {}\n", short_name_of(name), value);
}

}  // namespace phytobench
