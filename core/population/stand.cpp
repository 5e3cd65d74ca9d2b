// SPDX-License-Identifier: MIT
#include "core/population/stand.hpp"

#include <algorithm>
#include <numeric>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

template <class T>
void keep_only(std::vector<T>& values, const std::vector<std::uint8_t>& is_out) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    if (is_out[i] == 0) values[kept++] = values[i];
  values.resize(kept);
}

template <class T>
void reorder(std::vector<T>& values, const std::vector<std::uint32_t>& order) {
  std::vector<T> ordered(values.size());
  for (std::size_t i = 0; i < order.size(); ++i) ordered[i] = values[order[i]];
  values.swap(ordered);
}

/// Calls what with every array that has one entry for each plant.
template <class What>
void for_each_array(PopulationState& state, const What& what) {
  Stand& stand = state.stand;
  what(stand.x);
  what(stand.y);
  what(stand.stem_radius);
  what(stand.id);
  what(stand.age);
  what(stand.ill_since);
  what(stand.species);
  for (std::vector<float>& growth : state.recent_growth) what(growth);
}

/// Spreads the low 16 bits to the even places.
std::uint32_t spread_bits(std::uint32_t v) {
  v = (v | v << 8) & 0x00FF00FFu;
  v = (v | v << 4) & 0x0F0F0F0Fu;
  v = (v | v << 2) & 0x33333333u;
  return (v | v << 1) & 0x55555555u;
}

/// Places near to each other mostly have near codes (Morton 1966).
std::uint32_t place_code(const Point2& place, const Rectangle& ground) {
  const auto cell = [](double share) {
    return static_cast<std::uint32_t>(std::clamp(share, 0.0, 1.0) * 65535.0);
  };
  return spread_bits(cell((place.x - ground.low.x) / ground.width())) |
         spread_bits(cell((place.y - ground.low.y) / ground.height())) << 1;
}

}  // namespace

void reserve_plants(PopulationState& state, std::size_t count) {
  for_each_array(state, [count](auto& values) { values.reserve(count); });
}

void add_plant(PopulationState& state, const Point2& place, double stem_radius,
               SpeciesIndex species) {
  PHYTOBENCH_EXPECT(species < state.born.size());
  Stand& stand = state.stand;
  stand.x.push_back(place.x);
  stand.y.push_back(place.y);
  stand.stem_radius.push_back(stem_radius);
  stand.id.push_back(state.next_id++);
  stand.age.push_back(0);
  stand.ill_since.push_back(healthy);
  stand.species.push_back(species);
  for (std::vector<float>& growth : state.recent_growth) growth.push_back(0.0f);
  ++state.born[species];
}

void remove_plants(PopulationState& state, const std::vector<std::uint8_t>& is_out) {
  PHYTOBENCH_EXPECT(is_out.size() == state.stand.size());
  for (std::size_t i = 0; i < is_out.size(); ++i)
    if (is_out[i] != 0) ++state.died[state.stand.species[i]];
  for_each_array(state, [&](auto& values) { keep_only(values, is_out); });
}

bool order_by_place(PopulationState& state, const Rectangle& ground) {
  const Stand& stand = state.stand;
  std::vector<std::uint32_t> code(stand.size());
  for (std::size_t i = 0; i < code.size(); ++i) code[i] = place_code(stand.place(i), ground);
  const auto before = [&](std::size_t a, std::size_t b) {
    return code[a] != code[b] ? code[a] < code[b] : stand.id[a] < stand.id[b];
  };
  bool is_ordered = true;
  for (std::size_t i = 1; i < code.size() && is_ordered; ++i) is_ordered = before(i - 1, i);
  if (is_ordered) return false;
  std::vector<std::uint32_t> order(stand.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(), before);
  std::vector<std::uint32_t>().swap(code);
  for_each_array(state, [&](auto& values) { reorder(values, order); });
  return true;
}

std::vector<std::size_t> order_of_ids(const Stand& stand) {
  std::vector<std::size_t> order(stand.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return stand.id[a] < stand.id[b]; });
  return order;
}

}  // namespace phytobench
