// SPDX-License-Identifier: MIT
#include "core/nearest_node/plugin/engine_plugin.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/nearest_node/plugin/floating_point_control.hpp"
#include "core/nearest_node/plugin/phytobench_engine.h"
#include "core/nearest_node/plugin/plugin_engine.hpp"

namespace phytobench {

namespace {

constexpr const char* entry_name = "phytobench_engine";

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw InputError("plugin '" + file + "': " + why);
}

/// What is linked with -ffast-math changes it for whoever loads it.
void refuse_change(const FloatingPointControl& before, const std::string& file) {
  if (before.is_in_force()) return;
  before.restore();
  refuse(file,
         "changes the floating-point environment when it is loaded; link it without -ffast-math");
}

void* load(const std::string& file, const PluginWatch& watch) {
  std::error_code error;
  const auto type = std::filesystem::status(file, error).type();
  if (type == std::filesystem::file_type::not_found)
    refuse(file, "there is no such file; give the path of a shared library");
  if (type != std::filesystem::file_type::regular)
    refuse(file, "is no file that can be read; give the path of a shared library");
  // A name without a slash would be looked for where the system keeps its libraries.
  const std::string path = std::filesystem::absolute(file, error).string();
  const WatchedCall call(watch, PluginCall::load, 0);
  const FloatingPointControl before;
  // Never unloaded: threads of its pools (OpenMP's) may still run code of it, and its destructors
  // would run where nobody watches for one that hangs.
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);
  if (library == nullptr)
    refuse(file, fmt::format("cannot be loaded ({}); build it with -shared -fPIC for this machine",
                             plain_line(::dlerror())));
  refuse_change(before, file);
  return library;
}

const phytobench_engine_v1* table_of(void* library, const std::string& file,
                                     const PluginWatch& watch) {
  using Entry = const phytobench_engine_v1* (*)();
  const WatchedCall call(watch, PluginCall::load, 0);
  const auto entry = reinterpret_cast<Entry>(::dlsym(library, entry_name));
  if (entry == nullptr)
    refuse(file, fmt::format("exports no function {}(); see phytobench_engine.h", entry_name));
  const FloatingPointControl before;
  const phytobench_engine_v1* table = entry();
  refuse_change(before, file);
  if (table == nullptr) refuse(file, fmt::format("{}() gives no table", entry_name));
  return table;
}

bool is_well_formed(const std::string& name) {
  constexpr std::size_t longest = 64;
  return !name.empty() && name.size() <= longest &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos;
}

/// What of the table this program knows, null where it is shorter. Reads nothing beyond what the
/// plugin says its table holds.
phytobench_engine_v1 known_part(const phytobench_engine_v1& table, const std::string& file) {
  if (table.abi != PHYTOBENCH_ENGINE_ABI)
    refuse(file, fmt::format("was built for version {} of the interface, but this program has {}; "
                             "build it with this program's phytobench_engine.h",
                             table.abi, PHYTOBENCH_ENGINE_ABI));
  constexpr std::size_t least = offsetof(phytobench_engine_v1, last_error);  // after destroy()
  if (table.size < least)
    refuse(file, fmt::format("its table has {} bytes, but destroy() ends at {}; set size to "
                             "sizeof(phytobench_engine_v1)",
                             table.size, least));
  phytobench_engine_v1 known{};
  const std::size_t whole_members = table.size / sizeof(void*) * sizeof(void*);
  std::memcpy(&known, &table, std::min(whole_members, sizeof(known)));
  return known;
}

void check(const phytobench_engine_v1& table, const std::string& file) {
  const std::string name = table.name == nullptr ? "" : plain_line(table.name);
  if (!is_well_formed(name))
    refuse(file, fmt::format("its engine's name '{}' is not made of a-z, 0-9 and _", name));
  if (table.summary == nullptr || *table.summary == '\0')
    refuse(file, "has no summary; say in one sentence how it finds the nearest node");
  for (const auto& [is_there, function] : {std::pair{table.create != nullptr, "create"},
                                           std::pair{table.associate != nullptr, "associate"},
                                           std::pair{table.destroy != nullptr, "destroy"}})
    if (!is_there) refuse(file, fmt::format("its table lacks {}()", function));
  const auto engines = all_engines();
  if (std::any_of(engines.begin(), engines.end(),
                  [&](const EngineDescriptor* engine) { return engine->name == name; }))
    refuse(file,
           fmt::format("its engine is called '{}', as one of this program's; rename it", name));
}

std::shared_ptr<const phytobench_engine_v1> checked_table_of(void* library, const std::string& file,
                                                             const PluginWatch& watch) {
  const phytobench_engine_v1 known = known_part(*table_of(library, file, watch), file);
  check(known, file);
  return std::make_shared<const phytobench_engine_v1>(known);
}

std::unique_ptr<NearestNodeEngine> make_engine(const void* plugin) {
  return std::make_unique<PluginEngine>(*static_cast<const EnginePlugin*>(plugin));
}

}  // namespace

std::string plain_line(const char* text) {
  constexpr std::size_t longest = 200;
  std::string line;
  for (; text != nullptr && *text != '\0' && line.size() < longest; ++text)
    line += *text >= ' ' && *text <= '~' ? *text : ' ';
  return line;
}

void EnginePlugin::Close::operator()(void* library) const {
  ::dlclose(library);
}

EnginePlugin::EnginePlugin(const std::filesystem::path& file, const PluginWatch& watch)
    : file_(file.string()),
      watch_(watch),
      library_(load(file_, watch_)),
      table_(checked_table_of(library_.get(), file_, watch_)),
      name_(plain_line(table_->name)),
      summary_(plain_line(table_->summary)),
      source_("plugin " + file.filename().string()),
      descriptor_{.name = name_,
                  .summary = summary_,
                  .source = source_,
                  .uses_point_filter = false,
                  .create = EngineFactory(make_engine, this)} {}

}  // namespace phytobench
