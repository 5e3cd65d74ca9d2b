// SPDX-License-Identifier: MIT
#include "benchmarks/history/sqlite_database.hpp"

#include <sqlite3.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

constexpr int patience_ms = 20'000;

void refuse_what_is_no_file(const fs::path& file, DatabaseAccess access) {
  std::error_code ignored;
  if (fs::is_directory(file, ignored))
    throw InputError(file.string() + ": is a folder, a file is needed");
  if (access == DatabaseAccess::create)
    make_folder(file.parent_path());
  else if (!fs::exists(file, ignored))
    throw InputError(file.string() +
                     ": no such file; `phytobench history append RESULT.json` makes it");
}

}  // namespace

void SqliteDatabase::Close::operator()(sqlite3* database) const {
  ::sqlite3_close_v2(database);
}

SqliteDatabase::SqliteDatabase(const fs::path& file, DatabaseAccess access) : file_(file) {
  refuse_what_is_no_file(file, access);
  const int flags =
      SQLITE_OPEN_READWRITE | (access == DatabaseAccess::create ? SQLITE_OPEN_CREATE : 0);
  // An absolute path: some relative names (":memory:", "file:x") mean something else to SQLite.
  const std::string path = fs::absolute(file).string();
  sqlite3* handle = nullptr;
  const int code = ::sqlite3_open_v2(path.c_str(), &handle, flags, nullptr);
  handle_.reset(handle);  // to be closed even where opening failed
  if (code != SQLITE_OK) fail(code);
  ::sqlite3_extended_result_codes(handle, 1);
  ::sqlite3_busy_timeout(handle, patience_ms);
  execute("PRAGMA foreign_keys = ON");
}

void SqliteDatabase::fail(int code) const {
  const std::string what = handle_ ? ::sqlite3_errmsg(handle_.get()) : "out of memory";
  const std::string whose = file_.string();
  switch (code & 0xff) {  // the rest of the code is its detail
    case SQLITE_NOTADB:
      throw InputError(whose + ": is no SQLite file; give a history, or a name that is free");
    case SQLITE_CORRUPT:
    case SQLITE_ERROR:
      throw InputError(whose + ": is damaged (" + what + "); restore a copy or start another file");
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
      throw EnvironmentError(whose + ": another program has held it for 20 seconds; try again");
    case SQLITE_CONSTRAINT:
    case SQLITE_MISUSE:
    case SQLITE_RANGE:
    case SQLITE_MISMATCH:
      contract_failed("SQLite", what.c_str(), __FILE__, __LINE__);
    default:
      throw EnvironmentError("cannot use " + whose + ": " + what +
                             "; nothing was changed there, free the disk or choose another file");
  }
}

void SqliteDatabase::execute(const char* sql) const {
  const int code = ::sqlite3_exec(handle_.get(), sql, nullptr, nullptr, nullptr);
  if (code != SQLITE_OK) fail(code);
}

std::int64_t SqliteDatabase::whole(const char* sql) const {
  SqliteStatement statement = prepared(sql);
  PHYTOBENCH_ENSURE(statement.step());
  return statement.whole(0);
}

std::int64_t SqliteDatabase::last_row() const {
  return ::sqlite3_last_insert_rowid(handle_.get());
}

void SqliteStatement::Finalise::operator()(sqlite3_stmt* statement) const {
  ::sqlite3_finalize(statement);
}

SqliteStatement::SqliteStatement(const SqliteDatabase& database, const char* sql)
    : database_(database) {
  sqlite3_stmt* statement = nullptr;
  check(::sqlite3_prepare_v2(database.handle(), sql, -1, &statement, nullptr));
  statement_.reset(statement);
}

void SqliteStatement::check(int code) const {
  if (code != SQLITE_OK) database_.fail(code);
}

SqliteStatement& SqliteStatement::bind_text(std::string_view value) {
  // Never a null pointer, which would be NULL and not an empty text.
  const char* bytes = value.data() == nullptr ? "" : value.data();
  check(::sqlite3_bind_text64(statement_.get(), ++bound_, bytes, value.size(), SQLITE_TRANSIENT,
                              SQLITE_UTF8));
  return *this;
}

SqliteStatement& SqliteStatement::bind_whole(std::int64_t value) {
  check(::sqlite3_bind_int64(statement_.get(), ++bound_, value));
  return *this;
}

SqliteStatement& SqliteStatement::bind_real(double value) {
  check(::sqlite3_bind_double(statement_.get(), ++bound_, value));
  return *this;
}

SqliteStatement& SqliteStatement::bind_nothing() {
  check(::sqlite3_bind_null(statement_.get(), ++bound_));
  return *this;
}

bool SqliteStatement::step() {
  const int code = ::sqlite3_step(statement_.get());
  if (code == SQLITE_ROW) return true;
  if (code != SQLITE_DONE) database_.fail(code);
  return false;
}

std::string SqliteStatement::text(int column) const {
  const unsigned char* bytes = ::sqlite3_column_text(statement_.get(), column);
  if (bytes == nullptr) return "";
  return std::string(reinterpret_cast<const char*>(bytes),
                     static_cast<std::size_t>(::sqlite3_column_bytes(statement_.get(), column)));
}

std::int64_t SqliteStatement::whole(int column) const {
  return ::sqlite3_column_int64(statement_.get(), column);
}

double SqliteStatement::real(int column) const {
  return ::sqlite3_column_double(statement_.get(), column);
}

SqliteTransaction::SqliteTransaction(const SqliteDatabase& database) : database_(database) {
  database_.execute("BEGIN IMMEDIATE");
}

SqliteTransaction::~SqliteTransaction() {
  if (is_open_)  // after some errors SQLite has undone it already, and refuses to do so again
    ::sqlite3_exec(database_.handle(), "ROLLBACK", nullptr, nullptr, nullptr);
}

void SqliteTransaction::commit() {
  database_.execute("COMMIT");
  is_open_ = false;
}

}  // namespace phytobench
