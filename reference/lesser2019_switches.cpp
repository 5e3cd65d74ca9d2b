// SPDX-License-Identifier: MIT
#include "reference/lesser2019_switches.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

using enum LesserErratum;

/// Who has it: the listings, the text alone, or images that were saved.
enum class LesserSource { listing, text, image };

struct LesserEntry {
  LesserErratum erratum;
  std::string_view id;
  std::string_view name;
  LesserSource source;
};

constexpr std::array<LesserEntry, 18> lesser_entries = {
    {{latent_heat_054, "E01", "latent-heat-054", LesserSource::listing},
     {text_elevation_step, "E02", "text-elevation-step", LesserSource::text},
     {even_hours_step, "E03", "even-hours-step", LesserSource::listing},
     {two_hour_azimuth, "E04", "two-hour-azimuth", LesserSource::listing},
     {no_cosine, "E07", "no-cosine", LesserSource::listing},
     {ray_step_rule, "E08", "ray-step-rule", LesserSource::listing},
     {unguarded_march, "E09", "unguarded-march", LesserSource::listing},
     {truncate_towards_zero, "E10", "truncate-towards-zero", LesserSource::listing},
     {eight_neighbours, "E12", "eight-neighbours-always", LesserSource::listing},
     {reflect_absorbed, "E13", "reflect-absorbed", LesserSource::listing},
     {losses_as_fractions, "E14", "losses-as-fractions", LesserSource::text},
     {dot_as_angle, "E15", "dot-as-angle", LesserSource::text},
     {multiply_evaporation, "E16", "multiply-evaporation", LesserSource::listing},
     {zero_need, "E18", "zero-need", LesserSource::listing},
     {unchecked_losses, "E19", "unchecked-losses", LesserSource::listing},
     {triangle_depth, "E21", "triangle-depth", LesserSource::text},
     {truncate_images, "E22", "truncate-images", LesserSource::image},
     {wrap_images, "E23", "wrap-images", LesserSource::image}}};

constexpr std::string_view rounding_name = "rounded-sun";

const LesserEntry& entry_of(LesserErratum erratum) {
  for (const LesserEntry& entry : lesser_entries)
    if (entry.erratum == erratum) return entry;
  throw ContractViolation("an erratum of lesser2019 has no entry");
}

std::string ids_of_source(LesserSource source) {
  std::vector<std::string_view> ids;
  for (const LesserEntry& entry : lesser_entries)
    if (entry.source == source) ids.push_back(entry.id);
  return fmt::format("{}", fmt::join(ids, ", "));
}

/// In small letters, without spaces around it.
std::string plain_word(std::string_view text) {
  const std::size_t first = text.find_first_not_of(' ');
  if (first == std::string_view::npos) return "";
  std::string word(text.substr(first, text.find_last_not_of(' ') + 1 - first));
  for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return word;
}

void switch_on(const std::string& text, LesserSwitches& switches) {
  const std::string word = plain_word(text);
  if (word == "none")
    throw InputError("none leaves nothing as printed; give it alone, or leave it out");
  if (word == "all")
    for (const LesserEntry& entry : lesser_entries)
      if (entry.source == LesserSource::listing) switches.printed.insert(entry.erratum);
  if (word == "all" || word == rounding_name) {
    switches.rounded_sun = true;
    return;
  }
  std::string known;
  for (const LesserEntry& entry : lesser_entries) {
    if (word == plain_word(entry.id) || word == entry.name) {
      switches.printed.insert(entry.erratum);
      return;
    }
    known += fmt::format("{} ({}), ", entry.id, entry.name);
  }
  throw InputError(fmt::format(
      "'{}' is no erratum that a map can show; write none, all (without {}), or of {}{}", text,
      left_out_of_all(), known, rounding_name));
}

}  // namespace

std::string_view id_of(LesserErratum erratum) {
  return entry_of(erratum).id;
}

std::string_view name_of(LesserErratum erratum) {
  return entry_of(erratum).name;
}

bool can_be_left_in(std::string_view id) {
  return std::any_of(lesser_entries.begin(), lesser_entries.end(),
                     [&](const LesserEntry& entry) { return entry.id == id; });
}

std::string left_out_of_all() {
  return fmt::format("{}, which only the text has, and {}, which only saved maps have",
                     ids_of_source(LesserSource::text), ids_of_source(LesserSource::image));
}

LesserSwitches lesser_switches(const std::string& text) {
  LesserSwitches switches;
  if (plain_word(text) == "none") return switches;
  std::size_t from = 0;
  while (from <= text.size()) {
    const std::size_t comma = std::min(text.find(',', from), text.size());
    switch_on(text.substr(from, comma - from), switches);
    from = comma + 1;
  }
  return switches;
}

std::string shown(const LesserSwitches& switches) {
  std::vector<std::string_view> words;
  for (const LesserErratum erratum : switches.printed) words.push_back(id_of(erratum));
  if (switches.rounded_sun) words.push_back(rounding_name);
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ","));
}

}  // namespace phytobench
