// SPDX-License-Identifier: MIT
// How a turtle stands and turns: in the plane with a table of headings, in the plane by any angles,
// and in space. interpret() takes the first that is enough for a system.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/contract/check.hpp"
#include "core/lsystem/drawing.hpp"
#include "core/lsystem/turtle_commands.hpp"

namespace phytobench {

/// plane_direction() that remembers: words turn by few angles, and often.
class DirectionCache {
 public:
  PlaneDirection operator()(double degrees) {
    const auto bits = std::bit_cast<std::uint64_t>(degrees);
    Entry& entry = entries_[(bits * 0x9e3779b97f4a7c15u) >> 56];
    if (entry.bits != bits) [[unlikely]]
      entry = {bits, plane_direction(degrees)};
    return entry.direction;
  }

 private:
  struct Entry {
    std::uint64_t bits = 0;  // of +0 degrees
    PlaneDirection direction{1.0, 0.0};
  };
  std::array<Entry, 256> entries_;
};

/// Frame of a turtle that looks there in the plane.
inline TurtleFrame plane_frame(const PlaneDirection& heading) {
  return {{heading.x, heading.y, 0.0}, {0.0 - heading.y, heading.x, 0.0}, {0.0, 0.0, 1.0}};
}

/// In the plane, all turns by the same angle or by 180 degrees, of which some number makes a full
/// turn: the heading is a number, and turning is counting, so that no turn ever rounds.
class PlaneTable {
 public:
  static constexpr bool planar = true;
  struct Pose {
    double x = 0.0;
    double y = 0.0;
    std::uint32_t heading = 0;  ///< < number of headings; 0 is the first
  };

  /// Sets `headings` of the commands. None if the angle does not divide any small number of full
  /// turns, or if turns have parameters.
  static std::optional<PlaneTable> of(const TurtleSettings& turtle, TurtleCommands& commands);

  Pose start() const { return {}; }
  void turn(Pose& pose, const TurtleCommand& command, const double* /*parameters*/) const {
    pose.heading += command.headings;
    if (pose.heading >= count_) pose.heading -= count_;
  }
  void turn_back(Pose& pose) const {
    pose.heading += count_ / 2;
    if (pose.heading >= count_) pose.heading -= count_;
  }
  void move(Pose& pose, double length) const {
    const PlaneDirection& direction = directions_[pose.heading];
    pose.x += length * direction.x;
    pose.y += length * direction.y;
  }
  Vector3 position(const Pose& pose) const { return {pose.x, pose.y, 0.0}; }
  TurtleFrame frame(const Pose& pose) const { return plane_frame(directions_[pose.heading]); }

 private:
  std::uint32_t count_ = 0;  // even
  std::vector<PlaneDirection> directions_;
};

/// In the plane by any angles. Headings are whole numbers of 2^-54 degrees, to which angles are
/// rounded, if they are smaller than a quarter of a degree: turns add up exactly.
class PlaneAngle {
 public:
  static constexpr bool planar = true;
  struct Pose {
    double x = 0.0;
    double y = 0.0;
    std::int64_t heading = 0;  ///< in [-180, 180) degrees
    PlaneDirection direction{1.0, 0.0};
  };

  explicit PlaneAngle(const TurtleSettings& turtle) : start_(turtle.start) {}

  Pose start() {
    Pose pose;
    turn_by(pose, start_ == TurtleStart::upwards ? 90.0 : 0.0);
    return pose;
  }
  void turn(Pose& pose, const TurtleCommand& command, const double* parameters) {
    turn_by(pose, command.value(parameters));
  }
  void turn_back(Pose& pose) { turn_by(pose, 180.0); }
  void move(Pose& pose, double length) const {
    pose.x += length * pose.direction.x;
    pose.y += length * pose.direction.y;
  }
  Vector3 position(const Pose& pose) const { return {pose.x, pose.y, 0.0}; }
  TurtleFrame frame(const Pose& pose) const { return plane_frame(pose.direction); }

 private:
  static constexpr std::int64_t half_turn = std::int64_t{180} << 54;

  void turn_by(Pose& pose, double degrees) {
    if (!(std::abs(degrees) <= 180.0)) {
      PHYTOBENCH_EXPECT(std::isfinite(degrees));
      degrees = std::remainder(degrees, 360.0);
    }
    pose.heading += std::llrint(degrees * 0x1p54);
    if (pose.heading >= half_turn) pose.heading -= 2 * half_turn;
    if (pose.heading < -half_turn) pose.heading += 2 * half_turn;
    pose.direction = directions_(static_cast<double>(pose.heading) * 0x1p-54);
  }

  TurtleStart start_;
  DirectionCache directions_;
};

/// In space: [Liebemann2017] eq. 2.7 to 2.16, columns H, L, U.
class SpaceFrame {
 public:
  static constexpr bool planar = false;
  struct Pose {
    Vector3 position;
    TurtleFrame frame;
    std::uint32_t turns = 0;  ///< part of the pose, so that ] gives back all that follows, too
  };

  explicit SpaceFrame(const TurtleSettings& turtle) : start_(turtle.start) {}

  Pose start() const;
  void turn(Pose& pose, const TurtleCommand& command, const double* parameters) {
    rotate(pose, pose.frame.heading, pose.frame.left, command.value(parameters));
  }
  void pitch(Pose& pose, const TurtleCommand& command, const double* parameters) {
    rotate(pose, pose.frame.up, pose.frame.heading, command.value(parameters));
  }
  void roll(Pose& pose, const TurtleCommand& command, const double* parameters) {
    rotate(pose, pose.frame.up, pose.frame.left, command.value(parameters));
  }
  void turn_back(Pose& pose) const {
    pose.frame.heading = Vector3{} - pose.frame.heading;
    pose.frame.left = Vector3{} - pose.frame.left;
  }
  /// L = V x H and U = H x L for the vertical V = +y; nothing if the turtle looks along it.
  void level(Pose& pose) const;
  void move(Pose& pose, double length) const {
    pose.position = pose.position + length * pose.frame.heading;
  }
  Vector3 position(const Pose& pose) const { return pose.position; }
  TurtleFrame frame(const Pose& pose) const { return pose.frame; }

 private:
  /// Turns a towards b, and b away from a.
  void rotate(Pose& pose, Vector3& a, Vector3& b, double degrees) {
    const PlaneDirection by = directions_(degrees);
    const Vector3 turned = by.x * a + by.y * b;
    b = by.x * b - by.y * a;
    a = turned;
    constexpr std::uint32_t turns_between = 32;
    if (++pose.turns % turns_between == 0) make_orthonormal(pose.frame);
  }
  static void make_orthonormal(TurtleFrame& frame);

  TurtleStart start_;
  DirectionCache directions_;
};

}  // namespace phytobench
