// SPDX-License-Identifier: MIT
// Sec. 9.2.5, listing 9.14: what neighbours throw over.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/random/counter_stream.hpp"
#include "core/terrain/site_model.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/lesser2019_energy.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

constexpr int side = 7;
constexpr double share = 0.1;        // figure 10.4
constexpr double energy = 819.0;     // kcal/m2 on dirt, as listing 9.13 leaves it
constexpr double incident = 1092.0;  // before the soil has thrown back a quarter
constexpr double albedo = 0.25;

/// Which pixels a single bright one adds to, and whether it adds to itself.
void record_stencil(ExperimentContext& context) {
  oracle::Values one = oracle::even_values(side, 0.0);
  one.value[3 * side + 3] = 8.0;
  const oracle::Values after = oracle::listing_9_14(one, share);
  std::int64_t reached = 0;
  double sum = 0.0;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double more = after.at(column, row) - one.at(column, row);
      reached += more != 0.0;
      sum += more;
      if (column == 3 && row == 3) context.record("stencil/centre", more, "kcal/m2");
    }
  context.record("stencil", reached, "pixels");
  context.record("stencil/share-handed-on", sum / 8.0);
}

/// The listing reads a copy: with rows and columns in the opposite order nothing changes. Read from
/// the image itself, later pixels get more.
void record_order(ExperimentContext& context) {
  CounterStream stream(context.seed(), 50);
  oracle::Values image = oracle::even_values(side, 0.0);
  for (double& value : image.value) value = stream.next_unit() * 1000.0;
  const oracle::Values copied = oracle::listing_9_14(image, share);
  std::int64_t in_place_differs = 0, turned_differs = 0;
  oracle::Values in_place = image, turned = image;
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const auto at = [](int c, int r) { return static_cast<std::size_t>(r * side + c); };
      in_place.value[at(column, row)] = oracle::listing_9_14(in_place, share).at(column, row);
      in_place_differs += in_place.at(column, row) != copied.at(column, row);
      turned.value[at(column, row)] = image.at(side - 1 - column, side - 1 - row);
    }
  const oracle::Values turned_after = oracle::listing_9_14(turned, share);
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column)
      turned_differs += std::abs(turned_after.at(side - 1 - column, side - 1 - row) -
                                 copied.at(column, row)) > 1e-9;
  context.record("order/turned-by-half-a-turn", turned_differs, "pixels");
  context.record("order/in-place-differs", in_place_differs, "pixels");
}

/// Even ground: interior, edge and corner.
void record_even_ground(ExperimentContext& context) {
  const auto record = [&](const std::string& name, const auto& map) {
    context.record(name + "interior", map.at(3, 3), "kcal/m2");
    context.record(name + "edge", map.at(3, 0), "kcal/m2");
    context.record(name + "corner", map.at(0, 0), "kcal/m2");
  };
  const oracle::Values image = oracle::even_values(side, energy);
  record("printed/", oracle::listing_9_14(image, share));
  record("printed-by-number/", oracle::listing_9_14(image, share, oracle::Padding::zeros,
                                                    oracle::Divisor::number_of_neighbours));
  record("printed-edge-padding/", oracle::listing_9_14(image, share, oracle::Padding::edge));
  context.record("printed/interior-of-whole-numbers",
                 std::trunc(std::trunc(energy) * (1.0 + share)), "kcal/m2");
  TerrainMap incoming{side, side, std::vector<double>(side * side, incident)}, ground = incoming;
  for (double& value : ground.values) value = albedo;
  record("corrected/", corrected_site_model()->absorbed(incoming, ground, share, 1));
  record(
      "corrected-all-kept/",
      corrected_site_model({.reflected_is_absorbed = false})->absorbed(incoming, ground, share, 1));
}

/// What even ground keeps, over what comes to it, for albedos from 0 to 1 and shares up to 1.
void record_gain(ExperimentContext& context) {
  double printed = 0.0, corrected = 0.0;
  std::int64_t printed_gains = 0, corrected_gains = 0, cases = 0;
  for (int a = 0; a <= 20; ++a)
    for (int c = 1; c <= 10; ++c) {
      const double ground = a / 20.0, handed = c / 10.0;
      const oracle::Values image = oracle::even_values(3, 1000.0 * (1.0 - ground));
      const double by_listing = oracle::listing_9_14(image, handed).at(1, 1) / 1000.0;
      const TerrainMap incoming{3, 3, std::vector<double>(9, 1000.0)},
          thrown{3, 3, std::vector<double>(9, ground)};
      const double by_core =
          corrected_site_model()->absorbed(incoming, thrown, handed, 1).at(1, 1) / 1000.0;
      ++cases;
      printed_gains += by_listing > 1.0 + 1e-12;
      corrected_gains += by_core > 1.0 + 1e-12;
      if (c == 1) {
        printed = std::max(printed, by_listing);
        corrected = std::max(corrected, by_core);
      }
    }
  context.record("gain/cases", cases, "cases");
  context.record("gain/printed/cases-with-more-than-comes", printed_gains, "cases");
  context.record("gain/corrected/cases-with-more-than-comes", corrected_gains, "cases");
  context.record("gain/printed/greatest-at-a-tenth", printed);
  context.record("gain/corrected/greatest-at-a-tenth", corrected);
}

/// Sec. 8.2.1: what is handed on is part of what the ground throws back. From snow more than from
/// bare soil.
void record_brightness(ExperimentContext& context) {
  const auto handed_on = [](double ground, bool as_printed) {
    if (as_printed) {
      const oracle::Values image = oracle::even_values(3, 1000.0 * (1.0 - ground));
      return oracle::listing_9_14(image, share).at(1, 1) - image.at(1, 1);
    }
    const TerrainMap incoming{3, 3, std::vector<double>(9, 1000.0)};
    TerrainMap thrown{3, 3, std::vector<double>(9, ground)};
    thrown.values[4] = 0.0;  // the middle keeps all that it gets
    return corrected_site_model()->absorbed(incoming, thrown, share, 1).at(1, 1) - 1000.0;
  };
  for (const bool as_printed : {true, false}) {
    const std::string name = as_printed ? "handed-on/printed/" : "handed-on/corrected/";
    context.record(name + "snow", handed_on(0.84, as_printed), "kcal/m2");
    context.record(name + "dirt", handed_on(0.25, as_printed), "kcal/m2");
    context.record(name + "black", handed_on(0.0, as_printed), "kcal/m2");
  }
}

void run(ExperimentContext& context) {
  record_stencil(context);
  record_order(context);
  record_even_ground(context);
  record_gain(context);
  record_brightness(context);
}

}  // namespace

extern const ExperimentDescriptor reflection;
constinit const ExperimentDescriptor reflection{
    .id = "lesser2019/reflection",
    .question = "What does a pixel get from its neighbours?",
    .source = "[Lesser2019] sec. 8.2.1, 9.2.5, listing 9.14",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
