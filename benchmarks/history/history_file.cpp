// SPDX-License-Identifier: MIT
#include "benchmarks/history/history_file.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "benchmarks/history/history_tables.hpp"
#include "benchmarks/history/sqlite_database.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"

namespace phytobench {

namespace {

constexpr int run_columns = 9;
#define PHYTOBENCH_RUN_COLUMNS                                                            \
  "run.id, run.utc, run.commit_id, run.changed, run.compiler, run.flags, run.processor, " \
  "run.logical_processors, run.command"

HistoryRun run_from(const SqliteStatement& row) {
  return {.id = row.whole(0),
          .utc = row.text(1),
          .commit = row.text(2),
          .changed = row.whole(3) != 0,
          .compiler = row.text(4),
          .flags = row.text(5),
          .processor = row.text(6),
          .logical_processors = static_cast<int>(row.whole(7)),
          .command = row.text(8)};
}

/// From the columns benchmark, quantity, inputs, whole, ratio.
HistoryValue value_from(const SqliteStatement& row, int first) {
  const HistoryQuantity quantity = HistoryQuantity::named(row.text(first + 1));
  const std::string benchmark = row.text(first), inputs = row.text(first + 2);
  if (quantity.is_ratio()) return HistoryValue::ratio(benchmark, inputs, row.real(first + 4));
  return HistoryValue::counted(benchmark, inputs, quantity,
                               static_cast<std::uint64_t>(row.whole(first + 3)));
}

std::vector<std::string> texts(SqliteStatement&& rows) {
  std::vector<std::string> result;
  while (rows.step()) result.push_back(rows.text(0));
  return result;
}

void refuse_twice_the_same(const std::vector<HistoryValue>& values) {
  if (values.empty()) throw InputError("there is nothing to append: no value of any benchmark");
  std::set<std::pair<std::string, HistoryQuantity>> seen;
  for (const HistoryValue& value : values)
    if (!seen.insert({value.benchmark(), value.quantity()}).second)
      throw InputError(
          fmt::format("{} of '{}' is there twice; append the files one after the other",
                      value.quantity().text(), value.benchmark()));
}

void refuse_odd_name(const std::string& name) {
  const bool is_number = name.find_first_not_of("0123456789") == std::string::npos;
  const bool is_word = name.find_first_not_of(
                           "abcdefghijklmnopqrstuvwxyz"
                           "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                           "0123456789_-./") == std::string::npos;
  if (is_number || !is_word)
    throw InputError("'" + name +
                     "' cannot name a baseline; use letters, digits and _-./, not digits alone");
}

}  // namespace

std::string HistoryRun::machine_class() const {
  return fmt::format("{}, {} logical processors", processor.empty() ? "unknown" : processor,
                     logical_processors);
}

HistoryFile::HistoryFile(const std::filesystem::path& file, HistoryAccess access)
    : database_(std::make_unique<SqliteDatabase>(file, access == HistoryAccess::append
                                                           ? DatabaseAccess::create
                                                           : DatabaseAccess::existing)) {
  begin_history(*database_, access);
}

HistoryFile::~HistoryFile() = default;

std::int64_t HistoryFile::append(const HistoryRun& run, const std::vector<HistoryValue>& values) {
  refuse_twice_the_same(values);
  SqliteTransaction transaction(*database_);
  database_
      ->prepared(
          "INSERT INTO run (utc, commit_id, changed, compiler, flags, processor, "
          "logical_processors, command) VALUES "
          "(coalesce(nullif(?, ''), strftime('%Y-%m-%dT%H:%M:%SZ', 'now')), ?, ?, ?, ?, ?, ?, ?)")
      .bind_text(run.utc)
      .bind_text(run.commit)
      .bind_whole(run.changed ? 1 : 0)
      .bind_text(run.compiler)
      .bind_text(run.flags)
      .bind_text(run.processor)
      .bind_whole(run.logical_processors)
      .bind_text(run.command)
      .step();
  const std::int64_t id = database_->last_row();
  for (const HistoryValue& value : values) {
    SqliteStatement insert = database_->prepared(
        "INSERT INTO value (run, benchmark, quantity, inputs, whole, ratio) "
        "VALUES (?, ?, ?, ?, ?, ?)");
    insert.bind_whole(id)
        .bind_text(value.benchmark())
        .bind_text(value.quantity().text())
        .bind_text(value.inputs());
    if (value.quantity().is_ratio())
      insert.bind_nothing().bind_real(value.number());
    else
      insert.bind_whole(value.count()).bind_nothing();
    insert.step();
  }
  transaction.commit();
  return id;
}

std::vector<HistoryRun> HistoryFile::runs() const {
  std::vector<HistoryRun> result;
  SqliteStatement rows = database_->prepared(
      "SELECT " PHYTOBENCH_RUN_COLUMNS
      ", (SELECT count(*) FROM value WHERE value.run = run.id) FROM run ORDER BY run.id");
  while (rows.step()) {
    result.push_back(run_from(rows));
    result.back().values = static_cast<std::size_t>(rows.whole(run_columns));
  }
  SqliteStatement names = database_->prepared("SELECT run, name FROM baseline ORDER BY name");
  while (names.step())
    for (HistoryRun& run : result)
      if (run.id == names.whole(0)) run.baselines.push_back(names.text(1));
  return result;
}

std::vector<HistoryValue> HistoryFile::values(std::int64_t run) const {
  SqliteStatement rows = database_->prepared(
      "SELECT benchmark, quantity, inputs, whole, ratio FROM value WHERE run = ? "
      "ORDER BY benchmark, quantity");
  rows.bind_whole(run);
  std::vector<HistoryValue> result;
  while (rows.step()) result.push_back(value_from(rows, 0));
  return result;
}

std::vector<std::string> HistoryFile::benchmarks() const {
  return texts(database_->prepared("SELECT DISTINCT benchmark FROM value ORDER BY benchmark"));
}

std::vector<std::string> HistoryFile::quantities(const std::string& benchmark) const {
  SqliteStatement rows = database_->prepared(
      "SELECT DISTINCT quantity FROM value WHERE benchmark = ? ORDER BY quantity");
  rows.bind_text(benchmark);
  return texts(std::move(rows));
}

std::vector<HistoryPoint> HistoryFile::series(
    const std::string& benchmark, const HistoryQuantity& quantity,
    const std::optional<std::string>& machine_class) const {
  SqliteStatement rows = database_->prepared(
      "SELECT " PHYTOBENCH_RUN_COLUMNS
      ", benchmark, quantity, inputs, whole, ratio FROM value JOIN run ON run.id = value.run "
      "WHERE benchmark = ? AND quantity = ? ORDER BY run.id");
  rows.bind_text(benchmark).bind_text(quantity.text());
  std::vector<HistoryPoint> result;
  while (rows.step()) {
    HistoryRun run = run_from(rows);
    if (machine_class && run.machine_class() != *machine_class) continue;
    result.push_back({std::move(run), value_from(rows, run_columns)});
  }
  return result;
}

void HistoryFile::save_baseline(const std::string& name, std::int64_t run) {
  refuse_odd_name(name);
  SqliteTransaction transaction(*database_);
  SqliteStatement known = database_->prepared("SELECT 1 FROM run WHERE id = ?");
  if (!known.bind_whole(run).step())
    throw InputError(fmt::format("there is no run {}; see phytobench history list", run));
  database_->prepared("INSERT OR REPLACE INTO baseline (name, run) VALUES (?, ?)")
      .bind_text(name)
      .bind_whole(run)
      .step();
  transaction.commit();
}

HistoryRun HistoryFile::baseline(const std::string& name) const {
  std::vector<std::string> names;
  for (HistoryRun& run : runs())
    for (const std::string& saved : run.baselines) {
      if (saved == name) return run;
      names.push_back(saved);
    }
  throw InputError("there is no baseline '" + name + "'" + did_you_mean(name, names) +
                   "; see phytobench history list");
}

std::vector<double> HistoryFile::changes_of_instructions(const std::string& benchmark) const {
  std::vector<double> changes;
  std::map<std::tuple<std::string, std::string, std::string>, HistoryPoint> before;
  for (const HistoryPoint& point : series(benchmark, HistoryQuantity::instructions())) {
    const std::tuple build(point.run.machine_class(), point.run.compiler, point.run.flags);
    const auto found = before.find(build);
    if (found != before.end() && found->second.value.inputs() == point.value.inputs() &&
        found->second.value.count() > 0)
      changes.push_back(std::abs(point.value.number() / found->second.value.number() - 1.0));
    before.insert_or_assign(build, point);
  }
  return changes;
}

}  // namespace phytobench
