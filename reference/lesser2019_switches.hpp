// SPDX-License-Identifier: MIT
// Which errata of [Lesser2019] a calculation has, by name.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace phytobench {

/// Those that change a map.
enum class LesserErratum {
  latent_heat_054,        ///< E01
  text_elevation_step,    ///< E02
  even_hours_step,        ///< E03
  two_hour_azimuth,       ///< E04
  no_cosine,              ///< E07
  ray_step_rule,          ///< E08
  unguarded_march,        ///< E09
  truncate_towards_zero,  ///< E10
  eight_neighbours,       ///< E12
  reflect_absorbed,       ///< E13
  losses_as_fractions,    ///< E14
  dot_as_angle,           ///< E15
  multiply_evaporation,   ///< E16
  zero_need,              ///< E18
  unchecked_losses,       ///< E19
  triangle_depth,         ///< E21
  truncate_images,        ///< E22
  wrap_images,            ///< E23
};

/// What is as printed.
struct LesserSwitches {
  std::set<LesserErratum> printed;
  /// Directions to the sun have four decimals, as listing 9.7 gives them.
  bool rounded_sun = false;

  bool has(LesserErratum erratum) const { return printed.contains(erratum); }
  friend bool operator==(const LesserSwitches&, const LesserSwitches&) = default;
};

/// "E16", as in errata/, and "multiply-evaporation".
std::string_view id_of(LesserErratum erratum);
std::string_view name_of(LesserErratum erratum);

/// Whether a map can show the erratum with this id of lesser2019.
bool can_be_left_in(std::string_view id);

/// "E02, E14, E15, E21, which only the text has, and E22, E23, which only saved maps have".
std::string left_out_of_all();

/// "none", or with commas between them: ids, names, "rounded-sun", "all"; capitals and spaces
/// around do not matter. "all" is the program as its listings have it: without E02, E14, E15 and
/// E21, which only the text has, and without E22 and E23, which only maps have that were saved and
/// loaded again. With the directions rounded. Throws InputError naming those that there are.
LesserSwitches lesser_switches(const std::string& text);

/// The other way round: "none", "E13,E16", "E01,rounded-sun".
std::string shown(const LesserSwitches& switches);

}  // namespace phytobench
