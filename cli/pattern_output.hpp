// SPDX-License-Identifier: MIT
// What `phytobench pattern` found, and how it says so.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "core/point_pattern/close_pairs.hpp"
#include "core/point_pattern/distance_functions.hpp"
#include "core/point_pattern/envelope_tests.hpp"
#include "core/point_pattern/hopkins_null.hpp"
#include "core/point_pattern/marks.hpp"
#include "core/point_pattern/monte_carlo.hpp"
#include "core/point_pattern/nearest_neighbour_index.hpp"
#include "core/point_pattern/ripley.hpp"

namespace phytobench::cli {

/// A function of distance, and a global test of it against simulations.
struct PatternCurve {
  std::vector<double> distances, values;
  EnvelopeTest test;
  std::size_t simulations = 0;      ///< 0: not tested
  bool has_too_many_pairs = false;  ///< not even computed: points stand in tight lumps
};

struct SpeciesPair {
  std::string first, second;
  std::size_t first_count = 0, second_count = 0;
  PatternCurve cross_l;  ///< against random labelling
};

struct PatternFindings {
  std::vector<Point2> points;
  Window window;
  bool window_is_guessed = false;  ///< the bounding box: too small, so that points look crowded
  HopkinsIndex hopkins = {}, sampled_hopkins = {};
  HopkinsNull null = {};
  std::optional<double> p_value = std::nullopt;  ///< of the exact mean ratio, two-sided
  ClarkEvansIndex clark_evans = {};
  PatternCurve l_function = {};
  std::optional<PatternCurve> marks = std::nullopt;  ///< mark correlation against random labelling
  std::vector<SpeciesPair> species = {};
};

std::string pattern_json(const PatternFindings& findings, const PatternOptions& options);
std::string pattern_text(const PatternFindings& findings, const PatternOptions& options);

}  // namespace phytobench::cli
