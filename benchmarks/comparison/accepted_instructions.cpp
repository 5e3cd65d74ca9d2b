// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/accepted_instructions.hpp"

#include <fnmatch.h>

#include <algorithm>

#include <fmt/format.h>

#include "core/contract/text_file.hpp"
#include "core/contract/toml_values.hpp"

namespace phytobench {

namespace {

constexpr std::size_t least_digits = 12;

bool is_short_commit(std::string_view text) {
  return text.size() >= least_digits && text.size() <= 40 &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string some_text(const TomlValue& value) {
  const std::string text = read_text(value);
  if (text.find_first_not_of(" \t\n") == std::string::npos)
    value.fail(fmt::format("{} must not be empty", value.name));
  return text;
}

AcceptedIncrease increase_from(const toml::table& table, const std::filesystem::path& file) {
  for (const char* key : {"benchmark", "percent", "base", "reason"})
    if (!table.contains(key)) fail_at(file, table, fmt::format("[[accepted]] has no {}", key));
  AcceptedIncrease increase;
  for (const auto& [key, node] : table) {
    const TomlValue value{file, key.str(), node};
    if (key == "benchmark") {
      increase.benchmark = some_text(value);
    } else if (key == "percent") {
      increase.percent = read_number(value, {.high = 1000.0, .low_is_allowed = false});
    } else if (key == "base") {
      increase.base = read_text(value);
      if (!is_short_commit(increase.base))
        value.fail("base must be a commit: at least 12 of its digits, in lower case");
    } else if (key == "reason") {
      increase.reason = some_text(value);
    } else {
      value.fail(fmt::format("unknown key '{}'; benchmark, percent, base and reason are known",
                             in_one_line(key.str())));
    }
  }
  return increase;
}

}  // namespace

bool AcceptedIncrease::applies_to(std::string_view name, std::string_view base_commit) const {
  const std::size_t digits = std::min(base.size(), base_commit.size());
  return digits >= least_digits && base.substr(0, digits) == base_commit.substr(0, digits) &&
         ::fnmatch(benchmark.c_str(), std::string(name).c_str(), 0) == 0;
}

std::vector<AcceptedIncrease> accepted_increases_from(const std::string& text,
                                                      const std::filesystem::path& file) {
  const toml::table document = parse_toml(text, file.string());
  std::vector<AcceptedIncrease> increases;
  for (const auto& [key, node] : document) {
    const toml::array* list = node.as_array();
    if (key != "accepted" || list == nullptr)
      fail_at(file, node,
              fmt::format("'{}' is not known; only [[accepted]] is", in_one_line(key.str())));
    for (const toml::node& entry : *list) {
      if (!entry.is_table()) fail_at(file, entry, "accepted must be tables: [[accepted]]");
      increases.push_back(increase_from(*entry.as_table(), file));
    }
  }
  return increases;
}

std::vector<AcceptedIncrease> read_accepted_increases(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) return {};
  return accepted_increases_from(read_text_file(file), file);
}

}  // namespace phytobench
