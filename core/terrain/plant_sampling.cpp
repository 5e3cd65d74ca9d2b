// SPDX-License-Identifier: MIT
#include "core/terrain/plant_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <unordered_map>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

constexpr std::uint64_t dart_stream = 0x7465727261696e31;  // another for every use of a seed
constexpr double square_metres_per_hectare = 1e4;
/// In a row. Then a place is so rare that it takes longer to find than to do without.
constexpr std::uint64_t most_misses = 20'000;

double counted_chance(double chance) {
  return chance > 0.0 ? chance : 0.0;  // NaN is nothing, too
}

/// Finds species and cell of a dart: each as likely as its chance says. Holds a number for each row
/// only; the row itself is gone through for every dart.
class ChanceDraw {
 public:
  explicit ChanceDraw(std::span<const SampledSpecies> species) : species_(species) {
    for (const SampledSpecies& one : species)
      for (int row = 0; row < one.chance->rows; ++row) {
        for (int column = 0; column < one.chance->columns; ++column)
          total_ += counted_chance(one.chance->at(column, row));
        up_to_.push_back(total_);
      }
  }

  /// Cells with chance 1 that all chances together make.
  double total() const { return total_; }

  struct Cell {
    std::uint32_t species = 0;
    int column = 0;
    int row = 0;
  };
  /// `unit` in [0, 1); total() > 0.
  Cell at(double unit) const {
    const double wanted = unit * total_;
    const auto found = std::upper_bound(up_to_.begin(), up_to_.end() - 1, wanted);
    const auto line = static_cast<std::size_t>(found - up_to_.begin());
    const auto rows = static_cast<std::size_t>(species_[0].chance->rows);
    Cell cell{.species = static_cast<std::uint32_t>(line / rows),
              .row = static_cast<int>(line % rows)};
    cell.column = column_of(cell, wanted, line == 0 ? 0.0 : up_to_[line - 1]);
    return cell;
  }

 private:
  /// The last one with a chance, should rounding lead beyond it.
  int column_of(const Cell& cell, double wanted, double before) const {
    const TerrainMap& map = *species_[cell.species].chance;
    int last = 0;
    double sum = before;
    for (int column = 0; column < map.columns; ++column) {
      const double chance = counted_chance(map.at(column, cell.row));
      if (chance == 0.0) continue;
      last = column;
      sum += chance;
      if (sum > wanted) break;
    }
    return last;
  }

  std::span<const SampledSpecies> species_;
  std::vector<double> up_to_;  ///< sums of chances, species after species, row after row
  double total_ = 0.0;
};

/// The plants of one species, found by where they stand.
class PlantGrid {
 public:
  explicit PlantGrid(double cell) : cell_(cell) {}

  void add(double east, double south) {
    cells_[key(cell_of(east), cell_of(south))].push_back({east, south});
  }

  bool has_within(double east, double south, double distance) const {
    const std::int64_t first_column = cell_of(east - distance);
    const std::int64_t last_column = cell_of(east + distance);
    for (std::int64_t row = cell_of(south - distance); row <= cell_of(south + distance); ++row)
      for (std::int64_t column = first_column; column <= last_column; ++column) {
        const auto found = cells_.find(key(column, row));
        if (found == cells_.end()) continue;
        for (const Place& place : found->second) {
          const double dx = place.east - east, dy = place.south - south;
          if (dx * dx + dy * dy < distance * distance) return true;
        }
      }
    return false;
  }

 private:
  struct Place {
    double east, south;
  };
  std::int64_t cell_of(double at) const {
    return static_cast<std::int64_t>(std::floor(at / cell_));
  }
  static std::uint64_t key(std::int64_t column, std::int64_t row) {
    return static_cast<std::uint64_t>(row) << 32 ^
           (static_cast<std::uint64_t>(column) & 0xffffffff);
  }

  double cell_;
  std::unordered_map<std::uint64_t, std::vector<Place>> cells_;
};

class DartThrower {
 public:
  DartThrower(const HeightField& heights, std::span<const SampledSpecies> species,
              std::uint64_t seed)
      : heights_(heights), species_(species), draw_(species), darts_(seed, dart_stream) {
    double widest = 0.0;
    for (const SampledSpecies& one : species) widest = std::max(widest, one.spacing);
    // Cells far smaller than what is asked for would be very many to look through.
    for (const SampledSpecies& one : species)
      grids_.emplace_back(std::max({one.spacing, widest / 64.0, 1e-3}));
  }

  double total_chance() const { return draw_.total(); }
  const std::vector<SampledPlant>& plants() const { return plants_; }

  /// Whether the dart stays.
  bool threw() {
    const ChanceDraw::Cell cell = draw_.at(darts_.next_unit());
    SampledPlant plant{.species = cell.species};
    plant.east = (cell.column + darts_.next_unit()) * heights_.cell_width();
    plant.south = (cell.row + darts_.next_unit()) * heights_.cell_depth();
    for (std::size_t other = 0; other < species_.size(); ++other) {
      const double distance = 0.5 * (species_[plant.species].spacing + species_[other].spacing);
      if (distance > 0.0 && grids_[other].has_within(plant.east, plant.south, distance))
        return false;
    }
    grids_[plant.species].add(plant.east, plant.south);
    plants_.push_back(plant);
    return true;
  }

 private:
  const HeightField& heights_;
  std::span<const SampledSpecies> species_;
  ChanceDraw draw_;
  CounterStream darts_;
  std::vector<PlantGrid> grids_;
  std::vector<SampledPlant> plants_;
};

void throw_until(DartThrower& darts, double number) {
  std::uint64_t misses = 0;
  while (static_cast<double>(darts.plants().size()) < number && misses < most_misses)
    misses = darts.threw() ? 0 : misses + 1;
}

double number_on_hectares(double total_chance, const HeightField& heights, double per_hectare) {
  const double hectares =
      total_chance * heights.cell_width() * heights.cell_depth() / square_metres_per_hectare;
  return std::round(per_hectare * hectares);
}

void throw_on_hectares(DartThrower& darts, const HeightField& heights, double per_hectare) {
  const double wanted = number_on_hectares(darts.total_chance(), heights, per_hectare);
  if (wanted > most_sampled_plants)
    throw InputError(fmt::format(
        "{:g} plants for each hectare are {:g} on this map; ask for fewer (at most {:g})",
        per_hectare, wanted, most_sampled_plants));
  for (auto left = static_cast<std::uint64_t>(wanted); left > 0; --left) darts.threw();
}

}  // namespace

std::vector<SampledPlant> sampled_plants(const HeightField& heights,
                                         std::span<const SampledSpecies> species,
                                         const PlantSampling& sampling) {
  PHYTOBENCH_EXPECT(!species.empty() && sampling.number >= 0.0 &&
                    sampling.number <= most_sampled_plants);
  for (const SampledSpecies& one : species)
    PHYTOBENCH_EXPECT(one.chance != nullptr && one.chance->columns == heights.columns() &&
                      one.chance->rows == heights.rows() && one.spacing >= 0.0);
  DartThrower darts(heights, species, sampling.seed);
  if (darts.total_chance() == 0.0) return {};
  if (sampling.is_per_hectare)
    throw_on_hectares(darts, heights, sampling.number);
  else
    throw_until(darts, sampling.number);
  return darts.plants();
}

double sampled_number(const HeightField& heights, std::span<const SampledSpecies> species,
                      const PlantSampling& sampling) {
  if (!sampling.is_per_hectare) return sampling.number;
  return number_on_hectares(ChanceDraw(species).total(), heights, sampling.number);
}

std::string sampled_plants_csv(const HeightField& heights, std::span<const SampledPlant> plants,
                               std::span<const PlantColumns> species) {
  const double north = heights.rows() * heights.cell_depth();
  std::string csv = "x,y,radius,species\n";
  for (const SampledPlant& plant : plants) {
    PHYTOBENCH_EXPECT(plant.species < species.size());
    const PlantColumns& columns = species[plant.species];
    fmt::format_to(std::back_inserter(csv), "{},{},{},{}\n", plant.east, north - plant.south,
                   columns.stem_radius, columns.name);
  }
  return csv;
}

}  // namespace phytobench
