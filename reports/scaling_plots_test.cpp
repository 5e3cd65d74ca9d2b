// SPDX-License-Identifier: MIT
#include "reports/scaling_plots.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// One engine at two sizes.
JudgedScaling measured() {
  JudgedScaling scaling;
  scaling.study.id = "study";
  ScaledEntry entry{.name = "grid.dn", .at = {}, .time_law = {}, .work_law = {}};
  for (const double size : {1000.0, 10000.0}) {
    scaling.sizes[size] = {
        .points = size + 7.0, .association_pairs = 2.0 * size, .removal_pairs = size};
    entry.at[size].seconds =
        MedianOfRounds{{.value = 1e-5 * size, .low = 0.9e-5 * size, .high = 1.1e-5 * size}, 9};
    entry.at[size].evaluations = 5.0 * size;
  }
  scaling.entries.push_back(entry);
  return scaling;
}

TEST(ScalingPlotData, HoldsWhatThePicturesShow) {
  const auto data = scaling_plot_data(measured(), false);
  ASSERT_EQ(data.size(), 2u);
  EXPECT_EQ(data.at("study-time"),
            "series,x,y,low,high\ngrid.dn,1007,0.01,0.009,0.011\ngrid.dn,10007,0.1,0.09,0.11\n");
  EXPECT_THAT(data.at("study-work"), StartsWith("series,x,y,low,high\ngrid.dn,1007,5000,"));
  EXPECT_THAT(data.at("study-work"), HasSubstr("\nfloor,10007,30000,,\n"));
}

TEST(ScalingPlotData, LeavesOutWhatVariesOnRequestAndWhatWasNotMeasured) {
  EXPECT_EQ(scaling_plot_data(measured(), true).size(), 1u);
  EXPECT_TRUE(scaling_plot_data(measured(), true).contains("study-work"));
  EXPECT_TRUE(scaling_plot_data({}, false).empty());
}

TEST(ScalingPlots, HaveTheNamesOfTheirData) {
  const auto plots = scaling_plots(measured(), false);
  if (plots.empty()) GTEST_SKIP() << "gnuplot (package gnuplot-nox) is not installed";
  for (const auto& [name, text] : scaling_plot_data(measured(), false))
    EXPECT_TRUE(plots.contains(name)) << name;
}

}  // namespace
}  // namespace phytobench
