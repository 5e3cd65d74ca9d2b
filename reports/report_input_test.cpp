// SPDX-License-Identifier: MIT
#include "reports/report_input.hpp"

#include "core/record/plot_files.hpp"
#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

class ReportInputs : public RunFolder {
 protected:
  /// Of one experiment, with the files that its report shows.
  void write_run_with_pictures() const {
    const PlotData plot{.title = "t", .description = "d", .panels = {{.curves = {curve()}}}};
    RunWriter writer = start();
    writer.write_artifact("p/one", "tree.svg", "<svg/>");
    writer.write_artifact("p/one", "leaf.jpg", "jpeg");
    writer.write_artifact("p/one", "leaf.full.jpg", "large jpeg");
    writer.write_artifact("p/one", "growth.plot.json", plot_json(plot));
    writer.write_artifact("p/one", "growth.csv", plot_csv(plot));
    append_to(writer, "p/one");
  }

  static PlotCurve curve() { return {.name = "c", .x = {0, 1}, .y = {0, 1}}; }

  /// Copies the shown files of p/one to other names below artifacts/.
  void copy_pictures_as(const std::string& folder, const std::string& stem) const {
    const fs::path from = folder_ / "artifacts/p/one", to = folder_ / "artifacts" / folder;
    fs::create_directories(to);
    fs::copy(from / "tree.svg", to / (stem + ".svg"));
    fs::copy(from / "leaf.jpg", to / (stem + ".jpg"));
    fs::copy(from / "growth.plot.json", to / (stem + ".plot.json"));
    fs::copy(from / "growth.csv", to / (stem + ".csv"));
  }

  static std::set<std::string> names_in(const std::map<std::string, Picture>& pictures) {
    std::set<std::string> names;
    for (const auto& [name, picture] : pictures) names.insert(name);
    return names;
  }

  void expect_pictures_of_one_only() const {
    const ReportInput input = read_report_input({folder_}, {});
    std::set<std::string> drawings = names_in(input.drawings);
    drawings.erase("p/one/growth.svg");  // there if gnuplot is installed
    EXPECT_EQ(drawings, std::set<std::string>{"p/one/tree.svg"});
    EXPECT_EQ(names_in(input.photographs), std::set<std::string>{"p/one/leaf.jpg"});
    EXPECT_EQ(names_in(input.plot_data), std::set<std::string>{"p/one/growth.csv"});
    EXPECT_EQ(input.drawings.at("p/one/tree.svg").bytes, "<svg/>");
    EXPECT_EQ(input.drawings.at("p/one/tree.svg").file, folder_ / "artifacts/p/one/tree.svg");
  }
};

TEST_F(ReportInputs, ShowThePicturesThatTheRunSealed) {
  write_run_with_pictures();
  expect_pictures_of_one_only();
}

TEST_F(ReportInputs, LeaveOutFilesThatNoExperimentWrote) {
  write_run_with_pictures();
  copy_pictures_as("p/one", "fake");
  copy_pictures_as("x/never-run", "fake");
  expect_pictures_of_one_only();
}

TEST_F(ReportInputs, LeaveOutThePicturesOfAnExperimentThatIsNotComplete) {
  write_run_with_pictures();
  const std::string records = read_text_file(records_file());
  RunWriter writer = resume();
  writer.write_artifact("p/two", "tree.svg", "<svg/>");
  expect_pictures_of_one_only();
  append_to(writer, "p/two");
  EXPECT_TRUE(read_report_input({folder_}, {}).drawings.contains("p/two/tree.svg"));
  overwrite(records_file(), records);
  expect_pictures_of_one_only();
}

TEST_F(ReportInputs, LackTheBrokenExperimentUnlessAnotherRunHasIt) {
  write_run({"p/one", "p/two"});
  const fs::path whole = base_ / "whole", other = base_ / "other";
  fs::copy(folder_, whole, fs::copy_options::recursive);
  {
    RunWriter writer(other, quick_seven, RunMode::fresh);
    append_to(writer, "p/one");
  }
  const std::string records = read_text_file(records_file());
  overwrite(records_file(), records.substr(0, records.size() - 100));
  const ReportInputOptions options{.pictures = false};
  EXPECT_EQ(read_report_input({folder_}, options).judged.run.unfinished, "p/two");
  EXPECT_EQ(read_report_input({folder_, other}, options).judged.run.unfinished, "p/two");
  EXPECT_EQ(read_report_input({other, folder_}, options).judged.run.unfinished, "p/two");
  EXPECT_EQ(read_report_input({folder_, whole}, options).judged.run.unfinished, std::nullopt);
}

}  // namespace
}  // namespace phytobench
