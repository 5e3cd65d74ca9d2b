// SPDX-License-Identifier: MIT
#include "benchmarks/history/history_input.hpp"

#include "benchmarks/comparison/counter_gate.hpp"
#include "benchmarks/history/history_folder_fixture.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string some_inputs(64, 'a');

const std::string instructions = R"({"schema": "phytobench/instructions-1",
  "origin": {"commit": "abc", "changed": true, "compiler": "GNU 13", "flags": "-O2"},
  "benchmarks": [{"name": "p/one", "inputs": "i", "instructions": 9007199254740993},
                 {"name": "p/two", "instructions": 5}]})";

std::string counters() {
  return to_json(CounterBaseline{{"p/one", {some_inputs, {{"evaluations", 12}, {"nodes", 3}}}}});
}

std::string result(bool has_reference = true) {
  StoredResult stored{
      .origin = {.commit = "abc", .changed = true, .compiler = "GNU 13", .flags = "-O2"},
      .machine = {.processor = "Model 7", .logical_processors = 4},
      .benchmarks = {{.name = "p/one",
                      .inputs = "i",
                      .processes = {{0.2}, {0.1, 0.3, 0.5}, {0.5}},
                      .is_by_process = true},
                     {.name = "p/wrong", .objection = "no"}}};
  if (has_reference) stored.reference = ReferenceTime{"reference kernel", 0.1};
  return to_json(stored);
}

class HistoryInputFile : public HistoryFolder {
 protected:
  std::string file_of(const std::string& name, const std::string& content) const {
    write_file_atomically(folder_ / name, content);
    return (folder_ / name).string();
  }
  std::string complaint(const std::string& content) const {
    const std::string file = file_of("x.json", content);
    return input_error([&] { read_history_input(file); });
  }
};

TEST_F(HistoryInputFile, CountersAreOfThisBuildWhereTheFileDoesNotSay) {
  const HistoryEntry entry =
      history_entry_of({file_of("c.json", counters())}, history_run_of("me"));
  EXPECT_EQ(entry.run.commit, "me");
  const auto value = [](const char* name, std::uint64_t count) {
    return HistoryValue::counted("p/one", some_inputs, HistoryQuantity::counter(name), count);
  };
  EXPECT_THAT(entry.values, ElementsAre(value("evaluations", 12), value("nodes", 3)));
}

TEST_F(HistoryInputFile, CountersAreOfTheBuildThatTheirFileNames) {
  const std::string file = file_of(
      "c.json",
      to_json(CounterDocument{SideOrigin{.commit = "abc", .changed = true, .compiler = "GNU 13"},
                              CounterBaseline{{"p/one", {some_inputs, {{"evaluations", 12}}}}}}));
  const HistoryEntry entry = history_entry_of({file}, history_run_of("me"));
  EXPECT_EQ(entry.run.commit, "abc");
  EXPECT_TRUE(entry.run.changed);
  EXPECT_EQ(entry.run.compiler, "GNU 13");
  EXPECT_EQ(entry.values.size(), 1u);
}

TEST_F(HistoryInputFile, InstructionsKeepAllDigitsAndTheirBuild) {
  const HistoryEntry entry =
      history_entry_of({file_of("i.json", instructions)}, history_run_of("me"));
  EXPECT_EQ(entry.run.commit, "abc");
  EXPECT_TRUE(entry.run.changed);
  EXPECT_EQ(entry.run.compiler, "GNU 13");
  EXPECT_EQ(entry.run.processor, "Model 1");
  EXPECT_THAT(entry.values, ElementsAre(instructions_of("p/one", 9007199254740993u),
                                        instructions_of("p/two", 5, "")));
}

TEST_F(HistoryInputFile, OfTwoComparedBuildsTheNewOneIsKept) {
  const std::string compared = R"({"schema": "phytobench/instructions-1",
    "base": {"commit": "old", "compiler": "GNU 12"}, "new": {"commit": "abc", "compiler": "GNU 13"},
    "benchmarks": [{"name": "p/one", "base": {"instructions": 1, "inputs": "i"},
                    "new": {"instructions": 2, "inputs": "i"}},
                   {"name": "p/gone", "base": {"instructions": 1, "inputs": "i"}, "new": null}]})";
  const HistoryEntry entry = history_entry_of({file_of("i.json", compared)}, history_run_of("me"));
  EXPECT_EQ(entry.run.commit, "abc");
  EXPECT_THAT(entry.values, ElementsAre(instructions_of("p/one", 2)));
}

TEST_F(HistoryInputFile, SecondsBecomeRatiosToTheReferenceKernel) {
  const HistoryEntry entry = history_entry_of({file_of("r.json", result())}, history_run_of("me"));
  EXPECT_EQ(entry.run.machine_class(), "Model 7, 4 logical processors");
  ASSERT_EQ(entry.values.size(), 1u);
  EXPECT_EQ(entry.values[0].quantity(), HistoryQuantity::ratio());
  EXPECT_DOUBLE_EQ(entry.values[0].number(), 3.0);
  EXPECT_THAT(complaint(result(false)), HasSubstr("no bare seconds"));
}

TEST_F(HistoryInputFile, SeveralFilesAreOneRunOfOneBuild) {
  const std::string first = file_of("i.json", instructions), second = file_of("r.json", result()),
                    third = file_of("c.json", counters());
  const HistoryEntry entry = history_entry_of({third, first, second}, history_run_of("me"));
  EXPECT_EQ(entry.values.size(), 5u);
  EXPECT_EQ(entry.run.commit, "abc");
  std::string other = instructions;
  other.replace(other.find("abc"), 3, "abd");
  const std::string fourth = file_of("o.json", other);
  EXPECT_THAT(input_error([&] {
                history_entry_of({second, fourth}, history_run_of("me"));
              }),
              HasSubstr("o.json: is of another build"));
}

TEST_F(HistoryInputFile, EverythingElseIsToldWhatIsTaken) {
  for (const char* content :
       {"{}", R"({"schema": "phytobench/comparison-1"})", R"({"context": {}, "benchmarks": []})"})
    EXPECT_THAT(complaint(content), HasSubstr("a history takes phytobench/counters-1")) << content;
  for (
      const char* content :
      {"", "x", "[]", R"({"schema": "phytobench/instructions-1"})",
       R"({"schema": "phytobench/instructions-1", "benchmarks": [{"name": "a", "instructions": -1}]})",
       R"({"schema": "phytobench/instructions-1", "benchmarks": [{"name": "a", "instructions": 1.5}]})",
       R"({"schema": "phytobench/counters-1"})", R"({"schema": "phytobench/result-1"})"}) {
    EXPECT_THAT(complaint(content), HasSubstr("x.json: ")) << content;
    EXPECT_EQ(complaint(content).find('\n'), std::string::npos) << complaint(content);
  }
  const std::string file =
      file_of("e.json", R"({"schema": "phytobench/instructions-1", "benchmarks": []})");
  EXPECT_THROW(read_history_input(file), NothingSelected);
}

}  // namespace
}  // namespace phytobench
