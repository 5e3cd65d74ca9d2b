// SPDX-License-Identifier: MIT
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "reference/errata_oracles.hpp"
#include "reference/oracles/lesser2019_growth.hpp"

namespace phytobench {

namespace {

namespace lesser = oracles::lesser2019;

/// The name of listing 9.10, of one site.
std::string name_of_map(double hours) {
  return "site_" + std::to_string(static_cast<int>(hours)) + "daylight_hours_insolation_image.png";
}

}  // namespace

OracleTable lesser2019_file_oracles() {
  return {
      {"lesser2019/number-after-a-file",
       {1, [](const Arguments& a) { return lesser::reloaded(a[0]); },
        [](const Arguments& a) { return lesser::reloaded_rounded(a[0]); }}},
      {"lesser2019/soil-depth-after-a-file",
       {1, [](const Arguments& a) { return lesser::reloaded(a[0]); },
        [](const Arguments& a) { return lesser::reloaded_without_wrap(a[0]); }}},
      // How often a species is saved; entries, in a file that is appended to and in one that has
      // each name once.
      {"lesser2019/entries-of-a-name",
       {1,
        [](const Arguments& a) {
          std::vector<std::string> names;
          for (int k = 0; k < static_cast<int>(a[0]); ++k) names.emplace_back("Appletree");
          return static_cast<double>(names.size());
        },
        [](const Arguments& a) {
          std::set<std::string> names;
          for (int k = 0; k < static_cast<int>(a[0]); ++k) names.insert("Appletree");
          return static_cast<double>(names.size());
        }}},
      // Hours and greatest elevation of two maps; how many names they have, and how many they need.
      {"lesser2019/names-of-two-maps",
       {4,
        [](const Arguments& a) {
          return static_cast<double>(std::set{name_of_map(a[0]), name_of_map(a[2])}.size());
        },
        [](const Arguments& a) {
          return static_cast<double>(std::set{std::pair{a[0], a[1]}, std::pair{a[2], a[3]}}.size());
        }}},
      // Columns and rows of an image that is at least as wide as high.
      {"lesser2019/pixels-loaded",
       {2, [](const Arguments& a) { return a[1] * a[1]; },
        [](const Arguments& a) { return a[0] * a[1]; }}},
  };
}

}  // namespace phytobench
