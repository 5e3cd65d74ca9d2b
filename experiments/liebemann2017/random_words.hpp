// SPDX-License-Identifier: MIT
// Words that nobody chose, for what must hold in all of them.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/random/counter_stream.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::liebemann2017 {

/// A random word of F(l) with l > 0, turns by the symbols in `turns` and, if wanted, branches,
/// which begin and end anywhere. Lengths and angles are eighths, so that text holds them exactly.
class RandomWords {
 public:
  RandomWords(std::uint64_t seed, std::uint64_t stream, std::string turns)
      : stream_(seed, stream), turns_(std::move(turns)) {}

  std::string next(int symbols, bool branches) {
    std::string word = "F(1)";
    int open = 0;
    for (int i = 0; i < symbols; ++i) {
      const int choice = below(branches ? 6 : 4);
      if (choice < 2) word += move();
      if (choice == 2 || choice == 3) word += turn();
      if (choice == 4) word += '[', ++open;
      if (choice == 5 && open > 0) word += ']', --open;
    }
    return word + std::string(static_cast<std::size_t>(open), ']');
  }
  double angle_deg() { return below(2880) / 8.0; }
  int below(int count) { return static_cast<int>(stream_.next_unit() * count); }

 private:
  std::string move() { return fmt::format("F({})", (1 + below(40)) / 8.0); }
  std::string turn() {
    const char symbol = turns_[static_cast<std::size_t>(below(static_cast<int>(turns_.size())))];
    return fmt::format("{}({})", symbol, angle_deg());
  }

  CounterStream stream_;
  std::string turns_;
};

/// The word without its branches.
inline std::string trunk_of(const std::string& word) {
  std::string trunk;
  int open = 0;
  for (const char c : word) {
    if (c == '[') ++open;
    if (open == 0) trunk += c;
    if (c == ']') --open;
  }
  return trunk;
}

/// A measurement that rests on them.
inline void record_seeded(ExperimentContext& context, const std::string& name, RecordValue value,
                          const std::string& unit = "1") {
  Record record;
  record.measurement = name;
  record.value = std::move(value);
  record.unit = unit;
  record.seed = context.seed();
  context.record(std::move(record));
}

}  // namespace phytobench::experiments::liebemann2017
