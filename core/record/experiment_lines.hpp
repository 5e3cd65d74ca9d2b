// SPDX-License-Identifier: MIT
// What the formats of records.jsonl and timings.jsonl have in common: the lines of an experiment,
// and after them a sealed one that says how many they are.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"
#include "core/record/sealed_lines.hpp"

namespace phytobench {

/// What a line is called; of several it is the key of their number, too.
struct LineWords {
  const char* one;
  const char* several;
};

inline constexpr LineWords record_words{"record", "records"};
inline constexpr LineWords timing_words{"timing", "timings"};

/// The line that ends an experiment of so many lines.
inline nlohmann::ordered_json completion_line(const std::string& experiment, LineWords words,
                                              std::size_t count) {
  return {{"experiment", experiment}, {"complete", true}, {words.several, count}};
}

/// The lines of the experiment that is being read. Each `Line` names its `experiment`.
template <class Line>
class PendingLines {
 public:
  explicit PendingLines(LineWords words) : words_(words) {}

  void add(Line line) { lines_.push_back(std::move(line)); }

  /// The first line's experiment; nothing without a line.
  std::optional<std::string> experiment() const {
    return lines_.empty() ? std::nullopt : std::optional(lines_.front().experiment);
  }

  /// All of them, to which `completion` belongs; none are pending then. Throws InputError if they
  /// are not as many as it says, or not of its experiment.
  std::vector<Line> completed(const nlohmann::ordered_json& completion) {
    const std::string experiment = completion.at("experiment");
    if (lines_.size() != completion.at(words_.several).get<std::size_t>())
      throw InputError("experiment '" + experiment + "' lost or gained " + words_.several +
                       "; run the experiments again");
    for (const Line& line : lines_)
      if (line.experiment != experiment)
        throw InputError(std::string("a ") + words_.one + " of '" + line.experiment +
                         "' stands in '" + experiment + "'; run the experiments again");
    return std::exchange(lines_, {});
  }

 private:
  LineWords words_;
  std::vector<Line> lines_;
};

/// Reads the content of a sealed file into a `Collector`: add_line() and add_seal() get its lines
/// in order, taken() is the result. Throws InputError with file and line, also without a header.
template <class Collector>
auto collect_sealed_lines(const std::filesystem::path& file, std::string_view text) {
  Collector collector;
  read_sealed_lines(file, text,
                    {.line = [&](const nlohmann::ordered_json& line) { collector.add_line(line); },
                     .seal = [&](const nlohmann::ordered_json& line,
                                 const Seal& seal) { collector.add_seal(line, seal); }});
  if (!collector.has_header())
    throw InputError(file.string() + ":1: is empty; run the experiments again");
  return collector.taken();
}

}  // namespace phytobench
