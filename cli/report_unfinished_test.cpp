// SPDX-License-Identifier: MIT
// phytobench report on a run that is not whole.
#include "cli/command_line_fixture.hpp"
#include "core/record/run_writer.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::Not;

class ReportUnfinishedSlow : public CommandLine {
 protected:
  void write_run() const {
    RunWriter writer(folder() / "run", {Tier::smoke, 0}, RunMode::fresh);
    for (const std::string experiment : {"p/one", "p/two"}) {
      writer.write_artifact(experiment, "tree.svg", "<svg/>");
      writer.append(experiment, std::vector{Record{experiment, experiment + "/share", 0.5}}, {});
    }
  }
};

TEST_F(ReportUnfinishedSlow, SaysWhichExperimentWasLeftOut) {
  write_run();
  const Words report{"report", "run", "--format", "csv"};
  EXPECT_THAT(output_of(report), Not(HasSubstr("left out")));
  const std::string records = read("run/records.jsonl");
  write("run/records.jsonl", records.substr(0, records.size() - 20));
  EXPECT_THAT(output_of(report),
              HasSubstr("p/two was left out: its records break off; go on with --resume\n"));
}

TEST_F(ReportUnfinishedSlow, NamesTheFolderWhereAFileIsGiven) {
  write_run();
  expect_refused({"report", "run/records.jsonl"}, 2,
                 "run/records.jsonl: is a file; give the folder of its run, run");
}

}  // namespace
}  // namespace phytobench
