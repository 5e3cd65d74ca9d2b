// SPDX-License-Identifier: MIT
// What all sweeps have in common: rows one after the other from the side of the sun, and lines
// towards the sun that move along with them.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/terrain/height_field.hpp"
#include "core/terrain/shadow/lit_maps.hpp"
#include "core/terrain/shadow/shadow_engine.hpp"
#include "core/terrain/shadow/sweep_rows.hpp"
#include "core/terrain/sun/sun_direction.hpp"

namespace phytobench {

/// A field with its rows as they are, and once more with rows and columns exchanged, for suns that
/// are nearer to east or west than to south or north: a line then meets every row of one of them,
/// and at most one column in between.
class SweptField {
 public:
  /// `field` must outlive this.
  SweptField(const HeightField& field, std::span<const SunDirection> suns);

  const HeightField& field() const { return field_; }
  const HeightField& sideways() const { return sideways_; }  ///< empty if no sun needs it

 private:
  const HeightField& field_;
  HeightField sideways_;
};

/// Whether lines towards that sun meet more columns than rows.
bool is_sideways(const HeightField& field, const SunDirection& sun);

/// The sun as seen where rows and columns are exchanged.
inline SunDirection sideways(const SunDirection& sun) {
  return {sun.south, sun.east, sun.up};
}

/// The rows of a field from the side of the sun, which lies nearer to the columns' direction. A
/// line towards the sun that meets row 0 of them at column q is at column q - lag(row) in later
/// ones.
class SweepRows {
 public:
  SweepRows(const HeightField& field, const SunDirection& sun);

  int count() const { return field_->rows(); }
  /// The row that comes after `swept` others: its place in the field, and what is in it.
  int place(int swept) const { return goes_south_ ? field_->rows() - 1 - swept : swept; }
  SweepRow row(int swept) const;
  double lag(int swept) const { return swept * lag_per_row_; }
  /// How many lines there are, and how much is to be added to column + lag for their number.
  std::size_t lines() const { return lines_; }
  std::ptrdiff_t first_line() const { return first_line_; }
  /// More than all that may be rounded in a key.
  double rounding() const;

 private:
  const HeightField* field_;
  bool goes_south_;
  double lag_per_row_;
  double rise_per_row_;
  std::vector<double> column_rise_;
  std::size_t lines_;
  std::ptrdiff_t first_line_;
};

/// A position's map with rows and columns exchanged, bit by bit. `to` has the shape for it.
void transpose_bits(const LitMaps& from, std::size_t from_position, LitMaps& to,
                    std::size_t to_position);

/// Runs fill(field, sun, map, position) on the field, or on the exchanged one; the map is that of
/// the field in the end. fill() gets a map that is dark.
template <class Fill>
auto sweep_position(const SweptField& swept, const SunDirection& sun, LitMaps& lit,
                    std::size_t position, const Fill& fill) {
  if (!is_sideways(swept.field(), sun)) return fill(swept.field(), sun, lit, position);
  LitMaps exchanged(lit.rows(), lit.columns(), 1);
  const auto result = fill(swept.sideways(), sideways(sun), exchanged, std::size_t{0});
  transpose_bits(exchanged, 0, lit, position);
  return result;
}

/// An engine that is one function of a field whose rows lie towards the sun, and keeps nothing.
template <ShadowWork (*fill)(const HeightField&, const SunDirection&, LitMaps&, std::size_t)>
std::unique_ptr<ShadowEngine> swept_engine() {
  struct Engine final : ShadowEngine {
    ShadowWork cast(const HeightField& field, std::span<const SunDirection> suns,
                    const ShadowSetup& setup, LitMaps& lit) override {
      const SweptField swept(field, suns);
      return cast_each(field, suns, setup.threads, lit,
                       [&](const SunDirection& sun, std::size_t position) {
                         return sweep_position(swept, sun, lit, position, fill);
                       });
    }
  };
  return std::make_unique<Engine>();
}

}  // namespace phytobench
