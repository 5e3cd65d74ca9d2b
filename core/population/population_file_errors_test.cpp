// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "core/contract/text_file.hpp"
#include "core/picture/image.hpp"
#include "core/population/test_population_files.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

int line_of(const std::string& text, std::string_view name) {
  if (section_of(name).empty()) return 1;
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/// That the key alone, with this value, is refused in its line, by a message with its name.
void expect_refused(std::string_view name, std::string_view value) {
  const std::string text = file_with(name, value);
  expect_complaint(text, line_of(text, name), name);
}

TEST(PopulationFileErrors, NumbersOfTheWrongTypeOrOutOfRangeAreRefused) {
  for (const PopulationKey& key : population_keys()) {
    const auto* number = std::get_if<PopulationNumber>(&key.kind);
    if (number == nullptr) continue;
    const NumberRange& range = number->range;
    for (const char* value : {"\"1\"", "true", "[1.0]", "{ a = 1 }", "1979-05-27", "nan", "-inf"})
      expect_refused(key.name, value);
    expect_refused(key.name, fmt::format("{}", range.low - 1.0));
    if (std::isfinite(range.high)) expect_refused(key.name, fmt::format("{}", range.high + 1.0));
    if (!range.infinity_is_allowed) expect_refused(key.name, "inf");
    if (!range.low_is_allowed) expect_refused(key.name, fmt::format("{}", range.low));
    if (!range.high_is_allowed) expect_refused(key.name, fmt::format("{}", range.high));
    if (range.whole) expect_refused(key.name, "2.5");
  }
}

TEST(PopulationFileErrors, OtherTypesAreRefusedToo) {
  for (const PopulationKey& key : population_keys()) {
    if (std::holds_alternative<PopulationNumber>(key.kind)) continue;
    const bool is_pair = std::holds_alternative<PopulationPair>(key.kind);
    for (const char* value : {"1", "{ a = 1 }", "[]", "[1.0, nan]", "[\"a\"]"})
      expect_refused(key.name, value);
    if (is_pair)
      for (const char* value :
           {"[1.0]", "[1.0, 2.0, 3.0]", "[1.0, -1e10]", "[inf, 1.0]", "\"1, 2\""})
        expect_refused(key.name, value);
    if (std::holds_alternative<PopulationChoice>(key.kind))
      for (const char* value : {"\"nonsense\"", "\"\""}) expect_refused(key.name, value);
    if (std::holds_alternative<PopulationSwitch>(key.kind)) expect_refused(key.name, "\"true\"");
    if (std::holds_alternative<PopulationIds>(key.kind))
      for (const char* value : {"[-1]", "[1.5]", "[1e16]"}) expect_refused(key.name, value);
  }
}

TEST(PopulationFileErrors, UnknownKeysGetASuggestion) {
  expect_complaint("\n\nsed = 1\n", 3, "unknown key 'sed'; did you mean 'seed'?");
  expect_complaint("[ground]\nsiz = [1, 1]\n", 2, "did you mean 'ground.size'?");
  expect_complaint("[[species]]\nname = \"oak\"\ngrowth_rat = 1\n", 3,
                   "unknown key 'species.growth_rat'; did you mean 'species.growth_rate'?");
  expect_complaint("[[species]]\nname = \"oak\"\n[species.reproduction]\nseeds = 1\n", 4,
                   "unknown key 'species.reproduction.seeds'");
  expect_complaint("[weather]\nrain = 1\n", 1, "unknown key 'weather'");
  expect_complaint("\"a\\nb\" = 1\n", 1, "unknown key 'a?b'");
  expect_complaint("\"ground.size\" = [1, 1]\n", 1, "in quotes");
  EXPECT_THAT(complaint_on("x = 1"), HasSubstr("(phytobench compete --example lists all keys)"));
}

struct BadFile {
  const char* text;
  int line;
  const char* part;
};

void expect_complaints(std::initializer_list<BadFile> files) {
  for (const BadFile& file : files) expect_complaint(file.text, file.line, file.part);
}

TEST(PopulationFileErrors, SectionsAndListsMustBeWrittenAsSuch) {
  expect_complaints({
      {"ground = 3\n", 1, "ground is a section; write it as [ground]"},
      {"\n[[ground]]\nsize = [1, 1]\n", 2, "ground is a section"},
      {"[species]\nname = \"oak\"\n", 1, "species is a list; write [[species]]"},
      {"species = \"oak\"\n", 1, "species is a list"},
      {"species = []\n", 1, "species is a list"},
      {"species = [1, {name = \"oak\"}]\n", 1, "species is a list"},
      {"[[species]]\nname = \"oak\"\n[event]\nstep = 1\n", 3, "event is a list"},
      {"[[species]]\nname = \"oak\"\n[[species.reproduction]]\n", 3,
       "species.reproduction is a section"},
      {"[ground.size]\nx = 1\n", 1, "ground.size must be two numbers"},
  });
}

TEST(PopulationFileErrors, BrokenTomlIsRefusedAtItsPlace) {
  expect_complaints({
      {"[ground\n", 1, "not valid TOML"},
      {"seed = 1\nseed = 2\n", 2, "not valid TOML"},
      {"rule =\n", 1, "not valid TOML"},
      {"[ground]\ntorus = fals\n", 2, "not valid TOML"},
      {"name = \"\x80\"\n", 1, "not valid TOML"},
      {"seed = 99999999999999999999\n", 1, "not valid TOML"},
  });
}

TEST(PopulationFileErrors, SpeciesAreThereNamedAndDifferent) {
  expect_complaints({
      {"", 1, "there is no species; give at least one [[species]]"},
      {"seed = 1\n\n[ground]\ntorus = true\n", 1, "there is no species"},
      {"[[species]]\ncount = 3\n", 1, "species.name is missing in [[species]]"},
      {"[[species]]\nname = \"*\"\n", 2, "species.name = '*' is not allowed"},
      {"[[species]]\nname = \"a,b\"\n", 2, "species.name = 'a,b' is not allowed"},
      {"[[species]]\nname = \"oak\"\n[[species]]\nname = \"oak\"\n", 4,
       "there are two species 'oak'; rename one"},
  });
}

TEST(PopulationFileErrors, SizesAndRatesMustFitTogether) {
  expect_complaints({
      {"[[species]]\nname = \"a\"\nstart_radius = [0.2, 0.1]\n", 3, "begins with the larger"},
      {"[[species]]\nname = \"a\"\nstart_radius = [0.2, 0.6]\n", 3, "exceeds species.largest"},
      {"[[species]]\nname = \"a\"\nlargest_radius = 0.05\n", 3, "species.start_radius = 0.07"},
      {"[[species]]\nname = \"a\"\ngrowth_rate = 0.6\n", 3, "one step would overshoot"},
      {"[[species]]\nname = \"a\"\ngrowth_rate = 0\ngrowth = \"richards\"\n", 3, "Richards' law"},
      {"[[species]]\nname = \"a\"\n[species.reproduction]\nseeds_per_metre = 1\n", 4,
       "no plant would bear seeds"},
      {"[[species]]\nname = \"a\"\n[species.reproduction]\nseeds_per_metre = 1\nthreshold = 0.5\n",
       5, "no plant would bear seeds"},
      {"[[species]]\nname = \"a\"\n[species.reproduction]\nseeds_per_metre = 1\nthreshold = 0.1\n"
       "seedling_radius = 0.5\n",
       6, "seedling_radius = 0.5 is not below"},
      {"[[species]]\nname = \"a\"\ncount = 15000000\n[[species]]\nname = \"b\"\ncount = 15000000\n",
       6, "adds up to 30000000 plants; give at most 20000000"},
  });
}

TEST(PopulationFileErrors, FactorsAreOneOrTwo) {
  expect_complaints({
      {"[[species]]\nname = \"a\"\nroot_factor_poor = 9\n", 3,
       "species.root_factor_poor is given without species.root_factor_rich"},
      {"[[species]]\nname = \"a\"\ncrown_factor_rich = 9\n", 3,
       "species.crown_factor_rich is given without species.crown_factor_poor"},
      {"[[species]]\nname = \"a\"\nroot_factor_poor = 9\nroot_factor_rich = 3\nroot_factor = 6\n",
       5, "species.root_factor and species.root_factor_poor set the same; give one of them"},
  });
}

TEST(PopulationFileErrors, RulesOfCompetitionAndMortalityAreChecked) {
  expect_complaints({
      {"[competition]\nrule = \"symetric\"\n[[species]]\nname = \"a\"\n", 2,
       "unknown rule 'symetric'; did you mean 'symmetric'?"},
      {"[mortality]\nthreshold = 0.1\n[[species]]\nname = \"a\"\n", 1, "without mortality.rule"},
      {"[mortality]\nrule = \"mean-growth\"\n[[species]]\nname = \"a\"\n", 2, "lets no plant die"},
  });
  EXPECT_EQ(complaint_on("[mortality]\n[[species]]\nname = \"a\"\n"), "no error");
}

TEST(PopulationFileErrors, InfluenceNamesSpeciesAndSaysSomething) {
  const std::string oak = "[[species]]\nname = \"oak\"\n[[influence]]\n";
  expect_complaint(oak + "of = \"oka\"\non = \"oak\"\nabove = \"none\"\n", 4,
                   "influence.of = \"oka\" is no species of this file; did you mean 'oak'?");
  expect_complaint(oak + "of = \"*\"\non = \"oak \"\nabove = \"none\"\n", 5, "influence.on = ");
  expect_complaint(oak + "of = \"oak\"\non = \"oak\"\n", 3, "[[influence]] says nothing");
  expect_complaint(oak + "on = \"oak\"\nabove = \"none\"\n", 3, "influence.of is missing");
  expect_complaint(oak + "of = \"oak\"\nabove = \"none\"\n", 3, "influence.on is missing");
}

TEST(PopulationFileErrors, EventsStrikeInOneWayAndHappen) {
  const std::string oak = "steps = 9\n[[species]]\nname = \"oak\"\n[[event]]\nkind = \"removal\"\n";
  expect_complaint(oak, 4, "event.step is missing in [[event]]");
  expect_complaint(oak + "step = 1\n", 4, "none of them strike plants; give exactly one");
  expect_complaint(oak + "step = 1\nlargest = 1\nshare = 0.5\n", 4, "several of them");
  expect_complaint(oak + "step = 9\nlargest = 1\n", 6,
                   "event.step = 9 is not below steps = 9; the event would never happen");
  expect_complaint(oak + "step = 8\nlargest = 1\nspecies = \"okk\"\n", 8,
                   "event.species = \"okk\" is no species of this file; did you mean 'oak'?");
  expect_complaint(oak + "step = 8\nlargest = 1\nspecies = \"*\"\n", 8, "by leaving it out");
  expect_complaint(oak + "step = 8\nplants = [1]\nspecies = \"oak\"\n", 8, "does not go with");
  EXPECT_EQ(complaint_on(oak + "step = 8\nlargest = 1\nspecies = \"oak\"\n"), "no error");
}

/// Files that others lie beside, in a fresh folder that is removed afterwards.
class PopulationFolder : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / (std::string("phytobench-population-") + test->name() +
                                              "-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    file_ = folder_ / "stand.toml";
  }
  void TearDown() override { fs::remove_all(folder_); }

  PopulationFile read(const std::string& text) const {
    write_file_atomically(file_, text);
    return read_population_file(file_);
  }
  std::string complaint(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_, file_;
};

constexpr const char* two_soils =
    "[[species]]\nname = \"a\"\nroot_factor_poor = 15\nroot_factor_rich = 6\n";

TEST_F(PopulationFolder, MapsLieBesideTheFile) {
  Image image(4, 2);
  image.at(3, 0) = {255, 255, 255, 255};
  write_file_atomically(folder_ / "maps" / "soil.png", to_png(image));
  const PopulationParameters read = this->read(
                                            "ground = { size = [40, 20], corner = [100, 0] "
                                            "}\nresources.nutrients = \"maps/soil.png\"\n" +
                                            std::string(two_soils))
                                        .parameters;
  EXPECT_EQ(read.nutrients.columns(), 4);
  EXPECT_EQ(read.nutrients.at({139.0, 19.0}), 1.0);
  EXPECT_EQ(read.nutrients.at({139.0, 1.0}), 0.0);
  EXPECT_TRUE(read.light.is_uniform());
}

TEST_F(PopulationFolder, MapsThatCannotBeReadOrChangeNothingAreRefusedInTheirLine) {
  EXPECT_THAT(complaint("[resources]\nnutrients = \"soil.png\"\n" + std::string(two_soils)),
              StartsWith(file_.string() + ":2: resources.nutrients: " +
                         (folder_ / "soil.png").string() + ": no such file"));
  write_file_atomically(folder_ / "soil.png", to_png(Image(20, 10)));
  EXPECT_THAT(complaint("[resources]\nnutrients = \"soil.png\"\n" + std::string(two_soils)),
              HasSubstr("not in the proportion of the ground, 200 m x 200 m"));
  write_file_atomically(folder_ / "soil.png", to_png(Image(20, 20)));
  EXPECT_EQ(complaint("[resources]\nnutrients = \"soil.png\"\n" + std::string(two_soils)),
            "no error");
  EXPECT_THAT(complaint("[resources]\nlight = \"soil.png\"\n" + std::string(two_soils)),
              StartsWith(file_.string() + ":2: resources.light changes nothing: give a species "
                                          "crown_factor_poor and crown_factor_rich that differ"));
}

TEST_F(PopulationFolder, PlantsLieBesideTheFile) {
  const std::string text = "\nplants = \"two.csv\"\n[[species]]\nname = \"a\"\n";
  EXPECT_EQ(complaint(text),
            file_.string() + ":2: plants: " + (folder_ / "two.csv").string() + ": no such file");
  write_file_atomically(folder_ / "two.csv", "x,y,radius\n1,1,0.1\n");
  EXPECT_EQ(read(text).plants, folder_ / "two.csv");
  EXPECT_TRUE(read("plants = \"\"\n[[species]]\nname = \"a\"\n").plants.empty());
}

TEST_F(PopulationFolder, NamesWhatItReadsAsItIsWrittenAndWhereItLies) {
  write_file_atomically(folder_ / "maps" / "soil.png", to_png(Image(20, 20)));
  write_file_atomically(folder_ / "two.csv", "x,y,radius\n1,1,0.1\n");
  const std::string both =
      "[resources]\nnutrients = \"maps/soil.png\"\nlight = \"maps/soil.png\"\n" +
      std::string(two_soils) + "crown_factor_poor = 15\ncrown_factor_rich = 6\n";
  const NamedFile soil{"maps/soil.png", folder_ / "maps/soil.png"};
  const NamedFile plants{"./two.csv", folder_ / "./two.csv"};
  EXPECT_EQ(read("plants = \"./two.csv\"\n" + both).files, (std::vector{plants, soil}));
  EXPECT_EQ(read(both).files, std::vector{soil});
  EXPECT_TRUE(read("plants = \"\"\n" + std::string(two_soils)).files.empty());
}

TEST_F(PopulationFolder, MissingFileIsAnInputErrorThatNamesIt) {
  try {
    read_population_file(folder_ / "none.toml");
    ADD_FAILURE() << "a file that is not there was read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), StartsWith((folder_ / "none.toml").string() + ": no such file"));
  }
}

}  // namespace
}  // namespace phytobench
