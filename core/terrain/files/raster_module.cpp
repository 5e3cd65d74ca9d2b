// SPDX-License-Identifier: MIT
#include <dlfcn.h>

#include <cstdlib>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"
#include "core/nearest_node/plugin/floating_point_control.hpp"
#include "core/terrain/files/gdal_raster.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

std::optional<fs::path> module_in(const fs::path& folder) {
  std::error_code error;
  const fs::path file = folder / raster_module_file;
  return fs::is_regular_file(file, error) ? std::optional(file) : std::nullopt;
}

/// Null with a reason if it cannot be used.
const RasterModule* opened_module(const fs::path& file, std::string& reason) {
  // Its 114 libraries must leave rounding as it is.
  const FloatingPointControl before;
  void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (!before.is_in_force()) before.restore();
  if (library == nullptr) {
    reason = plain_line(::dlerror());
    return nullptr;
  }
  const auto entry = reinterpret_cast<RasterModuleEntry>(::dlsym(library, raster_module_entry));
  const RasterModule* module = entry == nullptr ? nullptr : entry();
  if (module != nullptr && module->version == raster_module_version) return module;
  reason = "it belongs to another version of the program";
  return nullptr;
}

}  // namespace

std::optional<fs::path> raster_module_path() {
  if (const char* given = std::getenv("PHYTOBENCH_MODULES"); given != nullptr && *given != '\0')
    return module_in(given);
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  for (fs::path folder = program.parent_path(); folder.has_relative_path();
       folder = folder.parent_path())
    for (const fs::path& candidate : {folder / "modules", folder / "lib" / "phytobench"})
      if (const std::optional<fs::path> found = module_in(candidate)) return found;
  return std::nullopt;
}

const RasterModule& raster_module(const std::string& purpose) {
  const std::optional<fs::path> file = raster_module_path();
  if (!file)
    throw InputError(
        fmt::format("{} needs GDAL, which this build does not have; install "
                    "libgdal-dev and build again, or use an ESRI ASCII grid (.asc)",
                    purpose));
  std::string reason;
  const RasterModule* module = opened_module(*file, reason);
  if (module == nullptr)
    throw InputError(
        fmt::format("{} needs GDAL, but {} cannot be loaded ({}); install libgdal-dev "
                    "and build again, or use an ESRI ASCII grid (.asc)",
                    purpose, file->string(), reason));
  return *module;
}

std::string map_reader_name() {
  const std::optional<fs::path> file = raster_module_path();
  if (!file) return "not built: GDAL is missing";
  std::string reason;
  const RasterModule* module = opened_module(*file, reason);
  return module == nullptr ? "cannot be loaded: " + reason : module->library();
}

}  // namespace phytobench
