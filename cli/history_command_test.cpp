// SPDX-License-Identifier: MIT
#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string instructions(const std::string& commit, const std::string& count) {
  return R"({"schema": "phytobench/instructions-1", "origin": {"commit": ")" + commit +
         R"(", "changed": false, "compiler": "GNU 12", "flags": "-O3"},
  "benchmarks": [{"name": "grid/near", "inputs": "i", "instructions": )" +
         count + R"(}, {"name": "grid/far", "inputs": "i", "instructions": 77}]})";
}

std::string result(const std::string& commit, const std::string& processor,
                   const std::string& seconds) {
  return R"({"schema": "phytobench/result-1", "origin": {"commit": ")" + commit +
         R"(", "changed": false, "compiler": "GNU 12", "flags": "-O3"},
  "machine": {"processor": ")" +
         processor + R"(", "logical_processors": 2, "kernel": "Linux"}, "seed": 0,
  "reference": {"name": "reference kernel", "seconds": 0.5},
  "benchmarks": [{"name": "grid/near", "inputs": "i", "answer": "a", "processes": [[)" +
         seconds + "]]}]}";
}

class History : public CommandLine {
 protected:
  /// Two runs: instructions 1000, then 1030.
  void append_two() const {
    write("1.json", instructions("aaa", "1000"));
    write("2.json", instructions("bbb", "1030"));
    EXPECT_THAT(output_of({"history", "append", "1.json"}), HasSubstr("run 1: 2 values"));
    EXPECT_THAT(output_of({"history", "append", "2.json"}), HasSubstr("run 2: 2 values"));
  }
};

TEST_F(History, AppendsAndLists) {
  append_two();
  EXPECT_TRUE(exists("build/history.sqlite"));
  const std::string text = output_of({"history"});
  EXPECT_THAT(text, HasSubstr("aaa"));
  EXPECT_EQ(line_count(text), 3);
  const nlohmann::json document = json_of({"history", "list", "--json"}, "phytobench/history-1");
  ASSERT_EQ(document.at("entries").size(), 2u);
  EXPECT_EQ(document.at("entries").at(1).at("commit"), "bbb");
  EXPECT_EQ(document.at("entries").at(1).at("values"), 2);
  EXPECT_EQ(left_behind(), (std::set<std::string>{"1.json", "2.json", "build"}));
}

TEST_F(History, ShowsASeriesWithItsChanges) {
  append_two();
  const std::string text = output_of({"history", "show", "grid/near"});
  EXPECT_THAT(text, HasSubstr("grid/near, instructions"));
  EXPECT_THAT(text, HasSubstr("+3.00 %"));
  const nlohmann::json document =
      json_of({"history", "show", "grid/near", "--json"}, "phytobench/history-1");
  const nlohmann::json& points = document.at("entries").at(0).at("lines").at(0).at("points");
  EXPECT_EQ(points.at(0).at("value"), 1000);
  EXPECT_TRUE(points.at(0).at("change").is_null());
  EXPECT_NEAR(points.at(1).at("change").get<double>(), 0.03, 1e-12);
}

TEST_F(History, PlotsOnTheTerminalAndAsSvg) {
  append_two();
  expect_refused({"history", "plot", "grid/near", "--out", "plots/near.svg"}, 2,
                 "there is no folder plots");
  std::filesystem::create_directories(folder() / "plots");
  EXPECT_THAT(output_of({"history", "plot", "grid/near", "--out", "plots/near.svg"}),
              HasSubstr("run 1 to run 2"));
  EXPECT_THAT(read("plots/near.svg"), HasSubstr("<title>grid/near, instructions</title>"));
  write("r.json", result("bbb", "Model 1", "0.5"));
  output_of({"history", "append", "r.json"});
  expect_refused({"history", "plot", "grid/near", "--out", "x.svg"}, 2, "instructions, ratio");
  output_of({"history", "plot", "grid/near", "--out", "x.svg", "--quantity", "ratio"});
  expect_refused({"history", "plot", "grid/far", "--out", "x.png"}, 2, ".svg");
  expect_refused({"history", "list", "--out", "x.svg"}, 2, "history plot only");
}

TEST_F(History, SavesAndComparesBaselines) {
  append_two();
  EXPECT_THAT(output_of({"history", "save", "v2"}), HasSubstr("v2 is run 2"));
  EXPECT_THAT(output_of({"history"}), HasSubstr("v2"));
  const std::string text = output_of({"history", "compare", "v2", "1"});
  EXPECT_THAT(text, HasSubstr("-2.91 %"));
  EXPECT_THAT(text, HasSubstr("1 of 2 values differ"));
  EXPECT_THAT(text, Not(HasSubstr("grid/far")));
  EXPECT_THAT(output_of({"history", "compare", "v2"}), HasSubstr("run 1, "));
  const nlohmann::json document =
      json_of({"history", "compare", "1", "2", "--json"}, "phytobench/history-1");
  EXPECT_EQ(document.at("entries").size(), 2u);
  expect_refused({"history", "compare", "v3"}, 2, "did you mean 'v2'");
  expect_refused({"history", "compare", "9"}, 2, "no run 9");
}

TEST_F(History, ComparesOneQuantityAlone) {
  append_two();
  EXPECT_THAT(output_of({"history", "compare", "1", "2", "--quantity", "instructions"}),
              HasSubstr("1 of 2 values differ"));
  expect_refused({"history", "compare", "1", "2", "--quantity", "instruction"}, 2,
                 "'instruction' is no quantity");
  expect_refused({"history", "compare", "1", "2", "--quantity", "ratio"}, 2,
                 "'1' has no ratio; it has instructions");
  for (const char* action : {"list", "append 1.json", "save v1"})
    expect_refused_line(std::string("history ") + action + " --quantity nothing",
                        "--quantity nothing: goes with history show, plot and compare only");
}

TEST_F(History, RatiosOfOtherMachinesAreNotCompared) {
  write("1.json", result("aaa", "Model 1", "0.5"));
  write("2.json", result("bbb", "Model 2", "0.75"));
  write("3.json", result("ccc", "Model 1", "0.75"));
  for (const char* file : {"1.json", "2.json", "3.json"}) output_of({"history", "append", file});
  expect_refused({"history", "compare", "1", "2"}, 4, "one kind of machine");
  EXPECT_THAT(output_of({"history", "compare", "1", "3"}), HasSubstr("+50.00 %"));
  const std::string text = output_of({"history", "show", "grid/near"});
  EXPECT_THAT(text, HasSubstr("+50.00 %"));
  EXPECT_THAT(text, Not(HasSubstr("same")));
}

TEST_F(History, WrongWordsAndFilesAreRefused) {
  expect_refused({"history"}, 2, "history append");
  append_two();
  expect_refused({"history", "lst"}, 2, "did you mean 'list'");
  expect_refused({"history", "show"}, 2, "show BENCHMARK");
  expect_refused({"history", "list", "more"}, 2, "with 1 more word;");
  expect_refused({"history", "show", "grid/nearer"}, 2, "did you mean 'grid/near'");
  expect_refused({"history", "show", "grid/near", "--quantity", "seconds"}, 2, "counter:NAME");
  expect_refused({"history", "show", "grid/near", "--quantity", "ratio"}, 2, "has no ratio");
  expect_refused({"history", "append", "none.json"}, 2, "no such file");
  expect_refused({"history", "append", "build/history.sqlite"}, 2, "is no JSON");
  expect_refused({"history", "append", "1.json", "2.json"}, 2, "another build");
  expect_refused({"history", "list", "--file", "1.json"}, 2, "is no SQLite file");
  EXPECT_EQ(line_count(output_of({"history"})), 3);
}

TEST_F(History, FullDiskKeepsWhatWasThere) {
  append_two();
  {
    const SmallFilesOnly full(4096);
    expect_refused({"history", "append", "1.json"}, 3, "nothing was changed there");
    expect_refused({"history", "append", "1.json", "--file", "other/h.sqlite"}, 3,
                   "nothing was changed there");
  }
  EXPECT_EQ(line_count(output_of({"history"})), 3);
  output_of({"history", "append", "1.json", "--file", "other/h.sqlite"});
}

}  // namespace
}  // namespace phytobench
