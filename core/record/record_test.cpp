// SPDX-License-Identifier: MIT
#include "core/record/record.hpp"

#include <limits>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Record record_with(RecordValue value) {
  return {.experiment = "p/e", .measurement = "p/e/m", .value = std::move(value)};
}

TEST(RecordLine, HoldsWholeNumbersAsTheyAre) {
  EXPECT_EQ(to_json_line(record_with(std::int64_t{3})),
            R"({"experiment":"p/e","measurement":"p/e/m","value":3,"unit":"1","n":1})");
  EXPECT_THAT(to_json_line(record_with(std::numeric_limits<std::int64_t>::min())),
              testing::HasSubstr(R"("value":-9223372036854775808,)"));
}

TEST(RecordLine, ShowsThatANumberIsNoWholeOne) {
  EXPECT_THAT(to_json_line(record_with(3.0)), testing::HasSubstr(R"("value":3.0,)"));
  EXPECT_THAT(to_json_line(record_with(0.1)), testing::HasSubstr(R"("value":0.1,)"));
}

TEST(RecordLine, HoldsUnitSampleSizeSpreadAndSeed) {
  const Record record{.experiment = "p/e",
                      .measurement = "p/e/m",
                      .value = 0.5,
                      .unit = "degree",
                      .sample_size = 30,
                      .spread = 0.25,
                      .seed = 7};
  EXPECT_EQ(to_json_line(record),
            R"({"experiment":"p/e","measurement":"p/e/m","value":0.5,"unit":"degree","n":30,)"
            R"("spread":0.25,"seed":7})");
}

TEST(RecordLine, IsOneLineWhateverTheText) {
  const std::string line = to_json_line(record_with(std::string("two\nlines \"quoted\"")));
  EXPECT_EQ(line.find('\n'), std::string::npos);
  EXPECT_THAT(line, testing::HasSubstr(R"("value":"two\nlines \"quoted\"")"));
}

TEST(RecordLine, RefusesWhatIsNotFinite) {
  for (const double value : {not_a_number, infinity, -infinity}) {
    EXPECT_THROW(to_json_line(record_with(value)), ContractViolation) << value;
    Record record = record_with(1.0);
    record.spread = value;
    EXPECT_THROW(to_json_line(record), ContractViolation) << value;
  }
}

TEST(TimingLine, HoldsRoundPositionSecondsAndThreads) {
  const TimingSample sample{.experiment = "p/e",
                            .measurement = "p/e/m",
                            .round = 2,
                            .position = 1,
                            .value = 0.25,
                            .threads = 4};
  EXPECT_EQ(to_json_line(sample),
            R"({"experiment":"p/e","measurement":"p/e/m","round":2,"position":1,"seconds":0.25,)"
            R"("threads":4})");
}

TEST(TimingLine, NamesTheUnitOfWhatIsNoTime) {
  const TimingSample sample{
      .experiment = "p/e", .measurement = "p/e/m", .value = 4096.0, .unit = "B"};
  EXPECT_EQ(to_json_line(sample),
            R"({"experiment":"p/e","measurement":"p/e/m","round":0,"position":0,"value":4096.0,)"
            R"("unit":"B","threads":1})");
}

TEST(TimingLine, RefusesWhatIsNotFinite) {
  for (const double seconds : {not_a_number, infinity})
    EXPECT_THROW(to_json_line(TimingSample{.value = seconds}), ContractViolation) << seconds;
}

TEST(Tier, IsFoundByItsName) {
  for (const Tier tier : {Tier::smoke, Tier::quick, Tier::full})
    EXPECT_EQ(tier_named(name_of(tier)), tier);
  EXPECT_EQ(name_of(Tier::smoke), "smoke");
}

TEST(Tier, UnknownIsAnInputErrorThatNamesTheThree) {
  for (const char* name : {"", "Quick", "fulll"}) {
    try {
      tier_named(name);
      ADD_FAILURE() << "'" << name << "' was taken";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("'" + std::string(name) + "'"));
      for (const char* known : {"smoke", "quick", "full"})
        EXPECT_THAT(error.what(), testing::HasSubstr(known));
    }
  }
}

}  // namespace
}  // namespace phytobench
