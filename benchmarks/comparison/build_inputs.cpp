// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/build_inputs.hpp"

#include <cstdlib>
#include <sstream>

#include <fmt/format.h>

#include "benchmarks/comparison/child_process.hpp"
#include "benchmarks/comparison/plain_text.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

constexpr std::size_t most_value_bytes = 4000;  // of a value; paths of libraries may be many

/// The first line of what the compiler says of its version. CXX may hold arguments, too; CMake
/// looks for c++ first where it is not set.
std::string compiler() {
  try {
    const ChildResult result =
        run_child({.command = {"sh", "-c", "exec ${CXX:-c++} --version"},
                   .environment = {{"LC_ALL", "C"}, {"LANGUAGE", std::nullopt}},
                   .limit_s = 60.0});
    return result.is_ok() ? one_line(result.out.substr(0, result.out.find('\n')), most_value_bytes)
                          : "";
  } catch (const EnvironmentError&) {
    return "";  // whoever builds without a shell will hear of it then
  }
}

std::string line_at(std::istringstream& lines) {
  std::string line;
  std::getline(lines, line);
  return line;
}

std::string value_in(const std::string& line) {
  const std::size_t colon = line.find(": ");
  return colon == std::string::npos ? "" : line.substr(colon + 2);
}

}  // namespace

std::string build_inputs() {
  std::string text = fmt::format("compiler: {}\n", compiler());
  for (const char* name : {"CXX", "CXXFLAGS", "LDFLAGS", "CMAKE_TOOLCHAIN_FILE",
                           "CMAKE_PREFIX_PATH", "CPATH", "CPLUS_INCLUDE_PATH", "LIBRARY_PATH"}) {
    const char* value = std::getenv(name);
    text +=
        fmt::format("{}: {}\n", name, value == nullptr ? "" : one_line(value, most_value_bytes));
  }
  return text;
}

std::string change_of_inputs(const std::string& before, const std::string& now) {
  if (before == now) return "";
  std::istringstream lines_before(before), lines_now(now);
  while (lines_before && lines_now) {
    const std::string old_line = line_at(lines_before), line = line_at(lines_now);
    const std::string name = line.substr(0, line.find(": "));
    if (old_line == line) continue;
    if (name.empty() || !old_line.starts_with(name + ": ")) break;
    return fmt::format("{} was '{}' and is '{}'", name, value_in(old_line), value_in(line));
  }
  return "nobody knows what it was built with";
}

}  // namespace phytobench
