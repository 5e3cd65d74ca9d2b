// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <span>
#include <string>

#include "core/record/folder_lock.hpp"
#include "core/record/run_files.hpp"
#include "core/record/sealed_file.hpp"
#include "core/record/timings_file.hpp"

namespace phytobench {

enum class RunMode {
  fresh,   ///< the folder must hold nothing of a run yet
  resume,  ///< finished experiments are kept, a half-written one is dropped
};

/// Throws InputError if the run in the folder was begun with another tier or seed.
void refuse_other_header(const std::filesystem::path& folder, const RunHeader& found,
                         const RunHeader& wanted);

/// Writes the folder of a run. Killed at any moment, it leaves a folder that can be read and
/// resumed, without the experiment that was being written.
class RunWriter {
 public:
  /// Opens or continues a run, and keeps others out as long as it lives. Throws InputError if the
  /// mode does not fit what is there, if that is damaged, or if another program writes there;
  /// EnvironmentError if nothing can be written.
  RunWriter(std::filesystem::path folder, const RunHeader& header, RunMode mode);

  bool is_complete(const std::string& experiment) const { return complete_.contains(experiment); }

  /// environment.json, before the experiments that it is about. A resumed run replaces it.
  void write_environment(const std::string& json);

  /// artifacts/<experiment>/<name>, before that experiment is appended.
  void write_artifact(const std::string& experiment, const std::string& name,
                      const std::string& content);

  /// Appends all of an experiment at once and marks it complete. On failure the files are cut back
  /// to what they were. No measurement may be recorded twice, and no experiment be complete
  /// already.
  void append(const std::string& experiment, std::span<const Record> records,
              std::span<const TimingSample> timings);

  const std::filesystem::path& folder() const { return folder_; }

 private:
  void begin(const RunHeader& header);
  void go_on(const RunHeader& header);
  void remove_leftovers() const;

  std::filesystem::path folder_;
  FolderLock lock_;
  std::set<std::string> complete_;
  SealedFile records_;
  SealedFile timings_;
  std::map<std::string, ArtifactDigests> artifacts_;  ///< of experiments that are not complete
};

}  // namespace phytobench
