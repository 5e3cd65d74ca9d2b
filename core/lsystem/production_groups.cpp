// SPDX-License-Identifier: MIT
#include "core/lsystem/production_groups.hpp"

#include <bit>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "core/lsystem/source_lines.hpp"

namespace phytobench {

namespace {

using Key = std::vector<std::uint64_t>;

/// Equal for productions that differ only in condition, successor, probability and names.
Key pattern_key(const Production& production) {
  Key key{production.predecessor.symbol, production.left.size()};
  for (const PatternModule& module : production.left) key.push_back(module.symbol);
  for (const PatternModule& module : production.right) key.push_back(module.symbol);
  return key;
}

Key condition_key(const Production& production) {
  Key key = pattern_key(production);
  if (!production.condition) return key;
  key.push_back(most_symbols);  // no symbol: separates the two parts
  for (const Expression::Instruction& step : production.condition->program()) {
    key.push_back(static_cast<std::uint64_t>(step.operation));
    key.push_back(step.index);
    key.push_back(std::bit_cast<std::uint64_t>(step.value));
  }
  return key;
}

class GroupNumbering {
 public:
  explicit GroupNumbering(LSystem& system) : system_(system) {}

  void run() {
    for (std::size_t i = 0; i < system_.productions.size(); ++i) add(i);
    for (const Group& group : groups_) check_sum(group);
  }

 private:
  struct Group {
    std::size_t first = 0;
    double sum = 0.0;
    bool has_probabilities = false;
  };

  void add(std::size_t index) {
    Production& production = system_.productions[index];
    refuse_ignored_contexts(production);
    const auto [entry, is_new] = numbers_.try_emplace(condition_key(production), groups_.size());
    if (is_new) {
      refuse_unreachable(production);
      groups_.push_back({index, 0.0, production.probability.has_value()});
    }
    Group& group = groups_[entry->second];
    if (!is_new && !(group.has_probabilities && production.probability))
      refuse_second(group, production);
    group.sum += production.probability.value_or(1.0);
    production.group = static_cast<std::uint16_t>(entry->second);
    if (!production.condition) always_.try_emplace(pattern_key(production), index);
  }

  std::string predecessor_of(const Production& production) const {
    const Symbol& symbol = system_.symbols[production.predecessor.symbol];
    if (symbol.arity == 0) return fmt::format("'{}'", symbol.letter);
    return fmt::format("'{}' with {} parameter{}", symbol.letter, symbol.arity,
                       symbol.arity == 1 ? "" : "s");
  }

  [[noreturn]] void fail(const Production& production, const std::string& problem) const {
    fail_in_text(system_.source, production.place, problem);
  }

  void refuse_second(const Group& group, const Production& production) const {
    fail(production,
         fmt::format("a second production for {}, as in line {}; remove one, or give both a "
                     "probability, as in 'A -> B : 0.5'",
                     predecessor_of(production), system_.productions[group.first].place.line));
  }

  void refuse_unreachable(const Production& production) const {
    const auto always = always_.find(pattern_key(production));
    if (always == always_.end()) return;
    const Production& earlier = system_.productions[always->second];
    fail(production, fmt::format("never used: the production without condition in line {} takes "
                                 "every {} before; move this one above it",
                                 earlier.place.line, predecessor_of(production)));
  }

  void refuse_ignored_contexts(const Production& production) const {
    for (const auto* context : {&production.left, &production.right})
      for (const PatternModule& module : *context)
        if (system_.ignored[module.symbol])
          fail(production,
               fmt::format("its context names '{}', which 'ignore:' hides from contexts; "
                           "remove it from one of them",
                           system_.symbols[module.symbol].letter));
  }

  void check_sum(const Group& group) const {
    if (!group.has_probabilities || std::abs(group.sum - 1.0) <= 1e-9) return;
    const Production& first = system_.productions[group.first];
    fail(first, fmt::format("the probabilities of the productions for {} add up to {:.10g}; change "
                            "them until they add up to 1",
                            predecessor_of(first), group.sum));
  }

  LSystem& system_;
  std::vector<Group> groups_;
  std::map<Key, std::size_t> numbers_;
  std::map<Key, std::size_t> always_;  ///< first production that needs no condition
};

}  // namespace

void number_groups(LSystem& system) {
  GroupNumbering(system).run();
}

}  // namespace phytobench
