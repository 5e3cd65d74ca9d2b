// SPDX-License-Identifier: MIT
#include "experiments/experiment_registry.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "experiments/run_experiments.hpp"
#include "reference/papers.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

TEST(ExperimentRegistry, DescriptorsAreCompleteAndUnique) {
  std::set<std::string_view> ids;
  for (const ExperimentDescriptor* experiment : all_experiments()) {
    EXPECT_TRUE(ids.insert(experiment->id).second) << experiment->id;
    EXPECT_TRUE(experiment->question.ends_with('?')) << experiment->id;
    EXPECT_TRUE(experiment->source.starts_with('[')) << experiment->id;
    EXPECT_NE(experiment->run, nullptr);
    for (const double seconds : experiment->seconds) EXPECT_GT(seconds, 0.0) << experiment->id;
  }
}

TEST(ExperimentRegistry, SelectsByIdAndGlob) {
  EXPECT_EQ(selected_experiments({}).size(), all_experiments().size());
  ASSERT_EQ(selected_experiments({"brzoska2019/table-1"}).size(), 1u);
  EXPECT_EQ(selected_experiments({"brzoska2019/table-1"})[0]->id, "brzoska2019/table-1");
  EXPECT_EQ(selected_experiments({"*/*"}).size(), all_experiments().size());
  EXPECT_GT(selected_experiments({"brzoska2019/*"}).size(), 10u);
  EXPECT_EQ(selected_experiments({"*/equations", "brzoska2019/eq*"}).size(), 1u)
      << "no experiment runs twice";
}

TEST(ExperimentRegistry, EveryExperimentIsOfARegisteredPaperOrOfTheSuite) {
  const std::vector<std::string> papers = paper_keys();
  for (const ExperimentDescriptor* experiment : all_experiments()) {
    const std::string group(experiment->id.substr(0, experiment->id.find('/')));
    EXPECT_TRUE(group == "suite" || std::find(papers.begin(), papers.end(), group) != papers.end())
        << experiment->id;
  }
}

TEST(ExperimentRegistry, SaysWhetherAnIdIsWrongOrAGlobEmpty) {
  EXPECT_THROW(selected_experiments({"brzoska2019/tabel-1"}), InputError);
  EXPECT_THROW(selected_experiments({"nothing*"}), NothingSelected);
  try {
    selected_experiments({"brzoska2019/tabel-1"});
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("brzoska2019/table-1"), std::string::npos)
        << error.what();
  }
}

class RunExperiments : public testing::Test {
 protected:
  fs::path folder_ =
      fs::path(testing::TempDir()) /
      (std::string("phytobench_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  RunRequest request(int threads) const {
    return {.experiments = selected_experiments({"*/deferred-removal", "*/attraction-cloud"}),
            .header = {Tier::smoke, 0},
            .threads = threads,
            .folder = folder_,
            .command_line = "test"};
  }
};

TEST_F(RunExperiments, GiveTheSameBytesForTheSameSeedAndAnyThreadCount) {
  run_experiments(request(1));
  const std::string first = read_text_file(folder_ / "records.jsonl");
  fs::remove_all(folder_);
  run_experiments(request(2));
  EXPECT_EQ(read_text_file(folder_ / "records.jsonl"), first);
}

TEST_F(RunExperiments, KeepFinishedExperimentsWhenInterruptedAndGoOnFromThere) {
  RunRequest interrupted = request(1);
  int asked = 0;
  interrupted.is_interrupted = [&] { return ++asked > 3; };  // in the second experiment
  EXPECT_THROW(run_experiments(interrupted), Interrupted);
  const RunContents partial = read_run(folder_);
  EXPECT_EQ(partial.complete_experiments.size(), 1u);

  RunRequest resumed = request(1);
  resumed.mode = RunMode::resume;
  run_experiments(resumed);
  const std::string after_resume = read_text_file(folder_ / "records.jsonl");
  fs::remove_all(folder_);
  run_experiments(request(1));
  EXPECT_EQ(read_text_file(folder_ / "records.jsonl"), after_resume);
}

TEST_F(RunExperiments, RefuseToMixWhatWasMeasuredOtherwise) {
  RunRequest first = request(1);
  first.experiments = selected_experiments({"*/deferred-removal"});
  run_experiments(first);
  const std::string environment = read_text_file(folder_ / "environment.json");
  RunRequest other_threads = request(2);
  other_threads.mode = RunMode::resume;
  EXPECT_THROW(run_experiments(other_threads), InputError);
  EXPECT_EQ(read_text_file(folder_ / "environment.json"), environment);
  EXPECT_EQ(read_run(folder_).complete_experiments.size(), 1u);
}

}  // namespace
}  // namespace phytobench
