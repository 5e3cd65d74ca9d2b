// SPDX-License-Identifier: MIT
#include "core/record/records_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const std::string quick_header = records_header(quick_seven);

/// What reading says about a file of that text.
std::string records_complaint(const std::string& text) {
  return input_error([&] { parse_records("run/records.jsonl", text); });
}

std::string records_place(int line) {
  return "run/records.jsonl:" + std::to_string(line) + ": ";
}

TEST(RecordsFile, HasOneSealedLineBeforeAndAfterTheRecords) {
  EXPECT_EQ(quick_header, R"({"schema":"phytobench/records-2","tier":"quick","seed":7})");
  EXPECT_EQ(records_completion("p/one", 2),
            R"({"experiment":"p/one","complete":true,"records":2})");
}

TEST(RecordsFile, ComesBackInItsOrder) {
  SealedText file(quick_header);
  file.add(record_line("p/two", "a") + record_line("p/two", "b"), records_completion("p/two", 2));
  file.add("", records_completion("p/one", 0));
  const RecordsFile read = parse_records("f", file.text());
  EXPECT_EQ(read.header, quick_seven);
  ASSERT_EQ(read.records.size(), 2u);
  EXPECT_EQ(read.records[1].measurement, "p/two/b");
  ASSERT_EQ(read.experiments.size(), 2u);
  EXPECT_EQ(read.experiments[0].name, "p/two");
  EXPECT_EQ(read.experiments[1].name, "p/one");
  EXPECT_EQ(read.last.digest, read.experiments[1].digest);
  EXPECT_EQ(read.last.line, 5);
  EXPECT_EQ(read.last.end, file.text().size());
}

TEST(RecordsFile, LeavesOutWhatIsUnfinishedWhereverItBreaksOff) {
  const std::string whole = SealedText(quick_header).add("", records_completion("p/one", 0)).text();
  SealedText more(quick_header);
  more.add("", records_completion("p/one", 0));
  more.add(to_json_line(record_of("p/two", "text", std::string("\xc3\xa4 \"\n\x01"))) + "\n" +
               to_json_line(record_of("p/two", "value", -1.5e-300)) + "\n",
           records_completion("p/two", 2));
  for (std::size_t cut = whole.size(); cut < more.text().size(); ++cut) {
    const RecordsFile read = parse_records("f", more.text().substr(0, cut));
    EXPECT_EQ(read.experiments.size(), 1u) << cut;
    EXPECT_TRUE(read.records.empty()) << cut;
    EXPECT_EQ(read.last.end, whole.size()) << cut;
  }
  EXPECT_EQ(parse_records("f", more.text()).experiments.size(), 2u);
}

TEST(RecordsFile, DamagedLastLineIsNotTakenForAnUnfinishedOne) {
  std::string text = SealedText(quick_header).add("", records_completion("p/one", 0)).text();
  text.back() = 'x';  // was its line end
  EXPECT_THAT(records_complaint(text), StartsWith(records_place(2) + "damaged line"));
  EXPECT_THAT(records_complaint(SealedText(quick_header).text() + "3"),
              StartsWith(records_place(2) + "damaged line"));
}

TEST(RecordsFile, DamageIsToldInPrintableLetters) {
  const auto is_printable = [](const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
  };
  const std::string control = R"({"experiment":"\u001b[2J\u00e4","complete":true,"records":1})";
  for (const std::string& text :
       {std::string("{\"\xff\xfe\x1b[31m\": 1}\n"), std::string("\x1b\xc3\n"),
        SealedText(quick_header).add("", control).text(),
        SealedText(R"({"schema":"phytobench/records-\u001b\u00e4","tier":"quick"})").text()}) {
    EXPECT_TRUE(is_printable(records_complaint(text))) << records_complaint(text);
    EXPECT_THAT(records_complaint(text), StartsWith("run/records.jsonl:"));
  }
  EXPECT_THAT(records_complaint("{\"a\": \xff}\n"),
              StartsWith(records_place(1) + "damaged line (no JSON from its byte 7 on); "));
}

TEST(RecordsFile, ForeignSchemaIsAnInputErrorInTheFirstLine) {
  for (const char* first :
       {R"({"tier":"quick","seed":7})", R"({"schema":"other/1","tier":"quick"})",
        R"({"schema":3,"tier":"quick","seed":7})", "[]", "3", "{}"}) {
    EXPECT_THAT(records_complaint(std::string(first) + "\n"),
                StartsWith(records_place(1) + "not a run of this suite"))
        << first;
    EXPECT_THAT(records_complaint(std::string(first) + "\n"), HasSubstr("phytobench/records-2"))
        << first;
  }
  EXPECT_THAT(records_complaint("hello\n"), StartsWith(records_place(1) + "damaged line"));
}

TEST(RecordsFile, SchemaOfAnotherVersionIsSaidToBeOne) {
  const std::string older = R"({"schema":"phytobench/records-1","tier":"quick","seed":7})";
  const std::string newer = R"({"schema":"phytobench/records-3","tier":"quick","seed":7})";
  for (const std::string& text :
       {older + "\n", older + "\n" + record_line("p/one", "a"), SealedText(newer).text()}) {
    EXPECT_THAT(records_complaint(text),
                StartsWith(records_place(1) + "this run has the schema phytobench/records-"));
    EXPECT_THAT(records_complaint(text), HasSubstr("another version"));
    EXPECT_THAT(records_complaint(text),
                HasSubstr("phytobench/records-2; run the experiments again"));
  }
}

TEST(RecordsFile, HeaderWithoutTierSeedOrSealIsAnInputErrorInTheFirstLine) {
  EXPECT_THAT(records_complaint(quick_header + "\n"),
              StartsWith(records_place(1) + "the first line has lost"));
  for (const char* first : {R"({"schema":"phytobench/records-2","tier":"quick"})",
                            R"({"schema":"phytobench/records-2","seed":7})",
                            R"({"schema":"phytobench/records-2","tier":"slow","seed":7})",
                            R"({"schema":"phytobench/records-2","tier":3,"seed":7})",
                            R"({"schema":"phytobench/records-2","tier":"quick","seed":"7"})"})
    EXPECT_THAT(records_complaint(SealedText(first).text()), StartsWith(records_place(1))) << first;
}

TEST(RecordsFile, EmptyFileIsAnInputError) {
  EXPECT_THAT(records_complaint(""), StartsWith(records_place(1) + "is empty"));
  EXPECT_THAT(records_complaint(quick_header), StartsWith(records_place(1) + "is empty"))
      << "was being written";
}

TEST(RecordsFile, BrokenLineIsAnInputErrorAtThatLine) {
  for (const char* broken : {"{broken\n", "\n", "[]\n", "3\n", "{}\n",
                             R"({"experiment":"p/one"})"
                             "\n"})
    EXPECT_THAT(records_complaint(
                    SealedText(quick_header)
                        .add(record_line("p/one", "a") + broken, records_completion("p/one", 1))
                        .text()),
                StartsWith(records_place(3)))
        << broken;
}

TEST(RecordsFile, ValueThatIsNeitherNumberNorTextIsAnInputErrorAtItsLine) {
  for (const char* value : {"null", "true", "[1]", "{}"}) {
    const std::string line = R"({"experiment":"p/one","measurement":"p/one/m","value":)" +
                             std::string(value) + R"(,"unit":"1","n":1})" + "\n";
    const std::string message = records_complaint(SealedText(quick_header).text() + line);
    EXPECT_THAT(message, StartsWith(records_place(2))) << value;
    EXPECT_THAT(message, HasSubstr("neither number nor text")) << value;
  }
}

// What no damage does: its seals are right. A program that wrote such files would be wrong.
TEST(RecordsFile, ContradictionIsAnInputErrorAtItsLine) {
  const std::string one = record_line("p/one", "a");
  SealedText twice(quick_header);
  twice.add(one + one, records_completion("p/one", 2));
  EXPECT_THAT(records_complaint(twice.text()),
              StartsWith(records_place(4) + "measurement 'p/one/a' stands here twice"));

  Record foreign = record_of("p/two", "a", std::int64_t{1});
  foreign.measurement = "p/one/a";
  SealedText elsewhere(quick_header);
  elsewhere.add(one, records_completion("p/one", 1));
  elsewhere.add(to_json_line(foreign) + "\n", records_completion("p/two", 1));
  EXPECT_THAT(records_complaint(elsewhere.text()),
              StartsWith(records_place(5) + "measurement 'p/one/a' stands here twice"));

  for (const std::size_t number : {0u, 2u})
    EXPECT_THAT(records_complaint(
                    SealedText(quick_header).add(one, records_completion("p/one", number)).text()),
                StartsWith(records_place(3) + "experiment 'p/one' lost or gained records"));

  SealedText again(quick_header);
  again.add(one, records_completion("p/one", 1));
  again.add(record_line("p/one", "b"), records_completion("p/one", 1));
  EXPECT_THAT(records_complaint(again.text()),
              StartsWith(records_place(5) + "experiment 'p/one' stands here twice"));

  EXPECT_THAT(
      records_complaint(SealedText(quick_header).add(one, records_completion("p/two", 1)).text()),
      StartsWith(records_place(3) + "a record of 'p/one' stands in 'p/two'"));
}

}  // namespace
}  // namespace phytobench
