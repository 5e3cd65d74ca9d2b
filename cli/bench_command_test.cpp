// SPDX-License-Identifier: MIT
// `phytobench bench` as a user runs it. Work is counted by a script in the place of a worker, whose
// counters and answers are files beside it.
#include <sys/stat.h>

#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::Not;

const std::string script = R"sh(#!/bin/sh
here=$(dirname "$0")
verb=$1
shift
begin='{"schema":"phytobench/worker-1","answers":'
if [ "$verb" = list ]; then
  counts=true
  [ ! -e "$here/counts-nothing" ] || counts=false
  printf '%s"list","compiler":"c","flags":"f","counts_work":%s,"benchmarks":[' "$begin" $counts
  for name in $(cat "$here/names"); do
    printf '%s{"name":"%s","summary":"s","is_own":true}' "$comma" "$name"
    comma=,
  done
else
  printf '%s"verify","benchmarks":[' "$begin"
  for name; do
    file="$here/$(echo "$name" | tr / -)"
    printf '%s{"name":"%s","inputs":"%064d","answer":"a","objection":"%s","work":%s}' \
      "$comma" "$name" 1 "$(cat "$file.objection" 2>/dev/null)" "$(cat "$file.work")"
    comma=,
  done
fi
echo ']}'
)sh";

class BenchCounters : public CommandLine {
 protected:
  BenchCounters() {
    write("worker/phytobench_worker", script);
    ::chmod((folder() / "worker" / "phytobench_worker").c_str(), 0755);
    write("worker/names", "near/grid/a near/scan/a tree/mesh");
    write("worker/near-grid-a.work", R"({"evaluations":1000000,"queries":50})");
    write("worker/near-scan-a.work", R"({"evaluations":7})");
    write("worker/tree-mesh.work", R"({"triangles":12})");
  }

  Outcome count(const std::string& more = "") const {
    return run_line("bench counters --worker worker/phytobench_worker --baseline counters.json " +
                    more);
  }
};

TEST_F(BenchCounters, WithoutABaselineSayHowToWriteOne) {
  const Outcome outcome = count();
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--accept"));
  EXPECT_FALSE(exists("counters.json"));
}

TEST_F(BenchCounters, WhatWasAcceptedPassesFromThenOn) {
  const Outcome accepted = count("--accept");
  EXPECT_EQ(accepted.code, 0) << accepted.err;
  EXPECT_THAT(accepted.out, HasSubstr("near/grid/a is new\n"));
  EXPECT_THAT(accepted.out, HasSubstr("counters.json: written with 3 changes"));
  EXPECT_THAT(read("counters.json"), HasSubstr("\n        \"evaluations\": 1000000,\n"));
  const Outcome again = count();
  EXPECT_EQ(again.code, 0) << again.out;
  EXPECT_THAT(again.out, HasSubstr("3 benchmarks: right answers, counters as in counters.json"));
}

TEST_F(BenchCounters, AnyDifferenceFailsAndIsNamed) {
  count("--accept");
  const std::string before = read("counters.json");
  write("worker/near-grid-a.work", R"({"evaluations":1050000,"queries":50})");
  const Outcome outcome = count("--junit counters.xml");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out,
              HasSubstr("near/grid/a evaluations 1,000,000 -> 1,050,000 (+5.0 %)\n1 change from"));
  EXPECT_EQ(read("counters.json"), before);
  EXPECT_THAT(read("counters.xml"), HasSubstr("tests=\"3\" failures=\"1\""));
}

TEST_F(BenchCounters, AWrongAnswerFailsBeforeCountersAreLookedAt) {
  count("--accept");
  const std::string before = read("counters.json");
  write("worker/tree-mesh.objection", "one triangle too few");
  write("worker/near-grid-a.work", R"({"evaluations":1,"queries":50})");
  for (const char* accept : {"", "--accept"}) {
    const Outcome outcome = count(accept);
    EXPECT_EQ(outcome.code, 1);
    EXPECT_THAT(outcome.out, HasSubstr("tree/mesh: one triangle too few"));
    EXPECT_THAT(outcome.out, Not(HasSubstr("near/grid/a")));
    EXPECT_EQ(read("counters.json"), before);
  }
}

TEST_F(BenchCounters, GlobsAcceptOnlyWhatTheyChoose) {
  count("--accept");
  write("worker/near-scan-a.work", R"({"evaluations":8})");
  write("worker/tree-mesh.work", R"({"triangles":13})");
  EXPECT_EQ(count("near/grid/*").code, 0);
  EXPECT_EQ(count("near/* --accept").code, 0);
  const Outcome rest = count();
  EXPECT_EQ(rest.code, 1);
  EXPECT_THAT(rest.out, HasSubstr("tree/mesh triangles 12 -> 13"));
  EXPECT_THAT(rest.out, Not(HasSubstr("near/")));
  EXPECT_EQ(count("far/*").code, 4);
  EXPECT_EQ(count("tree/mush").code, 2);
}

TEST_F(BenchCounters, ABenchmarkThatIsGoneFailsUntilItIsAccepted) {
  count("--accept");
  write("worker/names", "near/grid/a near/scan/a");
  const Outcome outcome = count();
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.out, HasSubstr("tree/mesh is gone"));
  EXPECT_EQ(count("--accept").code, 0);
  EXPECT_EQ(count().code, 0);
}

TEST_F(BenchCounters, InJsonEveryChangeHasItsNumbers) {
  count("--accept");
  write("worker/near-scan-a.work", R"({"evaluations":8})");
  const Outcome outcome = count("--json");
  EXPECT_EQ(outcome.code, 1);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json["schema"], "phytobench/bench-counters-1");
  ASSERT_EQ(json["changes"].size(), 1u);
  EXPECT_EQ(json["changes"][0]["benchmark"], "near/scan/a");
  EXPECT_EQ(json["changes"][0]["before"], 7);
  EXPECT_EQ(json["changes"][0]["after"], 8);
}

TEST_F(BenchCounters, WhatWasCountedIsKeptWithItsOrigin) {
  count("--accept");
  std::filesystem::create_directories(folder() / "kept");
  const Outcome outcome = count("--out kept/counts.json --json");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const auto kept = nlohmann::json::parse(read("kept/counts.json"));
  EXPECT_EQ(kept["schema"], "phytobench/counters-1");
  EXPECT_EQ(kept["origin"]["given"], "worker/phytobench_worker");
  EXPECT_EQ(kept["origin"]["compiler"], "c");
  EXPECT_TRUE(kept["origin"].contains("commit"));
  EXPECT_TRUE(kept["origin"].contains("changed"));
  EXPECT_EQ(kept["benchmarks"]["near/scan/a"]["counters"]["evaluations"], 7);
  EXPECT_EQ(nlohmann::json::parse(outcome.out)["origin"], kept["origin"]);
  EXPECT_THAT(output_of({"history", "append", "kept/counts.json"}), HasSubstr("4 values"));
  EXPECT_FALSE(nlohmann::json::parse(read("counters.json")).contains("origin"));
}

TEST_F(BenchCounters, WrongAnswersAreNotKept) {
  count("--accept");
  write("worker/tree-mesh.objection", "one triangle too few");
  EXPECT_EQ(count("--out counts.json").code, 1);
  EXPECT_FALSE(exists("counts.json"));
}

TEST_F(BenchCounters, FilesThatCannotBeWrittenAreRefusedBeforeAnythingIsCounted) {
  count("--accept");
  write("worker/phytobench_worker", "#!/bin/sh\n: > \"$(dirname \"$0\")/was-asked\"\nexit 3\n");
  write("file", "");
  std::filesystem::create_directories(folder() / "folder");
  const auto expect = [&](const std::string& more, int code, const std::string& part) {
    const Outcome outcome = count(more);
    EXPECT_EQ(outcome.code, code) << more;
    EXPECT_THAT(outcome.err, HasSubstr(part)) << more;
    EXPECT_EQ(line_count(outcome.err), 1) << outcome.err;
  };
  expect("--out folder", 2, "folder: is a folder");
  expect("--junit folder", 2, "folder: is a folder");
  expect("--out /dev/null", 2, "/dev/null: is no ordinary file");
  expect("--out a.json --junit ./a.json", 2, "is given for two documents");
  expect("--out counters.json --accept", 2, "is given for two documents");
  expect("--junit file/below.xml", 3, "cannot write file/below.xml: file is no folder");
  expect("--junit typo/below.xml", 2, "there is no folder typo");
  EXPECT_FALSE(exists("worker/was-asked"));
  {
    const SmallFilesOnly full(0);
    EXPECT_EQ(count("--out counts.json").code, 3);
  }
  EXPECT_FALSE(exists("worker/was-asked"));
  EXPECT_EQ(left_behind(), (std::set<std::string>{"counters.json", "file", "folder", "worker"}));
}

TEST_F(BenchCounters, DamageAndWorkersThatDoNotCountAreRefused) {
  const std::string line = "bench counters --baseline counters.json --worker ";
  write("counters.json", "{");
  expect_refused_line(line + "worker/phytobench_worker", "counters.json: is not JSON");
  write("counters.json", "{\n  \"schema\": \"phytobench/counters-1\",\n  \"benchmarks\": {}\n}\n");
  expect_refused_line(line + "nowhere", "no such program");
  write("worker/counts-nothing", "");
  expect_refused_line(line + "worker/phytobench_worker", "without counters");
}

class BenchCommand : public CommandLine {};

TEST_F(BenchCommand, ListNamesWhatIsWatched) {
  const auto json = json_of({"bench", "list", "--json"}, "phytobench/bench-list-1");
  ASSERT_FALSE(json["benchmarks"].empty());
  const std::string first = json["benchmarks"][0]["name"];
  EXPECT_THAT(output_of({"bench", "list"}), HasSubstr(first));
  EXPECT_EQ(line_count(output_of({"bench", "list", first})), 1);
  EXPECT_EQ(run({"bench", "list", "nothing/*"}).code, 4);
}

}  // namespace
}  // namespace phytobench
