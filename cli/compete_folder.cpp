// SPDX-License-Identifier: MIT
#include "cli/compete_folder.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <regex>
#include <set>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/population/checkpoint.hpp"
#include "core/record/append_to_file.hpp"

namespace phytobench::cli {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t any_size = std::numeric_limits<std::uintmax_t>::max();

/// What a run leaves, apart from its inputs.
constexpr const char* file_names[] = {"checkpoint.bin", "steps.csv",  "plants.csv",   "stand.svg",
                                      "stand.png",      "curves.svg", "summary.json", "frames"};

}  // namespace

bool is_name_of_run(const fs::path& name) {
  const std::string first = name.begin()->string();
  return first == parameters_name ||
         std::find(std::begin(file_names), std::end(file_names), first) != std::end(file_names);
}

std::string FrameFiles::name(std::int32_t number) const {
  return fmt::format("frames/{:05}.{}", number, format);
}

CompeteFolder::CompeteFolder(fs::path folder, std::vector<Setting> settings, FrameFiles frames,
                             std::vector<FileContent> inputs)
    : folder_(std::move(folder)),
      settings_(std::move(settings)),
      frames_(std::move(frames)),
      inputs_(std::move(inputs)) {}

void CompeteFolder::begin(const CompeteProgress& progress) {
  make_folder(folder_);
  // First: another run may be about to write what is looked for.
  lock_ = FolderLock(folder_);
  refuse_files_of_others();
  remove_leftovers();
  save(progress.state, progress.pairs);
  write_inputs();
}

void CompeteFolder::refuse_files_of_others() const {
  std::error_code error;
  for (const char* name : file_names)
    if (fs::exists(folder_ / name, error))
      throw InputError(fmt::format(
          "{}: already holds {}; use --resume to go on with the run there, or another --out",
          folder_.string(), name));
  for (const FileContent& input : inputs_)
    if (const fs::path file = folder_ / input.file;
        fs::exists(file, error) && read_text_file(file, any_size) != input.content)
      throw InputError(file.string() +
                       ": is another file than the run starts from; use another --out");
}

CompeteProgress CompeteFolder::resume(std::int32_t last_step) {
  const fs::path file = checkpoint_file();
  std::error_code error;
  lock_ = FolderLock(folder_);
  if (!fs::exists(file, error))
    throw InputError(
        fmt::format("{}: holds no checkpoint.bin to go on from{}", folder_.string(),
                    fs::exists(folder_ / "summary.json", error)
                        ? ": that run is finished; one that is to go on later needs --checkpoint"
                        : "; start without --resume"));
  Checkpoint checkpoint = read_checkpoint(file);
  refuse_other_settings(checkpoint, settings_, file.string());
  if (checkpoint.tally.size() != 3)
    throw InputError(file.string() + ": is no checkpoint of phytobench compete");
  if (checkpoint.state.step > last_step)
    throw InputError(fmt::format(
        "{}: is at step {}, beyond the {} steps wanted; give more --steps, or start again with "
        "another --out",
        file.string(), checkpoint.state.step, last_step));
  steps_bytes_ = checkpoint.tally[1];
  steps_digest_ = checkpoint.tally[2];
  cut_steps();
  remove_leftovers();
  remove_frames_from(checkpoint.state.step);
  write_inputs();
  return {std::move(checkpoint.state), checkpoint.tally[0]};
}

void CompeteFolder::save(const PopulationState& state, std::uint64_t pairs) {
  append_rows();
  write_file_atomically(
      checkpoint_file(),
      checkpoint_bytes(settings_, std::vector{pairs, steps_bytes_, steps_digest_}, state));
}

void CompeteFolder::write_frame(std::int32_t step, const std::string& content) const {
  write_file_atomically(folder_ / frames_.name(step / frames_.every), content);
}

std::string CompeteFolder::finished_steps() {
  append_rows();
  return read_text_file(steps_file(), any_size);
}

void CompeteFolder::finish(std::vector<FileContent> files, bool keeps_checkpoint) {
  const bool has_svg = std::any_of(
      files.begin(), files.end(), [](const FileContent& file) { return file.file == "stand.svg"; });
  for (FileContent& file : files) file.file = folder_ / file.file;
  write_files_atomically(files);
  std::error_code ignored;
  // One that a shorter run has left when it had fewer plants.
  if (!has_svg) fs::remove(folder_ / "stand.svg", ignored);
  if (!keeps_checkpoint) fs::remove(checkpoint_file(), ignored);
}

void CompeteFolder::append_rows() {
  if (rows_.empty()) return;
  append_or_restore(steps_file(), rows_, steps_bytes_);
  steps_bytes_ += rows_.size();
  steps_digest_ = digest(rows_, steps_digest_);
  rows_.clear();
}

void CompeteFolder::write_inputs() const {
  std::vector<FileContent> files = inputs_;
  for (FileContent& file : files) file.file = folder_ / file.file;
  // A run in the folder of its own inputs leaves them, and links to them, as they are.
  std::erase_if(files, [](const FileContent& file) {
    std::error_code error;
    return fs::is_regular_file(file.file, error) &&
           read_text_file(file.file, any_size) == file.content;
  });
  write_files_atomically(files);
}

/// Back to its length at the checkpoint, which must not have been touched.
void CompeteFolder::cut_steps() const {
  std::error_code error;
  if (steps_bytes_ == 0) {
    fs::remove(steps_file(), error);
    return;
  }
  const std::string text = read_text_file(steps_file(), any_size);
  if (text.size() < steps_bytes_ ||
      digest(std::string_view(text).substr(0, steps_bytes_)) != steps_digest_)
    throw InputError(steps_file().string() +
                     ": was changed since the checkpoint; start again with another --out");
  fs::resize_file(steps_file(), steps_bytes_, error);
  if (error)
    throw EnvironmentError("cannot write " + steps_file().string() + ": " + error.message());
}

/// Half-written files of a run that was killed; they have temporary names of the run's own files.
void CompeteFolder::remove_leftovers() const {
  static const std::regex temporary(R"((.*)\.part[0-9]+$)"), frame(R"([0-9]{5,}\.(svg|png))");
  std::set<fs::path> folders{folder_ / "", folder_ / "frames/"}, inputs;
  for (const FileContent& input : inputs_) {
    inputs.insert(folder_ / input.file);
    folders.insert((folder_ / input.file).parent_path() / "");
  }
  for (const fs::path& folder : folders) {
    std::error_code error;
    std::vector<fs::path> found;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
      const std::string name = entry.path().filename().string();
      std::smatch match;
      if (!std::regex_match(name, match, temporary)) continue;
      const std::string own = match[1].str();
      const bool is_of_run = folder == folder_ / ""          ? is_name_of_run(own)
                             : folder == folder_ / "frames/" ? std::regex_match(own, frame)
                                                             : false;
      if (is_of_run || inputs.contains(folder / own)) found.push_back(entry.path());
    }
    for (const fs::path& file : found) fs::remove(file, error);
  }
}

void CompeteFolder::remove_frames_from(std::int32_t step) const {
  if (frames_.every == 0) return;
  std::error_code error;
  const std::int32_t first = step / frames_.every + (step % frames_.every > 0 ? 1 : 0);
  for (std::int32_t number = first; fs::remove(folder_ / frames_.name(number), error);) ++number;
}

}  // namespace phytobench::cli
