// SPDX-License-Identifier: MIT
#include "cli/command_line_fixture.hpp"

#include <ostream>

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;

// The program itself.

TEST_F(CommandLine, TellsItsVersionAndHelp) {
  EXPECT_THAT(output_of({"--version"}), StartsWith("phytobench "));
  const std::string help = output_of({"--help"});
  for (const char* subcommand : {"list", "run", "report", "grow", "doctor"}) {
    EXPECT_THAT(help, HasSubstr(subcommand));
    EXPECT_THAT(output_of({subcommand, "--help"}), HasSubstr("Usage"));
  }
}

TEST_F(CommandLine, RefusesWrongUsageInOneLine) {
  expect_refused({}, 2, "--help");
  expect_refused({"nonsense"}, 2, "nonsense");
  expect_refused({"--nonsense"}, 2, "--help");
  expect_refused({"list", "--nonsense"}, 2, "--nonsense");
  expect_refused({"list", "papers", "extra"}, 2, "extra");
  expect_refused({"grow", "--engine"}, 2, "--engine");
  expect_refused({"run", "--threads", "0"}, 2, "--threads");
  expect_refused({"run", "--seed", "one"}, 2, "--seed");
  expect_refused({"terrain", "--presett", "fractal"}, 2,
                 "did you mean '--preset'? (phytobench terrain --help)");
  expect_refused({"race", "shadow", "--sizes=3"}, 2,
                 "did you mean '--size'? (phytobench race shadow --help)");
  // A list is one word: what follows is not taken for more of it.
  expect_refused({"race", "overlap", "--engines", "all", "more"}, 2, "not expected: more");
  expect_refused({"race", "competition", "--threads", "1", "2"}, 2, "not expected: 2");
}

TEST_F(CommandLine, FailsOnAFullDisk) {
  write("tree.toml", "");
  for (const Words& arguments : std::vector<Words>{
           {"list"}, {"list", "claims", "--json"}, {"grow", "--example"}, {"grow", "tree.toml"}}) {
    SCOPED_TRACE(arguments.back());
    const Outcome outcome = run_on_full_disk(arguments);
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(line_count(outcome.err), 1) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr("standard output"));
  }
}

TEST_F(CommandLine, ExaminesTheMachine) {
  const json document = json_of({"doctor", "--json"}, "phytobench/doctor-1");
  EXPECT_TRUE(document.contains("engines"));
  EXPECT_TRUE(document.contains("libraries"));
  EXPECT_FALSE(output_of({"doctor"}).empty());
}

// list

const Words kinds = {"papers",          "claims",  "errata",       "experiments",    "engines",
                     "overlap-engines", "presets", "graphs",       "components",     "lsystems",
                     "stands",          "sites",   "site-entries", "shadow-engines", "rules"};

TEST_F(CommandLine, ListsEveryKindWithUniqueIdsAndSummaries) {
  for (const std::string& kind : kinds) {
    SCOPED_TRACE(kind);
    const json document = json_of({"list", kind, "--json"}, "phytobench/list-1");
    EXPECT_EQ(document.at("kind").get<std::string>(), kind);
    std::set<std::string> ids;
    for (const json& entry : document.at("entries")) {
      const std::string id = entry.at("id").get<std::string>();
      EXPECT_TRUE(ids.insert(id).second) << id;
      EXPECT_EQ(id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789./_-"), std::string::npos)
          << id;
      EXPECT_FALSE(entry.at("summary").get<std::string>().empty()) << id;
    }
    const std::string plain = output_of({"list", kind});
    EXPECT_EQ(static_cast<std::size_t>(line_count(plain)), ids.size());
    for (const std::string& id : ids) EXPECT_THAT(plain, HasSubstr(id));
  }
}

TEST_F(CommandLine, CountsEveryKindInTheOverview) {
  const json document = json_of({"list", "--json"}, "phytobench/list-1");
  ASSERT_EQ(document.at("entries").size(), kinds.size());
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const json& entry = document.at("entries").at(i);
    EXPECT_EQ(entry.at("id").get<std::string>(), kinds[i]);
    const json all = json_of({"list", kinds[i], "--json"}, "phytobench/list-1");
    EXPECT_EQ(entry.at("summary").get<std::string>(), std::to_string(all.at("entries").size()));
  }
}

TEST_F(CommandLine, ListsNoPublishedValues) {
  const json document = json_of({"list", "claims", "--json"}, "phytobench/list-1");
  ASSERT_FALSE(document.at("entries").empty());
  for (const json& entry : document.at("entries")) EXPECT_FALSE(entry.contains("published"));
}

TEST_F(CommandLine, ListsWhatAMapCanShowAsPrinted) {
  const json document = json_of({"list", "errata", "--json"}, "phytobench/list-1");
  std::set<std::string> ids;
  for (const json& entry : document.at("entries"))
    if (entry.at("as_printed").get<bool>()) ids.insert(entry.at("id").get<std::string>());
  EXPECT_EQ(ids.size(), 18u);
  EXPECT_TRUE(ids.contains("lesser2019/e16"));
  EXPECT_FALSE(ids.contains("alsweis/e1"));
  EXPECT_THAT(output_of({"list", "errata"}), HasSubstr("listing 9.16: evaporated litres"));
}

TEST_F(CommandLine, RefusesAnUnknownKind) {
  expect_refused({"list", "nonsense"}, 2, "nonsense");
  expect_refused({"list", "enginess"}, 2, "did you mean 'engines'?");
}

// grow

TEST_F(CommandLine, GrowsItsExampleAlikeWithEveryEngineAndOption) {
  write("example.toml", output_of({"grow", "--example"}));
  std::set<std::string> hashes;
  const auto grow = [&](const Words& more) {
    SCOPED_TRACE(more.back());
    Words arguments = {"grow", "example.toml", "--json"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const json tree = json_of(arguments, "phytobench/grow-2");
    EXPECT_EQ(tree.at("edges").get<int>(), 2243);
    EXPECT_EQ(tree.at("nodes").get<int>(), 2244);
    hashes.insert(tree.at("tree_hash").get<std::string>());
  };
  std::set<std::string> engines;
  const json listed = json_of({"list", "engines", "--json"}, "phytobench/list-1");
  for (const json& engine : listed.at("entries")) {
    if (!engine.at("built").get<bool>()) continue;
    engines.insert(engine.at("id").get<std::string>());
    grow({"--engine", engine.at("id").get<std::string>()});
  }
  for (const char* engine : {"euclidean_scan", "squared_scan", "sorted_axes", "voxel_grid"})
    EXPECT_TRUE(engines.contains(engine)) << engine;
  for (const char* option : {"s", "d", "n", "dn"}) grow({"--option", option});
  grow({"--threads", "2"});
  EXPECT_EQ(hashes.size(), 1u);
}

TEST_F(CommandLine, GrowsAnEmptyFileLikeItsExample) {
  write("empty.toml", "");
  write("example.toml", output_of({"grow", "--example"}));
  EXPECT_EQ(output_of({"grow", "empty.toml"}), output_of({"grow", "example.toml"}));
}

TEST_F(CommandLine, GrowsAnotherTreeFromAnotherSeed) {
  write("seed.toml", "seed = 1\n");
  write("empty.toml", "");
  EXPECT_NE(output_of({"grow", "seed.toml"}), output_of({"grow", "empty.toml"}));
}

struct BadTree {
  std::string name;
  std::string file;
  std::string named;  ///< what the message must name
};

void PrintTo(const BadTree& tree, std::ostream* out) {
  *out << tree.name;
}

class CommandLineBadTree : public CommandLine, public testing::WithParamInterface<BadTree> {};

TEST_P(CommandLineBadTree, IsRefused) {
  write("tree.toml", GetParam().file);
  expect_refused({"grow", "tree.toml"}, 2, GetParam().named);
  expect_refused({"grow", "tree.toml", "--json", "--picture", "tree.svg"}, 2, GetParam().named);
  EXPECT_EQ(left_behind(), std::set<std::string>{"tree.toml"});
}

const std::vector<BadTree> bad_trees = {
    {"broken_toml", "seed = 1\nrandom = = 2\n", "tree.toml:2:"},
    {"key_twice", "seed = 1\nseed = 2\n", "tree.toml:2:"},
    {"unknown_key", "[cloud]\ndensty = 3\n", "tree.toml:2: unknown key 'cloud.densty'"},
    {"unknown_section", "[clowd]\ndensity = 3\n", "tree.toml:1: unknown key 'clowd'"},
    {"density_nan", "[cloud]\ndensity = nan\n", "tree.toml:2: cloud.density"},
    {"density_infinite", "[cloud]\ndensity = inf\n", "tree.toml:2: cloud.density"},
    {"density_zero", "[cloud]\ndensity = 0\n", "tree.toml:2: cloud.density"},
    {"density_as_text", "[cloud]\ndensity = \"30\"\n", "tree.toml:2: cloud.density"},
    {"radius_negative", "[cloud]\nradii = [-1.0, 2.0, 3.0]\n", "tree.toml:2: cloud.radii[0]"},
    {"radius_nan", "[cloud]\nradii = [1.0, nan, 3.0]\n", "tree.toml:2: cloud.radii[1]"},
    {"radius_missing", "[cloud]\nradii = [1.0, 2.0]\n", "tree.toml:2: cloud.radii"},
    {"cuts_that_cross", "[cloud]\ncutoff_bottom = 0.6\ncutoff_top = 0.5\n",
     "tree.toml:3: cloud.cutoff_bottom + cloud.cutoff_top"},
    {"too_many_points", "[cloud]\ndensity = 1e12\n", "tree.toml:2: cloud.density = 1e+12"},
    {"half_an_iteration", "[growth]\niterations = 1.5\n", "tree.toml:2: growth.iterations"},
    {"kill_above_influence",
     "[growth]\ninfluence_distance = 0.5\nkill_distance_begin = 0.6\nkill_distance_end = 0.2\n",
     "tree.toml:3: growth.kill_distance_begin"},
    {"one_distance_of_three", "[growth]\ninfluence_distance = 0.5\n",
     "tree.toml:2: growth.influence_distance"},
    {"unknown_word", "random = \"dice\"\n", "tree.toml:1: random"},
    {"endless_stem", "[stem]\nlength = 1e9\n", "growth.step_length"},
    {"nothing_in_reach", "[cloud]\ndensity = 0.02\n", "growth.influence_distance"},
};

INSTANTIATE_TEST_SUITE_P(All, CommandLineBadTree, testing::ValuesIn(bad_trees),
                         [](const auto& test) { return test.param.name; });

TEST_F(CommandLine, RefusesToGrowWithoutAFile) {
  expect_refused({"grow"}, 2, "grow --example");
  expect_refused({"grow", "absent.toml"}, 2, "absent.toml: no such file");
  expect_refused({"grow", "."}, 2, "is a folder");
}

TEST_F(CommandLine, RefusesUnknownEnginesAndOptions) {
  write("tree.toml", "");
  expect_refused({"grow", "tree.toml", "--engine", "nonsense"}, 2, "voxel_grid");
  expect_refused({"grow", "tree.toml", "--option", "x"}, 2, "loop option 'x'");
  expect_refused({"grow", "tree.toml", "--nonsense"}, 2, "--nonsense");
}

TEST_F(CommandLine, DrawsThePicture) {
  write("tree.toml", "");
  std::filesystem::create_directories(folder() / "new");
  output_of({"grow", "tree.toml", "--picture", "new/tree.svg"});
  ASSERT_TRUE(exists("new/tree.svg"));
  EXPECT_THAT(read("new/tree.svg"), StartsWith("<svg"));
  EXPECT_THAT(read("new/tree.svg"), HasSubstr("</svg>"));
}

TEST_F(CommandLine, FailsWhereNoPictureCanBeWritten) {
  write("tree.toml", "");
  write("regular", "a file\n");
  expect_refused({"grow", "tree.toml", "--picture", "/dev/full/x.svg"}, 3, "/dev/full");
  expect_refused({"grow", "tree.toml", "--picture", "regular/x.svg"}, 3, "regular");
  write("folder.svg/file", "");
  expect_refused({"grow", "tree.toml", "--picture", "folder.svg"}, 2, "is a folder");
  EXPECT_EQ(read("regular"), "a file\n");
  EXPECT_EQ(left_behind(), (std::set<std::string>{"folder.svg", "regular", "tree.toml"}));
}

// run

const Words short_run = {"run", "brzoska2019/equations", "--tier", "smoke"};

Words with(Words arguments, const Words& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST_F(CommandLine, RefusesUnknownExperimentsAndTiers) {
  expect_refused({"run", "no/such"}, 2, "no/such");
  expect_refused({"run", "brzoska2019/equation"}, 2, "did you mean 'brzoska2019/equations'?");
  expect_refused({"run", "--tier", "huge"}, 2, "huge");
  expect_refused({"run", "nothing*"}, 4, "nothing*");
  expect_refused({"run", "brzoska2019/equations", "nothing*"}, 4, "nothing*");
  EXPECT_TRUE(left_behind().empty());
}

TEST_F(CommandLine, SaysWhatItWouldRunAndWritesNothing) {
  const std::string plan = output_of({"run", "--dry-run"});
  const json listed = json_of({"list", "experiments", "--json"}, "phytobench/list-1");
  ASSERT_FALSE(listed.at("entries").empty());
  for (const json& experiment : listed.at("entries"))
    EXPECT_THAT(plan, HasSubstr(experiment.at("id").get<std::string>()));
  EXPECT_EQ(output_of({"run", "*", "--dry-run"}), plan);
  output_of({"run", "--dry-run", "--out", "results"});
  EXPECT_TRUE(left_behind().empty());
}

TEST_F(CommandLine, WritesTheSameRecordsTwice) {
  output_of(with(short_run, {"--out", "first"}));
  output_of(with(short_run, {"--out", "second"}));
  const std::string records = read("first/records.jsonl");
  EXPECT_GT(line_count(records), 2);
  EXPECT_EQ(read("second/records.jsonl"), records);
  for (const char* file : {"first/timings.jsonl", "first/environment.json"})
    EXPECT_TRUE(exists(file)) << file;
  EXPECT_EQ(left_behind(), (std::set<std::string>{"first", "second"}));
}

TEST_F(CommandLine, WritesOneJsonObjectPerLine) {
  output_of(with(short_run, {"--out", "run"}));
  std::ifstream stream(folder() / "run/records.jsonl");
  std::string line;
  ASSERT_TRUE(std::getline(stream, line));
  const json header = json::parse(line, nullptr, false);
  ASSERT_TRUE(header.is_object());
  EXPECT_EQ(text_at(header, "schema"), "phytobench/records-2");
  EXPECT_EQ(text_at(header, "tier"), "smoke");
  while (std::getline(stream, line))
    EXPECT_TRUE(json::parse(line, nullptr, false).is_object()) << line;
}

TEST_F(CommandLine, TouchesAnOlderRunOnlyToResumeIt) {
  output_of(with(short_run, {"--out", "run"}));
  const std::string records = read("run/records.jsonl");
  const std::string environment = read("run/environment.json");

  expect_refused(with(short_run, {"--out", "run"}), 2, "--resume");
  expect_refused(with(short_run, {"--out", "run", "--resume", "--seed", "5"}), 2, "--seed");
  EXPECT_EQ(read("run/records.jsonl"), records);
  EXPECT_EQ(read("run/environment.json"), environment);

  output_of(with(short_run, {"--out", "run", "--resume"}));
  EXPECT_EQ(read("run/records.jsonl"), records);
}

TEST_F(CommandLine, ResumesARunThatBrokeOff) {
  output_of(with(short_run, {"--out", "run"}));
  const std::string records = read("run/records.jsonl");
  write("run/records.jsonl", records.substr(0, records.size() / 2));
  output_of(with(short_run, {"--out", "run", "--resume"}));
  EXPECT_EQ(read("run/records.jsonl"), records);
}

TEST_F(CommandLine, FailsWhereNoRunCanBeWritten) {
  write("regular", "a file\n");
  expect_refused(with(short_run, {"--out", "regular/run"}), 3, "regular");
  expect_refused(with(short_run, {"--out", "regular"}), 3, "regular");
  EXPECT_EQ(read("regular"), "a file\n");
}

// report

TEST_F(CommandLine, ReportsTheSameTwiceWithoutWhatVaries) {
  output_of(with(short_run, {"--out", "run"}));
  output_of({"report", "run", "--without-varying"});
  const std::string html = read("run/report/index.html");
  const std::string markdown = read("run/report/report.md");
  EXPECT_FALSE(html.empty());
  EXPECT_FALSE(markdown.empty());
  output_of({"report", "run", "--without-varying"});
  EXPECT_EQ(read("run/report/index.html"), html);
  EXPECT_EQ(read("run/report/report.md"), markdown);
}

TEST_F(CommandLine, ReportsAVerdictOnEveryClaim) {
  output_of(with(short_run, {"--out", "run"}));
  output_of({"report", "run", "--out", "elsewhere", "--format", "csv"});
  EXPECT_FALSE(exists("run/report"));
  EXPECT_FALSE(exists("elsewhere/index.html"));
  EXPECT_TRUE(exists("elsewhere/claims.csv"));
  const json verdicts = json::parse(read("elsewhere/verdicts.json"), nullptr, false);
  ASSERT_TRUE(verdicts.is_object());
  const json claims = json_of({"list", "claims", "--json"}, "phytobench/list-1");
  EXPECT_EQ(verdicts.at("claims").size(), claims.at("entries").size());
}

TEST_F(CommandLine, RefusesToReportOnWhatIsNoRun) {
  fs::create_directories(folder() / "empty");
  write("foreign/records.jsonl", "{\"schema\":\"other/1\"}\n");
  write("damaged/records.jsonl", "hello\n");
  expect_refused({"report"}, 2, "folder");
  expect_refused({"report", "absent"}, 2, "absent");
  expect_refused({"report", "empty"}, 2, "records.jsonl");
  expect_refused({"report", "foreign"}, 2, "foreign/records.jsonl:1: ");
  expect_refused({"report", "damaged"}, 2, "damaged/records.jsonl:1: ");
  EXPECT_EQ(left_behind(), (std::set<std::string>{"damaged", "empty", "foreign"}));
  for (const char* folder_name : {"damaged", "empty", "foreign"})
    EXPECT_FALSE(exists(fs::path(folder_name) / "report")) << folder_name;
}

TEST_F(CommandLine, RefusesUnknownReportFormats) {
  output_of(with(short_run, {"--out", "run"}));
  expect_refused({"report", "run", "--format", "pdf"}, 2, "pdf");
  expect_refused({"report", "run", "--format", "html,pdf"}, 2, "pdf");
  EXPECT_FALSE(exists("run/report"));
}

TEST_F(CommandLine, FailsWhereNoReportCanBeWritten) {
  output_of(with(short_run, {"--out", "run"}));
  write("regular", "a file\n");
  expect_refused({"report", "run", "--out", "regular/report"}, 3, "regular");
}

}  // namespace
}  // namespace phytobench
