// SPDX-License-Identifier: MIT
// phytobench report as a user meets it: formats, folders, runs that disagree.
#include <cstdlib>
#include <map>

#include "cli/command_line_fixture.hpp"
#include "core/record/run_writer.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr const char* claim_id = "brzoska2019/cloud/cutoff-meaning";

class ReportCommandSlow : public CommandLine {
 protected:
  /// A run of one experiment, in which the claim above holds if the height is 1.6.
  void write_run(const std::string& name, double height, const std::string& compiler) const {
    const std::string experiment = "brzoska2019/attraction-cloud";
    RunWriter writer(folder() / name, {Tier::smoke, 0}, RunMode::fresh);
    writer.write_environment(R"({"compiler": ")" + compiler +
                             R"(", "date_utc": "2026-01-01", "machine": {"processor": "X"}})");
    const auto record = [&](const std::string& quantity, double value) {
      return Record{experiment, experiment + "/" + quantity, value};
    };
    writer.append(
        experiment,
        std::vector{record("height/largest_error", 0.0), record("height/default", height)}, {});
  }

  std::map<std::string, std::string> contents_of(const fs::path& name) const {
    std::map<std::string, std::string> contents;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder() / name))
      if (entry.is_regular_file())
        contents[fs::relative(entry.path(), folder() / name).string()] = content_of(entry.path());
    return contents;
  }

  json claim_in(const std::string& report) const {
    const json verdicts = json::parse(read(report + "/verdicts.json"), nullptr, false);
    for (const json& claim : verdicts.at("claims"))
      if (claim.at("id") == claim_id) return claim;
    return nullptr;
  }
};

TEST_F(ReportCommandSlow, WritesEveryFormatAndChecksumsThatHold) {
  write_run("run", 1.6, "GNU 12");
  output_of({"report", "run"});
  for (const char* name : {"index.html", "report.md", "errata-brzoska2019.md", "claims.csv",
                           "records.csv", "junit.xml", "verdicts.json", "tables/claims.tex",
                           "tables/claims-brzoska2019.tex", "tables/counts.tex", "tables/all.tex"})
    EXPECT_TRUE(exists(fs::path("run/report") / name)) << name;
  const std::string check =
      "cd '" + (folder() / "run/report").string() + "' && sha256sum --check --quiet SHA256SUMS";
  EXPECT_EQ(std::system(check.c_str()), 0);
  const std::string sums = read("run/report/SHA256SUMS");
  EXPECT_EQ(line_count(sums), static_cast<std::ptrdiff_t>(contents_of("run/report").size()) - 1);
}

TEST_F(ReportCommandSlow, WritesTheFormatsAskedForAndNoMore) {
  write_run("run", 1.6, "GNU 12");
  output_of({"report", "--format", "junit,csv", "run"});
  std::set<std::string> names;
  for (const auto& [name, content] : contents_of("run/report")) names.insert(name);
  EXPECT_EQ(names, (std::set<std::string>{"SHA256SUMS", "claims.csv", "junit.xml", "records.csv",
                                          "verdicts.json"}));
  output_of({"report", "run", "--format", "junit"});
  EXPECT_FALSE(exists("run/report/claims.csv")) << "a folder holds one report";
}

TEST_F(ReportCommandSlow, KeepsTheOldReportWholeOnAFullDisk) {
  write_run("run", 1.6, "GNU 12");
  output_of({"report", "run"});
  const auto before = contents_of("run/report");
  {
    const SmallFilesOnly disk(60'000);
    expect_refused({"report", "run", "--format", "html,csv"}, 3, "run/report/");
  }
  EXPECT_EQ(contents_of("run/report"), before);
}

TEST_F(ReportCommandSlow, ExitsWithOneWhereAVerdictIsNotTheExpectedOne) {
  write_run("run", 1.7, "GNU 12");
  const Outcome outcome = run({"report", "run", "--format", "junit"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, HasSubstr(std::string("unexpected: ") + claim_id));
  EXPECT_THAT(read("run/report/junit.xml"), HasSubstr("failures=\"1\""));
}

TEST_F(ReportCommandSlow, CallsAClaimInconclusiveThatTwoCompilersDecideDifferently) {
  write_run("a", 1.6, "GNU 12.2.0");
  write_run("b", 1.7, "Clang 14.0.6");
  const Outcome outcome = run({"report", "a", "b", "--out", "merged"});
  EXPECT_EQ(outcome.code, 0) << outcome.out;
  const json claim = claim_in("merged");
  EXPECT_EQ(claim["verdict"], "inconclusive");
  EXPECT_THAT(claim["reason"].get<std::string>(), HasSubstr("A: reproduced; B: not reproduced"));
  EXPECT_THAT(read("merged/report.md"), HasSubstr("## 2 runs side by side"));
  EXPECT_THAT(read("merged/index.html"), HasSubstr("id=\"comparison\""));
  EXPECT_THAT(read("merged/records-that-differ.csv"),
              HasSubstr("brzoska2019/attraction-cloud/height/default,B,Clang 14.0.6 on X,1.7\n"));
  EXPECT_THAT(read("merged/junit.xml"),
              HasSubstr("<property name=\"run B\" value=\"Clang 14.0.6 on X\"/>"));
  EXPECT_EQ(run({"report", "a", "b", "--out", "merged", "--strict"}).code, 5);
}

TEST_F(ReportCommandSlow, TakesTheVerdictOfTheRunThatDecides) {
  write_run("a", 1.6, "GNU 12.2.0");
  RunWriter(folder() / "empty", {Tier::smoke, 0}, RunMode::fresh);
  output_of({"report", "empty", "a", "--out", "merged"});
  EXPECT_EQ(claim_in("merged")["verdict"], "reproduced");
  EXPECT_EQ(claim_in("merged")["by_run"][0]["verdict"], "not measured");
}

TEST_F(ReportCommandSlow, MergesTheSameTwiceWithoutWhatVaries) {
  write_run("a", 1.6, "GNU 12.2.0");
  write_run("b", 1.7, "Clang 14.0.6");
  output_of({"report", "a", "b", "--out", "merged", "--without-varying"});
  const auto before = contents_of("merged");
  for (const auto& [name, content] : before) EXPECT_THAT(content, Not(HasSubstr("14.0.6"))) << name;
  output_of({"report", "a", "b", "--out", "merged", "--without-varying"});
  EXPECT_EQ(contents_of("merged"), before);
}

TEST_F(ReportCommandSlow, RefusesARunThatIsGivenTwice) {
  write_run("a", 1.6, "GNU 12.2.0");
  fs::copy(folder() / "a", folder() / "copy", fs::copy_options::recursive);
  expect_refused({"report", "a", "./a/", "--out", "merged"}, 2, "same run as a");
  expect_refused({"report", "a", "copy", "--out", "merged"}, 2, "copied");
  EXPECT_FALSE(exists("merged"));
}

TEST_F(ReportCommandSlow, AsksWhereTheReportOfSeveralRunsGoes) {
  write_run("a", 1.6, "GNU 12.2.0");
  write_run("b", 1.6, "Clang 14.0.6");
  expect_refused({"report", "a", "b"}, 2, "--out");
  EXPECT_FALSE(exists("a/report"));
}

}  // namespace
}  // namespace phytobench
