// SPDX-License-Identifier: MIT
#include "reports/artifact_plots.hpp"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/record/plot_files.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* no_gnuplot = "phytobench-no-such-program";

PlotData two_panels() {
  PlotPanel panel{
      .curves = {{.name = "first", .x = {0, 1, 2}, .y = {0, 1, 4}},
                 {.name = "second", .x = {0, 1, 2}, .y = {1, 2, 3}, .style = PlotStyle::points}},
      .caption = "left",
      .x_label = "time",
      .y_label = "size"};
  PlotPanel other = panel;
  other.caption = "right";
  std::swap(other.curves[0], other.curves[1]);
  return {.title = "Two plants", .description = "They grow.", .panels = {panel, other}};
}

class ArtifactPlots : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder()); }
  void TearDown() override { fs::remove_all(run_); }

  fs::path folder() const { return run_ / "artifacts/alsweis/two-plants"; }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder() / name) << text;
  }
  std::string refusal() const { return refusal(sealed_); }
  std::string refusal(const std::set<std::string>& sealed) const {
    try {
      artifact_plots(run_, sealed, no_gnuplot);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  /// The path of a file below artifacts/.
  static std::string path_of(const std::string& name) { return "alsweis/two-plants/" + name; }

  const std::set<std::string> sealed_{path_of("figure-4.5.plot.json"), path_of("figure-4.5.csv"),
                                      path_of("stand.svg"), path_of("passes.csv")};
  fs::path run_ =
      fs::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(ArtifactPlots, AreFoundWithTheirDataAlsoWithoutGnuplot) {
  write("figure-4.5.plot.json", plot_json(two_panels()));
  write("figure-4.5.csv", plot_csv(two_panels()));
  write("stand.svg", "<svg/>");
  write("passes.csv", "a,b\n");
  const auto plots = artifact_plots(run_, sealed_, no_gnuplot);
  ASSERT_EQ(plots.size(), 1u);
  const auto& [name, plot] = *plots.begin();
  EXPECT_EQ(name, "alsweis/two-plants/figure-4.5.svg");
  EXPECT_EQ(plot.svg, "");
  EXPECT_EQ(plot.caption.title, "Two plants");
  EXPECT_EQ(plot.caption.description, "They grow.");
  EXPECT_EQ(plot.data_name, "alsweis/two-plants/figure-4.5.csv");
  EXPECT_EQ(plot.data_file, folder() / "figure-4.5.csv");
  EXPECT_EQ(plot.data, plot_csv(two_panels()));
}

TEST_F(ArtifactPlots, AreNoneInARunWithoutArtifacts) {
  EXPECT_TRUE(artifact_plots(run_ / "nowhere", {}, no_gnuplot).empty());
}

TEST_F(ArtifactPlots, AreThoseThatTheRunSealed) {
  write("figure-4.5.plot.json", plot_json(two_panels()));
  write("figure-4.5.csv", plot_csv(two_panels()));
  EXPECT_TRUE(artifact_plots(run_, {path_of("figure-4.5.csv")}, no_gnuplot).empty());
  EXPECT_EQ(artifact_plots(run_, sealed_, no_gnuplot).size(), 1u);
}

TEST_F(ArtifactPlots, AreRefusedWithTheFileThatIsWrong) {
  write("figure-4.5.plot.json", plot_json(two_panels()));
  write("figure-4.5.csv", plot_csv(two_panels()));
  EXPECT_THAT(refusal({path_of("figure-4.5.plot.json")}),
              HasSubstr("figure-4.5.csv: the points of figure-4.5.plot.json are missing"));
  write("figure-4.5.csv", plot_csv(two_panels()) + "1,third,0,0\n");
  EXPECT_THAT(refusal(), HasSubstr("figure-4.5.csv:14: no series 'third'"));
  write("figure-4.5.csv", plot_csv(two_panels()));
  EXPECT_EQ(refusal(), "");
  write("figure-4.5.plot.json", "{\"schema\": \"vega\"}");
  EXPECT_THAT(refusal(), HasSubstr("figure-4.5.plot.json: the key 'schema'"));
}

TEST(DrawPlot, GivesAllPanelsOneLookAndOneTitle) {
  const auto svg = draw_plot(two_panels(), "plot");
  if (!svg) GTEST_SKIP() << "gnuplot (package gnuplot-nox) is not installed";
  EXPECT_THAT(*svg, HasSubstr("<title id='plot-title'>Two plants</title>"));
  EXPECT_THAT(*svg, HasSubstr(">left<"));
  EXPECT_THAT(*svg, HasSubstr(">right<"));
  EXPECT_THAT(*svg, HasSubstr("viewBox=\"0 0 960 400\""));
  EXPECT_LT(svg->size(), 60u * 1024u);
  // A name has its colour in every panel, whatever the order.
  const auto colour_after = [&](const std::string& start) {
    const std::size_t plot = svg->find("id=\"" + start);
    const std::size_t colour = svg->find("stroke='rgb(", svg->find("<path", plot));
    return svg->substr(colour, 25);
  };
  EXPECT_EQ(colour_after("plot-1-gnuplot_plot_1"), colour_after("plot-2-gnuplot_plot_2"));
  EXPECT_EQ(*draw_plot(two_panels(), "plot"), *svg);
}

TEST(DataTable, HoldsTheRowsOfSmallFilesOnly) {
  const DataTable table = data_table("series,x,y\n\"a, b\",1,2\nc,3,4\n");
  EXPECT_EQ(table.header, (std::vector<std::string>{"series", "x", "y"}));
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"a, b", "1", "2"}));
  EXPECT_TRUE(data_table("x\n1\n2\n", 1).rows.empty());
  EXPECT_EQ(data_table("x\n1\n2\n", 2).rows.size(), 2u);
  EXPECT_TRUE(data_table("").header.empty());
}

}  // namespace
}  // namespace phytobench
