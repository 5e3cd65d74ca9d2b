// SPDX-License-Identifier: MIT
#include "core/lsystem/turtle_settings.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

constexpr TurtleConvention all[] = {TurtleConvention::words, TurtleConvention::abop_matrices,
                                    TurtleConvention::cpfg, TurtleConvention::lpfg_uncorrected};

TEST(TurtleSettings, NamesLeadBackToTheirConvention) {
  for (const TurtleConvention convention : all)
    EXPECT_EQ(turtle_convention_named(name_of(convention)), convention);
}

TEST(TurtleSettings, RefusesUnknownConventionsNamingAllFour) {
  try {
    turtle_convention_named("word");
    FAIL();
  } catch (const InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("did you mean 'words'?"), std::string::npos) << message;
    for (const TurtleConvention convention : all)
      EXPECT_NE(message.find(name_of(convention)), std::string::npos) << message;
  }
}

TEST(TurtleSettingsLaw, SignsAreOfSizeOneAndTellConventionsApart) {
  for (const TurtleConvention one : all) {
    const TurtleSigns signs = signs_of(one);
    for (const double sign : {signs.turn, signs.pitch, signs.roll}) EXPECT_EQ(sign * sign, 1.0);
    for (const TurtleConvention other : all) {
      const TurtleSigns others = signs_of(other);
      const bool same =
          signs.turn == others.turn && signs.pitch == others.pitch && signs.roll == others.roll;
      EXPECT_EQ(same, one == other);
    }
  }
}

TEST(TurtleSettings, DiffersFromTheWordsWhereTheHeaderSays) {
  EXPECT_EQ(signs_of(TurtleConvention::words).roll, 1.0);
  EXPECT_EQ(signs_of(TurtleConvention::abop_matrices).turn, -1.0);
  EXPECT_EQ(signs_of(TurtleConvention::cpfg).pitch, 1.0);
  EXPECT_EQ(signs_of(TurtleConvention::cpfg).roll, -1.0);
  EXPECT_EQ(signs_of(TurtleConvention::lpfg_uncorrected).turn, 1.0);
  EXPECT_EQ(signs_of(TurtleConvention::lpfg_uncorrected).pitch, -1.0);
}

}  // namespace
}  // namespace phytobench
