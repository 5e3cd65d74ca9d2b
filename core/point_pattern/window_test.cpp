// SPDX-License-Identifier: MIT
#include "core/point_pattern/window.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/point_pattern/test_patterns.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/chi_square.hpp"

namespace phytobench {
namespace {

using test_patterns::infinity;
using test_patterns::least_p;

constexpr double difference_rounding = 1e-14;
constexpr Rectangle oblong{{-1.0, 2.0}, {3.0, 5.0}};

/// A 3 x 3 square with a notch that reaches from the top to a third of its height: area 7.
const std::vector<Point2>& notched_corners() {
  static const std::vector<Point2> corners{{0, 0}, {3, 0}, {3, 3}, {2, 3},
                                           {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  return corners;
}

Window notched() {
  return Window::polygon(notched_corners());
}

/// The message of the refusal, or nothing if the corners were accepted.
std::string refusal(const std::vector<Point2>& corners) {
  try {
    Window::polygon(corners);
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Window, MeasuresItself) {
  EXPECT_EQ(Window::rectangle(oblong).area(), 12.0);
  EXPECT_EQ(Window::torus(oblong).area(), 12.0);
  EXPECT_EQ(Window::torus(oblong).perimeter(), 14.0);
  EXPECT_EQ(notched().area(), 7.0);
  EXPECT_EQ(notched().perimeter(), 16.0);
  EXPECT_EQ(notched().bounding_box(), (Rectangle{{0, 0}, {3, 3}}));
  EXPECT_EQ(Window::rectangle(oblong).corners().size(), 4u);
}

TEST(Window, KnowsItsKind) {
  EXPECT_EQ(Window::rectangle(oblong).kind(), WindowKind::rectangle);
  EXPECT_EQ(Window::torus(oblong).kind(), WindowKind::torus);
  EXPECT_EQ(notched().kind(), WindowKind::polygon);
  EXPECT_EQ(name_of(WindowKind::rectangle), "rectangle");
  EXPECT_EQ(name_of(WindowKind::polygon), "polygon");
  EXPECT_EQ(name_of(WindowKind::torus), "torus");
}

TEST(Window, HoldsItsBorder) {
  for (const Window& window : {Window::rectangle(oblong), Window::torus(oblong)}) {
    for (const Point2& corner : window.corners()) EXPECT_TRUE(window.contains(corner));
    EXPECT_TRUE(window.contains({1.0, 2.0}));
    EXPECT_FALSE(window.contains({1.0, std::nextafter(2.0, 0.0)}));
    EXPECT_FALSE(window.contains({std::nextafter(3.0, 4.0), 3.0}));
  }
}

TEST(WindowPolygon, HoldsItsCornersAndSides) {
  const Window window = notched();
  for (const Point2& corner : notched_corners()) EXPECT_TRUE(window.contains(corner));
  for (const Point2& p : {Point2{1.5, 0}, {3, 1.5}, {2, 2}, {1.5, 1}, {1, 2}, {0.5, 3}, {0, 1}})
    EXPECT_TRUE(window.contains(p)) << p.x << ", " << p.y;
}

TEST(WindowPolygon, LeavesOutItsNotch) {
  const Window window = notched();
  for (const Point2& p : {Point2{1.5, 2}, {1.5, 1.0001}, {1.0001, 3}, {1.9999, 2}, {1.5, 3}})
    EXPECT_FALSE(window.contains(p)) << p.x << ", " << p.y;
  for (const Point2& p : {Point2{0.5, 2}, {2.5, 2}, {1.5, 0.5}, {1.5, 0.9999}, {0.9999, 2.9}})
    EXPECT_TRUE(window.contains(p)) << p.x << ", " << p.y;
  for (const Point2& p : {Point2{-0.1, 1}, {3.1, 1}, {1, -0.1}, {0.5, 3.1}})
    EXPECT_FALSE(window.contains(p)) << p.x << ", " << p.y;
}

// A ray to the side must not count a corner at its own height twice or never.
TEST(WindowPolygon, IsNotConfusedByCornersAtThePointsHeight) {
  const Window diamond = Window::polygon({{0, -1}, {1, 0}, {0, 1}, {-1, 0}});
  EXPECT_TRUE(diamond.contains({0, 0}));
  EXPECT_FALSE(diamond.contains({-0.9, 0.5}));
  EXPECT_FALSE(diamond.contains({0.9, -0.5}));
  const Window zigzag = Window::polygon({{0, 0}, {4, 0}, {4, 2}, {3, 1}, {2, 2}, {1, 1}, {0, 2}});
  EXPECT_TRUE(zigzag.contains({0.5, 1}));
  EXPECT_TRUE(zigzag.contains({2, 1}));
  EXPECT_FALSE(zigzag.contains({1, 1.5}));
  EXPECT_FALSE(zigzag.contains({-0.5, 1}));
  EXPECT_FALSE(zigzag.contains({-0.5, 2}));
}

TEST(WindowPolygonLaw, IsTheSameFromEitherSideAndAnyFirstCorner) {
  const Window window = notched();
  std::vector<Point2> backwards(notched_corners().rbegin(), notched_corners().rend());
  std::vector<Point2> turned(notched_corners().begin() + 3, notched_corners().end());
  turned.insert(turned.end(), notched_corners().begin(), notched_corners().begin() + 3);
  for (const std::vector<Point2>& corners : {backwards, turned}) {
    const Window other = Window::polygon(corners);
    EXPECT_EQ(other.area(), window.area());
    for (double x = -0.25; x < 3.5; x += 0.25)
      for (double y = -0.25; y < 3.5; y += 0.25)
        EXPECT_EQ(other.contains({x, y}), window.contains({x, y})) << x << ", " << y;
  }
  EXPECT_EQ(Window::polygon(backwards).corners().front(), notched_corners().front());
}

TEST(WindowPolygon, RefusesSidesThatMeet) {
  const auto says_meet = [](const std::vector<Point2>& corners) {
    return refusal(corners).find("meet") != std::string::npos;
  };
  EXPECT_TRUE(says_meet({{0, 0}, {1, 1}, {1, 0}, {0, 1.5}}));                    // bow tie
  EXPECT_TRUE(says_meet({{0, 0}, {2, 0}, {2, 2}, {1, 0}, {0, 2}}));              // corner on a side
  EXPECT_TRUE(says_meet({{0, 0}, {2, 0}, {1, 0}, {1, 1}}));                      // folded back
  EXPECT_TRUE(says_meet({{0, 0}, {1, -1}, {1, 1}, {0, 0}, {-1, 1}, {-1, -1}}));  // corner shared
  EXPECT_EQ(refusal({{0, 0}, {2, 0}, {2, 2}, {1, 0.001}, {0, 2}}), "");
}

TEST(WindowPolygon, RefusesCornersThatMakeNone) {
  EXPECT_NE(refusal({{0, 0}, {1, 0}}).find("three"), std::string::npos);
  // Numbered as the user has them, whichever way round.
  EXPECT_NE(refusal({{0, 0}, {0, 0}, {1, 0}, {0, 1}}).find("corners 1 and 2"), std::string::npos);
  EXPECT_NE(refusal({{0, 0}, {0, 1}, {1, 0}, {1, 0}}).find("corners 3 and 4"), std::string::npos);
  EXPECT_EQ(refusal({{0, 0}, {1, 0}, {0, 1}, {0, 0}}), "");  // a closed ring, as in maps
  EXPECT_NE(refusal({{0, 0}, {0, 2}, {1, 1}, {-1, 1}, {1, 0}}).find("sides 1 and 3"),
            std::string::npos);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(refusal({{0, 0}, {nan, 0}, {0, 1}}).find("corner 2"), std::string::npos);
  EXPECT_NE(refusal({{0, 0}, {1, 1}, {2, 2}}).find("area"), std::string::npos);
}

TEST(Window, ExpectsSidesOfSomeLength) {
  for (const Rectangle& wrong : {Rectangle{{0, 0}, {0, 1}},
                                 {{0, 0}, {1, 0}},
                                 {{1, 1}, {0, 0}},
                                 {{0, 0}, {infinity, 1}},
                                 {{0, 0}, {std::nan(""), 1}}}) {
    EXPECT_THROW(Window::rectangle(wrong), ContractViolation);
    EXPECT_THROW(Window::torus(wrong), ContractViolation);
  }
}

TEST(WindowTorus, GoesTheShorterWay) {
  const Window periodic_window = Window::torus(oblong);  // 4 wide, 3 high
  EXPECT_EQ(periodic_window.difference({-0.5, 2.5}, {2.5, 4.5}), (Point2{-1.0, -1.0}));
  EXPECT_EQ(periodic_window.difference({0.0, 3.0}, {1.0, 4.0}), (Point2{1.0, 1.0}));
  EXPECT_EQ(periodic_window.difference({-1.0, 2.0}, {3.0, 5.0}), (Point2{0.0, 0.0}));
  EXPECT_EQ(Window::rectangle(oblong).difference({-0.5, 2.5}, {2.5, 4.5}), (Point2{3.0, 2.0}));
}

TEST(WindowTorusLaw, DifferenceIsTheShortestOfAllImagesAndOdd) {
  const Window periodic_window = Window::torus(oblong);
  CounterStream stream(1, 0);
  for (int i = 0; i < 1000; ++i) {
    const Point2 a = periodic_window.random_point(stream), b = periodic_window.random_point(stream);
    const Point2 there = periodic_window.difference(a, b), back = periodic_window.difference(b, a);
    EXPECT_EQ(there, -1.0 * back);
    double shortest = std::numeric_limits<double>::max();
    for (const double x : {-4.0, 0.0, 4.0})
      for (const double y : {-3.0, 0.0, 3.0})
        shortest = std::min(shortest, norm(b - a + Point2{x, y}));
    EXPECT_NEAR(norm(there), shortest, difference_rounding);
  }
}

TEST(WindowLaw, RandomPointsAreUniform) {
  constexpr std::size_t across = 6, up = 6;
  for (const Window& window : {Window::rectangle({{0, 0}, {3, 3}}), notched()}) {
    std::vector<std::int64_t> cells(across * up, 0);
    CounterStream stream(2, 0);
    for (int i = 0; i < 20000; ++i) {
      const Point2 p = window.random_point(stream);
      ASSERT_TRUE(window.contains(p));
      ++cells.at(static_cast<std::size_t>(2.0 * p.y) * across +
                 static_cast<std::size_t>(2.0 * p.x));
    }
    std::vector<std::int64_t> inside;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const auto column = static_cast<double>(i % across), row = static_cast<double>(i / across);
      if (window.contains({0.5 * column + 0.25, 0.5 * row + 0.25})) inside.push_back(cells[i]);
    }
    EXPECT_EQ(static_cast<double>(inside.size()), 4.0 * window.area());
    EXPECT_GT(uniformity_p_value(inside), least_p);
  }
}

TEST(Window, TakesTwoNumbersForAPointOfARectangle) {
  CounterStream stream(3, 0), copy(3, 0);
  const Point2 p = Window::torus(oblong).random_point(stream);
  EXPECT_EQ(p.x, -1.0 + 4.0 * copy.next_unit());
  EXPECT_EQ(p.y, 2.0 + 3.0 * copy.next_unit());
  EXPECT_EQ(stream.next_unit(), copy.next_unit());
}

}  // namespace
}  // namespace phytobench
