// SPDX-License-Identifier: MIT
// phytobench compete as a user meets it. Never asserts on a time.
#include <sstream>

#include "cli/compete_fixture.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using Lines = std::vector<std::string>;

Lines lines_of(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

Words fields_of(const std::string& line) {
  Words fields;
  std::istringstream stream(line);
  for (std::string field; std::getline(stream, field, ',');) fields.push_back(field);
  return fields;
}

TEST_F(CompeteCommand, RunsItsExample) {
  write("example.toml", output_of({"compete", "--example"}));
  const json d = document("example.toml");
  EXPECT_EQ(d["config"], "example.toml");
  EXPECT_TRUE(d["preset"].is_null());
  EXPECT_EQ(d["steps"], 60);
  EXPECT_EQ(d["species"].size(), 1u);
  EXPECT_GT(d["pairs_per_step"].get<double>(), 0.0);
  EXPECT_GT(d["pattern"]["clark_evans"].get<double>(), 0.5);
  EXPECT_TRUE(d["files"].empty());
  EXPECT_EQ(left_behind(), (std::set<std::string>{"example.toml", "lively.toml"}));
  expect_refused_line("compete --example --json", "nothing else; leave out --json");
}

TEST_F(CompeteCommand, AccountsForEveryPlant) {
  const json d = document("lively.toml --out run");
  std::uint64_t alive = 0;
  for (const json& row : d["species"]) {
    EXPECT_EQ(row["alive"].get<int>(),
              row["start"].get<int>() + row["born"].get<int>() - row["died"].get<int>());
    alive += row["alive"].get<std::uint64_t>();
  }
  EXPECT_EQ(d["species"][0]["start"], 80);
  EXPECT_GT(d["species"][0]["born"].get<int>(), 0);
  EXPECT_GT(d["species"][1]["died"].get<int>(), 2);
  EXPECT_EQ(d["all"]["alive"], alive);
  const Lines plants = lines_of(read("run/plants.csv")), steps = lines_of(read("run/steps.csv"));
  EXPECT_EQ(plants.size(), alive + 1);
  ASSERT_EQ(steps.size(), 1u + 3u * 41u);
  for (std::size_t i = 1; i < steps.size(); ++i) {
    const Words row = fields_of(steps[i]);
    ASSERT_EQ(row.size(), 11u);
    EXPECT_EQ(std::stoul(row[0]), (i - 1) / 3);
    const int start = row[1] == "annual" ? 80 : row[1] == "shrub" ? 60 : 140;
    EXPECT_EQ(std::stoi(row[2]), start + std::stoi(row[3]) - std::stoi(row[4])) << steps[i];
  }
  const Words last = fields_of(steps.back());
  EXPECT_EQ(last[1], "all");
  EXPECT_EQ(std::stoul(last[2]), alive);
  EXPECT_EQ(std::stod(last[8]), d["all"]["gini"].get<double>());
}

TEST_F(CompeteCommand, LeavesTheFilesItNames) {
  const std::string out =
      run_line("compete lively.toml --json --out new/run --frames 15 --every 7").out;
  EXPECT_EQ(read("new/run/summary.json"), out);
  const json d = json::parse(out);
  EXPECT_EQ(read("new/run/parameters.toml"), lively);
  for (const char* picture : {"stand.svg", "curves.svg"})
    EXPECT_THAT(read(fs::path("new/run") / picture), testing::StartsWith("<svg"));
  std::set<std::string> named;
  for (const json& file : d["files"])
    if (file != "frames/") named.insert(file.get<std::string>());
  for (const char* frame : {"frames/00000.png", "frames/00001.png", "frames/00002.png"})
    named.insert(frame);
  std::set<std::string> found;
  for (const auto& [name, content] : files_below("new/run")) {
    found.insert(name);
    if (name.ends_with(".png")) EXPECT_THAT(content, testing::StartsWith("\x89PNG")) << name;
  }
  EXPECT_EQ(found, named);
  EXPECT_EQ(lines_of(read("new/run/steps.csv")).size(), 1u + 3u * 6u);  // 0, 7, ... 35
}

TEST_F(CompeteCommand, FramesMayBeSvg) {
  document("lively.toml --out run --steps 4 --frames 2 --frame-format svg");
  EXPECT_THAT(read("run/frames/00002.svg"), HasSubstr("Step 4: "));
}

TEST_F(CompeteCommand, SameBytesForAnyNumberOfThreads) {
  const std::string first = run_line("compete lively.toml --json --out a --frames 20").out;
  EXPECT_EQ(run_line("compete lively.toml --json --out b --frames 20 --threads 3").out, first);
  expect_same_files("a", "b");
}

TEST_F(CompeteCommand, OtherEnginesFindTheSameUpToRounding) {
  const json first = document("lively.toml --steps 8");
  for (const char* engine : {"all_pairs", "sweep", "cell_grid"}) {
    const json other = document(std::string("lively.toml --steps 8 --engine ") + engine);
    EXPECT_EQ(other["engine"], engine);
    EXPECT_EQ(other["pairs"], first["pairs"]);
    EXPECT_EQ(other["all"]["alive"], first["all"]["alive"]);
    EXPECT_NEAR(other["all"]["basal_area"].get<double>(), first["all"]["basal_area"].get<double>(),
                1e-12);
  }
}

TEST_F(CompeteCommand, OptionsReplaceWhatTheFileSays) {
  const json d = document("lively.toml --seed 8 --rule none --steps 20");
  EXPECT_EQ(d["seed"], 8);
  EXPECT_EQ(d["rule"], "none");
  EXPECT_EQ(d["steps"], 20);
  EXPECT_EQ(d["pairs"], 0);
  EXPECT_EQ(d["all"]["mean_loss"], 0.0);
  EXPECT_EQ(document("lively.toml --steps 0")["all"]["alive"], 140);
}

TEST_F(CompeteCommand, ItsPlantsStartAnotherRun) {
  document("lively.toml --out run --steps 10");
  const std::size_t alive = lines_of(read("run/plants.csv")).size() - 1;
  std::string none_sown = lively;
  for (const std::string count : {"count = 80\n", "count = 60\n"})
    none_sown.erase(none_sown.find(count), count.size());
  write("none_sown.toml", none_sown);
  const json d = document("none_sown.toml --plants run/plants.csv --steps 0");
  EXPECT_EQ(d["plants"], "run/plants.csv");
  EXPECT_EQ(d["all"]["alive"], alive);
  const json before = json::parse(read("run/summary.json"));
  EXPECT_EQ(d["species"][0]["basal_area"], before["species"][0]["basal_area"]);
}

TEST_F(CompeteCommand, TableSaysWhatTheDocumentSays) {
  const Outcome outcome = run_line("compete lively.toml --out run");
  const json d = json::parse(read("run/summary.json"));
  EXPECT_THAT(outcome.out, HasSubstr("lively.toml: 40 steps, seed 3, rule combined, torus"));
  EXPECT_THAT(outcome.out, HasSubstr(d["all"]["alive"].dump()));
  EXPECT_THAT(outcome.out, HasSubstr("wrote to run: parameters.toml, steps.csv, plants.csv"));
}

TEST_F(CompeteCommand, KnowsPresets) {
  const json listed = json_of({"list", "stands", "--json"}, "phytobench/list-1");
  ASSERT_FALSE(listed["entries"].empty());
  const std::string name = listed["entries"][0]["id"];
  const json d = document("--steps 1 --preset " + name);
  EXPECT_EQ(d["preset"], name);
  EXPECT_TRUE(d["config"].is_null());
}

TEST_F(CompeteCommand, TakesStandsThatDieOut) {
  write("doomed.toml", "steps = 5\n[[species]]\nname = \"may fly\"\ncount = 9\nlargest_age = 2\n");
  const json d = document("doomed.toml --out run --frames 1 --frame-format svg");
  EXPECT_EQ(d["all"]["alive"], 0);
  EXPECT_TRUE(d["all"]["gini"].is_null());
  EXPECT_TRUE(d["pattern"].is_null());
  EXPECT_THAT(lines_of(read("run/steps.csv")).back(), HasSubstr("all,0,0,9,0,NaN,0,NaN,NaN,0"));
  EXPECT_EQ(line_count(read("run/plants.csv")), 1);
  EXPECT_TRUE(document("doomed.toml --steps 0")["pairs_per_step"].is_null());
}

TEST_F(CompeteCommand, RefusesToStartWithoutAPlant) {
  write("empty.toml", "[[species]]\nname = \"none\"\n");
  for (const char* more : {"", " --steps 0", " --out run"})
    expect_refused_line(std::string("compete empty.toml") + more,
                        "empty.toml: the stand has no plant to start with");
  EXPECT_FALSE(exists("run"));
  EXPECT_EQ(document("empty.toml --steps 1 --plants " +
                     file("one.csv", "x,y,radius\n1,1,0.1\n"))["all"]["alive"],
            1);
}

TEST_F(CompeteCommand, LeavesOutWhatFewPlantsCannotShow) {
  const auto of = [&](int count) {
    write("few.toml", "steps = 0\n[[species]]\nname = \"a\"\ncount = " + std::to_string(count) +
                          "\n[[species]]\nname = \"b\"\ncount = 1\n");
    return document("few.toml");
  };
  EXPECT_TRUE(of(8)["pattern"].is_null());
  EXPECT_EQ(run_line("compete few.toml --statistics").out.find("Clark-Evans"), std::string::npos);
  EXPECT_GT(of(9)["pattern"]["hopkins"].get<double>(), 0.0);
  EXPECT_THAT(run_line("compete few.toml").out, HasSubstr("Clark-Evans"));
  const json d = of(2);
  EXPECT_TRUE(d["species"][1]["gini"].is_null());
  EXPECT_GT(d["species"][0]["gini"].get<double>(), 0.0);
  EXPECT_GT(d["all"]["gini"].get<double>(), 0.0);
}

TEST_F(CompeteCommand, CurvesTellSpeciesAndAllApart) {
  document("lively.toml --out run --steps 6");
  const std::string svg = read("run/curves.svg");
  for (const char* part : {">Plants (dashed: all)<", ">Inequality of basal area (dashed: all)<",
                           ">Mean stem radius<", ">radius, m<", ">annual<", ">shrub<", ">0<"})
    EXPECT_THAT(svg, HasSubstr(part));
  EXPECT_THAT(svg, HasSubstr("stroke=\"currentColor\" stroke-width=\"1.8\" stroke-dasharray"));
  write("pair.toml", "steps = 10\n[[species]]\nname = \"only\"\ncount = 1\n");
  document("pair.toml --out pair");
  const std::string few = read("pair/curves.svg");
  EXPECT_THAT(few, testing::Not(HasSubstr("Inequality of basal area<")));
  EXPECT_THAT(few, testing::Not(HasSubstr("dashed")));
  for (const char* tick : {">1<", ">2<", ">3<", ">4<"}) EXPECT_THAT(few, HasSubstr(tick));
  EXPECT_THAT(few, testing::Not(HasSubstr(">0.5<")));
}

TEST_F(CompeteCommand, ThePatternOfManyPlantsOnlyOnDemand) {
  write("many.toml",
        "steps = 0\n[competition]\nrule = \"none\"\n[[species]]\nname = \"grass\"\n"
        "count = 20001\n");
  EXPECT_TRUE(document("many.toml --out many")["pattern"].is_null());
  EXPECT_FALSE(exists("many/stand.svg"));
  EXPECT_TRUE(exists("many/stand.png"));
  EXPECT_NEAR(document("many.toml --statistics")["pattern"]["hopkins"].get<double>(), 1.0, 0.05);
  expect_refused_line("compete many.toml --out svg --frames 1 --frame-format svg",
                      "step 0 has 20001 plants");
}

TEST_F(CompeteCommand, RefusesWrongInput) {
  const auto with = [&](const std::string& options, const std::string& part) {
    expect_refused_line("compete lively.toml " + options, part);
  };
  expect_refused_line("compete", "compete --example");
  expect_refused_line("compete absent.toml", "absent.toml: no such file");
  expect_refused_line("compete --preset disese", "did you mean 'disease'");
  expect_refused_line("compete --preset foo", "see phytobench list stands");
  with("--preset disease", "not both");
  with("--rule mixtur", "did you mean 'mixture'");
  with("--engine sweeep", "unknown engine");
  with("--steps -1", "--steps");
  with("--steps 1.5", "--steps");
  with("--seed -1", "--seed");
  with("--frames 0 --out run", "--frames");
  with("--every 0 --out run", "--every");
  with("--checkpoint 0 --out run", "--checkpoint");
  with("--frame-format gif --frames 1 --out run", "give png or svg");
  with("--threads 0", "--threads");
  for (const char* option : {"--frames 5", "--every 5", "--checkpoint 5"})
    with(option, "needs --out");
  with("--plants absent.csv", "absent.csv: no such file");
  with("--plants " + file("oak.csv", "x,y,radius,species\n1,9,0.1,oak\n"), "oak.csv:2: ");
  with("--plants " + file("far.csv", "x,y,radius,species\n1,9,0.1,shrub\n1,1,0.1,shrub\n"),
       "far.csv:3: ");
  write("wrong.toml", "[[species]]\nname = \"oak\"\ncont = 3\n");
  expect_refused_line("compete wrong.toml --out run", "wrong.toml:3: unknown key");
  EXPECT_FALSE(exists("run"));
}

TEST_F(CompeteCommand, FailsWhereNothingCanBeWritten) {
  write("regular", "a file\n");
  expect_refused({"compete", "lively.toml", "--out", "regular/run"}, 3, "regular");
  expect_refused({"compete", "lively.toml", "--out", "regular"}, 3, "regular");
  EXPECT_EQ(read("regular"), "a file\n");
  const Outcome outcome = run_on_full_disk({"compete", "lively.toml", "--steps", "2"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_THAT(outcome.err, HasSubstr("standard output"));
}

}  // namespace
}  // namespace phytobench
