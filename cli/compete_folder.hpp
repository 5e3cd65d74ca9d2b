// SPDX-License-Identifier: MIT
// The folder of one run of `phytobench compete`. Killed at any moment it can be taken up again: one
// file, checkpoint.bin, says where the run was, and all others are then made to fit it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/contract/text_file.hpp"
#include "core/population/population_settings.hpp"
#include "core/population/stand.hpp"
#include "core/record/folder_lock.hpp"

namespace phytobench::cli {

/// A run's copy of the file that it was started from.
inline constexpr const char* parameters_name = "parameters.toml";

/// Whether a run writes a file of that name into its folder, or a folder that it begins with.
bool is_name_of_run(const std::filesystem::path& name);

/// A run between two steps. Lines and pictures of this step are not written yet.
struct CompeteProgress {
  PopulationState state;
  std::uint64_t pairs = 0;  ///< overlapping zones found so far
};

/// Pictures "frames/00000.png" and so on, numbered without gaps.
struct FrameFiles {
  std::int32_t every = 0;  ///< steps; 0: none
  std::string format;      ///< "png" or "svg"

  std::string name(std::int32_t number) const;
};

class CompeteFolder {
 public:
  /// `settings` are all that the files depend on; `inputs`, copied into the folder under the names
  /// given, are what the run is repeated from.
  CompeteFolder(std::filesystem::path folder, std::vector<Setting> settings, FrameFiles frames,
                std::vector<FileContent> inputs);

  /// Starts a run with a first checkpoint. Throws InputError if the folder holds one, or other
  /// files of the names that a run writes, or if another program runs there; EnvironmentError if
  /// nothing can be written.
  void begin(const CompeteProgress& progress);

  /// Where the run in the folder was. Throws InputError if there is none, if it is beyond
  /// `last_step` or had other settings, or if its steps.csv was changed. Pictures of later steps
  /// are removed.
  CompeteProgress resume(std::int32_t last_step);

  /// Lines of steps.csv, kept until the next save() or finish().
  void add_rows(const std::string& rows) { rows_ += rows; }

  /// Writes kept lines, then the checkpoint.
  void save(const PopulationState& state, std::uint64_t pairs);

  void write_frame(std::int32_t step, const std::string& content) const;

  /// Writes kept lines and returns the whole of steps.csv.
  std::string finished_steps();

  /// Writes the last files, then removes the checkpoint unless it is to be kept.
  void finish(std::vector<FileContent> files, bool keeps_checkpoint);

  /// What a run goes on from.
  std::filesystem::path checkpoint_file() const { return folder_ / "checkpoint.bin"; }

 private:
  std::filesystem::path steps_file() const { return folder_ / "steps.csv"; }
  void append_rows();
  void refuse_files_of_others() const;
  void write_inputs() const;
  void cut_steps() const;
  void remove_leftovers() const;
  void remove_frames_from(std::int32_t step) const;

  std::filesystem::path folder_;
  std::vector<Setting> settings_;
  FrameFiles frames_;
  std::vector<FileContent> inputs_;
  std::string rows_;
  std::uint64_t steps_bytes_ = 0;  ///< of steps.csv, with its digest
  std::uint64_t steps_digest_ = digest_of_nothing;
  FolderLock lock_;
};

}  // namespace phytobench::cli
