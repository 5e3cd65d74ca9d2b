// SPDX-License-Identifier: MIT
// phytobench compete as a user meets it. Never asserts on a time.
#include <cmath>
#include <map>
#include <sstream>

#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using Lines = std::vector<std::string>;

/// Plants that bear seeds, rest, starve, fall ill and are taken out.
constexpr const char* lively = R"(seed = 3
steps = 40
[ground]
size = [60.0, 50.0]
corner = [-10.0, 5.0]
[competition]
rule = "combined"
[mortality]
rule = "mean-relative-growth"
threshold = 0.004
[seasons]
bad_year_share = 0.2
[illness]
duration = 10
is_deadly = true
[[species]]
name = "annual"
count = 80
largest_age = 30
largest_radius = 0.2
growth_rate = 0.03
[species.reproduction]
threshold = 0.08
seeds_per_metre = 8.0
dispersal_distance = 6.0
seed_mortality = 0.1
dormant_share = 0.4
germination_rate = 0.3
seedling_radius = 0.02
[[species]]
name = "shrub"
count = 60
[[event]]
kind = "disease"
step = 5
share = 0.3
[[event]]
kind = "removal"
step = 12
species = "shrub"
largest = 2
)";

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

class CompeteCommand : public CommandLine {
 protected:
  CompeteCommand() { write("lively.toml", lively); }

  void expect_done(const std::string& arguments) const {
    const Outcome outcome = run_line("compete " + arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
  }

  json document(const std::string& arguments) const {
    const Outcome outcome = run_line("compete --json " + arguments);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const json result = json::parse(outcome.out, nullptr, false);
    EXPECT_EQ(text_at(result, "schema"), "phytobench/compete-1");
    return result;
  }

  /// Every file below a folder, by its name seen from there.
  std::map<std::string, std::string> files_below(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder() / name))
      if (entry.is_regular_file())
        files[fs::relative(entry.path(), folder() / name).string()] = content_of(entry.path());
    return files;
  }

  void expect_same_files(const std::string& a, const std::string& b) const {
    const auto first = files_below(a), second = files_below(b);
    for (const auto& [name, content] : first) {
      ASSERT_TRUE(second.contains(name)) << name;
      EXPECT_TRUE(second.at(name) == content) << name << " differs";
    }
    EXPECT_EQ(first.size(), second.size());
  }

  /// Starts a run and sends it a signal so many milliseconds after the file is there. The code is
  /// -1 if that killed it; 0 if it was done before.
  Outcome run_and_signal(int signal, const std::string& arguments, const std::string& file,
                         int milliseconds) const {
    Words words;
    std::istringstream stream("compete " + arguments);
    for (std::string word; stream >> word;) words.push_back(word);
    const fs::path out = folder() / "stdout", err = folder() / "stderr";
    const pid_t child = start(words, folder(), out, err);
    siginfo_t ended{};
    while (!exists(file) && ended.si_pid == 0) {
      ::usleep(500);
      ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT);
    }
    ::usleep(static_cast<useconds_t>(1000 * milliseconds));
    ::kill(child, signal);
    const int code = exit_code_of(child);
    const Outcome outcome{code, content_of(out), content_of(err)};
    fs::remove(out);
    fs::remove(err);
    return outcome;
  }
};

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
  EXPECT_TRUE(d["pattern"]["hopkins"].is_null());
  EXPECT_THAT(lines_of(read("run/steps.csv")).back(), HasSubstr("all,0,0,9,0,NaN,0,NaN,NaN,0"));
  EXPECT_EQ(line_count(read("run/plants.csv")), 1);
  write("empty.toml", "steps = 0\n[[species]]\nname = \"none\"\n");
  EXPECT_TRUE(document("empty.toml --out empty")["pairs_per_step"].is_null());
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

// Runs that end early.

const std::string many_frames = "lively.toml --steps 90 --frames 1 --frame-format svg ";

TEST_F(CompeteCommand, KilledAndResumedItLeavesTheSameFiles) {
  const std::string options = many_frames + "--checkpoint 7 --every 2 ";
  expect_done(options + "--out whole");
  int kills = 0;
  const auto kill = [&](const std::string& more, const std::string& frame, int milliseconds) {
    const Outcome outcome = run_and_signal(SIGKILL, options + "--out broken" + more,
                                           "broken/frames/" + frame, milliseconds);
    kills += outcome.code == -1;
  };
  kill("", "00008.svg", 0);
  kill(" --resume", "00030.svg", 1);
  kill(" --resume", "00060.svg", 3);
  EXPECT_GT(kills, 0);
  expect_done(options + "--out broken --resume");
  expect_same_files("whole", "broken");
}

TEST_F(CompeteCommand, InterruptedItSaysHowToGoOn) {
  const Outcome outcome =
      run_and_signal(SIGINT, many_frames + "--out broken", "broken/frames/00003.svg", 0);
  ASSERT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(line_count(outcome.err), 1) << outcome.err;
  EXPECT_THAT(outcome.err,
              HasSubstr("broken/checkpoint.bin, go on with the same command and --resume"));
  expect_done(many_frames + "--out broken --resume --threads 2");
  expect_done(many_frames + "--out whole");
  expect_same_files("whole", "broken");
}

TEST_F(CompeteCommand, GoesOnToMoreSteps) {
  const std::string options =
      "lively.toml --frames 7 --frame-format svg --every 3 --checkpoint 10 ";
  expect_done(options + "--steps 26 --out longer");
  expect_done(options + "--steps 40 --out longer --resume");
  expect_done(options + "--steps 40 --out whole");
  expect_same_files("whole", "longer");
  const std::string steps = read("longer/steps.csv");
  expect_refused_line("compete " + options + "--steps 39 --out longer --resume",
                      "is at step 40, beyond the 39 steps");
  EXPECT_EQ(read("longer/steps.csv"), steps);
}

TEST_F(CompeteCommand, RemovesWhatAKilledRunLeftHalfWritten) {
  expect_done("lively.toml --out run --checkpoint 10 --steps 20");
  write("run/stand.png.part123", "half");
  write("run/frames/00002.png.part9", "half");
  write("run/notes.part", "mine");
  expect_done("lively.toml --out run --checkpoint 10 --steps 20 --resume");
  EXPECT_FALSE(exists("run/stand.png.part123"));
  EXPECT_FALSE(exists("run/frames/00002.png.part9"));
  EXPECT_EQ(read("run/notes.part"), "mine");
}

TEST_F(CompeteCommand, TouchesAnOlderRunOnlyToResumeIt) {
  expect_done("lively.toml --out run --checkpoint 10 --steps 20");
  const auto files = files_below("run");
  expect_refused_line("compete lively.toml --out run", "run: already holds checkpoint.bin");
  const std::string again = "compete lively.toml --out run --steps 30 --resume ";
  expect_refused_line(again + "--seed 5", "seed = 3, not 5");
  expect_refused_line(again + "--rule none", "competition.rule = combined, not none");
  expect_refused_line(again + "--every 2", "--every = 1, not 2");
  write("more.toml", lively + std::string("[[species]]\nname = \"tree\"\n"));
  expect_refused_line("compete more.toml --out run --resume", "species = annual, shrub, not");
  EXPECT_EQ(files_below("run"), files);

  std::string changed = read("run/steps.csv");
  changed[200] = '7';
  write("run/steps.csv", changed);
  expect_refused_line(again, "run/steps.csv: was changed");
  write("run/checkpoint.bin", read("run/checkpoint.bin").substr(0, 1000));
  expect_refused_line(again, "run/checkpoint.bin: is damaged");
}

TEST_F(CompeteCommand, RefusesToResumeNothing) {
  expect_refused_line("compete lively.toml --resume", "--resume needs --out");
  expect_refused_line("compete lively.toml --out absent --resume", "start without --resume");
  expect_done("lively.toml --out run --steps 2");
  EXPECT_FALSE(exists("run/checkpoint.bin"));
  expect_refused_line("compete lively.toml --out run --resume", "that run is finished");
  write("mine/plants.csv", "x,y,radius,species\n1,9,0.1,shrub\n");
  expect_refused_line("compete lively.toml --plants mine/plants.csv --out mine",
                      "already holds plants.csv");
  EXPECT_EQ(left_behind(), (std::set<std::string>{"lively.toml", "mine", "run"}));
}

// What goes wrong.

TEST_F(CompeteCommand, RefusesWrongInput) {
  const auto with = [&](const std::string& options, const std::string& part) {
    expect_refused_line("compete lively.toml " + options, part);
  };
  expect_refused_line("compete", "compete --example");
  expect_refused_line("compete absent.toml", "absent.toml: no such file");
  expect_refused_line("compete --preset disese", "did you mean 'disease'");
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

TEST_F(CompeteCommand, AFullDiskLeavesNothingHalfWritten) {
  {
    const SmallFilesOnly no_room(1000);
    expect_refused({"compete", "lively.toml", "--out", "none"}, 3, "none/checkpoint.bin");
  }
  EXPECT_TRUE(files_below("none").empty());
  {
    const SmallFilesOnly little_room(30'000);  // no picture fits
    expect_refused({"compete", "lively.toml", "--out", "some"}, 3, "cannot write some/");
  }
  for (const auto& [name, content] : files_below("some")) {
    EXPECT_TRUE(name == "checkpoint.bin" || name == "parameters.toml" || name == "steps.csv")
        << name;
    EXPECT_EQ(content.find(".part"), std::string::npos);
  }
  expect_done("lively.toml --out some --resume");
  expect_done("lively.toml --out whole");
  expect_same_files("whole", "some");
}

}  // namespace
}  // namespace phytobench
