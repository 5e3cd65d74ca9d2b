// SPDX-License-Identifier: MIT
// The format of records.jsonl, schema phytobench/records-2: a sealed first line that names schema,
// tier and seed; then for each experiment its records and a sealed line that says it is complete.
// The same seed gives the same bytes.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/record/run_files.hpp"
#include "core/record/sealed_file.hpp"

namespace phytobench {

inline constexpr const char* records_name = "records.jsonl";

std::string records_header(const RunHeader& header);
std::string records_completion(const std::string& experiment, std::size_t records);

/// What is complete in the file.
struct RecordsFile {
  struct Experiment {
    std::string name;
    std::string digest;  ///< its seal
  };
  RunHeader header;
  std::vector<Record> records;
  std::vector<Experiment> experiments;  ///< in the order of the file
  Seal last;                            ///< after it comes what is unfinished
  /// The experiment whose whole lines stand there; unset where no whole line does.
  std::optional<std::string> unfinished;
};

/// Reads the content of `file`. Throws InputError with file and line.
RecordsFile parse_records(const std::filesystem::path& file, std::string_view text);

}  // namespace phytobench
