// SPDX-License-Identifier: MIT
// [Lesser2019] listing 9.12 as printed: a ray from the corner of a pixel, which steps to a border
// of columns or rows by the larger remainder, truncates towards zero and compares the pixel it
// finds. Only its traps are guarded: a step of nothing, and a division by zero.
#include <cmath>
#include <limits>

#include "core/terrain/shadow/shadow_engine.hpp"
#include "core/terrain/shadow/traced_rows.hpp"

namespace phytobench::shadow_engines {

namespace {

/// fmod for 0 <= value and 0 < edge, to the last bit, where their quotient fits into 53 bits: the
/// library's takes a step for each of these bits, which was most of the time of a march.
double remainder_of(double value, double edge) {
  // The quotient may have been rounded up to a whole number; both remainders are exact.
  const double whole = std::trunc(value / edge);
  const double remainder = std::fma(-whole, edge, value);
  return remainder < 0.0 ? std::fma(-(whole - 1.0), edge, value) : remainder;
}

enum class End { lit, dark, stuck };

struct March {
  const HeightField& field;
  const SunDirection& sun;
  double highest;

  /// How far the ray goes in this step; NaN where the listing divides by zero.
  double step(double x, double y) const {
    const double width = field.cell_width(), depth = field.cell_depth();
    const double in_x = remainder_of(x, width), in_y = remainder_of(y, depth);
    if (in_x >= in_y && sun.east != 0.0) return std::abs((width - in_x) / sun.east);
    if (sun.south == 0.0) return std::numeric_limits<double>::quiet_NaN();
    return std::abs((depth - in_y) / sun.south);
  }

  End end(int column, int row, ShadowWork& work) const {
    const double from_x = column * field.cell_width(), from_y = row * field.cell_depth();
    const double east_border = field.columns() * field.cell_width();
    const double south_border = field.rows() * field.cell_depth();
    double x = from_x, y = from_y, z = field.at(column, row), gone = 0.0;
    while (x >= 0.0 && x < east_border && y >= 0.0 && y < south_border && z < highest) {
      const double next = gone + step(x, y);
      if (!(next > gone)) return End::stuck;
      gone = next;
      x = from_x + gone * sun.east;
      y = from_y + gone * sun.south;
      z = field.at(column, row) + gone * sun.up;
      // A conversion to a whole number cuts off: what is less than a pixel outside is inside.
      const double met_column = std::trunc(x / field.cell_width());
      const double met_row = std::trunc(y / field.cell_depth());
      if (met_column < 0.0 || met_row < 0.0 || met_column > field.columns() - 1 ||
          met_row > field.rows() - 1)
        break;
      ++work.samples;
      if (field.at(static_cast<int>(met_column), static_cast<int>(met_row)) > z) return End::dark;
    }
    return End::lit;
  }
};

ShadowWork cast(const HeightField& field, const SunDirection& sun, const ShadowSetup& setup,
                std::size_t position, LitMaps& lit) {
  const March march{field, sun, height_range(field).highest};
  return trace_rows(field.rows(), setup.threads, [&](int row, ShadowWork& work) {
    for (int column = 0; column < field.columns(); ++column) {
      const End end = march.end(column, row, work);
      work.stuck += end == End::stuck;
      // A ray that never ends has not been stopped by anything.
      if (end != End::dark) lit.set_lit(position, column, row);
    }
    work.rays += static_cast<std::uint64_t>(field.columns());
  });
}

}  // namespace

extern const ShadowEngineDescriptor printed_march;
constinit const ShadowEngineDescriptor printed_march{
    .name = "printed_march",
    .summary = "Steps a ray as printed, which passes over cells that it crosses.",
    .source = "[Lesser2019] listing 9.12",
    .exact = false,
    .create = shadow_engine_from<cast>,
};

}  // namespace phytobench::shadow_engines
