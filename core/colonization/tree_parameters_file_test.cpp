// SPDX-License-Identifier: MIT
#include "core/colonization/tree_parameters_file.hpp"

#include <unistd.h>

#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/colonization/test_growth.hpp"
#include "core/colonization/tree_parameter_keys.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

/// The message of the InputError that the text ends with.
std::string complaint(std::string_view text) {
  try {
    parsed_tree(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// One line that begins with file and line and holds `part`.
void expect_complaint(std::string_view text, int line, std::string_view part) {
  const std::string message = complaint(text);
  EXPECT_THAT(message, StartsWith(fmt::format("tree.toml:{}:", line))) << "for\n" << text;
  EXPECT_THAT(message, HasSubstr(std::string(part))) << "for\n" << text;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

/// A file that gives nothing but one key, which stands in the line `line_of(name)`.
std::string file_with(std::string_view name, std::string_view value) {
  const std::size_t period = name.find('.');
  if (period == std::string_view::npos) return fmt::format("{} = {}\n", name, value);
  return fmt::format("[{}]\n{} = {}\n", name.substr(0, period), name.substr(period + 1), value);
}

int line_of(std::string_view name) {
  return name.find('.') == std::string_view::npos ? 1 : 2;
}

void expect_same(const GrowthVariant& a, const GrowthVariant& b) {
  EXPECT_EQ(a.tropism_order, b.tropism_order);
  EXPECT_EQ(a.attraction_sum, b.attraction_sum);
  EXPECT_EQ(a.perception_test, b.perception_test);
  EXPECT_EQ(a.repeat_guard, b.repeat_guard);
  EXPECT_EQ(a.start_killers, b.start_killers);
  EXPECT_EQ(a.deferred_kill_distance, b.deferred_kill_distance);
  EXPECT_EQ(a.deferred_first_pass, b.deferred_first_pass);
  EXPECT_EQ(a.influence_boundary, b.influence_boundary);
  EXPECT_EQ(a.kill_boundary, b.kill_boundary);
}

void expect_same(const GrowthLimits& a, const GrowthLimits& b) {
  EXPECT_EQ(a.most_children, b.most_children);
  EXPECT_EQ(a.most_branch_depth, b.most_branch_depth);
  EXPECT_EQ(a.rest_iterations, b.rest_iterations);
  EXPECT_EQ(a.step_weighting, b.step_weighting);
}

void expect_same(const KillDistanceSchedule& a, const KillDistanceSchedule& b) {
  EXPECT_EQ(a.begin, b.begin);
  EXPECT_EQ(a.end, b.end);
  EXPECT_EQ(a.sigmoid_begin, b.sigmoid_begin);
  EXPECT_EQ(a.sigmoid_end, b.sigmoid_end);
  EXPECT_EQ(a.interpolation, b.interpolation);
}

void expect_same(const TreeParameters& a, const TreeParameters& b) {
  EXPECT_EQ(a.seed, b.seed);
  EXPECT_EQ(a.random, b.random);
  EXPECT_EQ(a.cloud.radii, b.cloud.radii);
  EXPECT_EQ(a.cloud.cutoff_bottom, b.cloud.cutoff_bottom);
  EXPECT_EQ(a.cloud.cutoff_top, b.cloud.cutoff_top);
  EXPECT_EQ(a.cloud_density, b.cloud_density);
  EXPECT_EQ(a.iterations, b.iterations);
  EXPECT_EQ(a.step_length, b.step_length);
  EXPECT_EQ(a.influence_distance, b.influence_distance);
  EXPECT_EQ(a.perception_angle_deg, b.perception_angle_deg);
  expect_same(a.kill_distance, b.kill_distance);
  EXPECT_EQ(a.tropism_direction, b.tropism_direction);
  EXPECT_EQ(a.tropism_weights, b.tropism_weights);
  EXPECT_EQ(a.tropism_damping, b.tropism_damping);
  EXPECT_EQ(a.tropism_damping_density, b.tropism_damping_density);
  EXPECT_EQ(a.stem_length, b.stem_length);
  EXPECT_EQ(a.stem_tilt_deg, b.stem_tilt_deg);
  EXPECT_EQ(a.crown_stem_ratio, b.crown_stem_ratio);
  expect_same(a.variant, b.variant);
  expect_same(a.limits, b.limits);
  EXPECT_EQ(a.round_cloud.has_value(), b.round_cloud.has_value());
  EXPECT_EQ(a.plant.angle_reduction, b.plant.angle_reduction);
  EXPECT_EQ(a.plant.curve_reduction.cosine_above, b.plant.curve_reduction.cosine_above);
  EXPECT_EQ(a.plant.curve_reduction.order, b.plant.curve_reduction.order);
}

TEST(TreeParametersFile, EmptyHoldsTheDefaults) {
  const TreeParameters read = parsed_tree("");
  TreeParameters defaults;
  // Gnarliness 0.8 gives the start settings but for rounding; its author published four digits.
  EXPECT_NEAR(read.influence_distance, defaults.influence_distance, 1e-12);
  EXPECT_NEAR(read.cloud_density, defaults.cloud_density, 1e-12);
  EXPECT_NEAR(read.kill_distance.begin, defaults.kill_distance.begin, 1e-12);
  EXPECT_NEAR(read.kill_distance.end, defaults.kill_distance.end, 5e-5);
  defaults.influence_distance = read.influence_distance;
  defaults.cloud_density = read.cloud_density;
  defaults.kill_distance.begin = read.kill_distance.begin;
  defaults.kill_distance.end = read.kill_distance.end;
  expect_same(read, defaults);
}

TEST(TreeParametersFile, ExampleHoldsTheDefaultsAndGivesTheSameSeedling) {
  const TreeParameters example = parse_tree_parameters(example_tree_file(), "example");
  const TreeParameters empty = parsed_tree("");
  expect_same(example, empty);
  const Seedling from_example = make_seedling(example);
  const Seedling from_empty = make_seedling(empty);
  EXPECT_EQ(from_example.attraction_points, from_empty.attraction_points);
  EXPECT_EQ(tree_hash(from_example.skeleton), tree_hash(from_empty.skeleton));
  EXPECT_EQ(from_example.growth.tropism, from_empty.growth.tropism);
}

TEST(TreeParametersFile, ExampleShowsEveryKeyWithMeaningAndSource) {
  const std::string example = example_tree_file();
  for (const TreeParameterKey& key : tree_parameter_keys()) {
    const std::string short_name(key.name.substr(key.name.rfind('.') + 1));
    EXPECT_THAT(example, HasSubstr(fmt::format("{}{} = {}\n", key.shown_as_comment ? "# " : "\n",
                                               short_name, key.default_text)));
    // The sentence begins with a capital letter.
    EXPECT_THAT(example, HasSubstr(std::string(key.meaning.substr(1)) + ". Unit: "));
    EXPECT_FALSE(key.source.empty()) << key.name;
  }
}

TEST(TreeParametersFile, EveryDefaultMayBeWrittenOut) {
  const TreeParameters defaults = parsed_tree("");
  for (const TreeParameterKey& key : tree_parameter_keys()) {
    if (key.shown_as_comment) continue;  // the three distances, which go together only
    SCOPED_TRACE(key.name);
    expect_same(parsed_tree(file_with(key.name, key.default_text)), defaults);
  }
}

TEST(TreeParametersFile, EveryNumberReachesItsPlace) {
  const TreeParameters read = parsed_tree(R"(
seed = 5
random = "counter"
[cloud]
radii = [1, 2.5, 3]
cutoff_bottom = 0.25
cutoff_top = 0.125
density = 7.5
[growth]
iterations = 12
step_length = 0.5
perception_angle_deg = 90
influence_distance = 2.0
kill_distance_begin = 1.5
kill_distance_end = 0.75
kill_interpolation = "linear"
sigmoid_begin = -8
sigmoid_end = 8.5
[tropism]
direction = [0.5, -1.0, 0.0]
weights = [2.0, 3.0, 4.0]
damping = "none"
damping_density = 1.5
[stem]
length = 3.0
tilt_deg = 10.0
crown_ratio = 0.5
)");
  TreeParameters expected;
  expected.seed = 5;
  expected.random = StreamKind::counter;
  expected.cloud = {.radii = {1, 2.5, 3}, .cutoff_bottom = 0.25, .cutoff_top = 0.125};
  expected.cloud_density = 7.5;
  expected.iterations = 12;
  expected.step_length = 0.5;
  expected.perception_angle_deg = 90.0;
  expected.influence_distance = 2.0;
  expected.kill_distance = {.begin = 1.5,
                            .end = 0.75,
                            .sigmoid_begin = -8.0,
                            .sigmoid_end = 8.5,
                            .interpolation = KillInterpolation::linear};
  expected.tropism_direction = {0.5, -1.0, 0.0};
  expected.tropism_weights = {2.0, 3.0, 4.0};
  expected.tropism_damping = TropismDamping::none;
  expected.tropism_damping_density = 1.5;
  expected.stem_length = 3.0;
  expected.stem_tilt_deg = 10.0;
  expected.crown_stem_ratio = 0.5;
  expect_same(read, expected);
}

TEST(TreeParametersFile, EveryVariantReachesItsPlace) {
  const TreeParameters read = parsed_tree(R"(
[variant]
tropism_order = "after_normalising"
attraction_sum = "raw_vectors"
perception_test = "after_search"
repeat_guard = "off"
start_killers = "crown_stem_too"
deferred_kill_distance = "current_iteration"
deferred_first_pass = "kill"
)");
  expect_same(read.variant, {.tropism_order = TropismOrder::after_normalising,
                             .attraction_sum = AttractionSum::raw_vectors,
                             .perception_test = PerceptionTest::after_search,
                             .repeat_guard = RepeatGuard::off,
                             .start_killers = StartKillers::crown_stem_too,
                             .deferred_kill_distance = DeferredKillDistance::current_iteration,
                             .deferred_first_pass = DeferredFirstPass::kill});
}

TEST(TreeParametersFile, GnarlinessSetsDistancesAndDensity) {
  const TreeParameters read = parsed_tree(
      "[growth]\ngnarliness = 0.5\nbranch_density_begin = 0.25\nbranch_density_end = 1.0\n");
  const GnarlinessCoupling coupling = couple_to_gnarliness(0.5);
  EXPECT_EQ(read.influence_distance, coupling.influence_distance);
  EXPECT_EQ(read.kill_distance.begin, coupling.kill_distance(0.25));
  EXPECT_EQ(read.kill_distance.end, coupling.kill_distance(1.0));
  EXPECT_EQ(read.cloud_density, coupling.cloud_density);
}

TEST(TreeParametersFile, DensityInTheFileBeatsThatOfGnarliness) {
  EXPECT_EQ(parsed_tree("[cloud]\ndensity = 3.0\n[growth]\ngnarliness = 0.5\n").cloud_density, 3.0);
}

TEST(TreeParametersFile, InfluenceDistanceMayBeInfinite) {
  const TreeParameters read = parsed_tree(
      "[growth]\ninfluence_distance = inf\nkill_distance_begin = 0.58\nkill_distance_end = "
      "0.265\n");
  EXPECT_EQ(read.influence_distance, std::numeric_limits<double>::infinity());
}

TEST(TreeParametersFile, KillDistanceMayEqualTheInfluenceDistance) {
  const TreeParameters read = parsed_tree(
      "[growth]\ninfluence_distance = 0.5\nkill_distance_begin = 0.5\nkill_distance_end = 0.5\n");
  EXPECT_EQ(read.kill_distance.begin, 0.5);
}

TEST(TreeParametersFile, TakesDottedKeysAndForeignLineEnds) {
  EXPECT_EQ(parsed_tree("growth.iterations = 7\n").iterations, 7);
  EXPECT_EQ(parsed_tree("seed = 7\r\n[cloud]\r\ndensity = 2.0\r\n").cloud_density, 2.0);
  EXPECT_EQ(parsed_tree("seed = 7").seed, 7u);
}

TEST(TreeParametersFile, NumbersOfTheWrongTypeAreInputErrors) {
  for (const TreeParameterKey& key : tree_parameter_keys()) {
    if (!std::holds_alternative<NumberKey>(key.kind)) continue;
    for (const char* value : {"\"1\"", "true", "[1.0]", "{ a = 1 }", "1979-05-27"})
      expect_complaint(file_with(key.name, value), line_of(key.name), key.name);
  }
}

TEST(TreeParametersFile, NumbersThatAreNoneOrUnboundedAreInputErrors) {
  const std::set<std::string_view> unbounded{"growth.influence_distance", "growth.most_children",
                                             "growth.most_branch_depth", "growth.rest_iterations"};
  for (const TreeParameterKey& key : tree_parameter_keys()) {
    const NumberKey* number = std::get_if<NumberKey>(&key.kind);
    if (number == nullptr) continue;
    expect_complaint(file_with(key.name, "nan"), line_of(key.name), key.name);
    expect_complaint(file_with(key.name, "-inf"), line_of(key.name), key.name);
    EXPECT_EQ(number->infinity_is_allowed, unbounded.contains(key.name)) << key.name;
    if (!number->infinity_is_allowed)
      expect_complaint(file_with(key.name, "inf"), line_of(key.name), key.name);
  }
}

TEST(TreeParametersFile, NumbersOutOfRangeAreInputErrors) {
  for (const TreeParameterKey& key : tree_parameter_keys()) {
    const NumberKey* number = std::get_if<NumberKey>(&key.kind);
    if (number == nullptr) continue;
    const std::string below = fmt::format("{}", number->low - 1.0);
    expect_complaint(file_with(key.name, below), line_of(key.name), key.name);
    const std::string lowest = fmt::format("{}", number->low);
    if (!number->low_is_allowed)
      expect_complaint(file_with(key.name, lowest), line_of(key.name), key.name);
    if (std::isfinite(number->high)) {
      const std::string above = fmt::format("{}", number->high + 1.0);
      expect_complaint(file_with(key.name, above), line_of(key.name), key.name);
    }
  }
}

TEST(TreeParametersFile, LengthsAndDensitiesMustBePositive) {
  for (const char* name :
       {"cloud.density", "growth.step_length", "growth.perception_angle_deg",
        "growth.influence_distance", "growth.kill_distance_begin", "growth.kill_distance_end"})
    for (const char* value : {"0.0", "0", "-0.0", "-1.0"})
      expect_complaint(file_with(name, value), 2, name);
  expect_complaint(file_with("growth.iterations", "0"), 2, "growth.iterations");
  expect_complaint(file_with("stem.length", "-0.1"), 2, "stem.length");
}

TEST(TreeParametersFile, FractionsForWholeNumbersAreInputErrors) {
  for (const char* name : {"seed", "growth.iterations"})
    expect_complaint(file_with(name, "1.5"), line_of(name), fmt::format("{} = 1.5", name));
  EXPECT_EQ(parsed_tree("seed = 3.0\n").seed, 3u);
}

TEST(TreeParametersFile, VectorsMustBeThreeFiniteNumbers) {
  for (const TreeParameterKey& key : tree_parameter_keys()) {
    const VectorKey* vector = std::get_if<VectorKey>(&key.kind);
    if (vector == nullptr) continue;
    for (const char* value : {"[]", "[1.0, 2.0]", "[1.0, 2.0, 3.0, 4.0]", "5.0", "\"1 2 3\"",
                              "[1.0, nan, 3.0]", "[1.0, 2.0, inf]", "[1.0, \"2\", 3.0]"})
      expect_complaint(file_with(key.name, value), line_of(key.name), key.name);
    if (!vector->must_be_positive) continue;
    for (const char* value : {"[1.0, 0.0, 3.0]", "[-1.0, 2.0, 3.0]"})
      expect_complaint(file_with(key.name, value), line_of(key.name), key.name);
  }
  EXPECT_NO_THROW(parsed_tree("[tropism]\ndirection = [0.0, -1.0, 0.0]\n"));
}

TEST(TreeParametersFile, ChoicesMustBeOneOfTheirWords) {
  for (const TreeParameterKey& key : tree_parameter_keys()) {
    const ChoiceKey* choice = std::get_if<ChoiceKey>(&key.kind);
    if (choice == nullptr) continue;
    for (const char* value : {"\"nonsense\"", "\"\"", "1", "true"})
      expect_complaint(file_with(key.name, value), line_of(key.name), key.name);
    for (const std::string_view word : choice->words) {
      // Weights need a depth to divide by.
      const char* companion = word == "by_branch_depth" ? "most_branch_depth = 2\n" : "";
      EXPECT_NO_THROW(parsed_tree(file_with(key.name, fmt::format("\"{}\"", word)) + companion))
          << key.name;
      EXPECT_THAT(complaint(file_with(key.name, "\"nonsense\"")), HasSubstr(std::string(word)));
    }
  }
}

TEST(TreeParametersFile, UnknownKeysAreInputErrorsWithASuggestion) {
  expect_complaint("\n\nsed = 1\n", 3, "unknown key 'sed'; did you mean 'seed'?");
  expect_complaint("[cloud]\ndesity = 3.0\n", 2,
                   "unknown key 'cloud.desity'; did you mean 'cloud.density'?");
  expect_complaint("[variant]\nrepeat_gaurd = \"off\"\n", 2, "'variant.repeat_guard'");
  expect_complaint("[growth]\niterations = 3\n\n[leaf]\nsize = 1\n", 4, "unknown key 'leaf'");
  EXPECT_THAT(complaint("[leaf]\n"), testing::Not(HasSubstr("did you mean")));
}

TEST(TreeParametersFile, SectionsMustBeSections) {
  expect_complaint("cloud = 3\n", 1, "unknown key 'cloud'");
  expect_complaint("[[cloud]]\ndensity = 3.0\n", 1, "unknown key 'cloud'");
  expect_complaint("[seed]\n", 1, "seed must be a number");
  expect_complaint("seed = 1\n[cloud.radii]\nx = 1.0\n", 2, "cloud.radii must be three numbers");
  expect_complaint("[cloud.extra]\n", 1, "unknown key 'cloud.extra'");
}

struct BadFile {
  const char* text;
  int line;
  const char* part;
};

TEST(TreeParametersFile, ImpossibleCombinationsAreInputErrors) {
  const BadFile files[] = {
      {"[growth]\ninfluence_distance = 0.5\nkill_distance_begin = 0.6\nkill_distance_end = 0.2\n",
       3, "growth.kill_distance_begin = 0.6 exceeds growth.influence_distance = 0.5"},
      {"[growth]\ninfluence_distance = 0.5\nkill_distance_begin = 0.4\nkill_distance_end = 0.7\n",
       4, "growth.kill_distance_end = 0.7 exceeds growth.influence_distance = 0.5"},
      {"[growth]\ninfluence_distance = 0.5\n", 2,
       "growth.influence_distance is given without growth.kill_distance_begin"},
      {"[growth]\nkill_distance_begin = 0.2\n", 2,
       "growth.kill_distance_begin is given without growth.influence_distance"},
      {"[growth]\nkill_distance_end = 0.2\n", 2,
       "growth.kill_distance_end is given without growth.influence_distance"},
      {"[growth]\ninfluence_distance = 0.5\nkill_distance_begin = 0.4\n", 2,
       "growth.influence_distance is given without growth.kill_distance_end"},
      {"[growth]\ngnarliness = 0.5\ninfluence_distance = 0.5\nkill_distance_begin = 0.4\n"
       "kill_distance_end = 0.2\n",
       2, "growth.gnarliness would set growth.influence_distance"},
      {"[growth]\ninfluence_distance = 0.5\nkill_distance_begin = 0.4\nkill_distance_end = 0.2\n"
       "branch_density_end = 0.5\n",
       5, "growth.branch_density_end would set growth.influence_distance"},
      {"[growth]\ninfluence_distance = 1e-150\nkill_distance_begin = 1e-160\n"
       "kill_distance_end = 1e-160\n",
       2, "growth.influence_distance = 1e-150 is too small"},
      {"\n[cloud]\ncutoff_bottom = 0.5\ncutoff_top = 0.5\n", 4,
       "cloud.cutoff_bottom + cloud.cutoff_top = 1 leaves too little"},
  };
  for (const BadFile& file : files) expect_complaint(file.text, file.line, file.part);
}

TEST(TreeParametersFile, AbsurdNumbersOfPointsAreInputErrors) {
  expect_complaint("[cloud]\ndensity = 1e12\n", 2, "cloud.density");
  expect_complaint("[cloud]\nradii = [1e5, 1e5, 1e5]\ndensity = 26.4\n", 3, "cloud.radii");
  expect_complaint("[cloud]\nradii = [1e12, 1e12, 1e12]\ndensity = 26.4\n", 3, "cloud.radii");
  EXPECT_THAT(complaint("[tropism]\ndamping_density = 1e12\n"), HasSubstr("attraction points"));
}

TEST(TreeParametersFile, AbsurdNumbersOfStemPiecesAreInputErrors) {
  expect_complaint("[stem]\nlength = 1e9\n", 2, "stem.length");
  expect_complaint("[growth]\nstep_length = 1e-9\n[stem]\nlength = 2.0\n", 4, "growth.step_length");
}

TEST(TreeParametersFile, ThicknessSetsTheExponentUnlessThatIsGiven) {
  EXPECT_NEAR(parse_tree_parameters("", "x").plant.radius_exponent, 1.9, 1e-15);
  EXPECT_EQ(parse_tree_parameters("branches.thickness = 0.0", "x").plant.radius_exponent, 3.0);
  EXPECT_EQ(parse_tree_parameters("branches.thickness = 1.0", "x").plant.radius_exponent, 1.0);
  EXPECT_EQ(parse_tree_parameters("branches.radius_exponent = 2.5", "x").plant.radius_exponent,
            2.5);
}

TEST(TreeParametersFile, LeavesAreSeededWithTheTree) {
  EXPECT_EQ(parse_tree_parameters("seed = 12", "x").plant.leaves.seed, 12u);
}

TEST(TreeParametersFile, TexturesAreFoundFromTheFolderOfTheFile) {
  const PlantParameters plant =
      parse_tree_parameters("colours.bark_texture = \"oak.png\"", "trees/oak.toml").plant;
  EXPECT_EQ(plant.bark_texture, "trees/oak.png");
  EXPECT_EQ(plant.leaf_texture, "");
}

TEST(TreeParametersFile, BadLooksAreInputErrors) {
  const BadFile files[] = {
      {"[branches]\nthickness = 0.5\nradius_exponent = 2.0\n", 2, "set the same"},
      {"[pendulous]\nbegin = 0.5\nfirst_order = 9\n", 2, "set the same"},
      {"[pendulous]\nintensity = 1.5\n", 2, "pendulous.intensity = 1.5 is not allowed"},
      {"[mesh]\ncircle_resolution = 2\n", 2, "mesh.circle_resolution = 2 is not allowed"},
      {"[mesh]\ncircle_resolution = 3.5\n", 2, "whole"},
      {"[leaves]\nper_node = -1\n", 2, "leaves.per_node = -1 is not allowed"},
      {"[leaves]\nshape = \"oak\"\n", 2, "\"cross_foil\", \"square\""},
      {"[colours]\nbark = \"brown\"\n", 2, "colours.bark: 'brown' is no colour"},
      {"[colours]\nbark = 7\n", 2, "colours.bark"},
      {"[colours]\nleaf_texture = 7\n", 2, "colours.leaf_texture must be a file name"},
      {"[leaves]\nsise = 1.0\n", 2, "did you mean 'leaves.size'"},
  };
  for (const BadFile& file : files) expect_complaint(file.text, file.line, file.part);
}

TEST(TreeParametersFile, BrokenTomlIsAnInputError) {
  const BadFile files[] = {
      {"[cloud\n", 1, "not valid TOML"},
      {"seed = 1\nrandom =\n", 2, "not valid TOML"},
      {"seed = 1\nseed = 2\n", 2, "not valid TOML"},
      {"seed = 1\n\nrandom = \"counter\n", 3, "not valid TOML"},
      {"random = \"\x80\"\n", 1, "not valid TOML"},
      {"this is no parameter file\n", 1, "not valid TOML"},
  };
  for (const BadFile& file : files) expect_complaint(file.text, file.line, file.part);
}

/// A file with several trees, in a fresh folder that is removed afterwards.
class TreeParametersTables : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        fs::path(testing::TempDir()) / (std::string("phytobench-") + test->test_suite_name() + "-" +
                                        test->name() + "-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    file_ = folder_ / "trees.toml";
    write_file_atomically(file_, R"([tree.base]
seed = 3
[tree.base.cloud]
density = 5.0
cutoff_top = 0.1
[tree.tall]
seed = 4
[tree.tall.cloud]
density = 7.0
[tree.gnarled]
growth.gnarliness = 0.5
[tree.explicit.growth]
influence_distance = 0.5
kill_distance_begin = 0.4
kill_distance_end = 0.2
[tree.wrong.cloud]
density = -1.0
)");
  }

  void TearDown() override { fs::remove_all(folder_); }

  TreeParameters read_tables(const std::vector<std::string>& tables) const {
    std::vector<TreeSource> sources;
    for (const std::string& table : tables) sources.push_back({file_, table});
    return read_tree_parameters(sources);
  }

  std::string table_complaint(const std::vector<std::string>& tables) const {
    try {
      read_tables(tables);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
  fs::path file_;
};

TEST_F(TreeParametersTables, OneIsReadAlone) {
  const TreeParameters base = read_tables({"tree.base"});
  EXPECT_EQ(base.seed, 3u);
  EXPECT_EQ(base.cloud_density, 5.0);
  EXPECT_EQ(base.cloud.cutoff_top, 0.1);
}

TEST_F(TreeParametersTables, LaterOneReplacesKeysOfAnEarlierOne) {
  const std::vector<std::string> tall_last{"tree.base", "tree.tall"};
  const TreeParameters tall = read_tables(tall_last);
  EXPECT_EQ(tall.seed, 4u);
  EXPECT_EQ(tall.cloud_density, 7.0);
  EXPECT_EQ(tall.cloud.cutoff_top, 0.1);
  const std::vector<std::string> base_last{"tree.tall", "tree.base"};
  const TreeParameters base = read_tables(base_last);
  EXPECT_EQ(base.seed, 3u);
  EXPECT_EQ(base.cloud_density, 5.0);
}

TEST_F(TreeParametersTables, MissingOneIsAnInputErrorThatNamesIt) {
  for (const char* table : {"tree.none", "tree.base.seed", "tree.base.stem"}) {
    const std::string message = table_complaint({std::string(table)});
    EXPECT_THAT(message, StartsWith(file_.string() + ":"));
    EXPECT_THAT(message, HasSubstr(fmt::format("no table [{}]", table)));
  }
  const std::vector<std::string> second_missing{"tree.base", "tree.none"};
  EXPECT_THAT(table_complaint(second_missing), HasSubstr("no table [tree.none]"));
}

TEST_F(TreeParametersTables, BadValueIsAnInputErrorAtItsLine) {
  EXPECT_THAT(table_complaint({std::string("tree.wrong")}),
              StartsWith(file_.string() + ":17: cloud.density = -1 is not allowed"));
}

TEST_F(TreeParametersTables, TogetherMustNotGiveGnarlinessAndDistances) {
  const std::vector<std::string> both{"tree.gnarled", "tree.explicit"};
  EXPECT_THAT(table_complaint(both), HasSubstr("growth.gnarliness would set"));
  EXPECT_EQ(table_complaint({std::string("tree.explicit")}), "no error");
}

TEST_F(TreeParametersTables, WholeFileOfATreeIsReadToo) {
  write_file_atomically(folder_ / "tree.toml", "seed = 9\n");
  EXPECT_EQ(read_tree_parameters(folder_ / "tree.toml").seed, 9u);
  write_file_atomically(folder_ / "bad.toml", "seed = -9\n");
  try {
    read_tree_parameters(folder_ / "bad.toml");
    ADD_FAILURE() << "a negative seed was taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), StartsWith((folder_ / "bad.toml").string() + ":1: seed = -9"));
  }
}

TEST_F(TreeParametersTables, MissingFileIsAnInputErrorThatNamesIt) {
  try {
    read_tree_parameters(folder_ / "none.toml");
    ADD_FAILURE() << "a file that is not there was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), StartsWith((folder_ / "none.toml").string() + ":"));
  }
}

// Each of these once ran for hours or grew a tree from overflowed numbers.
TEST(TreeParametersFile, NumbersThatOnlyLookHarmlessAreInputErrors) {
  for (const char* text :
       {"[cloud]\ncutoff_bottom = 0.9999999\ncutoff_top = 0.0\n",
        "[tropism]\ndirection = [1e200, 0.0, 0.0]\n", "[tropism]\nweights = [0.0, 1e308, 0.0]\n",
        "[cloud]\nradii = [1e-200, 1e-200, 1e-200]\n"})
    EXPECT_THROW(parse_tree_parameters(text, "tree.toml"), InputError) << text;
}

}  // namespace
}  // namespace phytobench
