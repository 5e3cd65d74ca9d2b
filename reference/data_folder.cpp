// SPDX-License-Identifier: MIT
#include "reference/data_folder.hpp"

#include <algorithm>
#include <cstdlib>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace fs = std::filesystem;

fs::path data_folder() {
  if (const char* given = std::getenv("PHYTOBENCH_DATA"); given != nullptr && *given != '\0') {
    if (!fs::is_directory(fs::path(given) / "papers"))
      throw EnvironmentError(std::string("PHYTOBENCH_DATA=") + given +
                             " holds no folder 'papers'; point it to the share folder of a build");
    return given;
  }
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (const std::optional<fs::path> found = data_folder_of_program(program)) return *found;
  throw EnvironmentError("no folder share/papers beside " + program.string() +
                         "; build or install again, or set PHYTOBENCH_DATA to the share folder of "
                         "a build");
}

std::optional<fs::path> data_folder_of_program(const fs::path& program) {
  for (fs::path folder = program.parent_path(); folder.has_relative_path();
       folder = folder.parent_path())
    for (const fs::path& data : {folder / "share", folder / "share" / "phytobench"})
      if (fs::is_directory(data / "papers")) return data;
  return std::nullopt;
}

fs::path paper_folder(const std::string& key) {
  const fs::path folder = data_folder() / "papers" / key;
  if (key.empty() || !fs::is_directory(folder))
    throw InputError("unknown paper '" + key + "'; see phytobench list papers");
  return folder;
}

std::vector<fs::path> paper_files(const std::string& key, const std::string& kind) {
  const fs::path folder = paper_folder(key) / kind, file = paper_folder(key) / (kind + ".toml");
  std::vector<fs::path> files;
  if (fs::is_directory(folder))
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
      if (entry.path().extension() == ".toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (fs::is_regular_file(file) != files.empty())
    throw InputError("paper '" + key + "' needs either " + file.string() + " or files in " +
                     folder.string() + ", not both");
  if (files.empty()) files.push_back(file);
  return files;
}

}  // namespace phytobench
