// SPDX-License-Identifier: MIT
// Sec. 9.1.3, 10.2, listing 9.8: results that are saved as grey images and loaded again.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "reference/oracles/lesser2019_energy.hpp"
#include "reference/oracles/lesser2019_growth.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

/// Digits after the point that a number shows which is loaded again.
std::int64_t decimals_of(double value) {
  std::string text = fmt::format("{:.9f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  return static_cast<std::int64_t>(text.size() - text.find('.') - 1);
}

void record_decimals(ExperimentContext& context) {
  std::int64_t most = 0;
  for (int i = 0; i <= 20000; ++i)
    most = std::max(most, decimals_of(oracle::reloaded(i / 10000.0)));
  context.record("decimals", most, "digits");
  context.record("decimals/of-1.2345", oracle::reloaded(1.2345));
  context.record("decimals/1.001", oracle::reloaded(1.001));
}

/// Of the 65536 codes of a pixel, those that become another one when an image is loaded and saved.
void record_codes(ExperimentContext& context) {
  std::int64_t changed = 0, changed_again = 0, by_more_than_one = 0, changed_if_rounded = 0;
  std::int64_t first = 0;
  for (int i = 0; i < 65536; ++i) {
    const auto code = static_cast<std::uint16_t>(i);
    const std::uint16_t once = oracle::saved_pixel(oracle::loaded_pixel(code));
    changed += once != code;
    if (once != code && first == 0) first = i;
    by_more_than_one += once != code && once + 1 != code;
    changed_again += oracle::saved_pixel(oracle::loaded_pixel(once)) != once;
    changed_if_rounded += std::llround(oracle::loaded_pixel(code) * 1000.0) != i;
  }
  context.record("codes", std::int64_t{65536}, "codes");
  context.record("changed-codes", changed, "codes");
  context.record("changed-codes/first", first);
  context.record("changed-codes/by-more-than-one", by_more_than_one, "codes");
  context.record("changed-codes/second-time", changed_again, "codes");
  context.record("changed-codes/if-rounded", changed_if_rounded, "codes");
}

/// Depths are centimetres up to 150, water some litres, chances at most 1.
void record_maps(ExperimentContext& context) {
  context.record("depth-150", oracle::reloaded(150.0), "cm");
  context.record("depth-150/without-wrap", oracle::reloaded_without_wrap(150.0), "cm");
  context.record("depth-80", oracle::reloaded(80.0), "cm");
  context.record("depth/largest", 65535 / 1000.0, "cm");
  context.record("depth/largest-chance-of-an-appletree",
                 oracle::depth_chance(80.0, 65535 / 1000.0, oracle::DepthRule::saturating));
  double depth_off = 0.0, other_off = 0.0;
  for (int i = 0; i <= 1500; ++i) {
    depth_off = std::max(depth_off, std::abs(oracle::reloaded(i / 10.0) - i / 10.0));
    for (const double value : {i / 1500.0, i / 1500.0 * 2.5})
      other_off = std::max(other_off, std::abs(oracle::reloaded(value) - value));
  }
  context.record("depth/farthest-off", depth_off, "cm");
  context.record("water-and-chance/farthest-off", other_off);
}

/// Listing 9.8, lines 2 to 9, for an image of fractions: its rows as loaded.
std::vector<std::vector<double>> loaded_rows(const std::vector<std::vector<std::uint16_t>>& image) {
  const std::size_t size = image.size();
  std::vector new_image(size, std::vector(size, 0.0));
  for (std::size_t y = 0; y < size; ++y)
    for (std::size_t x = 0; x < size; ++x)
      new_image[x][y] = oracle::loaded_pixel(image.at(x).at(y));
  return new_image;
}

/// The listing takes the number of rows for that of columns: of an image with more columns the rest
/// is not loaded. Every pixel has another number, none of them 0.
void record_oblong(ExperimentContext& context) {
  std::vector image(3, std::vector<std::uint16_t>(5));
  std::uint16_t number = 0;
  for (auto& row : image)
    for (std::uint16_t& pixel : row) pixel = ++number;
  std::set<double> loaded;
  for (const auto& row : loaded_rows(image)) loaded.insert(row.begin(), row.end());
  context.record("oblong/pixels", std::int64_t{number}, "pixels");
  context.record("oblong/loaded", whole(loaded.size() - loaded.count(0.0)), "pixels");
}

/// Listing 9.10.
std::string file_name(const HourlyPath& path) {
  return fmt::format("Map/Map_{}daylight_hours_insolation_image.png", path.hours);
}

/// What an insolation map is made from, and its file's name: settings whose change makes another
/// map under the same name.
void record_reuse(ExperimentContext& context) {
  const HeightField field = fractal_field(32, thesis_cell, 100.0, context.seed() + 5);
  const HourlyPath usual{.hours = thesis_hours, .max_elevation = 80.0};
  const auto insolation = [&](const HourlyPath& path, double reflection) {
    oracle::Values energy{32, 32, {}};
    for (const std::uint16_t hours :
         lit_positions(cast_by("printed_march", field, rounded_path(path)).lit))
      energy.value.push_back(hours * oracle::SOLAR_CONSTANT_K_CALORIES_PER_HOUR);
    return oracle::listing_9_14(energy, reflection).value;
  };
  const std::vector<double> before = insolation(usual, 0.1);
  const std::string name = file_name(usual);
  std::int64_t stale = 0;
  const auto try_settings = [&](const char* setting, const HourlyPath& path, double reflection) {
    const bool is_other = insolation(path, reflection) != before;
    stale += is_other && file_name(path) == name;
    context.record(fmt::format("reuse/{}/changes-the-map", setting), std::int64_t{is_other});
  };
  HourlyPath changed = usual;
  changed.start_elevation = 10.0;
  try_settings("start-elevation", changed, 0.1);
  changed = usual;
  changed.start_azimuth = 20.0;
  try_settings("start-azimuth", changed, 0.1);
  changed = usual;
  changed.max_elevation = 40.0;
  try_settings("max-elevation", changed, 0.1);
  try_settings("reflection", usual, 0.2);
  changed = usual;
  changed.hours = 11;
  try_settings("daylight-hours", changed, 0.1);
  context.record("reuse/daylight-hours/changes-the-name", std::int64_t{file_name(changed) != name});
  context.record("reuse/settings-under-one-name", stale, "settings");
}

void run(ExperimentContext& context) {
  record_decimals(context);
  record_codes(context);
  record_maps(context);
  record_oblong(context);
  record_reuse(context);
}

}  // namespace

extern const ExperimentDescriptor image_files;
constinit const ExperimentDescriptor image_files{
    .id = "lesser2019/image-files",
    .question = "Does a map come back from its file as it was?",
    .source = "[Lesser2019] sec. 9.1.3, 10.2, listings 9.8, 9.10",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
