// SPDX-License-Identifier: MIT
#include "cli/build_moments.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <regex>

#include <fmt/format.h>

#include "core/component_graph/parameter_range.hpp"
#include "core/contract/errors.hpp"

namespace phytobench::cli {

namespace {

constexpr std::uint32_t most_frames = 10'000;

template <class Number>
std::optional<Number> number_from(const std::string& text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [next, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || next != end) return std::nullopt;
  return number;
}

std::optional<double> time_from(const std::string& text) {
  const auto time = number_from<double>(text);
  return time && std::abs(*time) <= largest_parameter ? time : std::nullopt;
}

std::vector<std::string> split_at_colons(const std::string& text) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == ':')
      parts.emplace_back();
    else
      parts.back() += c;
  }
  return parts;
}

const std::regex& number_place() {
  static const std::regex place("%(0([1-9]))?d");
  return place;
}

}  // namespace

std::vector<double> moments_from(const std::string& text) {
  const std::vector<std::string> parts = split_at_colons(text);
  const auto first = time_from(parts[0]);
  if (parts.size() == 1 && first) return {*first};
  if (parts.size() == 3 && first) {
    const auto last = time_from(parts[1]);
    const auto frames = number_from<std::uint32_t>(parts[2]);
    if (last && frames && *frames >= 2 && *frames <= most_frames) {
      std::vector<double> moments;
      for (std::uint32_t i = 1; i <= *frames; ++i)
        moments.push_back(NumberSpan{*first, *last}.at({i, *frames}));
      return moments;
    }
  }
  throw InputError(
      fmt::format("--time '{}': give a time, or FIRST:LAST:FRAMES with 2 to {} frames, "
                  "like 0:1:25; times are at most {:g}",
                  text, most_frames, largest_parameter));
}

bool has_frame_number(const std::string& name) {
  return std::regex_search(name, number_place());
}

std::string frame_name(const std::string& pattern, std::size_t frame, const std::string& option) {
  std::smatch place;
  if (!std::regex_search(pattern, place, number_place()) ||
      std::regex_search(place[0].second, pattern.end(), number_place()))
    throw InputError(fmt::format(
        "{} {}: name files of several frames with one place for their numbers, like frame-%03d.png",
        option, pattern));
  const std::size_t width = place[2].matched ? static_cast<std::size_t>(*place[2].first - '0') : 0;
  return place.prefix().str() + fmt::format("{:0{}}", frame, width) + place.suffix().str();
}

}  // namespace phytobench::cli
