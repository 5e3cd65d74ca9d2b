// SPDX-License-Identifier: MIT
// Sec. 3.2: the values that the successors of a multiplier take from a range, by the printed
// formula and by the suite; then functions of the user, and chance.
#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "core/component_graph/component_graph_file.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/lintermann1997_placement.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

namespace oracle = oracles::lintermann1997;

constexpr NumberSpan example{10.0, 20.0};
constexpr std::uint32_t successors = 5;

/// The length of a horn whose file has this setting, as the i-th of n.
double length_of_horn(const std::string& setting, SiblingNumber number, std::uint64_t seed = 0) {
  const ComponentGraph graph = parse_component_graph(
      fmt::format("[graph]\nroot = \"horn\"\n[component.horn]\nkind = \"horn\"\nlength = {}\n",
                  setting),
      "range");
  const Prototype& horn = graph.prototypes.at(0);
  InstancePlace place;
  place.number = number;
  place.seed = seed;
  place.identity = number.i;
  const ComponentValues values(horn.kind->keys, horn.settings, place);
  const auto length = std::find_if(horn.kind->keys.begin(), horn.kind->keys.end(),
                                   [](const ComponentKey& key) { return key.name == "length"; });
  return values.number(static_cast<std::size_t>(length - horn.kind->keys.begin()));
}

bool is_within(double value, const NumberSpan& range) {
  return value >= std::min(range.first, range.last) && value <= std::max(range.first, range.last);
}

void record_example(ExperimentContext& context) {
  std::int64_t from_0 = 0, from_1 = 0;
  double apart = 0.0;
  for (std::uint32_t i = 1; i <= successors; ++i) {
    const int whole = static_cast<int>(i);
    const double value = length_of_horn("[10.0, 20.0]", {i, successors});
    context.record(fmt::format("range-10-20/successor-{}", i), value);
    const double printed_0 = oracle::v_i_as_printed(10, 20, successors, whole - 1);
    const double printed_1 = oracle::v_i_as_printed(10, 20, successors, whole);
    context.record(fmt::format("range-10-20/printed/i-{}", whole - 1), printed_0);
    from_0 += is_within(printed_0, example);
    from_1 += is_within(printed_1, example);
    apart = std::max(apart, std::abs(value - printed_0));
  }
  context.record("range-10-20/printed/i-5", oracle::v_i_as_printed(10, 20, successors, 5));
  context.record("range-10-20/printed_from_0/values_within", from_0);
  context.record("range-10-20/printed_from_1/values_within", from_1);
  context.record("range-10-20/largest_difference_from_printed", apart);
  context.record("range-10-20/only_successor", length_of_horn("[10.0, 20.0]", {1, 1}));
}

void record_with_seed(ExperimentContext& context, const std::string& name, RecordValue value,
                      std::int64_t sample) {
  Record record{.experiment = {}, .measurement = name, .value = std::move(value)};
  record.sample_size = sample;
  record.seed = context.seed();
  context.record(record);
}

/// Any ranges and numbers of successors.
void record_random_ranges(ExperimentContext& context) {
  constexpr std::int64_t ranges = 1000;
  std::int64_t outside = 0, ends_missed = 0;
  double unequal = 0.0, from_corrected = 0.0, from_printed_without_v0 = 0.0;
  CounterStream random(context.seed(), 0);
  for (std::int64_t k = 0; k < ranges; ++k) {
    const NumberSpan range{random.next_between(-100, 100), random.next_between(-100, 100)};
    const auto n = static_cast<std::uint32_t>(random.next_between(2, 30));
    const double step = (range.last - range.first) / (n - 1.0);
    for (std::uint32_t i = 1; i <= n; ++i) {
      const int whole_i = static_cast<int>(i), whole_n = static_cast<int>(n);
      const double value = range.at({i, n});
      outside += !is_within(value, range);
      if (i > 1) unequal = std::max(unequal, std::abs(value - range.at({i - 1, n}) - step));
      from_corrected = std::max(
          from_corrected,
          std::abs(value - oracle::v_i_corrected(range.first, range.last, whole_n, whole_i)));
      const double printed = oracle::v_i_as_printed(range.first, range.last, whole_n, whole_i - 1);
      from_printed_without_v0 =
          std::max(from_printed_without_v0, std::abs(value - range.first - printed));
    }
    ends_missed += range.at({1, n}) != range.first || range.at({n, n}) != range.last;
  }
  record_with_seed(context, "random_ranges/values_outside", outside, ranges);
  record_with_seed(context, "random_ranges/ranges_whose_ends_are_missed", ends_missed, ranges);
  record_with_seed(context, "random_ranges/largest_inequality_of_steps", unequal, ranges);
  record_with_seed(context, "random_ranges/differs_from_oracle", from_corrected, ranges);
  record_with_seed(context, "random_ranges/largest_difference_from_v_0_plus_printed",
                   from_printed_without_v0, ranges);
}

void record_functions(ExperimentContext& context) {
  context.record("function/squared",
                 length_of_horn("{ value = [10.0, 20.0], function = \"value ^ 2\" }", {3, 5}));
  context.record("function/of_the_number",
                 length_of_horn("{ value = [10.0, 20.0], function = \"value + i / n\" }", {3, 5}));
  const std::string chance = "{ value = 2.0, function = \"value * random(0.9, 1.1)\" }";
  constexpr std::uint32_t siblings = 500;
  double least = 1e9, greatest = 0.0, sum = 0.0;
  std::int64_t not_repeated = 0, same_for_next_seed = 0;
  for (std::uint32_t i = 1; i <= siblings; ++i) {
    const double factor = length_of_horn(chance, {i, siblings}, context.seed()) / 2.0;
    least = std::min(least, factor);
    greatest = std::max(greatest, factor);
    sum += factor;
    not_repeated += factor != length_of_horn(chance, {i, siblings}, context.seed()) / 2.0;
    same_for_next_seed += factor == length_of_horn(chance, {i, siblings}, context.seed() + 1) / 2.0;
  }
  record_with_seed(context, "random_factor/least", least, siblings);
  record_with_seed(context, "random_factor/greatest", greatest, siblings);
  record_with_seed(context, "random_factor/mean", sum / siblings, siblings);
  record_with_seed(context, "random_factor/not_repeated_by_their_seed", not_repeated, siblings);
  record_with_seed(context, "random_factor/same_for_the_next_seed", same_for_next_seed, siblings);
}

void run(ExperimentContext& context) {
  record_example(context);
  record_random_ranges(context);
  record_functions(context);
}

}  // namespace

extern const ExperimentDescriptor parameter_ranges;
constinit const ExperimentDescriptor parameter_ranges{
    .id = "lintermann1997/parameter-ranges",
    .question = "Which values do the successors of a multiplier take from a range?",
    .source = "[Lintermann1997] sec. 3.2",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
