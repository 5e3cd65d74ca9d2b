// SPDX-License-Identifier: MIT
#include "core/lsystem/turtle_commands.hpp"

#include <algorithm>
#include <string_view>

namespace phytobench {

namespace {

bool is_one_of(const std::string& letter, const std::string& letters) {
  return letter.size() == 1 && letters.find(letter[0]) != std::string::npos;
}

struct Meaning {
  std::string_view letter;
  TurtleAction action;
  double sign = 1.0;
};

/// In the convention of the books' words: left, down and roll left are positive.
constexpr Meaning meanings[] = {
    {"+", TurtleAction::turn},
    {"-", TurtleAction::turn, -1.0},
    {"&", TurtleAction::pitch},
    {"^", TurtleAction::pitch, -1.0},
    {"\\", TurtleAction::roll},
    {"/", TurtleAction::roll, -1.0},
    {"|", TurtleAction::turn_back},
    {"$", TurtleAction::level},
    {"[", TurtleAction::store},
    {"]", TurtleAction::restore},
    {"{", TurtleAction::open_polygon},
    {"}", TurtleAction::close_polygon},
    {".", TurtleAction::corner},
    {"!", TurtleAction::width},
    {"'", TurtleAction::colour},
    {"%", TurtleAction::cut},
    {"?P", TurtleAction::query_position},
    {"?H", TurtleAction::query_heading},
    {"?L", TurtleAction::query_left},
    {"?U", TurtleAction::query_up},
};

double convention_sign(TurtleAction action, const TurtleSigns& signs) {
  if (action == TurtleAction::turn) return signs.turn;
  if (action == TurtleAction::pitch) return signs.pitch;
  return action == TurtleAction::roll ? signs.roll : 1.0;
}

bool is_turn_about_an_axis(TurtleAction action) {
  return action == TurtleAction::turn || action == TurtleAction::pitch ||
         action == TurtleAction::roll;
}

TurtleCommand command_of(const Symbol& symbol, const TurtleSettings& turtle) {
  TurtleCommand command;
  command.arity = symbol.arity;
  command.amount = turtle.step;
  if (is_one_of(symbol.letter, turtle.draws)) {
    command.action = TurtleAction::draw;
    return command;
  }
  if (is_one_of(symbol.letter, turtle.moves)) {
    command.action = TurtleAction::move;
    return command;
  }
  for (const Meaning& meaning : meanings) {
    if (meaning.letter != symbol.letter) continue;
    command.action = meaning.action;
    command.sign = meaning.sign * convention_sign(meaning.action, signs_of(turtle.convention));
  }
  if (is_turn_about_an_axis(command.action)) command.amount = command.sign * turtle.angle_deg;
  if (command.action == TurtleAction::width) command.amount = turtle.width_factor;
  return command;
}

WidthSource width_source(const TurtleCommand& command) {
  const bool sets = command.action == TurtleAction::width;
  const bool draws = command.action == TurtleAction::draw;
  if ((sets && command.arity >= 1) || (draws && command.arity >= 2)) return WidthSource::given;
  return sets ? WidthSource::proportion : WidthSource::nowhere;
}

}  // namespace

TurtleCommands turtle_commands(const LSystem& system) {
  TurtleCommands commands;
  for (std::size_t i = 0; i < system.symbols.size(); ++i) {
    TurtleCommand& command = commands.of[i];
    command = command_of(system.symbols[i], system.turtle);
    const TurtleAction action = command.action;
    if (action == TurtleAction::pitch || action == TurtleAction::roll ||
        action == TurtleAction::level)
      commands.planar = false;
    if (action == TurtleAction::turn && command.arity > 0) commands.turns_by_parameters = true;
    if (action >= TurtleAction::query_position) commands.queries = true;
  }
  return commands;
}

std::size_t count_drawing_modules(const TurtleCommands& commands, const Word& word) {
  std::array<std::uint8_t, most_symbols> draws{};
  for (std::size_t i = 0; i < draws.size(); ++i)
    draws[i] = commands.of[i].action == TurtleAction::draw;
  std::size_t count = 0;
  for (std::size_t i = 0; i < word.size(); ++i) count += draws[word.symbols[i]];
  return count;
}

WidthSource width_source(const LSystem& system, const TurtleCommands& commands, const Word& word) {
  if (system.turtle.width_is_given) return WidthSource::given;
  std::array<WidthSource, most_symbols> sources{};
  for (std::size_t i = 0; i < sources.size(); ++i) sources[i] = width_source(commands.of[i]);
  const WidthSource most = *std::max_element(sources.begin(), sources.end());
  WidthSource found = WidthSource::nowhere;
  for (std::size_t i = 0; found < most && i < word.size(); ++i)
    found = std::max(found, sources[word.symbols[i]]);
  return found;
}

}  // namespace phytobench
