// SPDX-License-Identifier: MIT
// The contract of every nearest-node engine. It sits at the level of one iteration of space
// colonization, because a nearest(query) interface would shut out the fastest algorithms: nodes are
// only added and never move, points are only removed, so a point's nearest node changes only
// because of a new node.
#pragma once

#include <concepts>
#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "core/geometry/vector3.hpp"
#include "core/nearest_node/point_set.hpp"
#include "core/nearest_node/work_counters.hpp"

namespace phytobench {

using NodeIndex = std::int32_t;  ///< in the order in which nodes were handed to associate()
inline constexpr NodeIndex no_node = -1;

/// A node a point may be associated with. The direction (unit length) is fixed when the node is
/// made.
struct SearchableNode {
  Vector3 position;
  Vector3 direction;
  friend constexpr bool operator==(const SearchableNode&, const SearchableNode&) = default;
};

/// Below this the square of a distance underflows and "nearer" loses its meaning.
inline constexpr double smallest_influence_distance = 1e-100;

/// Which points an engine looks at ([Brzoska2019] sec. 5.2.2, option N).
enum class PointFilter {
  none,          ///< every live point
  bounding_box,  ///< only points inside the box of all searchable nodes widened by the influence
                 ///< distance
};

struct EngineSetup {
  double influence_distance = 0.0;         ///< length unit of the points; infinity is allowed
  double perception_half_angle_rad = 0.0;  ///< (0, pi]; pi perceives in every direction
  PointFilter search_filter = PointFilter::none;
  PointFilter kill_filter = PointFilter::none;
  int associations = 0;    ///< how many calls of associate() will follow at most; 0: not known
  int threads = 1;         ///< results are the same for any number
  bool count_work = true;  ///< false while timed: counters that cost time may stay at zero
};

/// For every point (live or not) its nearest perceiving node, or no_node, and the set of points
/// that have one: a thin front of the points at any time. Views into the engine, valid until its
/// next call. Removed points have no node. No distances: whoever needs one computes it with
/// squared_distance(), as every engine must.
struct Assignment {
  std::span<const NodeIndex> node;
  const PointSet& associated;
};

class NearestNodeEngine {
 public:
  virtual ~NearestNodeEngine() = default;

  /// Starts afresh. `points` must stay alive and unchanged until the next reset().
  virtual void reset(std::span<const Vector3> points, const EngineSetup& setup) = 0;

  /// Adds nodes, then gives each live point the nearest of all nodes so far that perceives it; of
  /// equally near ones the lowest index.
  virtual Assignment associate(std::span<const SearchableNode> new_nodes) = 0;

  /// Removes every live point with squared distance <= kill_distance^2 to one of `killers`,
  /// whatever their perception angle. Returns the removed points, each once, in any order; valid
  /// until the next call.
  virtual std::span<const PointIndex> kill(std::span<const SearchableNode> killers,
                                           double kill_distance) = 0;

  virtual std::size_t live_points() const = 0;
  virtual WorkCounters counters() const = 0;
};

/// Makes engines of one kind: a function, or for engines from outside a function that is told which
/// of them it stands for (see EnginePlugin).
class EngineFactory {
 public:
  using Made = std::unique_ptr<NearestNodeEngine>;

  constexpr EngineFactory() = default;
  template <std::convertible_to<Made (*)()> Function>
  constexpr EngineFactory(Function function) : function_(function) {}
  constexpr EngineFactory(Made (*function)(const void*), const void* context)
      : function_of_(function), context_(context) {}

  explicit constexpr operator bool() const {
    return function_ != nullptr || function_of_ != nullptr;
  }

  Made operator()() const { return function_ != nullptr ? function_() : function_of_(context_); }

 private:
  Made (*function_)() = nullptr;
  Made (*function_of_)(const void*) = nullptr;
  const void* context_ = nullptr;  ///< outlives the factory
};

/// The whole public face of an engine. One constant of this type per file in engines/, one line in
/// engines.def.
struct EngineDescriptor {
  std::string_view name;          ///< lower case, unique, equal to the file name
  std::string_view summary;       ///< one sentence: how it finds the nearest node
  std::string_view source;        ///< where the method comes from
  std::string_view library = {};  ///< what it asks, with version; empty if it asks nobody
  bool uses_point_filter = true;  ///< false: option N changes nothing for this engine
  std::string_view missing_package =
      {};  ///< empty if built, else the CMake target that was not found
  EngineFactory create = {};

  bool built() const { return static_cast<bool>(create); }
};

}  // namespace phytobench
