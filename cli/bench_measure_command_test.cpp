// SPDX-License-Identifier: MIT
#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

class BenchMeasureCommand : public CommandLine {};

TEST_F(BenchMeasureCommand, KeepsEveryProcessBesideTheReferenceKernel) {
  const nlohmann::json result =
      json_of({"bench", "measure", "overlap/sweep", "--processes", "2", "--samples", "3",
               "--sample-ms", "1", "--seed", "5", "--out", "result.json", "--json"},
              "phytobench/result-1");
  EXPECT_EQ(nlohmann::json::parse(read("result.json")), result);
  EXPECT_EQ(result.at("reference").at("name"), "selftest/steady");
  ASSERT_EQ(result.at("benchmarks").size(), 2u) << "the benchmark and the reference kernel";
  for (const nlohmann::json& benchmark : result.at("benchmarks")) {
    ASSERT_EQ(benchmark.at("processes").size(), 2u);
    for (const nlohmann::json& process : benchmark.at("processes")) {
      ASSERT_EQ(process.size(), 3u);
      for (const nlohmann::json& seconds : process) EXPECT_GT(seconds.get<double>(), 0.0);
    }
  }
}

TEST_F(BenchMeasureCommand, ItsResultIsTakenByCompareAndHistory) {
  ASSERT_EQ(run_line("bench measure overlap/sweep --processes 9 --samples 1 --sample-ms 0.5 "
                     "--out result.json")
                .code,
            0);
  const Outcome compared = run_line("compare result.json result.json --json");
  EXPECT_EQ(compared.code, 0) << compared.err;
  EXPECT_EQ(run_line("history append result.json --file h.sqlite").code, 0);
  EXPECT_THAT(output_of({"history", "show", "overlap/sweep", "--file", "h.sqlite"}),
              testing::HasSubstr("ratio"));
}

TEST_F(BenchMeasureCommand, WrongInputIsRefused) {
  expect_refused_line("bench measure overlap/sweap", "overlap/sweep");
  expect_refused_line("bench measure --side nowhere", "nowhere");
  write("old.json", "{}");
  expect_refused_line("bench measure --side old.json", "is a result");
  expect_refused({"bench", "measure", "nothing/*"}, 4, "nothing/*");
  std::filesystem::create_directories(folder() / "folder");
  expect_refused_line("bench measure --side nowhere --out folder", "folder: is a folder");
  expect_refused({"bench", "measure", "--out", "old.json/new.json"}, 3, "old.json is no folder");
}

}  // namespace
}  // namespace phytobench
