// SPDX-License-Identifier: MIT
#include "core/record/environment.hpp"

#include <sys/utsname.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <gnu/libc-version.h>
#include <hwy/highway.h>
#include <oneapi/tbb/version.h>
#include <toml++/toml.h>
#include <boost/version.hpp>
#include <nlohmann/json.hpp>

#include "build_information.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

std::string first_line_of(const std::string& file) {
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

/// Value of the first "key : value" line of a /proc file.
std::string proc_value(const std::string& file, const std::string& key) {
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    if (!line.starts_with(key)) continue;
    const std::size_t colon = line.find(':');
    const std::size_t start = line.find_first_not_of(" \t", colon + 1);
    return start == std::string::npos ? "" : line.substr(start);
  }
  return "";
}

std::vector<std::string> cache_sizes() {
  std::vector<std::string> caches;
  for (int i = 0; i < 8; ++i) {
    const std::string folder = fmt::format("/sys/devices/system/cpu/cpu0/cache/index{}/", i);
    const std::string level = first_line_of(folder + "level");
    if (level.empty()) break;
    caches.push_back(fmt::format("L{} {} {}", level, first_line_of(folder + "type"),
                                 first_line_of(folder + "size")));
  }
  return caches;
}

std::string utc_now() {
  return fmt::format(
      "{:%Y-%m-%dT%H:%M:%SZ}",
      fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

ordered_json machine_json(const Machine& machine) {
  ordered_json json;
  json["processor"] = machine.processor;
  json["caches"] = machine.caches;
  json["logical_processors"] = machine.logical_processors;
  json["memory_gib"] = machine.memory_gib;
  json["kernel"] = machine.kernel;
  json["virtual_machine"] = machine.virtual_machine;
  json["load_1min"] = machine.load_1min;
  json["load_5min"] = machine.load_5min;
  return json;
}

}  // namespace

std::vector<Component> linked_components() {
  return {
      {"glibc", gnu_get_libc_version(), "C library (mathematical functions depend on it)"},
      {"libstdc++", fmt::format("{}", __GLIBCXX__), "C++ library"},
      {"oneTBB", TBB_runtime_version(), "threads"},
      {"Highway", fmt::format("{}.{}.{}", HWY_MAJOR, HWY_MINOR, HWY_PATCH), "vectors"},
      {"Boost",
       fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                   BOOST_VERSION % 100),
       "statistics"},
      {"fmt",
       fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100),
       "formatting"},
      {"nlohmann-json",
       fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                   NLOHMANN_JSON_VERSION_PATCH),
       "JSON"},
      {"toml++", fmt::format("{}.{}.{}", TOML_LIB_MAJOR, TOML_LIB_MINOR, TOML_LIB_PATCH), "TOML"},
  };
}

Machine this_machine() {
  Machine machine;
  machine.processor = proc_value("/proc/cpuinfo", "model name");
  machine.caches = cache_sizes();
  machine.logical_processors = static_cast<int>(std::thread::hardware_concurrency());
  const double bytes = static_cast<double>(::sysconf(_SC_PHYS_PAGES)) *
                       static_cast<double>(::sysconf(_SC_PAGE_SIZE));
  machine.memory_gib = static_cast<double>(static_cast<int>(bytes / (1 << 30) * 10.0)) / 10.0;
  utsname system{};
  if (::uname(&system) == 0) machine.kernel = std::string(system.sysname) + " " + system.release;
  machine.virtual_machine =
      proc_value("/proc/cpuinfo", "flags").find("hypervisor") != std::string::npos;
  double load[2] = {0.0, 0.0};
  if (::getloadavg(load, 2) == 2) {
    machine.load_1min = load[0];
    machine.load_5min = load[1];
  }
  return machine;
}

std::string environment_json(const std::string& command_line, std::uint64_t seed, int threads) {
  namespace build = build_information;
  ordered_json json;
  json["schema"] = "phytobench/environment-1";
  json["date_utc"] = utc_now();
  json["suite_version"] = build::version;
  json["commit"] = build::commit;
  json["source_changed"] = build::source_changed;
  json["compiler"] = build::compiler;
  json["flags"] = build::flags;
  json["build_type"] = build::build_type;
  json["command_line"] = command_line;
  json["seed"] = seed;
  json["threads"] = threads;
  json["machine"] = machine_json(this_machine());
  for (const Component& component : linked_components())
    json["libraries"][component.name] = component.version;
  return json.dump(2) + "\n";
}

std::string difference_of_origin(const std::string& before, const std::string& now) {
  const ordered_json old_origin = ordered_json::parse(before, nullptr, false);
  const ordered_json new_origin = ordered_json::parse(now);
  if (!old_origin.is_object()) return "environment.json is damaged";
  for (const char* pointer :
       {"/commit", "/source_changed", "/compiler", "/flags", "/threads", "/machine/processor"}) {
    const ordered_json::json_pointer place(pointer);
    if (!old_origin.contains(place) || old_origin[place] == new_origin[place]) continue;
    return fmt::format("{} {} instead of {}", pointer + 1, new_origin[place].dump(),
                       old_origin[place].dump());
  }
  return "";
}

}  // namespace phytobench
