// SPDX-License-Identifier: MIT
#include "core/record/run_writer.hpp"

#include <regex>
#include <vector>

#include "core/contract/check.hpp"
#include "core/contract/sha256.hpp"
#include "core/contract/text_file.hpp"
#include "core/record/records_file.hpp"
#include "core/record/whole_run.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

template <class Line>
std::string joined_lines(std::span<const Line> lines) {
  std::string text;
  for (const Line& line : lines) text += to_json_line(line) + "\n";
  return text;
}

bool are_unique(std::span<const Record> records) {
  std::set<std::string_view> names;
  for (const Record& record : records)
    if (!names.insert(record.measurement).second) return false;
  return true;
}

/// Whether the file holds no more than a run writes before records.jsonl is there.
bool is_fresh(const fs::path& timings_file) {
  const std::string fresh = DigestChain().sealed("", timings_header()) + "\n";
  std::error_code ignored;
  return fs::file_size(timings_file, ignored) == fresh.size() &&
         read_text_file(timings_file) == fresh;
}

/// A run whose records.jsonl was lost cannot go on, but what is left of it is not ours to replace.
void refuse_rest_of_a_run(const fs::path& folder) {
  std::error_code ignored;
  const fs::path timings = folder / timings_name, artifacts = folder / artifacts_name;
  const char* found = nullptr;
  if (fs::is_regular_file(timings, ignored) && !is_fresh(timings))
    found = timings_name;
  else if (fs::exists(artifacts, ignored) && !fs::is_empty(artifacts, ignored))
    found = artifacts_name;
  if (found)
    throw InputError(folder.string() + ": holds " + found + " of a run but no " + records_name +
                     "; put that back and use --resume, or use another --out");
}

}  // namespace

void refuse_other_header(const fs::path& folder, const RunHeader& found, const RunHeader& wanted) {
  if (found != wanted)
    throw InputError(folder.string() + ": was begun with --tier " +
                     std::string(name_of(found.tier)) + " --seed " + std::to_string(found.seed) +
                     "; resume with the same or use another --out");
}

RunWriter::RunWriter(fs::path folder, const RunHeader& header, RunMode mode)
    : folder_(std::move(folder)) {
  make_folder(folder_);
  lock_ = FolderLock(folder_);
  std::error_code ignored;
  const bool has_records = fs::exists(folder_ / records_name, ignored);
  if (has_records && mode == RunMode::fresh)
    throw InputError(folder_.string() +
                     ": already holds records; use --resume to go on with them, or "
                     "another --out");
  if (has_records)
    go_on(header);
  else
    begin(header);
  remove_leftovers();
}

void RunWriter::begin(const RunHeader& header) {
  refuse_rest_of_a_run(folder_);
  std::error_code ignored;
  fs::remove(folder_ / environment_name, ignored);  // of a run whose records are gone
  timings_ = SealedFile(folder_ / timings_name, timings_header());
  // Last: with this file the folder is that of a run.
  records_ = SealedFile(folder_ / records_name, records_header(header));
}

void RunWriter::go_on(const RunHeader& header) {
  WholeRun old = read_whole_run(folder_);
  refuse_other_header(folder_, old.contents.header, header);
  complete_ = std::move(old.contents.complete_experiments);
  // Records first: an experiment of which there are only timings does not count.
  records_ = SealedFile(folder_ / records_name, old.last_of_records);
  timings_ = SealedFile(folder_ / timings_name, old.last_of_timings);
}

/// Half-written files of a run that was killed.
void RunWriter::remove_leftovers() const {
  static const std::regex own(R"((records\.jsonl|timings\.jsonl|environment\.json)\.part[0-9]+)"),
      any(R"(.+\.part[0-9]+)");
  std::vector<fs::path> found;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_, ignored))
    if (std::regex_match(entry.path().filename().string(), own)) found.push_back(entry.path());
  for (const fs::directory_entry& entry :
       fs::recursive_directory_iterator(folder_ / artifacts_name, ignored))
    if (std::regex_match(entry.path().filename().string(), any)) found.push_back(entry.path());
  for (const fs::path& file : found) fs::remove(file, ignored);
}

void RunWriter::write_environment(const std::string& json) {
  // What must be known of a file is written before it, so that none can be there unknown.
  timings_.append("", timings_session(sha256_hex(json)));
  write_file_atomically(folder_ / environment_name, json);
}

void RunWriter::write_artifact(const std::string& experiment, const std::string& name,
                               const std::string& content) {
  write_file_atomically(folder_ / artifacts_name / experiment / name, content);
  artifacts_[experiment][name] = sha256_hex(content);
}

void RunWriter::append(const std::string& experiment, std::span<const Record> records,
                       std::span<const TimingSample> timings) {
  PHYTOBENCH_EXPECT(!is_complete(experiment));
  PHYTOBENCH_EXPECT(are_unique(records));
  const std::string record_lines = joined_lines(records);
  const std::string completion = records_completion(experiment, records.size());
  // Timings first: they count only once the records say the experiment is complete.
  const SealedFile timings_before = timings_;
  timings_.append(
      joined_lines(timings),
      timings_completion(experiment, timings.size(),
                         records_.digest_after(record_lines, completion), artifacts_[experiment]));
  try {
    records_.append(record_lines, completion);
  } catch (...) {
    timings_ = timings_before;
    timings_.cut();
    throw;
  }
  artifacts_.erase(experiment);
  complete_.insert(experiment);
}

}  // namespace phytobench
