// SPDX-License-Identifier: MIT
#include "reports/report_folder.hpp"

#include <algorithm>
#include <csignal>
#include <cstdint>
#include <limits>
#include <vector>

#include "core/contract/errors.hpp"
#include "core/contract/sha256.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t digest_length = 64;
constexpr std::string_view between = "  ";  // the second space says: read as bytes or as text alike

bool is_digest(std::string_view text) {
  return text.size() == digest_length &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

/// A relative name that no part of leads upwards.
bool stays_inside(const fs::path& name) {
  return !name.empty() && name.is_relative() &&
         std::none_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".."; });
}

/// While it lives, signals that end the program are kept back.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t ending;
    ::sigemptyset(&ending);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) ::sigaddset(&ending, signal);
    ::pthread_sigmask(SIG_BLOCK, &ending, &before_);
  }
  ~SignalsWait() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  sigset_t before_{};
};

/// Removes the folders between `folder` and the file that hold nothing any more.
void remove_empty_folders(const fs::path& folder, fs::path name) {
  std::error_code error;
  for (name = name.parent_path(); !name.empty(); name = name.parent_path())
    if (!fs::remove(folder / name, error)) return;
}

constexpr const char* verdicts_name = "verdicts.json";
constexpr const char* verdicts_schema = "phytobench/verdicts-";

/// Whether the file is still what an earlier report wrote.
bool is_unchanged(const fs::path& file, const std::string& digest) {
  std::error_code error;
  if (!fs::is_regular_file(fs::symlink_status(file, error))) return false;
  try {
    return sha256_hex(read_text_file(file, std::numeric_limits<std::uintmax_t>::max())) == digest;
  } catch (const InputError&) {  // what cannot be read is nobody's to remove
    return false;
  }
}

/// Digests of the files that an earlier report wrote here; none if there was no report. Any program
/// may leave checksums: only those count that name verdicts of ours, which every report has.
std::map<std::string, std::string> earlier_checksums(const fs::path& folder) {
  std::error_code error;
  const fs::path file = folder / checksums_name;
  if (!fs::is_regular_file(file, error)) return {};
  auto digests = checksums_in(read_text_file(file));
  const auto verdicts = digests.find(verdicts_name);
  const bool ours = verdicts != digests.end() &&
                    is_unchanged(folder / verdicts_name, verdicts->second) &&
                    read_text_file(folder / verdicts_name).substr(0, 200).find(verdicts_schema) !=
                        std::string::npos;
  return ours ? digests : std::map<std::string, std::string>{};
}

/// A report replaces reports, nothing else.
void refuse_files_of_others(const fs::path& folder,
                            const std::map<std::string, std::string>& earlier,
                            const ReportFiles& files) {
  const auto refuse_if_there = [&](const std::string& name) {
    std::error_code error;
    if (!fs::exists(fs::symlink_status(folder / name, error))) return;
    throw InputError(folder.string() + ": already holds " + name +
                     ", which no report of ours wrote; move it or use another --out");
  };
  if (earlier.empty()) refuse_if_there(checksums_name);
  for (const auto& [name, content] : files)
    if (!earlier.contains(name)) refuse_if_there(name);
}

void remove_stale_files(const fs::path& folder, const std::map<std::string, std::string>& earlier,
                        const ReportFiles& files) {
  for (const auto& [name, digest] : earlier) {
    if (files.contains(name) || !is_unchanged(folder / name, digest)) continue;
    std::error_code error;
    fs::remove(folder / name, error);
    remove_empty_folders(folder, name);
  }
}

void write_all(const fs::path& folder, ReportFiles files, std::string checksums) {
  std::vector<FileContent> contents;
  for (auto& [name, content] : files) contents.push_back({folder / name, std::move(content)});
  contents.push_back({folder / checksums_name, std::move(checksums)});
  for (const FileContent& content : contents)
    if (fs::is_directory(content.file))
      throw EnvironmentError("cannot write " + content.file.string() +
                             ": a folder of that name exists; move it or use another --out");
  write_files_atomically(contents);
}

/// The folders that writing would make, those farther down first.
std::vector<fs::path> missing_folders(const fs::path& folder, const ReportFiles& files) {
  std::vector<fs::path> missing;
  const auto add = [&](fs::path path) {
    std::error_code error;
    for (; !path.empty() && !fs::exists(path, error); path = path.parent_path())
      missing.push_back(path);
  };
  add(folder);
  for (const auto& [name, content] : files) add((folder / name).parent_path());
  std::sort(missing.rbegin(), missing.rend());
  missing.erase(std::unique(missing.begin(), missing.end()), missing.end());
  return missing;
}

}  // namespace

std::string checksum_lines(const ReportFiles& files) {
  std::string lines;
  for (const auto& [name, content] : files)
    lines += sha256_hex(content) + std::string(between) + name + "\n";
  return lines;
}

std::map<std::string, std::string> checksums_in(std::string_view text) {
  std::map<std::string, std::string> digests;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.size() <= digest_length + between.size() ||
        !is_digest(line.substr(0, digest_length)) ||
        line.substr(digest_length, between.size()) != between)
      continue;
    const std::string name(line.substr(digest_length + between.size()));
    if (stays_inside(name)) digests.emplace(name, line.substr(0, digest_length));
  }
  return digests;
}

void put_report(const fs::path& folder, ReportFiles files) {
  const SignalsWait wait;
  const auto earlier = earlier_checksums(folder);
  refuse_files_of_others(folder, earlier, files);
  const std::vector<fs::path> made = missing_folders(folder, files);
  try {
    write_all(folder, files, checksum_lines(files));
  } catch (...) {
    std::error_code ignored;
    for (const fs::path& path : made) fs::remove(path, ignored);  // only where it is empty
    throw;
  }
  remove_stale_files(folder, earlier, files);
}

}  // namespace phytobench
