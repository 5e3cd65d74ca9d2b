// SPDX-License-Identifier: MIT
#include "benchmarks/history/history_tables.hpp"

#include <cstdint>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "benchmarks/history/sqlite_database.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

/// "phyt": tells our files from other programs' (pragma application_id).
constexpr std::int64_t application_id = 0x70687974;

constexpr const char* tables = R"(
CREATE TABLE run (
  id INTEGER PRIMARY KEY AUTOINCREMENT,
  utc TEXT NOT NULL,
  commit_id TEXT NOT NULL,
  changed INTEGER NOT NULL CHECK (changed IN (0, 1)),
  compiler TEXT NOT NULL,
  flags TEXT NOT NULL,
  processor TEXT NOT NULL,
  logical_processors INTEGER NOT NULL,
  command TEXT NOT NULL
) STRICT;
CREATE TABLE value (
  run INTEGER NOT NULL REFERENCES run (id),
  benchmark TEXT NOT NULL,
  quantity TEXT NOT NULL CHECK (quantity IN ('instructions', 'ratio') OR quantity GLOB 'counter:?*'),
  inputs TEXT NOT NULL,
  whole INTEGER,
  ratio REAL,
  PRIMARY KEY (benchmark, quantity, run),
  CHECK ((quantity = 'ratio') = (ratio IS NOT NULL)),
  CHECK ((quantity <> 'ratio') = (whole IS NOT NULL))
) STRICT, WITHOUT ROWID;
CREATE INDEX value_of_run ON value (run);
CREATE TABLE baseline (
  name TEXT PRIMARY KEY NOT NULL,
  run INTEGER NOT NULL REFERENCES run (id)
) STRICT, WITHOUT ROWID;
)";

void make_tables(const SqliteDatabase& database) {
  database.execute(tables);
  // Pragmas take no parameters; both are numbers of this file.
  database.execute(fmt::format("PRAGMA application_id = {}", application_id).c_str());
  database.execute(fmt::format("PRAGMA user_version = {}", history_version).c_str());
}

}  // namespace

void begin_history(const SqliteDatabase& database, HistoryAccess access) {
  // Whoever else is making the file now is waited for here.
  std::optional<SqliteTransaction> making;
  if (access == HistoryAccess::append) making.emplace(database);
  const std::string whose = database.file().string();
  const std::int64_t id = database.whole("PRAGMA application_id");
  const std::int64_t version = database.whole("PRAGMA user_version");
  const bool is_empty =
      id == 0 && version == 0 && database.whole("SELECT count(*) FROM sqlite_schema") == 0;
  if (is_empty && access == HistoryAccess::read)
    throw InputError(whose + ": is empty; `phytobench history append RESULT.json` fills it");
  if (!is_empty && id != application_id)
    throw InputError(
        whose + ": is an SQLite file of another program; give a history, or a name that is free");
  if (version > history_version)
    throw InputError(fmt::format(
        "{}: is a history of format {}, written by a newer phytobench; this one knows {}: use that "
        "one, or another file",
        whose, version, history_version));
  if (!is_empty && version < history_version)
    throw InputError(whose + ": is damaged: its format has no number; restore a copy");
  if (is_empty) make_tables(database);
  if (making) making->commit();
}

}  // namespace phytobench
