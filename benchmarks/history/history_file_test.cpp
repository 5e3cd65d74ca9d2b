// SPDX-License-Identifier: MIT
#include "benchmarks/history/history_file.hpp"

#include <sys/wait.h>

#include "benchmarks/history/history_folder_fixture.hpp"
#include "benchmarks/history/sqlite_database.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class HistoryFileTest : public HistoryFolder {
 protected:
  std::string complaint(HistoryAccess access = HistoryAccess::append) const {
    return input_error([&] { HistoryFile(file(), access); });
  }
};

TEST_F(HistoryFileTest, RunsAndValuesComeBack) {
  {
    HistoryFile history = open();
    EXPECT_EQ(history.append(history_run_of("aaa"),
                             {instructions_of("p/one", 9007199254740993u), counter_of("p/one", 3),
                              HistoryValue::ratio("p/two", "j", 1.0 / 3.0)}),
              1);
    HistoryRun changed = history_run_of("b'b\"; DROP TABLE run; --");
    changed.changed = true;
    changed.utc.clear();
    EXPECT_EQ(history.append(changed, {counter_of("p/one", 4)}), 2);
  }
  const HistoryFile history(file(), HistoryAccess::read);
  const std::vector<HistoryRun> runs = history.runs();
  ASSERT_EQ(runs.size(), 2u);
  EXPECT_EQ(runs[0].commit, "aaa");
  EXPECT_EQ(runs[0].utc, "2026-11-27T22:16:00Z");
  EXPECT_EQ(runs[0].machine_class(), "Model 1, 2 logical processors");
  EXPECT_EQ(runs[0].values, 3u);
  EXPECT_EQ(runs[1].commit, "b'b\"; DROP TABLE run; --");
  EXPECT_TRUE(runs[1].changed);
  EXPECT_EQ(runs[1].utc.size(), std::string("2026-11-27T22:16:00Z").size());
  EXPECT_THAT(history.values(1),
              ElementsAre(counter_of("p/one", 3), instructions_of("p/one", 9007199254740993u),
                          HistoryValue::ratio("p/two", "j", 1.0 / 3.0)));
  EXPECT_THAT(history.benchmarks(), ElementsAre("p/one", "p/two"));
  EXPECT_THAT(history.quantities("p/one"), ElementsAre("counter:evaluations", "instructions"));
}

TEST_F(HistoryFileTest, SeriesIsOfOneBenchmarkQuantityAndMachineClass) {
  HistoryFile history = open();
  history.append(history_run_of("a"), {counter_of("p", 1), counter_of("q", 7)});
  history.append(history_run_of("b", "Model 2"), {counter_of("p", 2), instructions_of("p", 9)});
  history.append(history_run_of("c"), {counter_of("p", 3)});
  const HistoryQuantity quantity = HistoryQuantity::counter("evaluations");
  const auto counts = [](const std::vector<HistoryPoint>& series) {
    std::vector<std::int64_t> result;
    for (const HistoryPoint& point : series) result.push_back(point.value.count());
    return result;
  };
  EXPECT_THAT(counts(history.series("p", quantity)), ElementsAre(1, 2, 3));
  EXPECT_THAT(counts(history.series("p", quantity, "Model 1, 2 logical processors")),
              ElementsAre(1, 3));
  EXPECT_THAT(history.series("none", quantity), IsEmpty());
}

TEST_F(HistoryFileTest, BaselineIsARunUntilItIsAnother) {
  HistoryFile history = open();
  history.append(history_run_of("a"), {counter_of("p", 1)});
  history.append(history_run_of("b"), {counter_of("p", 2)});
  history.save_baseline("v1.0", 1);
  EXPECT_EQ(history.baseline("v1.0").commit, "a");
  EXPECT_THAT(history.runs()[0].baselines, ElementsAre("v1.0"));
  history.save_baseline("v1.0", 2);
  EXPECT_EQ(history.baseline("v1.0").commit, "b");
  EXPECT_THAT(input_error([&] { history.baseline("v1.1"); }), HasSubstr("did you mean 'v1.0'"));
  EXPECT_THAT(input_error([&] { history.save_baseline("v2", 9); }), HasSubstr("no run 9"));
  for (const char* name : {"", "12", "a b", "'"})
    EXPECT_NE(input_error([&] { history.save_baseline(name, 1); }), "no error") << name;
}

TEST_F(HistoryFileTest, ChangesOfInstructionsStayWithinOneBuildAndInput) {
  HistoryFile history = open();
  HistoryRun other_compiler = history_run_of("c");
  other_compiler.compiler = "GNU 13";
  history.append(history_run_of("a"), {instructions_of("p", 1000)});
  history.append(history_run_of("b", "Model 2"), {instructions_of("p", 5000)});
  history.append(other_compiler, {instructions_of("p", 7000)});
  history.append(history_run_of("d"), {instructions_of("p", 1010)});
  history.append(history_run_of("e"), {instructions_of("p", 1010)});
  history.append(history_run_of("f"), {instructions_of("p", 2000, "other inputs")});
  history.append(history_run_of("g"), {instructions_of("p", 1000, "other inputs")});
  EXPECT_THAT(history.changes_of_instructions("p"),
              ElementsAre(DoubleNear(0.01, 1e-12), 0.0, DoubleNear(0.5, 1e-12)));
  EXPECT_THAT(history.changes_of_instructions("none"), IsEmpty());
}

TEST_F(HistoryFileTest, NothingOrTheSameTwiceIsNotAppended) {
  HistoryFile history = open();
  EXPECT_NE(input_error([&] { history.append(history_run_of("a"), {}); }), "no error");
  EXPECT_THAT(input_error([&] {
                history.append(history_run_of("a"), {counter_of("p", 1), counter_of("p", 2)});
              }),
              HasSubstr("twice"));
  EXPECT_THAT(history.runs(), IsEmpty());
}

TEST_F(HistoryFileTest, WhatIsNoHistoryIsRefusedInOneLineAndLeftAsItIs) {
  EXPECT_THAT(complaint(HistoryAccess::read), HasSubstr("no such file"));
  EXPECT_FALSE(std::filesystem::exists(file()));
  const std::string text(5000, 'x');
  write_file_atomically(file(), text);
  EXPECT_THAT(complaint(), HasSubstr("is no SQLite file"));
  EXPECT_EQ(read_text_file(file()), text);
  std::filesystem::remove(file());
  std::filesystem::create_directories(file());
  EXPECT_THAT(complaint(), HasSubstr("is a folder"));
}

TEST_F(HistoryFileTest, ForeignNewerOrDamagedDatabaseIsRefused) {
  { SqliteDatabase(folder_ / "foreign", DatabaseAccess::create).execute("CREATE TABLE x (a)"); }
  EXPECT_THAT(input_error([&] { HistoryFile(folder_ / "foreign", HistoryAccess::append); }),
              HasSubstr("of another program"));
  { open(); }
  { SqliteDatabase(file(), DatabaseAccess::existing).execute("PRAGMA user_version = 2"); }
  EXPECT_THAT(complaint(), HasSubstr("newer phytobench"));
  { SqliteDatabase(file(), DatabaseAccess::existing).execute("PRAGMA user_version = 0"); }
  EXPECT_THAT(complaint(), HasSubstr("damaged"));
  {
    SqliteDatabase(file(), DatabaseAccess::existing)
        .execute("PRAGMA user_version = 1; DROP TABLE baseline");
  }
  const HistoryFile history(file(), HistoryAccess::read);
  EXPECT_THAT(input_error([&] { history.runs(); }), HasSubstr("damaged"));
}

TEST_F(HistoryFileTest, EmptyFileIsAHistoryToAppendToButNotToRead) {
  write_file_atomically(file(), "");
  EXPECT_THAT(complaint(HistoryAccess::read), HasSubstr("is empty"));
  open().append(history_run_of("a"), {counter_of("p", 1)});
  EXPECT_EQ(HistoryFile(file(), HistoryAccess::read).runs().size(), 1u);
}

TEST_F(HistoryFileTest, UnwritablePlaceIsTheMachinesFault) {
  write_file_atomically(folder_ / "below", "a file where the folder should be");
  EXPECT_THROW(open(), EnvironmentError);
  EXPECT_THROW(HistoryFile("/proc/phytobench/history.sqlite", HistoryAccess::append),
               EnvironmentError);
}

TEST_F(HistoryFileTest, TablesTakeNoSeconds) {
  open().append(history_run_of("a"), {counter_of("p", 1)});
  const SqliteDatabase database(file(), DatabaseAccess::existing);
  EXPECT_THROW(database.execute("INSERT INTO value VALUES (1, 'p', 'seconds', '', NULL, 0.5)"),
               ContractViolation);
  EXPECT_THROW(database.execute("INSERT INTO value VALUES (1, 'p', 'instructions', '', NULL, 0.5)"),
               ContractViolation);
  EXPECT_THROW(database.execute("INSERT INTO value VALUES (1, 'p', 'instructions', '', 'x', NULL)"),
               ContractViolation);
  EXPECT_THROW(database.execute("INSERT INTO value VALUES (9, 'p', 'instructions', '', 1, NULL)"),
               ContractViolation);
}

/// Several programs begin a history and append to it at once; each of them returns 0.
TEST_F(HistoryFileTest, ProgramsAppendSideBySide) {
  constexpr int programs = 4, runs_each = 10;
  std::vector<pid_t> children;
  for (int program = 0; program < programs; ++program) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child > 0) {
      children.push_back(child);
      continue;
    }
    int code = 0;
    try {
      for (int i = 0; i < runs_each; ++i)
        open().append(history_run_of(std::to_string(program)),
                      {counter_of("p", static_cast<std::uint64_t>(i)), instructions_of("p", 1)});
    } catch (const std::exception&) {
      code = 1;
    }
    ::_exit(code);
  }
  for (const pid_t child : children) {
    int status = -1;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
  }
  const HistoryFile history(file(), HistoryAccess::read);
  EXPECT_EQ(history.runs().size(), static_cast<std::size_t>(programs * runs_each));
  for (const HistoryRun& run : history.runs()) EXPECT_EQ(run.values, 2u);
}

TEST_F(HistoryFileTest, UnfinishedTransactionLeavesNothing) {
  open();
  {
    const SqliteDatabase database(file(), DatabaseAccess::existing);
    const SqliteTransaction transaction(database);
    database.execute("INSERT INTO run VALUES (1, '', '', 0, '', '', '', 2, '')");
  }
  EXPECT_THAT(HistoryFile(file(), HistoryAccess::read).runs(), IsEmpty());
}

}  // namespace
}  // namespace phytobench
