// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/signal_derivation.hpp"

#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

constexpr const char* signal_text =
    "ignore: + -\n"
    "axiom: I(1)[+I(0)]-I(0)\n"
    "I(x) < I(y) : x > 0 && y == 0 -> I(x + 1)\n";

/// The random tree as a word: all successors of an internode but the last stand in brackets.
class TreeWriter {
 public:
  TreeWriter(const LSystem& system, std::size_t internodes)
      : system_(system), successors_(internodes) {
    CounterStream random(8, 0);
    for (std::size_t i = 1; i < internodes; ++i) {
      const double unit = random.next_unit();
      successors_[static_cast<std::size_t>(unit * static_cast<double>(i))].push_back(i);
    }
  }

  std::vector<AxiomModule> write() {
    put_internode(0);
    return std::move(modules_);
  }

 private:
  void put_internode(std::size_t internode) {
    put("I", {internode == 0 ? 1.0 : 0.0});
    const std::vector<std::size_t>& successors = successors_[internode];
    for (std::size_t i = 0; i < successors.size(); ++i) {
      const bool is_branch = i + 1 < successors.size();
      if (is_branch) put("[");
      put(i % 2 == 0 ? "+" : "-");
      put_internode(successors[i]);
      if (is_branch) put("]");
    }
  }
  void put(const char* letter, std::vector<double> parameters = {}) {
    const auto symbol = find_symbol(system_, letter, parameters.size());
    PHYTOBENCH_EXPECT(symbol.has_value());
    modules_.push_back({*symbol, std::move(parameters)});
  }

  const LSystem& system_;
  std::vector<std::vector<std::size_t>> successors_;
  std::vector<AxiomModule> modules_;
};

/// Goes along the word with the depth in its hand, and with those where branches began on a stack.
std::string objection_to_signal(const LSystem& system, int steps, const Word& word) {
  if (word.size() != system.axiom.size())
    return fmt::format("{} modules instead of {}", word.size(), system.axiom.size());
  std::vector<int> began;
  int depth = 0;
  const double* parameter = word.parameters.data();
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (word.symbols[i] != system.axiom[i].symbol)
      return fmt::format("module {} has become another", i);
    const std::string& letter = system.symbols[word.symbols[i]].letter;
    if (letter == "[") began.push_back(depth);
    if (letter == "]") {
      depth = began.back();
      began.pop_back();
    }
    if (letter != "I") continue;
    ++depth;
    const double expected = depth <= steps + 1 ? depth : 0;
    if (*parameter != expected)
      return fmt::format("module {} holds {} instead of {}", i, *parameter, expected);
    ++parameter;
  }
  return "";
}

}  // namespace

DerivationCase signal_derivation(std::size_t internodes, int steps) {
  LSystem system = parse_lsystem(signal_text, "signal");
  system.axiom = TreeWriter(system, internodes).write();
  return {"signal, parametric, contexts",
          signal_text,
          system,
          steps,
          true,
          [system, steps](const Word& word) { return objection_to_signal(system, steps, word); }};
}

}  // namespace phytobench
