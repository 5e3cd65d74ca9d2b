// SPDX-License-Identifier: MIT
// The values of reference/certified/lens_areas.toml derived again, and the library held to them.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/constants/constants.hpp>

#include "core/overlap/lens.hpp"
#include "core/statistics/log_relative_error.hpp"
#include "reference/certified_values.hpp"

namespace phytobench::certified {
namespace {

/// Both sectors less the kite of the centers and the crossings, whose area is Heron's twice over:
/// another form than that of the file, which adds two segments.
Exact lens(const Exact& r, const Exact& s, const Exact& d) {
  if (d >= r + s) return 0;
  const Exact small = r < s ? r : s;
  if (d <= abs(r - s)) return boost::math::constants::pi<Exact>() * small * small;
  const Exact own = acos(Exact((d * d + r * r - s * s) / (2 * d * r)));
  const Exact other = acos(Exact((d * d + s * s - r * r) / (2 * d * s)));
  const Exact kite = sqrt(Exact((r + s - d) * (d + r - s) * (d + s - r) * (d + r + s))) / 2;
  return r * r * own + s * s * other - kite;
}

TEST(CertifiedLensAreasOracle, HaveTheDigitsOfAnotherDerivation) {
  const std::vector<Value> values = values_of("lens_areas");
  ASSERT_GE(values.size(), 20u);
  for (const Value& value : values) {
    ASSERT_EQ(value.quantity(), "lens_area") << value.name();
    const Exact area = lens(value.exact("r"), value.exact("s"), value.exact("distance"));
    EXPECT_TRUE(is_rounded_to(value.digits(), area)) << value.name() << ": " << area.str(35);
  }
}

TEST(CertifiedLensAreasOracle, AreKeptByTheLibrary) {
  for (const Value& value : values_of("lens_areas")) {
    const double r = value.number("r"), s = value.number("s"), d = value.number("distance");
    const double digits = log_relative_error(lens_area(r, s, d), value.certified());
    EXPECT_GE(digits, value.promised_digits()) << value.name();
  }
}

// What makes a value hard: the textbook's form in double precision keeps no promise there.
TEST(CertifiedLensAreasOracle, AreOutOfReachOfTheTextbooksFormWhereHard) {
  int lost = 0;
  for (const Value& value : values_of("lens_areas")) {
    const double r = value.number("r"), s = value.number("s"), d = value.number("distance");
    if (value.name().find("outer-contact") == std::string::npos || d >= r + s) continue;
    const double kite = std::sqrt((r + s - d) * (d + r - s) * (d + s - r) * (d + r + s)) / 2;
    const double area = r * r * std::acos((d * d + r * r - s * s) / (2 * d * r)) +
                        s * s * std::acos((d * d + s * s - r * r) / (2 * d * s)) - kite;
    EXPECT_LT(log_relative_error(area, value.certified()), value.promised_digits());
    ++lost;
  }
  EXPECT_EQ(lost, 4);
}

}  // namespace
}  // namespace phytobench::certified
