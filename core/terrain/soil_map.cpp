// SPDX-License-Identifier: MIT
#include "core/terrain/soil_map.hpp"

#include <algorithm>
#include <unordered_map>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

[[noreturn]] void refuse_id(const NumberMap& map, std::size_t first, std::span<const Soil> soils,
                            const std::string& name) {
  const std::int16_t id = map.numbers[first];
  const auto count = std::count(map.numbers.begin(), map.numbers.end(), id);
  const auto columns = static_cast<std::size_t>(map.columns);
  std::vector<std::string> known;
  for (const Soil& soil : soils) known.push_back(fmt::format("{} {}", soil.id, soil.name));
  throw InputError(fmt::format(
      "{}: has soil {} at {} places, the first in row {}, column {}, and there is no [[soil]] with "
      "this id ({}); describe it, or change the map",
      name, id, count, first / columns + 1, first % columns + 1, fmt::join(known, ", ")));
}

}  // namespace

std::vector<std::int16_t> soils_of_ids(const NumberMap& map, std::span<const Soil> soils,
                                       const std::string& name) {
  std::unordered_map<int, std::int16_t> index_of{{-1, std::int16_t{-1}}};
  for (std::size_t i = 0; i < soils.size(); ++i)
    index_of.emplace(soils[i].id, static_cast<std::int16_t>(i));
  PHYTOBENCH_EXPECT(index_of.size() == soils.size() + 1);
  std::vector<std::int16_t> kinds(map.numbers.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const auto found = index_of.find(map.numbers[i]);
    if (found == index_of.end()) refuse_id(map, i, soils, name);
    kinds[i] = found->second;
  }
  return kinds;
}

}  // namespace phytobench
