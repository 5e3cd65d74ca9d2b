// SPDX-License-Identifier: MIT
#include "core/record/timings_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::StartsWith;

std::string timings_complaint(const std::string& text) {
  return input_error([&] { parse_timings("run/timings.jsonl", text); });
}

std::string timings_place(int line) {
  return "run/timings.jsonl:" + std::to_string(line) + ": ";
}

TEST(TimingsFile, SealsWhatBelongsToTheTimings) {
  EXPECT_EQ(timings_header(), R"({"schema":"phytobench/timings-2"})");
  EXPECT_EQ(timings_session("aa"), R"({"environment":"aa"})");
  EXPECT_EQ(timings_completion("p/one", 2, "bb", {}),
            R"({"experiment":"p/one","complete":true,"timings":2,"records_sha256":"bb"})");
  EXPECT_EQ(timings_completion("p/one", 2, "bb", {{"y.svg", "dd"}, {"x.svg", "cc"}}),
            R"({"experiment":"p/one","complete":true,"timings":2,"records_sha256":"bb",)"
            R"("artifacts":{"x.svg":"cc","y.svg":"dd"}})");
}

TEST(TimingsFile, ComesBackInItsOrder) {
  SealedText file(timings_header());
  file.add("", timings_session("e1"));
  file.add(timing_line("p/two", 0.5) + timing_line("p/two", 0.25),
           timings_completion("p/two", 2, "r2", {{"x.svg", "a"}}));
  file.add("", timings_session("e2"));
  const std::string before_last = file.text();
  file.add("", timings_completion("p/one", 0, "r1", {}));
  const TimingsFile read = parse_timings("f", file.text() + timing_line("p/three", 1.0));
  ASSERT_EQ(read.timings.size(), 2u);
  EXPECT_EQ(read.timings[1].value, 0.25);
  ASSERT_EQ(read.experiments.size(), 2u);
  EXPECT_EQ(read.experiments[0].name, "p/two");
  EXPECT_EQ(read.experiments[0].records_digest, "r2");
  EXPECT_THAT(read.experiments[0].artifacts, ElementsAre(testing::Pair("x.svg", "a")));
  EXPECT_EQ(read.experiments[0].timings, 2u);
  EXPECT_EQ(read.experiments[1].before.end, before_last.size());
  EXPECT_EQ(read.experiments[1].line, 7);
  ASSERT_EQ(read.sessions.size(), 2u);
  EXPECT_EQ(read.sessions[1].environment_digest, "e2");
  EXPECT_EQ(read.sessions[1].experiments, 1u);
  EXPECT_EQ(read.last.end, file.text().size());
}

TEST(TimingsFile, ForeignOrEmptyFileIsAnInputErrorInTheFirstLine) {
  for (const std::string& text :
       {std::string("{}\n"), timing_line("p/one", 1.0), SealedText(R"({"schema":"other"})").text(),
        SealedText(timings_session("e")).text()})
    EXPECT_THAT(timings_complaint(text),
                StartsWith(timings_place(1) + "the first line must name the schema"))
        << text;
  EXPECT_THAT(timings_complaint(""), StartsWith(timings_place(1) + "is empty"));
}

TEST(TimingsFile, ImpossibleTimingIsAnInputErrorAtItsLine) {
  for (const double seconds : {0.0, -1.0})
    EXPECT_THAT(timings_complaint(SealedText(timings_header()).text() + timing_line("p/one", 1.0) +
                                  timing_line("p/one", seconds)),
                StartsWith(timings_place(3)))
        << seconds;
}

TEST(TimingsFile, ContradictionIsAnInputErrorAtItsLine) {
  const std::string one = timing_line("p/one", 1.0);
  const auto with = [&](const std::string& lines, const std::string& object) {
    return timings_complaint(SealedText(timings_header()).add(lines, object).text());
  };
  EXPECT_THAT(with(one, timings_completion("p/one", 2, "r", {})),
              StartsWith(timings_place(3) + "experiment 'p/one' lost or gained timings"));
  EXPECT_THAT(with(one, timings_completion("p/two", 1, "r", {})),
              StartsWith(timings_place(3) + "a timing of 'p/one' stands in 'p/two'"));
  EXPECT_THAT(with(one, timings_session("e")),
              StartsWith(timings_place(3) + "timings of 'p/one' stand in no experiment"));
}

}  // namespace
}  // namespace phytobench
