// SPDX-License-Identifier: MIT
#include "core/overlap/coverage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/overlap/lens.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/overlap/test_discs.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using testing_discs::pi;

struct WindowedScene : testing_discs::Scene {
  std::optional<Rectangle> window;
};

Coverage coverage_of(const WindowedScene& scene, int threads = 1) {
  return coverage(scene.discs(), scene.ground, scene.window, threads);
}

/// The plane cut into strips at every place where something begins, ends or crosses; within a strip
/// no arcs cross, and the area between two neighbouring arcs has a closed form.
class StripOracle {
 public:
  StripOracle(std::vector<std::array<double, 3>> discs, std::optional<Rectangle> window)
      : discs_(std::move(discs)), window_(window) {
    result_.covered.assign(discs_.size(), 0.0);
    result_.by_times.assign(discs_.size() + 1, 0.0);
  }

  Coverage run() {
    const std::vector<double> cuts = cut_places();
    for (std::size_t c = 0; c + 1 < cuts.size(); ++c)
      if (cuts[c + 1] > cuts[c]) strip(cuts[c], cuts[c + 1]);
    return result_;
  }

 private:
  struct Arc {
    double middle;  ///< height in the middle of the strip
    double area;    ///< below it, within the strip
    int disc;       ///< -1 for a side of the window
    int step;
  };

  std::vector<double> cut_places() const {
    std::vector<double> cuts;
    for (const auto& [x, y, r] : discs_) {
      cuts.insert(cuts.end(), {x - r, x + r});
      for (const auto& [u, v, s] : discs_) {
        const double dx = u - x, dy = v - y, d2 = dx * dx + dy * dy;
        if (d2 == 0.0) continue;
        const double t = (d2 + r * r - s * s) / (2 * d2), h2 = r * r / d2 - t * t;
        if (h2 <= 0.0) continue;
        cuts.insert(cuts.end(), {x + t * dx - std::sqrt(h2) * dy, x + t * dx + std::sqrt(h2) * dy});
      }
      if (!window_) continue;
      for (const double side : {window_->low.y, window_->high.y})
        if (std::abs(side - y) < r)
          for (const int sign : {-1, 1})
            cuts.push_back(x + sign * std::sqrt(r * r - (side - y) * (side - y)));
    }
    if (window_) {
      cuts.insert(cuts.end(), {window_->low.x, window_->high.x});
      std::erase_if(cuts, [&](double c) { return c < window_->low.x || c > window_->high.x; });
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
  }

  static double below_circle(double x, double r) {
    const double t = std::clamp(x / r, -1.0, 1.0);
    return 0.5 * r * r * (t * std::sqrt((1 - t) * (1 + t)) + std::asin(t));
  }

  void strip(double left, double right) {
    const double middle = 0.5 * (left + right), width = right - left;
    std::vector<Arc> arcs;
    for (std::size_t i = 0; i < discs_.size(); ++i) {
      const auto& [x, y, r] = discs_[i];
      if (middle <= x - r || middle >= x + r) continue;
      const double up = std::sqrt((r - (middle - x)) * (r + (middle - x)));
      const double half = below_circle(right - x, r) - below_circle(left - x, r);
      const int disc = static_cast<int>(i);
      arcs.push_back({y - up, y * width - half, disc, +1});
      arcs.push_back({y + up, y * width + half, disc, -1});
    }
    if (window_) {
      arcs.push_back({window_->low.y, window_->low.y * width, -1, +1});
      arcs.push_back({window_->high.y, window_->high.y * width, -1, -1});
    }
    std::sort(arcs.begin(), arcs.end(),
              [](const Arc& a, const Arc& b) { return a.middle < b.middle; });
    std::vector<int> inside(discs_.size(), 0);
    int times = 0, in_window = window_ ? 0 : 1;
    for (std::size_t a = 0; a + 1 < arcs.size(); ++a) {
      if (arcs[a].disc < 0) in_window += arcs[a].step;
      if (arcs[a].disc >= 0) {
        inside[static_cast<std::size_t>(arcs[a].disc)] += arcs[a].step;
        times += arcs[a].step;
      }
      const double area = arcs[a + 1].area - arcs[a].area;
      if (in_window > 0 && (times > 0 || window_))
        result_.by_times[static_cast<std::size_t>(times)] += area;
      for (std::size_t i = 0; i < inside.size(); ++i)
        if (inside[i] > 0 && times > 1) result_.covered[i] += area;
    }
  }

  std::vector<std::array<double, 3>> discs_;
  std::optional<Rectangle> window_;
  Coverage result_;
};

/// On a torus with all images; only the discs themselves are asked for `covered`.
Coverage by_strips(const WindowedScene& scene) {
  std::vector<std::array<double, 3>> all;
  const Discs d = scene.discs();
  for (std::size_t i = 0; i < d.size(); ++i) all.push_back({d.x[i], d.y[i], d.radius[i]});
  if (scene.ground.torus)
    for (int ky = -1; ky <= 1; ++ky)
      for (int kx = -1; kx <= 1; ++kx)
        for (std::size_t i = 0; (kx != 0 || ky != 0) && i < d.size(); ++i)
          all.push_back({d.x[i] + kx * scene.ground.period_x(),
                         d.y[i] + ky * scene.ground.period_y(), d.radius[i]});
  const auto window = scene.ground.torus ? scene.ground.torus : scene.window;
  Coverage result = StripOracle(all, window).run();
  if (window) {  // `covered` takes no notice of it
    const auto whole = StripOracle(all, std::nullopt).run();
    result.covered = whole.covered;
  }
  result.covered.resize(d.size());
  return result;
}

void expect_equal(const Coverage& found, const Coverage& expected, double area) {
  const std::size_t most = std::max(found.by_times.size(), expected.by_times.size());
  for (std::size_t k = 0; k < most; ++k) {
    const auto at = [k](const Coverage& c) { return k < c.by_times.size() ? c.by_times[k] : 0.0; };
    EXPECT_NEAR(at(found), at(expected), 1e-12 * area) << k << " times";
  }
  ASSERT_EQ(found.covered.size(), expected.covered.size());
  for (std::size_t i = 0; i < found.covered.size(); ++i)
    EXPECT_NEAR(found.covered[i], expected.covered[i], 1e-12 * area) << "disc " << i;
}

WindowedScene random_scene(std::uint64_t seed, std::size_t count, double largest) {
  WindowedScene scene;
  CounterStream stream(seed, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 10 * stream.next_unit(), y = 8 * stream.next_unit();
    scene.add(x, y, largest * (0.05 + stream.next_unit()));
  }
  return scene;
}

TEST(CoverageOracle, IsThatOfStrips) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    WindowedScene scene = random_scene(seed, 1 + seed % 17, seed % 3 == 0 ? 0.8 : 2.5);
    expect_equal(coverage_of(scene), by_strips(scene), 80.0);
    scene.window = Rectangle{{1, 0.5}, {9, 7}};
    expect_equal(coverage_of(scene), by_strips(scene), 80.0);
  }
}

TEST(CoverageOracle, IsThatOfStripsOnATorus) {
  for (std::uint64_t seed = 100; seed < 130; ++seed) {
    SCOPED_TRACE(seed);
    WindowedScene scene = random_scene(seed, 1 + seed % 13, seed % 2 == 0 ? 0.7 : 3.5);
    scene.ground.torus = Rectangle{{0, 0}, {10, 8}};
    expect_equal(coverage_of(scene), by_strips(scene), 80.0);
  }
}

TEST(CoverageOracle, FollowsTouchingContainedAndEqualDiscs) {
  WindowedScene lattice;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 3; ++j) lattice.add(i, j, 0.5);
  expect_equal(coverage_of(lattice), by_strips(lattice), 10.0);

  WindowedScene nested;
  for (const double r : {3.0, 2.0, 1.0}) nested.add(r, 0, r);  // all touch from inside at 0
  EXPECT_THAT(
      coverage_of(nested).by_times,
      testing::ElementsAre(0.0, testing::DoubleNear(5 * pi, 1e-12),
                           testing::DoubleNear(3 * pi, 1e-12), testing::DoubleNear(pi, 1e-12)));

  WindowedScene equal;
  for (int i = 0; i < 5; ++i) equal.add(1, 2, 3);
  const Coverage c = coverage_of(equal);
  ASSERT_EQ(c.by_times.size(), 6u);
  EXPECT_NEAR(c.by_times[5], 9 * pi, 1e-12);
  for (int k = 1; k < 5; ++k) EXPECT_NEAR(c.by_times[static_cast<std::size_t>(k)], 0.0, 1e-12);
  for (const double covered : c.covered) EXPECT_NEAR(covered, 9 * pi, 1e-12);

  WindowedScene through_one_point;  // six circles of one radius with their centers around a point
  for (int i = 0; i < 6; ++i)
    through_one_point.add(std::cos(i * pi / 3), std::sin(i * pi / 3), 1.0);
  expect_equal(coverage_of(through_one_point), by_strips(through_one_point), 10.0);
}

TEST(Coverage, OfTwoIsTheirLens) {
  WindowedScene scene;
  scene.add(0, 0, 1);
  scene.add(1, 0, std::numbers::sqrt2);
  const Coverage c = coverage_of(scene);
  ASSERT_EQ(c.by_times.size(), 3u);
  EXPECT_NEAR(c.by_times[2], pi - 1, 1e-14);
  EXPECT_NEAR(c.by_times[1], pi + 2 * pi - 2 * (pi - 1), 1e-14);
  EXPECT_NEAR(c.covered[0], pi - 1, 1e-14);
  EXPECT_NEAR(c.covered[1], pi - 1, 1e-14);
}

TEST(Coverage, PairsMayAddUpToMoreThanTheDisc) {
  WindowedScene scene;
  scene.add(0, 0, 1);
  for (int i = 0; i < 3; ++i) scene.add(0.01 * i, 0.0, 5.0);
  const Coverage c = coverage_of(scene);
  EXPECT_NEAR(c.covered[0], pi, 1e-12);
  EXPECT_GT(3 * lens_area(1, 5, 0.02), 2.9 * pi);
}

TEST(Coverage, OfNothingIsTheBareWindow) {
  WindowedScene scene;
  EXPECT_THAT(coverage_of(scene).by_times, testing::ElementsAre(0.0));
  scene.window = Rectangle{{0, 0}, {3, 2}};
  EXPECT_THAT(coverage_of(scene).by_times, testing::ElementsAre(6.0));
  scene.add(1, 1, 0.0);
  EXPECT_THAT(coverage_of(scene).by_times, testing::ElementsAre(6.0));
  EXPECT_THAT(coverage_of(scene).covered, testing::ElementsAre(0.0));
  scene.add(1, 1, 100.0);
  const Coverage c = coverage_of(scene);
  ASSERT_EQ(c.by_times.size(), 2u);
  EXPECT_NEAR(c.by_times[0], 0.0, 1e-12);
  EXPECT_NEAR(c.by_times[1], 6.0, 1e-12);
}

double weighted_sum(const Coverage& c) {
  double sum = 0.0;
  for (std::size_t k = 1; k < c.by_times.size(); ++k) sum += static_cast<double>(k) * c.by_times[k];
  return sum;
}

TEST(CoverageLaw, TimesWeightedAreasAddUpToAllDiscs) {
  for (const bool is_torus : {false, true}) {
    WindowedScene scene;
    if (is_torus) scene.ground.torus = Rectangle{{0, 0}, {100, 100}};
    double discs = 0.0;
    for (std::size_t i = 0; i < 3000; ++i) {
      const double r = std::pow(30.0, random_unit(3, 2, i));
      scene.add(100 * random_unit(3, 0, i), 100 * random_unit(3, 1, i), r);
      discs += pi * r * r;
    }
    const Coverage c = coverage_of(scene);
    EXPECT_NEAR(weighted_sum(c) / discs, 1.0, 1e-12);
    if (is_torus)
      EXPECT_NEAR(std::accumulate(c.by_times.begin(), c.by_times.end(), 0.0), 1e4, 1e-8);
  }
}

TEST(CoverageLaw, DoesNotDependOnOrderPlaceScaleOrThreads) {
  const WindowedScene scene = random_scene(7, 60, 1.2);
  const Coverage first = coverage_of(scene);
  WindowedScene moved;
  for (std::size_t i = scene.x.size(); i-- > 0;)
    moved.add(8 * scene.x[i] + 4096, 8 * scene.y[i] - 512, 8 * scene.radius[i]);
  Coverage back = coverage_of(moved);
  std::reverse(back.covered.begin(), back.covered.end());
  for (double& area : back.covered) area /= 64;
  for (double& area : back.by_times) area /= 64;
  expect_equal(back, first, 80.0);

  WindowedScene many;
  for (std::size_t i = 0; i < 9000; ++i)
    many.add(100 * random_unit(5, 0, i), 100 * random_unit(5, 1, i), 1.0 + random_unit(5, 2, i));
  const Coverage one = coverage_of(many);
  for (const int threads : {2, 5}) {
    const Coverage several = coverage_of(many, threads);
    EXPECT_EQ(several.by_times, one.by_times);
    EXPECT_EQ(several.covered, one.covered);
  }
}

/// Without a third disc, a disc is covered by the sum of its pairs.
TEST(CoverageLaw, WithoutTriplesItIsTheSumOfPairs) {
  WindowedScene chain;
  for (int i = 0; i < 30; ++i) chain.add(1.5 * i, 0, 1.0);
  const Coverage c = coverage_of(chain);
  const double lens = lens_area(1, 1, 1.5);
  for (std::size_t i = 0; i < 30; ++i)
    EXPECT_NEAR(c.covered[i], i == 0 || i == 29 ? lens : 2 * lens, 1e-14);
}

/// Boolean model on a torus: each point is bare with probability prod(1 - pi r^2 / area).
TEST(CoverageLaw, BareShareOfRandomDiscsIsTheProduct) {
  constexpr int runs = 300;
  constexpr std::size_t count = 40;
  double expected = 1.0;
  const auto radius = [](std::size_t i) { return 0.02 + 0.003 * static_cast<double>(i); };
  for (std::size_t i = 0; i < count; ++i) expected *= 1 - pi * radius(i) * radius(i);
  double sum = 0.0, squares = 0.0;
  for (int run = 0; run < runs; ++run) {
    WindowedScene scene;
    scene.ground.torus = Rectangle{{0, 0}, {1, 1}};
    CounterStream stream(11, static_cast<std::uint64_t>(run));
    for (std::size_t i = 0; i < count; ++i) {
      const double x = stream.next_unit();
      scene.add(x, stream.next_unit(), radius(i));
    }
    const double bare = coverage_of(scene).by_times[0];
    sum += bare;
    squares += bare * bare;
  }
  const double mean = sum / runs, variance = squares / runs - mean * mean;
  EXPECT_NEAR(mean, expected, 4 * std::sqrt(variance / runs));
  EXPECT_GT(expected, 5 * 4 * std::sqrt(variance / runs));  // the test can fail
}

TEST(Coverage, OfATinyDiscAmongHugeOnesKeepsItsDigits) {
  WindowedScene scene;
  scene.add(1000, 0, 1000);     // its left end at 0
  scene.add(0, 0, 1e-3);        // half covered by it
  scene.add(5000, 3000, 2000);  // far
  const double exact = lens_area(1000, 1e-3, 1000);
  EXPECT_NEAR(coverage_of(scene).covered[1] / exact, 1.0, 1e-9);
}

}  // namespace
}  // namespace phytobench
