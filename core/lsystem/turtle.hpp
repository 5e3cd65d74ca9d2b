// SPDX-License-Identifier: MIT
// The turtle that draw, turtle_tree and answer_queries share: it walks, and an actor takes down
// what it does.
#pragma once

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/contract/check.hpp"
#include "core/lsystem/turtle_commands.hpp"
#include "core/lsystem/turtle_poses.hpp"

namespace phytobench {

/// Whether the system has no symbol that leaves the plane: & ^ \ / $.
bool is_planar(const LSystem& system);

/// Stored states at most; deeper words are refused.
inline constexpr std::size_t most_turtle_states = 1'000'000;
/// No coordinate gets larger, so that later squares are finite and single precision holds them.
inline constexpr double turtle_reach = 1e30;

/// What the turtle draws with.
struct TurtlePen {
  double width = 1.0;
  std::uint16_t colour = 0;
};

/// An actor that takes nothing down. Others hide what they need; nothing here is virtual.
struct TurtleActor {
  /// What [ stores and ] restores for the actor.
  struct Mark {};

  void segment(const Vector3& /*from*/, const Vector3& /*to*/, const TurtlePen& /*pen*/,
               Mark& /*mark*/) {}
  void open_polygon(const TurtlePen& /*pen*/) {}
  void corner(const Vector3& /*position*/) {}  ///< the first one where { stands
  void close_polygon() {}
  /// A query symbol whose parameters begin at that index of Word::parameters.
  void query(std::size_t /*first_parameter*/, std::size_t /*count*/, const Vector3& /*answer*/) {}
  void end(const Vector3& /*position*/, const TurtleFrame& /*frame*/) {}
};

/// Errors that a user can make; they throw InputError.
[[noreturn]] void refuse_nested_polygon(const LSystem& system);
[[noreturn]] void refuse_lone_brace(const LSystem& system);
[[noreturn]] void refuse_open_polygon(const LSystem& system);
[[noreturn]] void refuse_deep_word(const LSystem& system);
[[noreturn]] void refuse_reach(const LSystem& system);
double checked_width(const LSystem& system, double width);
std::uint16_t checked_colour(const LSystem& system, double colour);

template <class Moves, class Actor>
class TurtleWalk {
 public:
  TurtleWalk(const LSystem& system, const Word& word, const TurtleCommands& commands, Moves& moves,
             Actor& actor)
      : system_(system), word_(word), commands_(commands), moves_(moves), actor_(actor) {}

  void run() {
    State state{moves_.start(), {system_.turtle.width, 0}, {}};
    const double* parameters = word_.parameters.data();
    for (std::size_t i = 0, end = word_.size(); i < end; ++i) {
      const TurtleCommand& command = commands_.of[word_.symbols[i]];
      if (command.action == TurtleAction::cut) {
        skip_branch(i, parameters);
        continue;
      }
      obey(command, parameters, state);
      parameters += command.arity;
    }
    PHYTOBENCH_EXPECT(parameters == word_.parameters.data() + word_.parameters.size());
    PHYTOBENCH_EXPECT(stack_.empty());
    if (in_polygon_) refuse_open_polygon(system_);
    actor_.end(moves_.position(state.pose), moves_.frame(state.pose));
  }

 private:
  struct State {
    typename Moves::Pose pose;
    TurtlePen pen;
    [[no_unique_address]] typename Actor::Mark mark;
  };

  void obey(const TurtleCommand& command, const double* parameters, State& state) {
    switch (command.action) {
      case TurtleAction::nothing:
      case TurtleAction::cut:
        return;
      case TurtleAction::draw:
        return walk<true>(command, parameters, state);
      case TurtleAction::move:
        return walk<false>(command, parameters, state);
      case TurtleAction::turn:
        return moves_.turn(state.pose, command, parameters);
      case TurtleAction::turn_back:
        return moves_.turn_back(state.pose);
      case TurtleAction::pitch:
      case TurtleAction::roll:
      case TurtleAction::level:
        return leave_plane(command, parameters, state);
      case TurtleAction::store:
        return store(state);
      case TurtleAction::restore:
        PHYTOBENCH_EXPECT(!stack_.empty());
        state = stack_.back();
        return stack_.pop_back();
      default:
        return obey_rare(command, parameters, state);
    }
  }

  void obey_rare(const TurtleCommand& command, const double* parameters, State& state) {
    switch (command.action) {
      case TurtleAction::open_polygon:
        if (in_polygon_) refuse_nested_polygon(system_);
        in_polygon_ = true;
        actor_.open_polygon(state.pen);
        return actor_.corner(moves_.position(state.pose));
      case TurtleAction::close_polygon:
        if (!in_polygon_) refuse_lone_brace(system_);
        in_polygon_ = false;
        return actor_.close_polygon();
      case TurtleAction::corner:
        if (in_polygon_) actor_.corner(moves_.position(state.pose));
        return;
      case TurtleAction::width:
        state.pen.width = checked_width(
            system_, command.arity == 0 ? state.pen.width * command.amount : parameters[0]);
        return;
      case TurtleAction::colour:
        state.pen.colour = command.arity == 0 ? next_colour(state.pen.colour)
                                              : checked_colour(system_, parameters[0]);
        return;
      default:
        return answer(command, parameters, state);
    }
  }

  template <bool draws>
  void walk(const TurtleCommand& command, const double* parameters, State& state) {
    if constexpr (draws)
      if (command.arity >= 2) state.pen.width = checked_width(system_, parameters[1]);
    const Vector3 from = moves_.position(state.pose);
    moves_.move(state.pose, command.value(parameters));
    const Vector3 to = moves_.position(state.pose);
    if (!is_in_reach(to)) [[unlikely]]
      refuse_reach(system_);
    if constexpr (draws) actor_.segment(from, to, state.pen, state.mark);
    if (in_polygon_) actor_.corner(to);
  }

  /// Not a number counts as out of reach.
  static bool is_in_reach(const Vector3& p) {
    return std::abs(p.x) <= turtle_reach && std::abs(p.y) <= turtle_reach &&
           (Moves::planar || std::abs(p.z) <= turtle_reach);
  }

  void leave_plane(const TurtleCommand& command, const double* parameters, State& state) {
    if constexpr (Moves::planar) {
      PHYTOBENCH_EXPECT(!Moves::planar);  // interpret() has chosen by the symbols
    } else {
      if (command.action == TurtleAction::pitch) moves_.pitch(state.pose, command, parameters);
      if (command.action == TurtleAction::roll) moves_.roll(state.pose, command, parameters);
      if (command.action == TurtleAction::level) moves_.level(state.pose);
    }
  }

  void store(const State& state) {
    if (stack_.size() == most_turtle_states) refuse_deep_word(system_);
    const State copy = state;  // lets the compiler keep `state` in registers
    stack_.push_back(copy);
  }

  /// From the % at i to before the ] that ends its branch, or to the end of the word. A polygon
  /// that is open ends where its } would be.
  void skip_branch(std::size_t& i, const double*& parameters) {
    std::size_t branches = 0, polygons = 0;
    for (;; ++i) {
      parameters += commands_.of[word_.symbols[i]].arity;
      if (i + 1 == word_.size()) return;
      const TurtleAction next = commands_.of[word_.symbols[i + 1]].action;
      if (next == TurtleAction::restore && branches-- == 0) return;
      if (next == TurtleAction::store) ++branches;
      if (next == TurtleAction::open_polygon) ++polygons;
      if (next != TurtleAction::close_polygon) continue;
      if (polygons > 0)
        --polygons;
      else if (std::exchange(in_polygon_, false))
        actor_.close_polygon();
    }
  }

  void answer(const TurtleCommand& command, const double* parameters, const State& state) {
    const TurtleFrame frame = moves_.frame(state.pose);
    Vector3 said = moves_.position(state.pose);
    if (command.action == TurtleAction::query_heading) said = frame.heading;
    if (command.action == TurtleAction::query_left) said = frame.left;
    if (command.action == TurtleAction::query_up) said = frame.up;
    actor_.query(static_cast<std::size_t>(parameters - word_.parameters.data()), command.arity,
                 said);
  }

  static std::uint16_t next_colour(std::uint16_t colour) {
    return static_cast<std::uint16_t>(colour == 0xffff ? colour : colour + 1);
  }

  const LSystem& system_;
  const Word& word_;
  const TurtleCommands& commands_;
  Moves& moves_;
  Actor& actor_;
  std::vector<State> stack_;
  bool in_polygon_ = false;
};

/// Lets the turtle walk along a word. `commands` is turtle_commands(system). Throws InputError for
/// polygons that nest or do not match, too many stored states, a width or colour that is none, and
/// coordinates beyond turtle_reach. Brackets must match.
template <class Actor>
void interpret(const LSystem& system, TurtleCommands& commands, const Word& word, Actor& actor) {
  const auto walk_with = [&](auto moves) {
    TurtleWalk<decltype(moves), Actor>(system, word, commands, moves, actor).run();
  };
  if (!commands.planar)
    walk_with(SpaceFrame(system.turtle));
  else if (auto table = PlaneTable::of(system.turtle, commands))
    walk_with(*std::move(table));
  else
    walk_with(PlaneAngle(system.turtle));
}

}  // namespace phytobench
