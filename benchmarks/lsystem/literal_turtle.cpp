// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/literal_turtle.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace phytobench {

namespace {

/// Exact at multiples of 90 degrees.
long double cosine(long double degrees) {
  const long double rest = std::fmod(degrees, 360.0L);
  if (std::fmod(rest, 90.0L) != 0.0L)
    return std::cos(rest * std::numbers::pi_v<long double> / 180.0L);
  const int quarter = ((static_cast<int>(rest / 90.0L) % 4) + 4) % 4;
  return quarter == 0 ? 1.0L : quarter == 2 ? -1.0L : 0.0L;
}

long double sine(long double degrees) {
  return cosine(degrees - 90.0L);
}

}  // namespace

LiteralDrawer::LiteralDrawer(const LSystem& system)
    : system_(system), letters_(system.symbols.size()) {
  const TurtleSigns signs = signs_of(system.turtle.convention);
  const auto sign = [](double of_convention, bool is_first) {
    return (of_convention < 0.0) == is_first ? -1 : 1;
  };
  for (std::size_t i = 0; i < letters_.size(); ++i) {
    const std::string& name = system.symbols[i].letter;
    if (name.size() != 1) continue;
    const char c = name[0];
    Letter& letter = letters_[i];
    if (system.turtle.draws.find(c) != std::string::npos)
      letter.act = Act::draw;
    else if (system.turtle.moves.find(c) != std::string::npos)
      letter.act = Act::move;
    else if (c == '+' || c == '-')
      letter = {Act::turn, sign(signs.turn, c == '+')};
    else if (c == '&' || c == '^')
      letter = {Act::pitch, sign(signs.pitch, c == '&')};
    else if (c == '\\' || c == '/')
      letter = {Act::roll, sign(signs.roll, c == '\\')};
    else if (c == '|')
      letter.act = Act::half_turn;
    else if (c == '[' || c == ']')
      letter.act = c == '[' ? Act::store : Act::restore;
    planar_ = planar_ && letter.act != Act::pitch && letter.act != Act::roll;
  }
  for (const Production& production : system.productions) {
    Letter& letter = letters_[production.predecessor.symbol];
    letter.changes = true;
    for (const SuccessorModule& module : production.successor)
      letter.successor.push_back(module.symbol);
  }
  if (system.turtle.start == TurtleStart::upwards) {
    now_.heading = {0, 1, 0};
    now_.left = {-1, 0, 0};
  }
}

void LiteralDrawer::draw(int steps, const TakeSegment& take) {
  struct Rest {
    const SymbolIndex* next;
    const SymbolIndex* end;
    int steps;
  };
  std::vector<SymbolIndex> axiom;
  for (const AxiomModule& module : system_.axiom) axiom.push_back(module.symbol);
  std::vector<Rest> rests{{axiom.data(), axiom.data() + axiom.size(), steps}};
  while (!rests.empty()) {
    Rest& rest = rests.back();
    if (rest.next == rest.end) {
      rests.pop_back();
      continue;
    }
    const Letter& letter = letters_[*rest.next++];
    if (letter.changes && rest.steps > 0)
      rests.push_back({letter.successor.data(), letter.successor.data() + letter.successor.size(),
                       rest.steps - 1});
    else
      obey(letter, take);
  }
}

void LiteralDrawer::obey(const Letter& letter, const TakeSegment& take) {
  const long double degrees = static_cast<long double>(system_.turtle.angle_deg) * letter.sign;
  switch (letter.act) {
    case Act::none:
      return;
    case Act::draw:
    case Act::move:
      return step(letter.act == Act::draw, take);
    case Act::store:
      return stack_.push_back(now_);
    case Act::restore:
      now_ = stack_.back();
      return stack_.pop_back();
    case Act::turn:
      now_.angles += letter.sign;
      if (!planar_) rotate(now_.heading, now_.left, degrees);
      break;
    case Act::half_turn:
      now_.half = !now_.half;
      if (!planar_) rotate(now_.heading, now_.left, 180.0L);
      break;
    case Act::pitch:
      rotate(now_.up, now_.heading, degrees);
      break;
    case Act::roll:
      rotate(now_.up, now_.left, degrees);
      break;
  }
  ++now_.turns;
}

void LiteralDrawer::step(bool draws, const TakeSegment& take) {
  const Vector along = planar_ ? heading() : now_.heading;
  const Vector from = now_.position;
  for (std::size_t k = 0; k < from.size(); ++k) {
    now_.position[k] += static_cast<long double>(system_.turtle.step) * along[k];
    extent_ = std::max(extent_, std::abs(now_.position[k]));
  }
  ++now_.moves;
  if (!draws) return;
  most_moves_ = std::max(most_moves_, now_.moves);
  most_turns_ = std::max(most_turns_, now_.turns);
  take(from, now_.position);
}

void LiteralDrawer::rotate(Vector& a, Vector& b, long double degrees) {
  const long double c = cosine(degrees), s = sine(degrees);
  for (std::size_t k = 0; k < a.size(); ++k) {
    const long double turned = c * a[k] + s * b[k];
    b[k] = c * b[k] - s * a[k];
    a[k] = turned;
  }
}

LiteralDrawer::Vector LiteralDrawer::heading() {
  const auto [known, is_new] = headings_.try_emplace(2 * now_.angles + (now_.half ? 1 : 0));
  if (is_new) {
    const long double degrees =
        (system_.turtle.start == TurtleStart::upwards ? 90.0L : 0.0L) +
        (now_.half ? 180.0L : 0.0L) +
        static_cast<long double>(system_.turtle.angle_deg) * static_cast<long double>(now_.angles);
    known->second = {cosine(degrees), sine(degrees), 0};
  }
  return known->second;
}

}  // namespace phytobench
