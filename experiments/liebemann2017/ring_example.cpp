// SPDX-License-Identifier: MIT
// Figure 3.2 with its own numbers: does growth end as sec. 3.3 says, and what is the tree like?
#include <algorithm>
#include <map>
#include <tuple>

#include "core/tree/branch_angle_reduction.hpp"
#include "core/tree/branch_depth.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/skeleton_svg.hpp"
#include "experiments/liebemann2017/fork_angles.hpp"
#include "experiments/liebemann2017/influence_scenes.hpp"
#include "experiments/liebemann2017/literal_growth.hpp"
#include "experiments/liebemann2017/path_lengths.hpp"
#include "experiments/liebemann2017/random_words.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

using Place = std::tuple<double, double, double>;

std::size_t distinct_places(const Skeleton& skeleton) {
  std::map<Place, int> times;
  for (const Vector3& p : skeleton.positions()) ++times[{p.x, p.y, p.z}];
  return times.size();
}

/// The greatest number of successors of one node at one place.
int most_identical_successors(const Skeleton& skeleton) {
  std::map<std::pair<std::int32_t, Place>, int> times;
  int most = 0;
  for (std::size_t v = 1; v < skeleton.node_count(); ++v) {
    const Vector3& p = skeleton.positions()[v];
    most = std::max(most, ++times[{skeleton.parents()[v], Place{p.x, p.y, p.z}}]);
  }
  return most;
}

/// Ranges over the clouds, and how often growth ended for which reason.
struct Outcomes {
  std::map<std::string, Range> ranges;
  std::map<std::string, std::int64_t> reasons;
  std::int64_t differs_from_oracle = 0;

  void add(const std::string& name, double value) { ranges[name].extend(value); }

  void add(const GrowthResult& result) {
    const Skeleton& skeleton = result.skeleton;
    const ChildLists children(skeleton);
    std::size_t degree = 0;
    for (std::int32_t v = 0; v < static_cast<std::int32_t>(skeleton.node_count()); ++v)
      degree = std::max(degree, children.of(v).size());
    const auto depths = branch_depths(skeleton, BranchDepthReading::at_creation);
    const auto places = static_cast<double>(distinct_places(skeleton));
    ++reasons[stop_of(result)];
    add("iterations", static_cast<double>(iterations_that_grew(result)));
    add("nodes", static_cast<double>(skeleton.node_count()));
    add("places", places);
    add("repeated", static_cast<double>(skeleton.node_count()) - places);
    add("identical_successors", most_identical_successors(skeleton));
    add("tips", static_cast<double>(tip_count(skeleton)));
    add("greatest_degree", static_cast<double>(degree));
    add("greatest_Z", *std::max_element(depths.begin(), depths.end()));
    add("points_left", static_cast<double>(result.live_points));
    add("root_radius", branch_radii(skeleton, tip_radius, ring_g)[0]);
  }

  void record(ExperimentContext& context, const std::string& name,
              const std::vector<std::string>& measured) const {
    for (const StopReason reason : {StopReason::iteration_limit, StopReason::no_points_left,
                                    StopReason::no_point_in_range, StopReason::no_new_node}) {
      const std::string text(name_of(reason));
      const auto found = reasons.find(text);
      record_seeded(context, name + "/stop/" + text,
                    found == reasons.end() ? std::int64_t{0} : found->second);
    }
    record_ranges(context, name, measured, "1");
    record_seeded(context, name + "/differs_from_oracle", differs_from_oracle);
  }

  void record_ranges(ExperimentContext& context, const std::string& name,
                     const std::vector<std::string>& measured, const char* unit) const {
    for (const std::string& what : measured) {
      record_seeded(context, name + "/" + what + "/least", ranges.at(what).least, unit);
      record_seeded(context, name + "/" + what + "/greatest", ranges.at(what).greatest, unit);
    }
  }
};

Seedling figure_3_2(std::uint64_t seed, std::uint64_t number) {
  return scene(cloud(round_region(RoundShape::disc, ring_radius), ring_points, seed, number),
               {0, -ring_radius, 0});
}

/// Figure 3.2 (c): the tree with every node halfway to its parent, [RLP07] sec. 2.
Skeleton narrow(Outcomes& once, const Skeleton& skeleton) {
  Skeleton narrowed = reduce_branch_angles(skeleton, 0.5);
  const double before = mean_fork_angle_deg(skeleton), after = mean_fork_angle_deg(narrowed);
  once.add("fork_angle", before);
  once.add("narrowed_fork_angle", after);
  once.add("fork_angle_left", after / before);
  return narrowed;
}

void draw(ExperimentContext& context, const Skeleton& narrowed) {
  context.artifact(
      "figure-3.2.svg",
      skeleton_svg(narrowed, "Figure 3.2 (c, d): another cloud of 2000 points in a disc"));
}

void run(ExperimentContext& context) {
  // The literal loop takes a second for each cloud.
  const std::uint64_t clouds = context.tier() == Tier::smoke ? 5 : 20;
  const std::uint64_t literal_clouds = context.tier() == Tier::full ? 12 : 1;
  Outcomes printed, once;
  double radius_off = 0.0;
  std::int64_t repeats_elsewhere = 0;
  for (std::uint64_t i = 0; i < clouds; ++i) {
    context.progress(fmt::format("cloud {} of {}", i + 1, clouds));
    const Seedling as_printed = figure_3_2(context.seed(), i);
    const Seedling rejecting = without_repeats(as_printed);
    const GrowthResult repeated = grow(as_printed), single = grow(rejecting);
    printed.add(repeated);
    once.add(single);
    repeats_elsewhere += distinct_places(repeated.skeleton) != single.skeleton.node_count();
    radius_off =
        std::max(radius_off, std::abs(branch_radii(single.skeleton, tip_radius, ring_g)[0] -
                                      std::sqrt(static_cast<double>(tip_count(single.skeleton)))));
    const Skeleton narrowed = narrow(once, single.skeleton);
    if (i == 0) draw(context, narrowed);
    if (i >= literal_clouds) continue;
    printed.differs_from_oracle += differs_from_oracle(as_printed, repeated);
    once.differs_from_oracle += differs_from_oracle(rejecting, single);
  }
  record_seeded(context, "clouds", static_cast<std::int64_t>(clouds));
  printed.record(context, "printed",
                 {"nodes", "places", "repeated", "identical_successors", "points_left"});
  once.record(context, "once",
              {"iterations", "nodes", "repeated", "tips", "greatest_degree", "greatest_Z",
               "points_left", "root_radius", "fork_angle_left"});
  once.record_ranges(context, "once", {"fork_angle", "narrowed_fork_angle"}, "deg");
  record_seeded(context, "printed/places_not_those_without_repeats", repeats_elsewhere);
  record_seeded(context, "once/root_radius_off_sqrt_of_tips", radius_off, "length");
}

}  // namespace

extern const ExperimentDescriptor ring_example;
constinit const ExperimentDescriptor ring_example{
    .id = "liebemann2017/ring-example",
    .question = "Does growth with the numbers of figure 3.2 end by itself, and with which tree?",
    .source = "[Liebemann2017] sec. 3.3, 3.4, fig. 3.2",
    .seconds = {0.5, 3.0, 20.0},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
