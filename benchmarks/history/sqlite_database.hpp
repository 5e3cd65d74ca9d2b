// SPDX-License-Identifier: MIT
// SQLite as this suite uses it: values reach a statement as parameters only, and every refusal is
// one line. sqlite3.h is included by sqlite_database.cpp alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace phytobench {

enum class DatabaseAccess {
  existing,  ///< the file must be there
  create     ///< it is made with its folders if it is not
};

class SqliteDatabase;

/// One prepared statement. Parameters are bound from left to right.
class SqliteStatement {
 public:
  SqliteStatement(const SqliteDatabase& database, const char* sql);

  SqliteStatement& bind_text(std::string_view value);
  SqliteStatement& bind_whole(std::int64_t value);
  SqliteStatement& bind_real(double value);
  SqliteStatement& bind_nothing();

  /// Goes to the next row; false after the last. Throws as SqliteDatabase does.
  bool step();

  /// Of the current row; columns count from 0.
  std::string text(int column) const;
  std::int64_t whole(int column) const;
  double real(int column) const;

 private:
  struct Finalise {
    void operator()(sqlite3_stmt* statement) const;
  };
  void check(int code) const;

  const SqliteDatabase& database_;
  std::unique_ptr<sqlite3_stmt, Finalise> statement_;
  int bound_ = 0;
};

/// An open file. Throws InputError where the file is missing, a folder, no SQLite database or
/// damaged, and EnvironmentError where the system refuses: a full disk, no permission, another
/// program that does not let go of it within 20 seconds.
class SqliteDatabase {
 public:
  SqliteDatabase(const std::filesystem::path& file, DatabaseAccess access);
  SqliteDatabase(const SqliteDatabase&) = delete;
  SqliteDatabase& operator=(const SqliteDatabase&) = delete;

  /// Statements without parameters and results.
  void execute(const char* sql) const;
  SqliteStatement prepared(const char* sql) const { return SqliteStatement(*this, sql); }

  /// First column of the first row.
  std::int64_t whole(const char* sql) const;

  /// Key of the row inserted last.
  std::int64_t last_row() const;

  /// Throws what a result code of SQLite stands for.
  [[noreturn]] void fail(int code) const;

  const std::filesystem::path& file() const { return file_; }
  sqlite3* handle() const { return handle_.get(); }

 private:
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::filesystem::path file_;
  std::unique_ptr<sqlite3, Close> handle_;
};

/// Holds the file for writing from its beginning; undone unless it is committed.
class SqliteTransaction {
 public:
  explicit SqliteTransaction(const SqliteDatabase& database);
  ~SqliteTransaction();
  SqliteTransaction(const SqliteTransaction&) = delete;
  SqliteTransaction& operator=(const SqliteTransaction&) = delete;

  void commit();

 private:
  const SqliteDatabase& database_;
  bool is_open_ = true;
};

}  // namespace phytobench
