// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/area_checks.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/overlap/lens.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

TEST(LensAreasCheck, SeesADigitTooFewAndWhatIsNoNumber) {
  const std::vector<double> r{1.0, 1.0, 2.0}, s{1.0, 2.0, 1.0}, distance{1.0, 4.0, 0.5};
  std::vector<double> area(3);
  lens_areas(r, s, distance, area);
  EXPECT_EQ(objection_to_lens_areas(r, s, distance, area), "");
  const std::vector<double> right = area;
  area[0] *= 1.0 + 1e-11;
  EXPECT_THAT(objection_to_lens_areas(r, s, distance, area), HasSubstr("pair 0"));
  area = right;
  area[1] = 1e-300;
  EXPECT_THAT(objection_to_lens_areas(r, s, distance, area), HasSubstr("pair 1"));
  area = right;
  area[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(objection_to_lens_areas(r, s, distance, area), HasSubstr("pair 2"));
  area.pop_back();
  EXPECT_THAT(objection_to_lens_areas(r, s, distance, area), HasSubstr("2 areas of 3 pairs"));
}

class CoverageCheck : public testing::Test {
 protected:
  OverlapWorkload workload_ = random_discs(
      {.count = 40, .sizes = DiscSizes::uniform, .partners = 6.0, .is_torus = true, .seed = 1});
  Coverage found_ = coverage(workload_.discs(), workload_.ground);

  std::string objection() const { return objection_to_coverage(found_, workload_, 3); }
};

TEST_F(CoverageCheck, AcceptsWhatIsRight) {
  EXPECT_EQ(objection(), "");
}

TEST_F(CoverageCheck, SeesGroundThatIsMissing) {
  found_.by_times[0] -= 1e-6;
  EXPECT_THAT(objection(), HasSubstr("the ground adds up"));
}

TEST_F(CoverageCheck, SeesGroundThatIsCoveredOnceTooOften) {
  ASSERT_GE(found_.by_times.size(), 3u);
  found_.by_times[1] -= 1e-6;
  found_.by_times[2] += 1e-6;
  EXPECT_THAT(objection(), HasSubstr("times add up"));
}

TEST_F(CoverageCheck, SeesDiscsThatAreCoveredTooMuch) {
  for (double& covered : found_.covered) covered += 1e-6;
  EXPECT_THAT(objection(), HasSubstr("by strips"));
}

}  // namespace
}  // namespace phytobench
