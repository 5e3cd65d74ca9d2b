// SPDX-License-Identifier: MIT
#include "cli/output_files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <set>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench::cli {

namespace {

namespace fs = std::filesystem;

void refuse_closed_output() {
  const int flags = ::fcntl(STDOUT_FILENO, F_GETFL);
  if (flags < 0 || (flags & O_ACCMODE) == O_RDONLY)
    throw EnvironmentError("standard output is not open for writing; direct it to a file or pipe");
}

void refuse_other_kinds(const fs::path& file, const std::string& name) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::is_directory(status)) throw InputError(name + ": is a folder; name a file to write to");
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw InputError(name + ": is no ordinary file; name one to write to");
}

/// A folder made here would be one mistyped: folders of runs and reports are made, those of files
/// are not.
void refuse_missing_folder(const fs::path& file, const std::string& name) {
  if (!file.has_parent_path()) return;
  const fs::path folder = file.parent_path();
  std::error_code ignored;
  const fs::file_status status = fs::status(folder, ignored);
  if (status.type() == fs::file_type::not_found)
    throw InputError(name + ": there is no folder " + folder.string() +
                     "; make it first, or name another");
  if (fs::exists(status) && !fs::is_directory(status))
    throw EnvironmentError("cannot write " + name + ": " + folder.string() +
                           " is no folder; name another");
}

/// A rename would replace it all the same, and those who may do everything can even write to it:
/// that nobody may write says that it is to stay.
void refuse_protected(const fs::path& file) {
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  constexpr fs::perms anybody =
      fs::perms::owner_write | fs::perms::group_write | fs::perms::others_write;
  if (fs::exists(status) && (status.permissions() & anybody) == fs::perms::none)
    throw EnvironmentError("cannot write " + file.string() +
                           ": it is write-protected; name another, or allow it with chmod u+w");
}

/// What is written later goes under another name first, too: the folder decides.
void try_to_write(const fs::path& file, const std::string& name) {
  const std::string trial = file.string() + ".trial" + std::to_string(::getpid());
  const int handle = ::open(trial.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  const bool is_written = handle >= 0 && ::write(handle, "\n", 1) == 1;
  const int reason = errno;
  if (handle >= 0) {
    ::close(handle);
    ::unlink(trial.c_str());
  }
  if (!is_written)
    throw EnvironmentError("cannot write " + name + ": " + std::strerror(reason) +
                           "; free the disk or choose another folder");
}

}  // namespace

void refuse_unwritable_files(const std::vector<std::string>& names) {
  refuse_closed_output();
  std::set<fs::path> files;
  for (const std::string& name : names) {
    if (name.empty()) continue;
    const fs::path file = fs::path(name).lexically_normal();
    refuse_other_kinds(file, name);
    refuse_missing_folder(file, name);
    refuse_protected(file);
    if (!files.insert(file).second)
      throw InputError(name + ": is given for two documents; name a file for each");
    try_to_write(file, name);
  }
}

void write_new_files(const std::vector<FileContent>& files) {
  std::set<fs::path> names;
  for (const FileContent& file : files) {
    if (!names.insert(file.file.lexically_normal()).second)
      throw InputError(file.file.string() + ": two of the files would have this name; rename one");
    refuse_protected(file.file);
  }
  write_files_atomically(files);
}

}  // namespace phytobench::cli
