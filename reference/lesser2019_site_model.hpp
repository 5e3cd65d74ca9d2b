// SPDX-License-Identifier: MIT
// Whole maps as [Lesser2019] prints them: each erratum of its calculations can be put back in,
// alone or with others, while everything else stays corrected.
#pragma once

#include <memory>

#include "core/terrain/shadow/shadow_engine.hpp"
#include "core/terrain/site_model.hpp"
#include "reference/lesser2019_switches.hpp"

namespace phytobench {

/// What is not printed is `corrected`: with its variants, if it has some.
///
/// NaN where the printed program divides by zero (E18). Even hours go up for as many steps as half
/// of the hours (E03); the image of energy is padded with zeros (E12). E22 and E23 act on soil
/// depths in centimetres, on water and on chances, as if each had been saved and loaded. E19 lets
/// the air take more than there is, but check_site() will not.
std::unique_ptr<SiteModel> printed_site_model(const LesserSwitches& switches,
                                              const SiteModelOptions& corrected = {});

/// The shadows that go with it: with E08 those of the printed march, slowly, with the guards of E09
/// and the floor of E10 unless these are printed, too. Without E08 those of exact_traversal, which
/// has neither trap. A ray that does not end, or ends the program, counts as stuck and is lit.
std::unique_ptr<ShadowEngine> lesser_shadows(const LesserSwitches& switches);

}  // namespace phytobench
