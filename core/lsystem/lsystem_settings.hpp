// SPDX-License-Identifier: MIT
// Lines of the form 'key: value', several of which may share a line.
#pragma once

#include <string_view>
#include <vector>

#include "core/lsystem/module_parser.hpp"

namespace phytobench {

/// Which part of reading a key belongs to.
enum class SettingKind {
  alphabet,  ///< comes first: everything else is made of letters
  axiom,
  ignore,  ///< letters that contexts do not see
  value,   ///< a number or word of LSystem or TurtleSettings
};

struct LineSetting {
  std::string_view key;
  SettingKind kind = SettingKind::value;
  const SourceLine* line = nullptr;
  std::size_t key_offset = 0;
  std::size_t begin = 0;  ///< of the value in line->text
  std::size_t end = 0;

  LineScanner value() const { return {*line, begin, end}; }
};

/// Whether the word is a key that a label or constant could be mistaken for.
bool is_setting(std::string_view name);

/// The settings of a line that is neither a production nor a constant. Throws InputError for
/// unknown keys, missing values, and for a line of another kind.
std::vector<LineSetting> line_settings(const SourceLine& line);

/// Letters up to the end, blanks and commas between them mean nothing.
struct ListedLetter {
  std::string_view letter;
  std::size_t place = 0;
};
std::vector<ListedLetter> parse_letters(LineScanner& scanner, const Alphabet& alphabet);

/// Sets what a setting of SettingKind::value says. Throws InputError.
void assign_value(LSystem& system, const LineSetting& setting, const Alphabet& alphabet,
                  const Constants& constants);

/// Takes letters that draw from the default of those that only move, and the other way round.
/// Throws InputError for a letter that is named as both. To be called after the last
/// assign_value().
void settle_draw_and_move(LSystem& system, const std::vector<LineSetting>& settings);

}  // namespace phytobench
