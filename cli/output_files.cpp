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

/// What is written later goes under another name first, too: the folder decides.
void try_to_write(const fs::path& file, const std::string& name) {
  if (file.has_parent_path()) make_folder(file.parent_path());
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
    if (!files.insert(file).second)
      throw InputError(name + ": is given for two documents; name a file for each");
    try_to_write(file, name);
  }
}

}  // namespace phytobench::cli
