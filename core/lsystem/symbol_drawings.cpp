// SPDX-License-Identifier: MIT
#include "core/lsystem/symbol_drawings.hpp"

#include <map>
#include <utility>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

using Symbols = std::vector<SymbolIndex>;

/// Successors of all symbols; a symbol without one stays.
struct Rules {
  explicit Rules(const LSystem& system)
      : successors(system.symbols.size()), changes(system.symbols.size(), false) {
    for (const AxiomModule& module : system.axiom) axiom.push_back(module.symbol);
    for (const Production& production : system.productions) {
      const SymbolIndex from = production.predecessor.symbol;
      if (changes[from]) continue;  // the first that fits is taken
      changes[from] = true;
      for (const SuccessorModule& module : production.successor)
        successors[from].push_back(module.symbol);
    }
  }

  std::size_t size() const { return successors.size(); }

  Symbols axiom;
  std::vector<Symbols> successors;
  std::vector<bool> changes;
};

/// The sum, or the greatest number if that does not fit.
std::uint64_t saturating_sum(std::uint64_t a, std::uint64_t b) {
  return a + b < a ? ~std::uint64_t{0} : a + b;
}

}  // namespace

/// First from the axiom down which drawings are asked for, then from the last step up what they
/// are.
class DrawingMaker {
 public:
  DrawingMaker(const LSystem& system, int steps, SymbolDrawings& made)
      : commands_(turtle_commands(system)),
        steps_(static_cast<std::size_t>(steps)),
        rules_(system),
        made_(made),
        asked_((steps_ + 1) * rules_.size(), false),
        index_(asked_.size(), Index{SymbolDrawings::nothing}) {}

  void make() {
    ask();
    for (std::size_t left = 0; left <= steps_; ++left)
      for (std::size_t symbol = 0; symbol < rules_.size(); ++symbol) {
        if (left > 0 && !rules_.changes[symbol]) continue;
        const std::size_t place = place_of(left, symbol);
        if (!asked_[place]) continue;
        index_[place] = left > 0 ? drawing_from(composed(rules_.successors[symbol], left - 1))
                                 : leaf(commands_.of[symbol]);
      }
    const Composed axiom = composed(rules_.axiom, steps_);
    made_.parts_.insert(made_.parts_.end(), axiom.parts.begin(), axiom.parts.end());
    made_.axiom_parts_ = axiom.parts.size();
    made_.segments_ = axiom.segments;
  }

 private:
  using Index = SymbolDrawings::Index;

  /// Symbols that stay are the same whatever the steps left.
  std::size_t place_of(std::size_t left, std::size_t symbol) const {
    return (rules_.changes[symbol] ? left : 0) * rules_.size() + symbol;
  }

  void ask() {
    for (const SymbolIndex symbol : rules_.axiom) asked_[place_of(steps_, symbol)] = true;
    for (std::size_t left = steps_; left > 0; --left)
      for (std::size_t symbol = 0; symbol < rules_.size(); ++symbol)
        if (rules_.changes[symbol] && asked_[place_of(left, symbol)])
          for (const SymbolIndex part : rules_.successors[symbol])
            asked_[place_of(left - 1, part)] = true;
  }

  /// What moves the turtle alike is one drawing.
  Index leaf(const TurtleCommand& command) {
    const bool draws = command.action == TurtleAction::draw;
    const bool moves =
        command.action >= TurtleAction::move && command.action <= TurtleAction::level;
    if (!draws && !moves) return SymbolDrawings::nothing;
    const auto next = static_cast<Index>(made_.drawings_.size());
    const auto [known, is_new] =
        leaves_.try_emplace(std::pair(command.action, command.sign < 0.0), next);
    if (is_new) made_.drawings_.push_back({.segments = draws ? 1u : 0u, .command = command});
    return known->second;
  }

  struct Composed {
    std::vector<Index> parts;
    std::uint64_t segments = 0;
  };

  Composed composed(const Symbols& symbols, std::size_t left) const {
    struct Open {
      std::size_t part;
      std::uint64_t segments;
    };
    std::vector<Open> open;
    Composed made;
    for (const SymbolIndex symbol : symbols) {
      const TurtleAction action = commands_.of[symbol].action;
      if (action == TurtleAction::store) {
        open.push_back({made.parts.size(), made.segments});
        made.parts.push_back(SymbolDrawings::store);
      } else if (action == TurtleAction::restore) {
        PHYTOBENCH_EXPECT(!open.empty());
        // A branch without a segment leaves no trace.
        if (made.segments == open.back().segments)
          made.parts.resize(open.back().part);
        else
          made.parts.push_back(SymbolDrawings::restore);
        open.pop_back();
      } else if (const Index part = index_[place_of(left, symbol)];
                 part != SymbolDrawings::nothing) {
        made.parts.push_back(part);
        made.segments = saturating_sum(made.segments, made_.drawings_[part].segments);
      }
    }
    PHYTOBENCH_ENSURE(open.empty());
    return made;
  }

  Index drawing_from(const Composed& whole) {
    if (whole.parts.empty()) return SymbolDrawings::nothing;
    if (whole.parts.size() == 1) return whole.parts.front();
    made_.drawings_.push_back({.segments = whole.segments,
                               .first_part = static_cast<std::uint32_t>(made_.parts_.size()),
                               .part_count = static_cast<std::uint32_t>(whole.parts.size())});
    made_.parts_.insert(made_.parts_.end(), whole.parts.begin(), whole.parts.end());
    return static_cast<Index>(made_.drawings_.size() - 1);
  }

  TurtleCommands commands_;
  std::size_t steps_;
  Rules rules_;
  SymbolDrawings& made_;
  std::vector<bool> asked_;
  std::vector<Index> index_;
  std::map<std::pair<TurtleAction, bool>, Index> leaves_;
};

SymbolDrawings::SymbolDrawings(const LSystem& system, int steps) {
  if (steps < 0)
    throw InputError(fmt::format("{}: {} derivations; give none or more", system.source, steps));
  const std::size_t most_steps = most / system.symbols.size();
  if (static_cast<std::size_t>(steps) > most_steps)
    throw InputError(fmt::format(
        "{}: {} derivations are more than can be drawn without the word; derive {} times at most",
        system.source, steps, most_steps));
  DrawingMaker(system, steps, *this).make();
}

}  // namespace phytobench
