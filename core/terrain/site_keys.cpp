// SPDX-License-Identifier: MIT
// Keys of everything but heights and entries.
#include "core/terrain/site_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace phytobench {

namespace {

using Keys = std::vector<SiteKey>;
using Values = SiteFileValues;

constexpr NumberRange elevation_range{.high = 90.0};
constexpr SiteKeyCondition for_hourly{"sun.kind = \"hourly\"",
                                      [](const SiteDescription& d) { return !d.sun.is_solar; }};
constexpr SiteKeyCondition for_solar{"sun.kind = \"solar\"",
                                     [](const SiteDescription& d) { return d.sun.is_solar; }};

Keys top_keys() {
  return {
      {"entries", "-", "[\"lesser2019\", \"assumed\"]",
       "where biomes, soils and species come from that are not described below: files of entries "
       "that come with the program (phytobench list site-entries), or names of files",
       "phytobench",
       SiteNames{"names",
                 [](Values& v) -> std::vector<std::string>& { return v.site.entry_files; }}},
      {"grow", "-", "[\"Appletree\"]", "the species to map; all of the entries without it",
       "phytobench",
       SiteNames{"names of species",
                 [](Values& v) -> std::vector<std::string>& { return v.site.grow; }},
       false, true},
  };
}

Keys ground_keys() {
  return {
      {"ground.posterise", "-", "[\"Dirt\", \"Stone\"]",
       "soils of equal bands of height, from the lowest", "[Lesser2019] sec. 10.4",
       SiteNames{"names of soils",
                 [](Values& v) -> std::vector<std::string>& { return v.site.ground.posterise; }}},
      {"ground.soil", "-", "\"Dirt\"", "one soil everywhere, instead of ground.posterise",
       "phytobench",
       SiteText{"a name of a soil", [](Values& v) -> std::string& { return v.site.ground.soil; }},
       false, true},
      {"ground.file", "-", "\"soils.png\"",
       "map of soil ids, instead of ground.posterise; as large as the map of heights, and of the "
       "same ground",
       "[Lesser2019] listing 9.5",
       SiteFileName{[](Values& v) -> std::string& { return v.site.ground.file; }}, false, true},
      {"ground.max_depth", "cm", "150.0", "depth of the soil where the ground is level",
       "[Lesser2019] listing 9.5",
       SiteNumber{{.low = 1.0, .high = 1e4},
                  [](Values& v, double x) { v.site.ground.max_depth = centimetres(x); }}},
      {"climate.biome", "-", "\"PolarZone\"", "the biome whose air and rain this is",
       "[Lesser2019] sec. 8.1.3",
       SiteText{"a name of a biome", [](Values& v) -> std::string& { return v.site.biome; }}},
      {"climate.neighbour_share", "share", "0.1",
       "of the light that a place throws back, what its eight neighbours get",
       "[Lesser2019] sec. 8.2.1, fig. 10.4",
       SiteNumber{{.high = 1.0}, [](Values& v, double x) { v.site.neighbour_share = x; }}},
  };
}

Keys hourly_keys() {
  return {
      {"sun.kind", "-", "\"hourly\"",
       "the thesis' path, azimuth and elevation in equal steps, or the true one of a day and place",
       "[Lesser2019] sec. 9.2.3",
       SiteChoice{{"hourly", "solar"},
                  [](Values& v, std::size_t i) { v.site.sun.is_solar = i == 1; }}},
      {"sun.hours", "h", "13",
       "hours of daylight; of the true path into how many equal parts the day is cut, and without "
       "this key as many as it has hours",
       "[Lesser2019] fig. 10.4",
       SiteNumber{{.low = 1.0, .high = 240.0, .whole = true},
                  [](Values& v, double x) {
                    v.site.sun.hourly.hours = static_cast<int>(x);
                    v.site.sun.hours = static_cast<int>(x);
                  }}},
      {"sun.start_elevation", "degrees", "0.0", "elevation in the first and the last hour",
       "[Lesser2019] fig. 10.4",
       SiteNumber{elevation_range,
                  [](Values& v, double x) { v.site.sun.hourly.start_elevation = x; }},
       false, false, for_hourly},
      {"sun.start_azimuth", "degrees", "0.0",
       "azimuth in the first hour, from east over south; the path covers 180",
       "[Lesser2019] fig. 10.4",
       SiteNumber{{.high = 360.0},
                  [](Values& v, double x) { v.site.sun.hourly.start_azimuth = x; }},
       false, false, for_hourly},
      {"sun.max_elevation", "degrees", "90.0", "elevation at noon", "[Lesser2019] sec. 9.2.3",
       SiteNumber{elevation_range,
                  [](Values& v, double x) { v.site.sun.hourly.max_elevation = x; }},
       false, false, for_hourly},
      {"sun.even_hours", "-", "\"plateau\"",
       "with an even number of hours: both hours around noon the greatest elevation, or the same "
       "change every hour",
       "[Lesser2019] erratum E03",
       SiteChoice{{"plateau", "tent"},
                  [](Values& v, std::size_t i) {
                    v.site.sun.hourly.even_hours = static_cast<EvenHours>(i);
                  }},
       false, false, for_hourly},
  };
}

Keys solar_keys() {
  return {
      {"sun.latitude", "degrees", "47.5", "north is positive", "phytobench",
       SiteNumber{{.low = -90.0, .high = 90.0},
                  [](Values& v, double x) { v.site.sun.day.latitude = x; }},
       false, true, for_solar},
      {"sun.longitude", "degrees", "12.8", "east is positive", "phytobench",
       SiteNumber{{.low = -180.0, .high = 180.0},
                  [](Values& v, double x) { v.site.sun.day.longitude = x; }},
       false, true, for_solar},
      {"sun.date", "-", "2019-06-21", "the day", "phytobench", SiteDate{}, false, true, for_solar},
  };
}

template <class... Parts>
Keys joined_site_keys(Parts... parts) {
  Keys keys;
  (keys.insert(keys.end(), parts.begin(), parts.end()), ...);
  return keys;
}

}  // namespace

std::span<const SiteKey> site_keys() {
  static const Keys keys =
      joined_site_keys(top_keys(), site_height_keys(), ground_keys(), hourly_keys(), solar_keys(),
                       site_choice_keys(), site_entry_keys());
  return keys;
}

bool is_list_of_site(std::string_view section) {
  return section == "biome" || section == "soil" || section == "species";
}

std::string allowed_values(const SiteKey& key) {
  return std::visit(
      Overloaded{[](const SiteNumber& kind) { return "a number " + allowed(kind.range); },
                 [](const SiteChoice& kind) {
                   return fmt::format("one of \"{}\"", fmt::join(kind.words, "\", \""));
                 },
                 [](const SiteSwitch&) { return std::string("true or false"); },
                 [](const SiteText& kind) { return std::string(kind.allowed); },
                 [](const SiteFileName&) { return std::string("a file name in quotes"); },
                 [](const SiteNames& kind) {
                   return fmt::format("{}, as in [\"a\", \"b\"]", kind.allowed);
                 },
                 [](const SiteDate&) { return std::string("a date, as in 2019-06-21"); }},
      key.kind);
}

}  // namespace phytobench
