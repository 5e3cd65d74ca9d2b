// SPDX-License-Identifier: MIT
#include "core/point_pattern/bucket_grid.hpp"

#include <set>
#include <utility>

#include <gtest/gtest.h>

#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

TEST(BucketGrid, HasBucketsNoLargerThanAsked) {
  const BucketGrid grid(Window::rectangle({{1, 2}, {4, 4}}), 0.7, 1.0);
  EXPECT_EQ(grid.columns(), 5u);
  EXPECT_EQ(grid.rows(), 3u);
  EXPECT_NEAR(grid.bucket_size().x, 0.6, 1e-15);
  EXPECT_NEAR(grid.bucket_size().y, 2.0 / 3.0, 1e-15);
  EXPECT_EQ(grid.find_near(7, [](const Point2&) { return true; }), BucketGrid::none);
}

std::uint32_t bucket_of(const BucketGrid& grid, const Rectangle& box, const Point2& p) {
  const Point2 from_low = p - box.low;
  return static_cast<std::uint32_t>(from_low.y / grid.bucket_size().y) * grid.columns() +
         static_cast<std::uint32_t>(from_low.x / grid.bucket_size().x);
}

TEST(BucketGridLaw, MissesNoPointInReachAndAsksNoneTwice) {
  const Rectangle box{{-3, 5}, {-1, 6}};
  for (const Window& window : {Window::torus(box), Window::rectangle(box)})
    for (const double side : {0.05, 0.13, 0.4, 5.0})
      for (const double distance : {0.0, 0.1, 0.3, 0.8, 4.0}) {
        BucketGrid grid(window, side, distance);
        CounterStream stream(1, 0);
        for (int i = 0; i < 60; ++i) {
          const Point2 p = window.random_point(stream);
          grid.add(p, bucket_of(grid, box, p));
        }
        for (int i = 0; i < 60; ++i) {
          const Point2 place = window.random_point(stream);
          std::multiset<std::pair<double, double>> asked;
          grid.find_near(bucket_of(grid, box, place), [&](const Point2& p) {
            asked.emplace(p.x, p.y);
            return false;
          });
          for (const Point2& p : grid.points()) {
            const auto times = asked.count({p.x, p.y});
            ASSERT_LE(times, 1u);
            if (norm(window.difference(p, place)) <= distance) ASSERT_EQ(times, 1u);
          }
        }
      }
}

TEST(BucketGrid, NamesThePointThatIsWanted) {
  BucketGrid grid(Window::torus({{0, 0}, {1, 1}}), 0.25, 0.25);
  for (const double x : {0.1, 0.15, 0.6}) grid.add({x, 0.1}, x < 0.5 ? 0 : 2);
  EXPECT_EQ(grid.find_near(3, [](const Point2& p) { return p.x == 0.15; }), 1u);
  EXPECT_EQ(grid.find_near(3, [](const Point2& p) { return p.x > 0.5; }), 2u);
  EXPECT_EQ(grid.take_points().size(), 3u);
}

TEST(BucketGrid, LooksOnlyAtBucketsInReach) {
  BucketGrid grid(Window::torus({{0, 0}, {10, 10}}), 1.0, 1.0);
  for (std::uint32_t bucket = 0; bucket < 100; ++bucket)
    grid.add({bucket % 10 + 0.5, bucket / 10 + 0.5}, bucket);
  int asked = 0;
  grid.find_near(0, [&](const Point2&) {
    ++asked;
    return false;
  });
  EXPECT_EQ(asked, 25);  // a point just beyond one bucket's border may be exactly 1 away
}

}  // namespace
}  // namespace phytobench
