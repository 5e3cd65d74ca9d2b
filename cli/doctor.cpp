// SPDX-License-Identifier: MIT
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "build_information.hpp"
#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/picture/render.hpp"
#include "core/record/environment.hpp"
#include "core/statistics/order_statistics.hpp"
#include "core/terrain/files/gdal_raster.hpp"
#include "core/terrain/sun/solar_position.hpp"
#include "reference/data_folder.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

bool is_on_path(const std::string& program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path == nullptr ? "" : path);
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

struct Tool {
  const char* program;
  const char* purpose;
};
constexpr Tool tools[] = {{"g++", "building"},
                          {"cmake", "building"},
                          {"ninja", "building"},
                          {"git", "naming the commit a result comes from"},
                          {"ccache", "building again quickly"},
                          {"gnuplot", "plots in the report"},
                          {"valgrind", "counting instructions (bench instructions)"},
                          {"clang-format", "the formatting part of the tidy test"}};

/// How far the slowest of 40 equal pieces of work is from the fastest, and the median from the
/// fastest.
struct Noise {
  double slowest_over_fastest = 0.0;
  double median_over_fastest = 0.0;
};

Noise measured_noise() {
  std::vector<double> seconds;
  volatile double sink = 0.0;
  for (int repetition = 0; repetition < 40; ++repetition) {
    const auto start = std::chrono::steady_clock::now();
    double sum = 0.0;
    for (int i = 1; i < 2000000; ++i) sum += 1.0 / i;
    sink = sum;
    seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }
  (void)sink;
  const double fastest = *std::min_element(seconds.begin(), seconds.end());
  return {*std::max_element(seconds.begin(), seconds.end()) / fastest, median(seconds) / fastest};
}

ordered_json examination() {
  ordered_json json;
  json["schema"] = "phytobench/doctor-1";
  json["version"] = build_information::version;
  json["commit"] = build_information::commit;
  json["compiler"] = build_information::compiler;
  json["flags"] = build_information::flags;
  json["data_folder"] = data_folder().string();
  for (const Component& component : linked_components())
    json["libraries"][component.name] = component.version;
  for (const EngineDescriptor* engine : all_engines())
    json["engines"][std::string(engine->name)] =
        engine->built()
            ? "built" + (engine->library.empty() ? "" : ", " + std::string(engine->library))
            : "not built: " + std::string(engine->missing_package) + " is missing";
  json["pictures"] = renderer_name();
  json["map_formats"] = map_reader_name();
  json["solar_position"] = can_place_the_sun() ? "built, libnova" : "not built: libnova is missing";
  for (const Tool& tool : tools)
    json["tools"][tool.program] =
        is_on_path(tool.program) ? "found" : fmt::format("missing (needed for {})", tool.purpose);
  const Machine machine = this_machine();
  json["machine"] = {{"processor", machine.processor},
                     {"logical_processors", machine.logical_processors},
                     {"memory_gib", machine.memory_gib},
                     {"kernel", machine.kernel},
                     {"virtual_machine", machine.virtual_machine},
                     {"load_1min", machine.load_1min}};
  const Noise noise = measured_noise();
  const bool quiet = machine.load_1min < 0.3 && noise.median_over_fastest < 1.03 &&
                     noise.slowest_over_fastest < 1.25;
  json["quiet"] = {
      {"verdict",
       quiet ? "quiet" : "not quiet: trust ratios of one run only, with their intervals"},
      {"slowest_over_fastest", noise.slowest_over_fastest},
      {"median_over_fastest", noise.median_over_fastest}};
  return json;
}

std::string plain(const ordered_json& json, const std::string& indent = "") {
  std::string text;
  for (const auto& [key, value] : json.items()) {
    if (value.is_object())
      text += indent + key + "\n" + plain(value, indent + "  ");
    else
      text += fmt::format("{}{:<22} {}\n", indent, key,
                          value.is_string() ? value.get<std::string>() : value.dump());
  }
  return text;
}

}  // namespace

int doctor(const DoctorOptions& options) {
  const ordered_json json = examination();
  print(options.json ? json.dump(2) + "\n" : plain(json));
  return 0;
}

}  // namespace phytobench::cli
