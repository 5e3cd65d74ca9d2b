// SPDX-License-Identifier: MIT
// Every parameter of a tree file in one table: reading, checking, the commented example and the
// list of known keys all come from it.
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/colonization/tree_parameters.hpp"
#include "core/contract/parameter_keys.hpp"

namespace phytobench {

/// The words of cloud.shape.
enum class CloudShape { cut_ellipsoid, disc, annulus, ring, sphere_shell };

/// Values as they stand in a file, before gnarliness is resolved.
struct TreeFileValues {
  TreeParameters parameters;
  CloudShape cloud_shape = CloudShape::cut_ellipsoid;
  RoundCloud round_cloud;
  double cloud_points = 2000;
  double most_children = std::numeric_limits<double>::infinity();
  double most_branch_depth = std::numeric_limits<double>::infinity();
  double rest_iterations = std::numeric_limits<double>::infinity();
  double curve_reduction_deg = 0.0;
  double seed = 0;
  double iterations = 30;
  double gnarliness = 0.8;
  double branch_density_begin = 0.0;
  double branch_density_end = 0.8;
  double thickness = 0.55;
  double pendulous_begin = 0.7;
  double pendulous_first_order = 0;
  double circle_resolution = 3;
};

/// A number with its allowed range.
struct NumberKey {
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
  bool low_is_allowed = true;
  bool whole = false;  ///< only whole numbers
  bool infinity_is_allowed = false;
  double& (*place)(TreeFileValues&) = nullptr;

  NumberRange range() const {
    return {.low = low,
            .high = high,
            .low_is_allowed = low_is_allowed,
            .whole = whole,
            .infinity_is_allowed = infinity_is_allowed};
  }
};

/// Three numbers.
struct VectorKey {
  bool must_be_positive = false;
  Vector3& (*place)(TreeFileValues&) = nullptr;
};

/// One of a few words; `choose` takes the position of the word.
struct ChoiceKey {
  std::vector<std::string_view> words;
  void (*choose)(TreeFileValues&, std::size_t) = nullptr;
};

/// A colour, as in "#6b4a2b".
struct ColourKey {
  Colour& (*place)(TreeFileValues&) = nullptr;
};

/// The name of a file; relative ones start at the folder of the parameter file. Empty: none.
struct FileKey {
  std::string& (*place)(TreeFileValues&) = nullptr;
};

struct TreeParameterKey {
  std::string_view name;  ///< "section.key", or "key" at the top
  std::string_view unit;
  std::string_view default_text;  ///< as written in a file
  std::string_view meaning;
  std::string_view source;  ///< paper key and place, or "phytobench"
  std::variant<NumberKey, VectorKey, ChoiceKey, ColourKey, FileKey> kind;
  bool shown_as_comment = false;  ///< alternative to other keys: the example shows it commented out
};

/// All keys, grouped by section.
std::span<const TreeParameterKey> tree_parameter_keys();

}  // namespace phytobench
