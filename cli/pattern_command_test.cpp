// SPDX-License-Identifier: MIT
// phytobench pattern as a user meets it.
#include <cmath>

#include "cli/command_line_fixture.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr int side = 10;  // of the square in which all patterns below lie

class PatternCommand : public CommandLine {
 protected:
  json document(const std::string& arguments) const {
    const Outcome outcome = run_line("pattern --json " + arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return json::parse(outcome.out);
  }

  static std::string lattice() {
    std::string csv = "x,y\n";
    for (int i = 0; i < side; ++i)
      for (int j = 0; j < side; ++j)
        csv += std::to_string(i + 0.5) + "," + std::to_string(j + 0.5) + "\n";
    return csv;
  }

  /// Random points; of two species, with heights.
  static std::string random_points(std::uint64_t seed, int count) {
    CounterStream stream(seed, 0);
    std::string csv = "height,x,species,y\n";
    for (int i = 0; i < count; ++i) {
      const double height = 1 + stream.next_unit(), x = side * stream.next_unit();
      csv += std::to_string(height) + "," + std::to_string(x) + (i % 3 == 0 ? ",oak," : ",beech,") +
             std::to_string(side * stream.next_unit()) + "\n";
    }
    return csv;
  }

  static std::string clusters() {
    CounterStream stream(3, 0);
    std::string csv = "x,y\n";
    for (int i = 0; i < 100; ++i) {
      const double x = 2 + 3 * (i % 3) + 0.3 * stream.next_unit();
      csv +=
          std::to_string(x) + "," + std::to_string(1 + i % 2 * 5 + 0.3 * stream.next_unit()) + "\n";
    }
    return csv;
  }

  const std::string window = " --window 0,0,10,10";
};

TEST_F(PatternCommand, TellsLatticesClustersAndChanceApart) {
  const json regular = document(file("lattice.csv", lattice()) + window + " --torus");
  EXPECT_EQ(regular["schema"], "phytobench/pattern-1");
  EXPECT_EQ(regular["n"], 100);
  EXPECT_EQ(regular["window"]["kind"], "torus");
  EXPECT_NEAR(regular["hopkins"]["mean_ratio"]["exact"].get<double>(), 0.38259785823210635, 1e-12);
  EXPECT_NEAR(regular["hopkins"]["squared_ratio"]["exact"].get<double>(), 1.0 / 6, 1e-12);
  EXPECT_EQ(regular["kind"], "regular");
  EXPECT_EQ(regular["p_value"], 0.002);
  EXPECT_NEAR(regular["clark_evans"]["naive_ratio"].get<double>(), 2.0, 1e-12);

  const json clustered = document(file("clusters.csv", clusters()) + window);
  EXPECT_EQ(clustered["kind"], "clustered");
  EXPECT_GT(clustered["hopkins"]["mean_ratio"]["exact"].get<double>(), 3.0);
  EXPECT_LE(clustered["l_function"]["p_value"].get<double>(), 0.01);

  const json chance = document(file("random.csv", random_points(1, 150)) + window);
  EXPECT_EQ(chance["kind"], "random");
  const json band = chance["hopkins"]["mean_ratio"]["csr95"];
  EXPECT_LT(band[0].get<double>(), 1.0);
  EXPECT_GT(band[1].get<double>(), 1.0);
  EXPECT_THAT(chance["verdict"].get<std::string>(), HasSubstr("random"));
}

TEST_F(PatternCommand, ComparesMarksAndSpecies) {
  const json d = document(file("random.csv", random_points(2, 120)) + window +
                          " --mark height --species species --simulations 99");
  EXPECT_GT(d["mark_correlation"]["p_value"].get<double>(), 0.01);
  ASSERT_EQ(d["species"].size(), 1u);
  EXPECT_EQ(d["species"][0]["first"], "beech");
  EXPECT_EQ(d["species"][0]["n"], (json{80, 40}));
  EXPECT_GT(d["species"][0]["cross_l"]["p_value"].get<double>(), 0.01);
}

TEST_F(PatternCommand, SameBytesForAnyNumberOfThreads) {
  const std::string arguments =
      "pattern --json --simulations 99 " + file("random.csv", random_points(4, 90)) + window;
  EXPECT_EQ(run_line(arguments).out, run_line(arguments + " --threads 3").out);
}

TEST_F(PatternCommand, TakesAPolygon) {
  const std::string corners = file("plot.csv", "x,y\n0,0\n10,0\n10,10\n0,10\n");
  const std::string points = file("random.csv", random_points(5, 60));
  const json polygon = document(points + " --polygon " + corners);
  const json rectangle = document(points + window);
  EXPECT_EQ(polygon["window"]["kind"], "polygon");
  EXPECT_NEAR(polygon["hopkins"]["mean_ratio"]["exact"].get<double>(),
              rectangle["hopkins"]["mean_ratio"]["exact"].get<double>(), 1e-12);
}

TEST_F(PatternCommand, SaysThatItGuessedTheWindow) {
  const Outcome outcome = run_line("pattern " + file("random.csv", random_points(6, 60)));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("for want of --window"));
  EXPECT_THAT(outcome.out, HasSubstr("verdict: "));
  EXPECT_TRUE(document(file("random.csv", random_points(6, 60)))["window_is_guessed"]);
}

TEST_F(PatternCommand, HasAnswersForOddPatterns) {
  const json one = document(file("one.csv", "\xef\xbb\xbfx,y\r\n1,2\r\n") + window);
  EXPECT_EQ(one["kind"], "undecided");
  EXPECT_TRUE(one["p_value"].is_null());
  EXPECT_TRUE(one["hopkins"]["mean_ratio"]["exact"].is_null());
  const json equal = document(file("equal.csv", "x,y\n1,2\n1,2\n1,2\n") + window);
  EXPECT_EQ(equal["kind"], "clustered");
  EXPECT_THAT(equal["verdict"].get<std::string>(), HasSubstr("twin"));
  const json two = document(file("two.csv", "x,y\n1,2\n3,2\n") + window);
  EXPECT_EQ(two["n"], 2);
}

TEST_F(PatternCommand, SaysWhatIsUndefined) {
  std::string zeros = "x,y,m\n";
  for (int i = 0; i < 12; ++i)
    zeros += std::to_string(i % 4) + "," + std::to_string(i / 4 + 0.1 * i) + ",0\n";
  const Outcome outcome = run_line("pattern " + file("zeros.csv", zeros) + window + " --mark m");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("mark correlation of m: undefined"));
  const json guessed = document(file("three.csv", "x,y\n0,0\n1,2\n3,1\n"));
  EXPECT_TRUE(guessed["clark_evans"]["p_value"].is_null());
}

TEST_F(PatternCommand, LeavesOutWhatWouldTakeHours) {
  std::string csv = "x,y\n9,9\n";
  CounterStream stream(6, 0);
  for (int i = 0; i < 50'000; ++i) {
    const double x = 1e-5 * stream.next_unit();
    csv += std::to_string(1e6 * x) + "e-6," + std::to_string(1e6 * 1e-5 * stream.next_unit()) +
           "e-6\n";
  }
  const Outcome outcome =
      run_line("pattern " + file("lump.csv", csv) + window + " --simulations 39");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("too many pairs"));
  EXPECT_THAT(outcome.out, HasSubstr("verdict: clustered"));
}

TEST_F(PatternCommand, TakesNamesInAnyEncoding) {
  const json d = document(file("odd.csv",
                               "x,y,s\n1,1,b\xfc"
                               "che\n2,3,oak\n4,1,oak\n") +
                          window + " --species s");
  EXPECT_EQ(d["species"].size(), 1u);
}

TEST_F(PatternCommand, RefusesWrongInput) {
  const auto with = [&](const char* text) { return "pattern " + file("w.csv", text); };
  expect_refused_line("pattern", "points");
  expect_refused_line(with(""), "w.csv: is empty");
  expect_refused_line(with("x\n1\n"), "w.csv:1: no column 'y'");
  expect_refused_line(with("x,y\n1,inf\n"), "w.csv:2: y = 'inf'");
  expect_refused_line(with("x,y\n1,2\n1,2\n"), "give --window");
  expect_refused_line(with("x,y\n1,2\n\n11,2\n") + window, "w.csv:4: (11, 2) lies outside");
  expect_refused_line(with("x,y\n1,2\n") + " --torus", "--torus needs --window");
  const std::string good = with("x,y\n1,2\n3,4\n");
  expect_refused_line(good + " --window 0,0,0,1", "--window '0,0,0,1'");
  expect_refused_line(good + " --window 0,0,1e200,1e100", "use another unit");
  expect_refused_line(with("x,y\n0,0\n1e-170,2e-170\n"), "use another unit");
  expect_refused_line(good + " --mark height", "no column 'height'");
  expect_refused_line(good + " --species sp", "no column 'sp'");
  expect_refused_line(good + " --simulations 5", "simulations");
  expect_refused_line(good + window + " --polygon p.csv", "not both");
  const std::string crossed = file("p.csv", "x,y\n0,0\n1,1\n1,0\n0,1\n");
  expect_refused_line(good + " --polygon " + crossed, "p.csv: sides 1 and 3 of the polygon meet");
  expect_refused_line(with("x,y,s\n1,2,a\n3,4,a\n") + " --species s", "one species only");
}

}  // namespace
}  // namespace phytobench
