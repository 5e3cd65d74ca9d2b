// SPDX-License-Identifier: MIT
#include "core/point_pattern/point_limit.hpp"

#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

TEST(PointLimit, SaysHowManyAndWhatToDo) {
  EXPECT_NO_THROW(refuse_too_many_points(0.0, "x"));
  EXPECT_NO_THROW(refuse_too_many_points(most_points, "x"));
  try {
    refuse_too_many_points(3.1e8, "lower the intensity");
    ADD_FAILURE() << "should have been refused";
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("3.1e+08"), std::string::npos) << message;
    EXPECT_NE(message.find("lower the intensity"), std::string::npos) << message;
  }
}

TEST(PointLimit, RefusesWhatIsNoNumber) {
  for (const double wrong :
       {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(refuse_too_many_points(wrong, "x"), InputError);
}

}  // namespace
}  // namespace phytobench
