// SPDX-License-Identifier: MIT
// What was counted and measured of each build, in one SQLite file that grows with every run. Its
// format is version 1 of `pragma user_version`; tables: history_tables.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "benchmarks/history/history_value.hpp"

namespace phytobench {

class SqliteDatabase;

struct HistoryRun {
  std::int64_t id = 0;   ///< 1 and up in the order of appending; 0: not appended yet
  std::string utc;       ///< "2026-11-27T22:16:00Z"; where it is empty, append() takes the clock
  std::string commit;    ///< empty if unknown
  bool changed = false;  ///< its sources differed from that commit
  std::string compiler;
  std::string flags;
  std::string processor;
  int logical_processors = 0;
  std::string command;                 ///< that appended it
  std::vector<std::string> baselines;  ///< names under which it was saved
  std::size_t values = 0;              ///< how many it has

  /// "AMD EPYC 7763, 2 logical processors": only within one are ratios and instructions compared.
  std::string machine_class() const;
};

/// One value in the course of time.
struct HistoryPoint {
  HistoryRun run;  ///< without baselines and number of values
  HistoryValue value;
};

enum class HistoryAccess {
  read,   ///< the file must be there; a baseline may be saved
  append  ///< it is made with its folders if it is not
};

/// Several programs may append to one file at the same time. Every call throws InputError where the
/// file is no history, damaged, or of a newer format, and EnvironmentError where the system refuses
/// (a full disk, no permission, held by another program for 20 seconds); then nothing was changed.
class HistoryFile {
 public:
  HistoryFile(const std::filesystem::path& file, HistoryAccess access);
  ~HistoryFile();
  HistoryFile(const HistoryFile&) = delete;
  HistoryFile& operator=(const HistoryFile&) = delete;

  /// All or nothing; returns the run's id. At least one value, none twice of a benchmark and
  /// quantity: InputError otherwise. Ignores id, baselines and number of values of `run`.
  std::int64_t append(const HistoryRun& run, const std::vector<HistoryValue>& values);

  /// In the order of appending.
  std::vector<HistoryRun> runs() const;

  /// Of one run, by benchmark and quantity.
  std::vector<HistoryValue> values(std::int64_t run) const;

  /// Names of all benchmarks, and of all quantities of one, in alphabetical order.
  std::vector<std::string> benchmarks() const;
  std::vector<std::string> quantities(const std::string& benchmark) const;

  /// In the order of appending; of one machine class if it is given.
  std::vector<HistoryPoint> series(
      const std::string& benchmark, const HistoryQuantity& quantity,
      const std::optional<std::string>& machine_class = std::nullopt) const;

  /// The name stands for that run from now on. Throws InputError where the name is not of letters,
  /// digits and "_-./" or only of digits, and where there is no such run.
  void save_baseline(const std::string& name, std::int64_t run);

  /// Throws InputError with the nearest name where there is none of that name.
  HistoryRun baseline(const std::string& name) const;

  /// |new / old - 1| of instructions between successive runs of one machine class and one compiler
  /// with one set of flags, where inputs are the same: what the instruction gate takes as ordinary.
  std::vector<double> changes_of_instructions(const std::string& benchmark) const;

 private:
  std::unique_ptr<SqliteDatabase> database_;
};

}  // namespace phytobench
