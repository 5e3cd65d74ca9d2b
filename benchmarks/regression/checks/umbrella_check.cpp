// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/umbrella_check.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "benchmarks/regression/checks/straight_stems.hpp"
#include "reference/oracles/lintermann1997_placement.hpp"

namespace phytobench {

namespace {

constexpr double hair_rounding = 1e-12;
constexpr double degree = std::numbers::pi / 180.0;

std::string stem_text(const UmbrellaPlant::Stem& stem, const char* name, const char* colour) {
  return fmt::format(
      "[component.{}]\nkind = \"horn\"\nlength = {}\nsegments = {}\ncorners = {}\n"
      "radius_first = {}\nradius_last = {}\ncaps = \"none\"\ncolour = \"{}\"\n",
      name, stem.length, stem.segments, stem.corners, stem.radius_first, stem.radius_last, colour);
}

std::string link_text(const char* from, const char* to) {
  return fmt::format("[[link]]\nfrom = \"{}\"\nto = \"{}\"\n", from, to);
}

/// The angle from one direction to the next about an axis of length 1, in degrees from -180 to 180.
double turn_deg(const Vector3& from, const Vector3& to, const Vector3& axis) {
  const Vector3 a = from - dot(from, axis) * axis, b = to - dot(to, axis) * axis;
  return std::atan2(dot(cross(a, b), axis), dot(a, b)) / degree;
}

/// Whether both are the same turn, in whichever sense `sense` says (1 or -1).
bool is_turn(double found_deg, double expected_deg, double sense) {
  return std::abs(std::remainder(found_deg - sense * expected_deg, 360.0)) <= 1e-9;
}

class UmbrellaCheck {
 public:
  UmbrellaCheck(const UmbrellaPlant& plant, const BuiltPlant& built)
      : plant_(plant),
        built_(built),
        n_(static_cast<std::size_t>(plant.umbrellas)),
        per_(static_cast<std::size_t>(plant.hairs)) {}

  std::string run() const {
    const std::size_t instances = 1 + 2 * n_ + n_ * per_;
    if (built_.instance_count != instances)
      return fmt::format("{} instances instead of {}", built_.instance_count, instances);
    if (built_.parts.size() != 2) return fmt::format("{} parts", built_.parts.size());
    const StraightStems stalks(built_.parts[0].mesh, plant_.stalk, n_);
    const StraightStems hairs(built_.parts[1].mesh, plant_.hair, n_ * per_);
    for (const StraightStems* stems : {&stalks, &hairs})
      if (const std::string wrong = stems->objection(); !wrong.empty()) return wrong;
    for (std::size_t i = 0; i < n_; ++i)
      if (const std::string wrong = at_umbrella(i, stalks, hairs); !wrong.empty())
        return fmt::format("umbrella {}: {}", i, wrong);
    return "";
  }

 private:
  std::string at_umbrella(std::size_t i, const StraightStems& stalks,
                          const StraightStems& hairs) const {
    using namespace oracles::lintermann1997;
    const double radius = plant_.ball_radius;
    const Vector3 base = stalks.base(i), out = stalks.direction(i);
    const double height = height_on_cap(static_cast<int>(i), plant_.umbrellas, 0.0, 180.0);
    if (!(std::abs(base.y - radius * height) <= hair_rounding * radius)) return "wrong height";
    if (!(norm(base - radius * out) <= 10.0 * hair_rounding * radius))
      return "does not stand upright";
    const Vector3 up{0.0, 1.0, 0.0};
    const double sense = turn_deg(stalks.base(0), stalks.base(1), up) < 0.0 ? -1.0 : 1.0;
    // 137.5 degrees forward are less than half a turn, so that the sign tells the sense.
    if (i > 0 && !is_turn(turn_deg(stalks.base(i - 1), base, up), golden_angle_deg(), sense))
      return "not a golden angle on";
    return around(i * per_, stalks.tip(i), out, hairs);
  }

  /// Of the hairs that begin with `first`.
  std::string around(std::size_t first, const Vector3& tip, const Vector3& out,
                     const StraightStems& hairs) const {
    const double step = oracles::lintermann1997::hydra_step_deg(plant_.hairs);
    const double cosine = std::cos(plant_.tilt_deg * degree);
    const double sense =
        turn_deg(hairs.direction(first), hairs.direction(first + 1), out) < 0.0 ? -1.0 : 1.0;
    for (std::size_t k = first; k < first + per_; ++k) {
      const Vector3 along = hairs.direction(k);
      if (!(norm(hairs.base(k) - tip) <= 10.0 * hair_rounding)) return "a hair begins elsewhere";
      if (!(std::abs(dot(along, out) - cosine) <= 100.0 * hair_rounding))
        return "a hair's tilt is wrong";
      const Vector3 next = hairs.direction(k + 1 < first + per_ ? k + 1 : first);
      if (!is_turn(turn_deg(along, next, out), step, sense)) return "hairs are not evenly spread";
    }
    return "";
  }

  const UmbrellaPlant& plant_;
  const BuiltPlant& built_;
  std::size_t n_, per_;
};

}  // namespace

std::string UmbrellaPlant::graph() const {
  return fmt::format(
             "[graph]\nroot = \"ball\"\n[component.ball]\nkind = \"phiball\"\ncount = {}\n"
             "radius = {}\n[component.umbrella]\nkind = \"hydra\"\ncount = {}\ntilt = {}\n",
             umbrellas, ball_radius, hairs, tilt_deg) +
         stem_text(stalk, "stalk", "#b9a47c") + stem_text(hair, "hair", "#f6f4ec") +
         link_text("ball", "stalk") + link_text("stalk", "umbrella") +
         link_text("umbrella", "hair");
}

std::string objection_to_umbrellas(const BuiltPlant& built, const UmbrellaPlant& plant) {
  return UmbrellaCheck(plant, built).run();
}

}  // namespace phytobench
