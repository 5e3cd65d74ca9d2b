// SPDX-License-Identifier: MIT
#include "core/colonization/tree_parameter_keys.hpp"

namespace phytobench {

namespace {

using Values = TreeFileValues;

/// Choice between consecutive enumerators in the order of the words.
template <auto Member>
void choose_variant(Values& values, std::size_t word) {
  auto& field = values.parameters.variant.*Member;
  field = static_cast<std::remove_reference_t<decltype(field)>>(word);
}

/// A whole number, or inf.
NumberKey limit(double low, double& (*place)(Values&)) {
  return {.low = low, .high = 1e9, .whole = true, .infinity_is_allowed = true, .place = place};
}

std::vector<TreeParameterKey> make_keys() {
  constexpr std::string_view thesis = "[Brzoska2019] sec. 5.2.1, value published by its author";
  constexpr double most_iterations = 1e6;
  return {
      {"seed", "-", "0", "start of every random stream", "[Brzoska2019] sec. 5.5.3",
       NumberKey{.high = 2147483647,
                 .whole = true,
                 .place = [](Values& v) -> double& { return v.seed; }}},
      {"random", "-", "\"subtractive\"",
       "generator: \"subtractive\" hits the counts of the 2019 thesis, \"counter\" is the suite's "
       "own",
       "phytobench",
       ChoiceKey{{"counter", "subtractive"},
                 [](Values& v, std::size_t word) {
                   v.parameters.random = word == 0 ? StreamKind::counter : StreamKind::subtractive;
                 }}},

      {"cloud.radii", "length", "[5.0, 7.0, 4.5]",
       "half axes of the crown's ellipsoid: x, y (up), z", thesis,
       VectorKey{true, [](Values& v) -> Vector3& { return v.parameters.cloud.radii; }}},
      {"cloud.cutoff_bottom", "share", "0.15", "share of the ellipsoid's height cut off below",
       thesis,
       NumberKey{.high = 1,
                 .place = [](Values& v) -> double& { return v.parameters.cloud.cutoff_bottom; }}},
      {"cloud.cutoff_top", "share", "0.05", "share of the ellipsoid's height cut off above", thesis,
       NumberKey{.high = 1,
                 .place = [](Values& v) -> double& { return v.parameters.cloud.cutoff_top; }}},
      {"cloud.density", "1/length^3", "26.4",
       "attraction points per unit volume; without it 12 + 18 * gnarliness", thesis,
       NumberKey{.low_is_allowed = false,
                 .place = [](Values& v) -> double& { return v.parameters.cloud_density; }}},
      {"cloud.shape", "-", "\"cut_ellipsoid\"",
       "where attraction points lie: the crown's \"cut_ellipsoid\"; a \"disc\", an \"annulus\" or "
       "a "
       "\"ring\" (a circle line) in the plane z = 0; a \"sphere_shell\"",
       "[Liebemann2017] fig. 3.2",
       ChoiceKey{
           {"cut_ellipsoid", "disc", "annulus", "ring", "sphere_shell"},
           [](Values& v, std::size_t word) { v.cloud_shape = static_cast<CloudShape>(word); }}},
      {"cloud.radius", "length", "5.0", "radius of a round shape; instead of radii",
       "[Liebemann2017] fig. 3.2",
       NumberKey{.high = 1e15,
                 .low_is_allowed = false,
                 .place = [](Values& v) -> double& { return v.round_cloud.region.radius; }},
       true},
      {"cloud.inner_radius", "length", "0.0",
       "radius of the hole of an annulus or sphere_shell; at most radius", "phytobench",
       NumberKey{.high = 1e15,
                 .place = [](Values& v) -> double& { return v.round_cloud.region.inner_radius; }},
       true},
      {"cloud.centre", "length", "[0.0, 5.0, 0.0]",
       "centre of a round shape, seen from the crown root", "phytobench",
       VectorKey{false, [](Values& v) -> Vector3& { return v.round_cloud.region.centre; }}, true},
      {"cloud.points", "-", "2000", "attraction points of a round shape; instead of density",
       "[Liebemann2017] fig. 3.2",
       NumberKey{.low = 1,
                 .high = 1e8,
                 .whole = true,
                 .place = [](Values& v) -> double& { return v.cloud_points; }},
       true},

      {"growth.iterations", "-", "30", "iterations at most; growth may stop earlier", thesis,
       NumberKey{.low = 1,
                 .high = most_iterations,
                 .whole = true,
                 .place = [](Values& v) -> double& { return v.iterations; }}},
      {"growth.step_length", "length", "0.25", "D, distance of a new node from its parent",
       "[Brzoska2019] eq. 8, value published by its author",
       NumberKey{.low_is_allowed = false,
                 .place = [](Values& v) -> double& { return v.parameters.step_length; }}},
      {"growth.perception_angle_deg", "degree", "160.0",
       "full angle around a node's direction within which it perceives points; 360 is all around",
       "[Brzoska2019] fig. 26, value published by its author",
       NumberKey{.high = 360,
                 .low_is_allowed = false,
                 .place = [](Values& v) -> double& { return v.parameters.perception_angle_deg; }}},
      {"growth.gnarliness", "share", "0.8",
       "how crooked branches are; sets influence distance 1.3 - 0.8 g and the interval of kill "
       "distances",
       thesis, NumberKey{.high = 1, .place = [](Values& v) -> double& { return v.gnarliness; }}},
      {"growth.branch_density_begin", "share", "0.0",
       "0 gives the largest kill distance of that interval, 1 the smallest; at the start", thesis,
       NumberKey{.high = 1, .place = [](Values& v) -> double& { return v.branch_density_begin; }}},
      {"growth.branch_density_end", "share", "0.8", "the same at the last iteration", thesis,
       NumberKey{.high = 1, .place = [](Values& v) -> double& { return v.branch_density_end; }}},
      {"growth.influence_distance", "length", "0.66",
       "d_i, how far a point attracts; instead of gnarliness, with both kill distances",
       "[Brzoska2019] sec. 3.4.4",
       NumberKey{.low_is_allowed = false,
                 .infinity_is_allowed = true,
                 .place = [](Values& v) -> double& { return v.parameters.influence_distance; }},
       true},
      {"growth.kill_distance_begin", "length", "0.58",
       "d_c in the first iteration: points this near to a new node are removed; at most "
       "influence_distance",
       "[Brzoska2019] eq. 17",
       NumberKey{.low_is_allowed = false,
                 .place = [](Values& v) -> double& { return v.parameters.kill_distance.begin; }},
       true},
      {"growth.kill_distance_end", "length", "0.265", "d_c approached in the last iteration",
       "[Brzoska2019] eq. 17",
       NumberKey{.low_is_allowed = false,
                 .place = [](Values& v) -> double& { return v.parameters.kill_distance.end; }},
       true},
      {"growth.kill_interpolation", "-", "\"squared\"",
       "what the sigmoid interpolates: \"squared\" (published trees) or \"linear\" distances (eq. "
       "17 as printed)",
       "[Brzoska2019] eq. 17, erratum E4",
       ChoiceKey{{"squared", "linear"},
                 [](Values& v, std::size_t word) {
                   v.parameters.kill_distance.interpolation =
                       word == 0 ? KillInterpolation::squared : KillInterpolation::linear;
                 }}},
      {"growth.sigmoid_begin", "-", "-12.0", "argument of the sigmoid in the first iteration",
       thesis,
       NumberKey{
           .low = -700,
           .high = 700,
           .place = [](Values& v) -> double& { return v.parameters.kill_distance.sigmoid_begin; }}},
      {"growth.sigmoid_end", "-", "6.0", "argument of the sigmoid in the last iteration", thesis,
       NumberKey{
           .low = -700,
           .high = 700,
           .place = [](Values& v) -> double& { return v.parameters.kill_distance.sigmoid_end; }}},

      {"growth.most_children", "-", "inf", "max_grad, children that a node may get at most",
       "[Liebemann2017] sec. 3.5", limit(1, [](Values& v) -> double& { return v.most_children; })},
      {"growth.most_branch_depth", "-", "inf",
       "max_Z, greatest branch depth: the first child of a node is as deep as its parent, each "
       "later one is one deeper",
       "[Liebemann2017] eq. 3.5, sec. 3.5",
       limit(0, [](Values& v) -> double& { return v.most_branch_depth; })},
      {"growth.rest_iterations", "-", "inf",
       "max_NG, a node that gets no child in so many iterations in a row rests: other nodes get "
       "its points",
       "[Liebemann2017] sec. 3.5",
       limit(1, [](Values& v) -> double& { return v.rest_iterations; })},
      {"growth.step_weighting", "-", "\"none\"",
       "\"by_branch_depth\" multiplies the step length by 2 - Z / most_branch_depth: 2 at branch "
       "depth 0, 1 at the greatest",
       "[Liebemann2017] sec. 3.5, weighted growth",
       ChoiceKey{{"none", "by_branch_depth"},
                 [](Values& v, std::size_t word) {
                   v.parameters.limits.step_weighting = static_cast<StepWeighting>(word);
                 }}},

      {"tropism.direction", "-", "[0.0, 1.0, 0.0]",
       "g, added to the sum of unit vectors to the points", "[Brzoska2019] eq. 10",
       VectorKey{false, [](Values& v) -> Vector3& { return v.parameters.tropism_direction; }}},
      {"tropism.weights", "-", "[1.0, 1.0, 1.0]", "multiplies g component by component",
       "[Brzoska2019] sec. 4.1",
       VectorKey{false, [](Values& v) -> Vector3& { return v.parameters.tropism_weights; }}},
      {"tropism.damping", "-", "\"cloud_shape\"",
       "\"cloud_shape\" multiplies the y weight by min(1, (height / max(width, depth))^2) of the "
       "points; or \"none\"",
       "[Brzoska2019] sec. 5.5.1, formula published by its author",
       ChoiceKey{{"none", "cloud_shape"},
                 [](Values& v, std::size_t word) {
                   v.parameters.tropism_damping =
                       word == 0 ? TropismDamping::none : TropismDamping::cloud_shape;
                 }}},
      {"tropism.damping_density", "1/length^3", "0.0",
       "density of the cloud that is measured for the damping; 0 measures the crown's own",
       "phytobench", NumberKey{.place = [](Values& v) -> double& {
         return v.parameters.tropism_damping_density;
       }}},

      {"stem.length", "length", "2.0", "procedural stem below the crown", thesis,
       NumberKey{.place = [](Values& v) -> double& { return v.parameters.stem_length; }}},
      {"stem.tilt_deg", "degree", "5.0", "largest tilt of a stem piece from the vertical", thesis,
       NumberKey{.high = 90,
                 .place = [](Values& v) -> double& { return v.parameters.stem_tilt_deg; }}},
      {"stem.crown_ratio", "share", "0.0", "share of the cloud's height that the stem runs through",
       thesis,
       NumberKey{.high = 1,
                 .place = [](Values& v) -> double& { return v.parameters.crown_stem_ratio; }}},

      {"branches.thickness", "share", "0.55",
       "how thick the stem is; sets the exponent of the radius rule, 3 - 2 * thickness", thesis,
       NumberKey{.high = 1, .place = [](Values& v) -> double& { return v.thickness; }}},
      {"branches.radius_exponent", "-", "1.9",
       "n of r^n = r1^n + ... + rk^n, instead of thickness; 2 keeps the cross-section area",
       "[Brzoska2019] eq. 12",
       NumberKey{.low = 0.1,
                 .high = 100,
                 .place = [](Values& v) -> double& { return v.parameters.plant.radius_exponent; }},
       true},
      {"branches.tip_radius", "length", "0.007", "radius of every tip", thesis,
       NumberKey{.high = 1e6,
                 .low_is_allowed = false,
                 .place = [](Values& v) -> double& { return v.parameters.plant.tip_radius; }}},

      {"branches.angle_reduction", "share", "0.0",
       "how far each node of the finished skeleton moves to its parent, which narrows the angles "
       "between branches; 0.5 is halfway",
       "[Liebemann2017] sec. 3.4, after Runions et al. 2007",
       NumberKey{.high = 0.99,
                 .place = [](Values& v) -> double& { return v.parameters.plant.angle_reduction; }}},
      {"branches.curve_reduction_deg", "degree", "0.0",
       "nodes where a branch turns by less than this are left out of mesh and leaves; 0 leaves "
       "out none",
       "[Liebemann2017] eq. 3.6",
       NumberKey{.high = 180, .place = [](Values& v) -> double& { return v.curve_reduction_deg; }}},
      {"branches.curve_reduction_order", "-", "\"simultaneous\"",
       "turns measured between the edges as they were (\"simultaneous\"), or \"root_to_tip\" "
       "between those that are left",
       "[Liebemann2017] eq. 3.6",
       ChoiceKey{{"simultaneous", "root_to_tip"},
                 [](Values& v, std::size_t word) {
                   v.parameters.plant.curve_reduction.order = static_cast<ReductionOrder>(word);
                 }}},

      {"pendulous.intensity", "share", "0.0",
       "lambda, how far branches hang; bends the finished skeleton", "[Brzoska2019] eq. 13",
       NumberKey{
           .high = 1,
           .place = [](Values& v) -> double& { return v.parameters.plant.pendulous.intensity; }}},
      {"pendulous.begin", "share", "0.7",
       "where bending starts: share of the greatest node depth that stem and iterations can give",
       thesis,
       NumberKey{.high = 1, .place = [](Values& v) -> double& { return v.pendulous_begin; }}},
      {"pendulous.first_order", "-", "25",
       "the same as a number of edges from the root, instead of begin",
       "[Brzoska2019] fig. 43, ambiguity A4",
       NumberKey{.high = 1e9,
                 .whole = true,
                 .place = [](Values& v) -> double& { return v.pendulous_first_order; }},
       true},

      {"mesh.circle_resolution", "-", "3", "corners of a ring across a branch",
       "[Brzoska2019] eq. 2, value published by its author",
       NumberKey{.low = 3,
                 .high = 256,
                 .whole = true,
                 .place = [](Values& v) -> double& { return v.circle_resolution; }}},
      {"mesh.duplicate_ratio", "share", "0.49",
       "a child no thicker than this share of its parent gets a ring of its own at the parent's "
       "place",
       "[Brzoska2019] fig. 31, value published by its author",
       NumberKey{.high = 1,
                 .place = [](Values& v) -> double& {
                   return v.parameters.plant.branches.duplicate_ratio;
                 }}},
      {"mesh.ring_turn", "-", "\"from_parent\"",
       "rings turned \"from_parent\" do not twist; \"from_vertical\" is eq. 3 literally",
       "[Brzoska2019] eq. 3",
       ChoiceKey{{"from_parent", "from_vertical"},
                 [](Values& v, std::size_t word) {
                   v.parameters.plant.branches.ring_turn =
                       word == 0 ? RingTurn::from_parent : RingTurn::from_vertical;
                 }}},
      {"mesh.single_child_normal", "-", "\"bisector\"",
       "where the ring of a node with one child looks: along the \"bisector\" of the edges below "
       "and above, or at the \"child\"",
       "[Brzoska2019] sec. 5.1",
       ChoiceKey{{"bisector", "child"},
                 [](Values& v, std::size_t word) {
                   v.parameters.plant.branches.single_child_normal =
                       word == 0 ? SingleChildNormal::bisector : SingleChildNormal::child;
                 }}},
      {"mesh.texture_length", "length", "1.0",
       "length along a branch after which the bark's texture repeats", "phytobench",
       NumberKey{.high = 1e9,
                 .low_is_allowed = false,
                 .place = [](Values& v) -> double& {
                   return v.parameters.plant.branches.texture_length;
                 }}},

      {"leaves.per_node", "-", "0.7",
       "leaves on each thin node: the whole part always, the fraction as a probability",
       "[Brzoska2019] sec. 5.1, value published by its author",
       NumberKey{.high = 1000,
                 .place = [](Values& v) -> double& { return v.parameters.plant.leaves.per_node; }}},
      {"leaves.shape", "-", "\"cross_foil\"",
       "\"cross_foil\" (two squares at right angles) or one \"square\"; both sides of each are "
       "there",
       "[Brzoska2019] sec. 3.5",
       ChoiceKey{{"cross_foil", "square"},
                 [](Values& v, std::size_t word) {
                   v.parameters.plant.leaves.shape =
                       word == 0 ? LeafShape::cross_foil : LeafShape::square;
                 }}},
      {"leaves.size", "length", "0.7", "mean edge of a leaf's square", thesis,
       NumberKey{.high = 1e6,
                 .low_is_allowed = false,
                 .place = [](Values& v) -> double& { return v.parameters.plant.leaves.size; }}},
      {"leaves.size_spread", "share", "0.2", "standard deviation of the size over its mean",
       "[Brzoska2019] sec. 5.1",
       NumberKey{
           .high = 1,
           .place = [](Values& v) -> double& { return v.parameters.plant.leaves.size_spread; }}},
      {"leaves.radius_limit", "length", "0.009", "only branches thinner than this carry leaves",
       thesis,
       NumberKey{
           .high = 1e6,
           .low_is_allowed = false,
           .place = [](Values& v) -> double& { return v.parameters.plant.leaves.radius_limit; }}},

      {"colours.bark", "-", "\"#6b4a2b\"", "colour of the bark", "phytobench",
       ColourKey{[](Values& v) -> Colour& { return v.parameters.plant.bark_colour; }}},
      {"colours.leaves", "-", "\"#457d29\"", "colour of the leaves", "phytobench",
       ColourKey{[](Values& v) -> Colour& { return v.parameters.plant.leaf_colour; }}},
      {"colours.bark_texture", "-", "\"\"",
       "PNG file wrapped around the branches instead of the colour", "[Brzoska2019] sec. 5.4",
       FileKey{[](Values& v) -> std::string& { return v.parameters.plant.bark_texture; }}},
      {"colours.leaf_texture", "-", "\"\"",
       "PNG file on every leaf's squares instead of particles in the colour",
       "[Brzoska2019] sec. 5.4",
       FileKey{[](Values& v) -> std::string& { return v.parameters.plant.leaf_texture; }}},

      {"variant.tropism_order", "-", "\"before_normalising\"",
       "tropism added \"before_normalising\" (published trees) or \"after_normalising\" (eq. 10 as "
       "printed)",
       "[Brzoska2019] eq. 10, erratum E3",
       ChoiceKey{{"before_normalising", "after_normalising"},
                 choose_variant<&GrowthVariant::tropism_order>}},
      {"variant.attraction_sum", "-", "\"unit_vectors\"",
       "sum of \"unit_vectors\" (eq. 9) or \"raw_vectors\" (the sentence before eq. 8)",
       "[Brzoska2019] eq. 9, ambiguity A1",
       ChoiceKey{{"unit_vectors", "raw_vectors"}, choose_variant<&GrowthVariant::attraction_sum>}},
      {"variant.perception_test", "-", "\"during_search\"",
       "nearest node among those that perceive (\"during_search\"), or nearest first "
       "(\"after_search\")",
       "[Brzoska2019] sec. 4.1, ambiguity A2",
       ChoiceKey{{"during_search", "after_search"},
                 choose_variant<&GrowthVariant::perception_test>}},
      {"variant.repeat_guard", "-", "\"on\"",
       "\"off\" lets a node get the same child again and again", "[Brzoska2019] erratum E17",
       ChoiceKey{{"on", "off"}, choose_variant<&GrowthVariant::repeat_guard>}},
      {"variant.start_killers", "-", "\"crown_root\"",
       "start nodes that remove points: \"crown_root\" or \"crown_stem_too\"",
       "[Brzoska2019] ambiguity A3",
       ChoiceKey{{"crown_root", "crown_stem_too"}, choose_variant<&GrowthVariant::start_killers>}},
      {"variant.deferred_kill_distance", "-", "\"previous_iteration\"",
       "kill distance of a deferred removal; \"current_iteration\" is a mistake that grows another "
       "tree",
       "[Brzoska2019] sec. 5.2.2 D",
       ChoiceKey{{"previous_iteration", "current_iteration"},
                 choose_variant<&GrowthVariant::deferred_kill_distance>}},
      {"variant.influence_boundary", "-", "\"inclusive\"",
       "whether a point exactly at the influence distance still attracts (\"inclusive\") or not "
       "(\"exclusive\")",
       "[Liebemann2017] sec. 3.3",
       ChoiceKey{{"inclusive", "exclusive"}, choose_variant<&GrowthVariant::influence_boundary>}},
      {"variant.kill_boundary", "-", "\"inclusive\"",
       "whether a point exactly at the kill distance is removed (\"inclusive\") or not "
       "(\"exclusive\")",
       "[Liebemann2017] sec. 3.3",
       ChoiceKey{{"inclusive", "exclusive"}, choose_variant<&GrowthVariant::kill_boundary>}},
      {"variant.deferred_first_pass", "-", "\"skip\"",
       "whether a deferred removal runs before the first growth; \"kill\" is a mistake that grows "
       "another tree",
       "[Brzoska2019] sec. 5.2.2 D",
       ChoiceKey{{"skip", "kill"}, choose_variant<&GrowthVariant::deferred_first_pass>}},
  };
}

}  // namespace

std::span<const TreeParameterKey> tree_parameter_keys() {
  static const std::vector<TreeParameterKey> keys = make_keys();
  return keys;
}

}  // namespace phytobench
