// SPDX-License-Identifier: MIT
// How engines behave over the size of their workload, from the records of a scaling experiment, and
// how far the suite's own engine is from what it was meant to reach.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/statistics/power_law.hpp"
#include "reports/judge/evidence.hpp"

namespace phytobench {

/// What an engine must and should reach, written down before it was built.
struct Aim {
  enum class Kind {
    ratio,  ///< time of `entries[0]` over that of `entries[1]`, at sizes[0]
    /// Time per attraction point at sizes[0] over that at sizes[1]. The rounds of two sizes are
    /// independent of each other and are paired by their number: the value is the median of those
    /// ratios, not the ratio of two medians, and rounds that only one size has are left out.
    per_point,
    over_floor,       ///< distance evaluations over the floor, the largest of all sizes
    bytes_per_point,  ///< memory, the largest of all sizes
  };
  Kind kind = Kind::ratio;
  std::string text;
  std::vector<std::string> entries;  ///< "voxel_grid.dn"
  std::vector<double> sizes;
  double must = 0.0;
  double aim = 0.0;
  std::string limits;  ///< what keeps it from its aim, shown only if it surely misses it

  bool more_is_better() const { return kind == Kind::ratio; }
};

/// One scaling experiment and what is asked of it.
struct ScalingStudy {
  std::string id;
  std::string experiment;  ///< "brzoska2019/scaling"
  std::string title;
  std::string intro;
  std::vector<Aim> aims;
};

/// Reads a study. Throws InputError naming file and key.
ScalingStudy load_scaling_study(const std::string& id);

struct JudgedAim {
  enum class State {
    reached,
    must_reached,           ///< the least, and the aim is surely missed
    must_reached_aim_open,  ///< the least, and the interval holds the aim
    missed,
    open,  ///< too few rounds, or the interval holds the least
    not_measured
  };
  Aim aim;
  State state = State::not_measured;
  MedianOfRounds measured;
  bool varies = true;

  /// Whether even the better end of the interval is short of the aim (not of the least). A range
  /// of few rounds is sure of nothing.
  bool surely_misses_its_aim() const;
};

/// One engine with its loop option (and threads, if more than one) over all sizes.
struct ScaledEntry {
  struct AtSize {
    bool exact = false;
    std::optional<MedianOfRounds> seconds;
    std::optional<double> evaluations;
    std::optional<double> cells_visited;
    std::optional<double> over_floor;
    std::optional<double> bytes_per_point;
    std::map<std::string, double> phase_seconds;  ///< medians by "build", "association", ...
  };
  std::string name;                  ///< "voxel_grid.dn"
  std::map<double, AtSize> at;       ///< by nominal size
  std::optional<PowerLaw> time_law;  ///< from three timed sizes on
  std::optional<PowerLaw> work_law;
};

struct ScaledSize {
  double points = 0.0;
  double nodes = 0.0;
  double iterations = 0.0;
  double association_pairs = 0.0;  ///< floor
  double removal_pairs = 0.0;      ///< floor
};

/// `overtaken` is faster up to `low` points and slower from `high` points on.
struct Crossover {
  std::string overtaken;
  std::string overtaking;
  double low = 0.0;
  double high = 0.0;
  double about = 0.0;      ///< where straight lines between the medians cross, on logarithmic axes
  std::size_t rounds = 0;  ///< of the side that has fewer

  /// Too few rounds at one side to be sure of it, though none of them says otherwise.
  bool is_open() const { return rounds < fewest_rounds; }
};

struct JudgedScaling {
  ScalingStudy study;
  std::map<double, ScaledSize> sizes;
  std::vector<ScaledEntry> entries;  ///< fastest at the largest size first, then by name
  std::vector<Crossover> crossovers;
  std::vector<JudgedAim> aims;

  bool measured() const { return !sizes.empty(); }
};

/// Pure: everything comes from the evidence.
JudgedScaling judge_scaling(ScalingStudy study, const RunContents& run, const Evidence& evidence);

}  // namespace phytobench
