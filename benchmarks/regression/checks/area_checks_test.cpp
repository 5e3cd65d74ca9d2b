// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/area_checks.hpp"

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/overlap/overlap_judge.hpp"
#include "core/overlap/lens.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t seed = 3;

TEST(LensAreasCheck, SeesADigitTooFewAndWhatIsNoNumber) {
  const std::vector<double> r{1.0, 1.0, 2.0}, s{1.0, 2.0, 1.0}, distance{1.0, 4.0, 0.5};
  std::vector<double> area(3);
  lens_areas(r, s, distance, area);
  EXPECT_EQ(objection_to_lens_areas(r, s, distance, area, seed), "");
  const std::vector<double> right = area;
  area[0] *= 1.0 + 1e-13;
  EXPECT_THAT(objection_to_lens_areas(r, s, distance, area, seed), HasSubstr("pair 0"));
  area = right;
  area[1] = 1e-300;
  EXPECT_THAT(objection_to_lens_areas(r, s, distance, area, seed), HasSubstr("pair 1"));
  area = right;
  area[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(objection_to_lens_areas(r, s, distance, area, seed), HasSubstr("pair 2"));
  area.pop_back();
  EXPECT_THAT(objection_to_lens_areas(r, s, distance, area, seed), HasSubstr("2 areas of 3 pairs"));
}

/// Where the textbook's form has few digits or none, and is NaN for some.
TEST(LensAreasCheck, HasAllDigitsNearContactAndBetweenUnequalDiscs) {
  std::vector<double> r, s, distance;
  for (const double gap : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15})
    for (const double large : {1.0, 30.0, 1000.0}) {
      r.insert(r.end(), {1.0, large, large});
      s.insert(s.end(), {large, 1.0, 1.0});
      distance.insert(distance.end(),
                      {(1.0 + large) * (1.0 - gap), large - 1.0 + gap, large + 0.3});
    }
  std::vector<double> area(r.size());
  lens_areas(r, s, distance, area);
  EXPECT_EQ(objection_to_lens_areas(r, s, distance, area, seed), "");
  for (std::size_t p = 0; p < area.size(); ++p) {
    std::vector<double> wrong = area;
    wrong[p] *= 1.0 + 1e-8;
    EXPECT_NE(objection_to_lens_areas(r, s, distance, wrong, seed), "") << p;
  }
}

TEST(LensAreasCheck, SeesLostDigitsOfAllBySampling) {
  // Less than the rounding of the textbook's form for discs so unequal.
  const std::vector<double> r(50, 1000.0), s(50, 1.0), distance(50, 1000.2);
  std::vector<double> area(50);
  lens_areas(r, s, distance, area);
  EXPECT_EQ(objection_to_lens_areas(r, s, distance, area, seed), "");
  for (double& one : area) one *= 1.0 + 1e-13;
  EXPECT_THAT(objection_to_lens_areas(r, s, distance, area, seed), HasSubstr("a hundred digits"));
}

/// `pairs` with the area of one of them multiplied.
OverlapPairs with_area(const OverlapPairs& pairs, std::size_t which, double factor) {
  OverlapPairs changed;
  for (std::size_t p = 0; p < pairs.size(); ++p)
    changed.push_back(pairs.first()[p], pairs.second()[p],
                      p == which ? factor * pairs.area()[p] : pairs.area()[p]);
  return changed;
}

TEST(PairAreasCheck, SeesOneWrongArea) {
  for (const bool is_torus : {false, true}) {
    const OverlapWorkload workload =
        random_discs({.count = 200, .sizes = DiscSizes::mixed, .is_torus = is_torus, .seed = seed});
    const OverlapJudge judge(workload, seed);
    ASSERT_GT(judge.pairs().size(), 100u);
    const auto objection = [&](const OverlapPairs& pairs) {
      return objection_to_pair_areas(pairs, judge.distances(), workload, seed);
    };
    EXPECT_EQ(objection(judge.pairs()), "");
    EXPECT_THAT(objection(with_area(judge.pairs(), 70, 1.0 + 1e-8)), HasSubstr("pair 70"));
    EXPECT_THAT(objection(with_area(judge.pairs(), 70, 0.0)), HasSubstr("pair 70"));
  }
}

/// Two discs that meet across all four corners of a torus, at four distances.
TEST(PairAreasCheck, KnowsImagesApart) {
  OverlapWorkload workload;
  workload.x = {0.0, 4.5};
  workload.y = {0.0, 3.7};
  workload.radius = {3.5, 3.9};
  workload.ground.torus = Rectangle{{0.0, 0.0}, {10.0, 8.0}};
  const OverlapJudge judge(workload, seed);
  ASSERT_EQ(judge.pairs().size(), 4u);
  EXPECT_EQ(objection_to_pair_areas(judge.pairs(), judge.distances(), workload, seed), "");
  EXPECT_NE(objection_to_pair_areas(with_area(judge.pairs(), 2, 1.001), judge.distances(), workload,
                                    seed),
            "");
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
