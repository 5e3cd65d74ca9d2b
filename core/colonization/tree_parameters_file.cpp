// SPDX-License-Identifier: MIT
#include "core/colonization/tree_parameters_file.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <fmt/format.h>

#include "core/colonization/tree_parameter_keys.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/contract/toml_values.hpp"
#include "core/nearest_node/engine.hpp"

namespace phytobench {

namespace {

/// Vectors stay where their squares neither overflow nor vanish.
constexpr double largest_component = 1e15;

std::string allowed_values(const TreeParameterKey& key) {
  return std::visit(
      Overloaded{[](const NumberKey& kind) { return "a number " + allowed(kind.range()); },
                 [](const VectorKey& kind) {
                   return std::string(kind.must_be_positive ? "three numbers > 0"
                                                            : "three numbers");
                 },
                 [](const ChoiceKey& kind) {
                   return fmt::format("\"{}\"", fmt::join(kind.words, "\" or \""));
                 },
                 [](const ColourKey&) { return std::string("\"#rrggbb\""); },
                 [](const FileKey&) { return std::string("a file name"); }},
      key.kind);
}

/// A table and the file it comes from.
struct SourceTable {
  std::filesystem::path file;
  const toml::table* table;
};

class TreeFileReader {
 public:
  explicit TreeFileReader(std::vector<SourceTable> tables) : tables_(std::move(tables)) {}

  TreeParameters read() {
    for (current_ = 0; current_ < tables_.size(); ++current_)
      read_table(*tables_[current_].table, "");
    resolve_coupling();
    resolve_cloud();
    resolve_limits();
    values_.parameters.seed = static_cast<std::uint64_t>(values_.seed);
    values_.parameters.iterations = static_cast<int>(values_.iterations);
    resolve_plant();
    check_combinations();
    return values_.parameters;
  }

 private:
  /// Points to the first of the keys that the file gives, or to the table.
  [[noreturn]] void fail_any(const std::vector<std::string>& keys,
                             const std::string& problem) const {
    for (const std::string& key : keys)
      for (auto source = tables_.rbegin(); source != tables_.rend(); ++source)
        if (const toml::node* found = source->table->at_path(key).node())
          fail_at(source->file, *found, problem);
    fail_at(tables_.back().file, *tables_.back().table, problem);
  }

  [[noreturn]] void fail(const std::string& key, const std::string& problem) const {
    fail_any({key}, problem);
  }

  void read_table(const toml::table& table, const std::string& prefix) {
    for (const auto& [key, node] : table) {
      const std::string name = prefix + std::string(key.str());
      refuse_quoted_name({tables_[current_].file, name, node}, key.str());
      given_.insert(name);
      if (const toml::table* section = node.as_table(); section != nullptr && is_section(name)) {
        read_table(*section, name + ".");
      } else {
        read_value(name, node);
      }
    }
  }

  static bool is_section(std::string_view name) {
    const std::string prefix = std::string(name) + ".";
    return std::any_of(tree_parameter_keys().begin(), tree_parameter_keys().end(),
                       [&](const TreeParameterKey& key) { return key.name.starts_with(prefix); });
  }

  void read_value(const std::string& name, const toml::node& node) {
    const TomlValue value{tables_[current_].file, name, node};
    for (const TreeParameterKey& key : tree_parameter_keys()) {
      if (key.name != name) continue;
      std::visit(
          Overloaded{
              [&](const NumberKey& kind) {
                kind.place(values_) = read_number(value, kind.range());
              },
              [&](const VectorKey& kind) { kind.place(values_) = read_vector(value, kind); },
              [&](const ChoiceKey& kind) { kind.choose(values_, read_choice(value, kind.words)); },
              [&](const ColourKey& kind) { kind.place(values_) = read_colour(value); },
              [&](const FileKey& kind) { kind.place(values_) = read_file_name(value); }},
          key.kind);
      return;
    }
    std::vector<std::string> known;
    for (const TreeParameterKey& key : tree_parameter_keys()) known.emplace_back(key.name);
    value.fail(unknown_key(name, known, "phytobench grow --example"));
  }

  static Vector3 read_vector(const TomlValue& value, const VectorKey& kind) {
    const toml::array* array = value.node.as_array();
    if (array == nullptr || array->size() != 3)
      value.fail(fmt::format("{} must be three numbers, as in [1.0, 2.0, 3.0]", value.name));
    double numbers[3];
    for (std::size_t i = 0; i < 3; ++i) {
      const auto number = (*array)[i].value<double>();
      if (!number || !(std::abs(*number) <= largest_component) ||
          (kind.must_be_positive && *number < 1.0 / largest_component))
        value.fail(fmt::format("{}[{}] must be a number between {} and {}", value.name, i,
                               kind.must_be_positive ? 1.0 / largest_component : -largest_component,
                               largest_component));
      numbers[i] = *number;
    }
    return {numbers[0], numbers[1], numbers[2]};
  }

  static Colour read_colour(const TomlValue& value) {
    try {
      return parse_colour(value.node.value_or(std::string_view()));
    } catch (const InputError& error) {
      value.fail(fmt::format("{}: {}", value.name, error.what()));
    }
  }

  bool is_given(const std::string& key) const { return given_.contains(key); }

  void allow_one_of(const std::string& a, const std::string& b) const {
    if (is_given(a) && is_given(b)) fail(a, set_the_same(a, b));
  }

  /// What the look of the plant takes from other keys.
  void resolve_plant() {
    TreeParameters& p = values_.parameters;
    allow_one_of("branches.thickness", "branches.radius_exponent");
    if (!is_given("branches.radius_exponent"))
      p.plant.radius_exponent = radius_exponent_of(values_.thickness);
    allow_one_of("pendulous.begin", "pendulous.first_order");
    const double deepest = std::ceil(p.stem_length / p.step_length) + p.iterations - 1;
    const double first = is_given("pendulous.first_order")
                             ? values_.pendulous_first_order
                             : std::floor(values_.pendulous_begin * deepest);
    p.plant.pendulous.first_order = static_cast<std::int32_t>(std::min(first, 1e9));
    p.plant.curve_reduction.cosine_above =
        std::cos(values_.curve_reduction_deg * (std::numbers::pi / 180.0));
    p.plant.branches.circle_resolution = static_cast<int>(values_.circle_resolution);
    p.plant.leaves.seed = p.seed;
  }

  /// Gnarliness sets three distances and the default density; whoever gives the distances gives all
  /// three.
  void resolve_coupling() {
    const std::string explicit_keys[] = {"growth.influence_distance", "growth.kill_distance_begin",
                                         "growth.kill_distance_end"};
    const std::string coupled_keys[] = {"growth.gnarliness", "growth.branch_density_begin",
                                        "growth.branch_density_end"};
    const auto given = std::find_if(std::begin(explicit_keys), std::end(explicit_keys),
                                    [this](const std::string& key) { return is_given(key); });
    if (given != std::end(explicit_keys)) {
      for (const std::string& key : explicit_keys)
        if (!is_given(key))
          fail(*given, fmt::format("{} is given without {}; give all three distances or none",
                                   *given, key));
      for (const std::string& key : coupled_keys)
        if (is_given(key))
          fail(key, fmt::format("{} would set {} as well; give one or the other", key, *given));
      return;
    }
    const GnarlinessCoupling coupling = couple_to_gnarliness(values_.gnarliness);
    TreeParameters& parameters = values_.parameters;
    parameters.influence_distance = coupling.influence_distance;
    parameters.kill_distance.begin = coupling.kill_distance(values_.branch_density_begin);
    parameters.kill_distance.end = coupling.kill_distance(values_.branch_density_end);
    if (!is_given("cloud.density")) parameters.cloud_density = coupling.cloud_density;
  }

  /// A round cloud and the cut ellipsoid have keys of their own; a key that the shape does not
  /// look at is a mistake.
  void check_keys_of_cloud(bool round) const {
    for (const char* key : {"cloud.radii", "cloud.cutoff_bottom", "cloud.cutoff_top",
                            "cloud.density", "tropism.damping_density"})
      if (round && is_given(key))
        fail(key, fmt::format("{} belongs to cloud.shape = \"cut_ellipsoid\"; round shapes have "
                              "cloud.radius, inner_radius, centre and points",
                              key));
    for (const char* key : {"cloud.radius", "cloud.inner_radius", "cloud.centre", "cloud.points"})
      if (!round && is_given(key))
        fail(key, fmt::format("{} belongs to a round cloud.shape; give one, such as \"disc\", or "
                              "cloud.radii and cloud.density instead",
                              key));
  }

  void resolve_cloud() {
    const bool round = values_.cloud_shape != CloudShape::cut_ellipsoid;
    check_keys_of_cloud(round);
    if (!round) return;
    RoundCloud& cloud = values_.round_cloud;
    const bool hollow = values_.cloud_shape == CloudShape::annulus ||
                        values_.cloud_shape == CloudShape::sphere_shell;
    if (!hollow && is_given("cloud.inner_radius"))
      fail("cloud.inner_radius",
           "cloud.inner_radius belongs to cloud.shape = \"annulus\" or \"sphere_shell\"; leave it "
           "out or change the shape");
    if (cloud.region.inner_radius > cloud.region.radius)
      fail_any({"cloud.inner_radius", "cloud.radius"},
               fmt::format("cloud.inner_radius = {} exceeds cloud.radius = {}; lower the one or "
                           "raise the other",
                           cloud.region.inner_radius, cloud.region.radius));
    cloud.region.shape = static_cast<RoundShape>(static_cast<int>(values_.cloud_shape) - 1);
    cloud.points = static_cast<std::size_t>(values_.cloud_points);
    values_.parameters.round_cloud = cloud;
  }

  void resolve_limits() {
    const auto whole = [](double limit) {
      return std::isinf(limit) ? GrowthLimits::unlimited : static_cast<std::int32_t>(limit);
    };
    GrowthLimits& limits = values_.parameters.limits;
    limits.most_children = whole(values_.most_children);
    limits.most_branch_depth = whole(values_.most_branch_depth);
    limits.rest_iterations = whole(values_.rest_iterations);
    const double deepest = values_.most_branch_depth;
    if (limits.step_weighting == StepWeighting::by_branch_depth &&
        (deepest == 0.0 || std::isinf(deepest)))
      fail_any({"growth.step_weighting"},
               fmt::format("growth.step_weighting = \"by_branch_depth\" divides by "
                           "growth.most_branch_depth = {}; give a depth of at least 1",
                           deepest));
  }

  void check_combinations() const {
    const TreeParameters& p = values_.parameters;
    const double reach = largest_within(p.influence_distance, p.variant.influence_boundary);
    if (reach < smallest_influence_distance)
      fail("growth.influence_distance",
           fmt::format("growth.influence_distance = {} is too small to be squared; use at least {}",
                       p.influence_distance, smallest_influence_distance));
    if (std::max(p.kill_distance.begin, p.kill_distance.end) == p.influence_distance &&
        reach < p.influence_distance && p.variant.kill_boundary == Boundary::inclusive)
      fail_any({"variant.influence_boundary", "growth.influence_distance"},
               "points exactly at growth.influence_distance would be removed and never attract; "
               "set variant.kill_boundary = \"exclusive\" as well, or lower the kill distance");
    for (const auto& [key, distance] :
         {std::pair{"growth.kill_distance_begin", p.kill_distance.begin},
          std::pair{"growth.kill_distance_end", p.kill_distance.end}})
      if (largest_within(distance, p.variant.kill_boundary) > reach)
        fail_any(
            {key, "growth.influence_distance"},
            fmt::format("{} = {} exceeds growth.influence_distance = {}; points would vanish that "
                        "never attracted anything: lower the one or raise the other",
                        key, distance, p.influence_distance));
    if (!(1.0 - p.cloud.cutoff_bottom - p.cloud.cutoff_top >= smallest_kept_share))
      fail_any({"cloud.cutoff_top", "cloud.cutoff_bottom"},
               fmt::format("cloud.cutoff_bottom + cloud.cutoff_top = {} leaves too little of the "
                           "ellipsoid; keep "
                           "the sum at {} or below",
                           p.cloud.cutoff_bottom + p.cloud.cutoff_top, 1.0 - smallest_kept_share));
    check_point_count();
    if (p.stem_length / p.step_length > most_stem_pieces)
      fail_any(
          {"stem.length", "growth.step_length"},
          fmt::format(
              "stem.length = {} in pieces of growth.step_length = {} is more than {:.0e} nodes; "
              "shorten the stem or lengthen the steps",
              p.stem_length, p.step_length, most_stem_pieces));
  }

  void check_point_count() const {
    const TreeParameters& p = values_.parameters;
    if (p.round_cloud) return;  // says its number of points itself
    for (const auto& [key, density] :
         {std::pair{"cloud.density", p.cloud_density},
          std::pair{"tropism.damping_density", p.tropism_damping_density}}) {
      const double count = volume(p.cloud) * density;
      if (!(count <= most_attraction_points))
        fail_any({key, "cloud.radii"},
                 fmt::format("{} = {:.4g} in a volume of {:.4g} makes {:.3g} attraction points; at "
                             "most {:.0e} are "
                             "allowed: lower {} or cloud.radii",
                             key, density, volume(p.cloud), count, most_attraction_points, key));
    }
  }

  /// About 10 GiB of memory while growing; anything larger is taken for a typing error.
  static constexpr double most_attraction_points = 1e8;
  static constexpr double most_stem_pieces = 1e6;
  /// Sampling tries random heights until one lies between the cuts.
  static constexpr double smallest_kept_share = 0.01;

  std::vector<SourceTable> tables_;  // a later one replaces keys of an earlier one
  std::size_t current_ = 0;          // the one being read
  std::set<std::string> given_;
  TreeFileValues values_;
};

}  // namespace

TreeParameters read_tree_parameters(const std::filesystem::path& file) {
  return read_tree_parameters(std::vector<TreeSource>{{file, ""}});
}

TreeParameters read_tree_parameters(const std::vector<TreeSource>& sources) {
  std::vector<toml::table> roots;
  for (const TreeSource& source : sources)
    roots.push_back(parse_toml(read_text_file(source.file), source.file.string()));
  std::vector<SourceTable> tables;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const toml::table* table =
        sources[i].table.empty() ? &roots[i] : roots[i].at_path(sources[i].table).as_table();
    if (table == nullptr)
      throw InputError(
          fmt::format("{}: has no table [{}]", sources[i].file.string(), sources[i].table));
    tables.push_back({sources[i].file, table});
  }
  return TreeFileReader(std::move(tables)).read();
}

TreeParameters parse_tree_parameters(std::string_view text, std::string_view name) {
  const toml::table root = parse_toml(text, name);
  return TreeFileReader({{name, &root}}).read();
}

std::string example_tree_file() {
  std::string text =
      "# A tree for `phytobench grow`. Every key may be left out; the values here are the "
      "defaults.\n"
      "# Lengths share one free unit. [Brzoska2019] is described by `phytobench list papers`.\n";
  std::string_view section;
  for (const TreeParameterKey& key : tree_parameter_keys()) {
    if (section_of(key.name) != section) {
      section = section_of(key.name);
      text += fmt::format("\n[{}]\n", section);
    }
    text += example_lines({.name = key.name,
                           .unit = key.unit,
                           .meaning = key.meaning,
                           .source = key.source,
                           .allowed = allowed_values(key),
                           .value = key.default_text,
                           .is_commented_out = key.shown_as_comment});
  }
  return text;
}

}  // namespace phytobench
