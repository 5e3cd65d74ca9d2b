// SPDX-License-Identifier: MIT
// What everybody writes first: strings, a map of productions, and a turtle that reads the last one.
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/derivation_engine.hpp"
#include "core/lsystem/drawing.hpp"

namespace phytobench::derivation_engines {

namespace {

std::string objection_to_strings(const LSystem& system) {
  for (const Symbol& symbol : system.symbols)
    if (symbol.letter.size() != 1 && symbol.letter[0] != '?')
      return "has the letter " + symbol.letter + "; here each is one character";
  return objection_to_streaming(system);
}

char letter(const LSystem& system, SymbolIndex symbol) {
  return system.symbols[symbol].letter[0];
}

struct Rewritten {
  std::string word;
  DrawingWork work;
};

Rewritten rewritten(const LSystem& system, int steps) {
  std::map<char, std::string> productions;
  for (const Production& production : system.productions) {
    std::string successor;
    for (const SuccessorModule& module : production.successor)
      successor += letter(system, module.symbol);
    productions.emplace(letter(system, production.predecessor.symbol), successor);
  }
  Rewritten result;
  for (const AxiomModule& module : system.axiom) result.word += letter(system, module.symbol);
  constexpr std::size_t most_letters = 4'000'000'000;
  for (int step = 1; step <= steps; ++step) {
    std::string next;
    for (const char c : result.word) {
      const auto production = productions.find(c);
      if (production == productions.end())
        next += c;
      else
        next += production->second;
    }
    if (next.size() > most_letters)
      throw InputError(
          fmt::format("{}: the string has {} letters after {} derivations; derive less",
                      system.source, next.size(), step));
    result.work.bytes_held =
        std::max<std::uint64_t>(result.work.bytes_held, result.word.capacity() + next.capacity());
    result.work.modules_made += next.size();
    result.word = std::move(next);
  }
  return result;
}

/// Collects segments and hands them over.
template <class Segment>
class Handover {
 public:
  explicit Handover(const SegmentSink<Segment>& sink) : sink_(sink) { buffer_.reserve(most); }

  void add(const Segment& segment) {
    buffer_.push_back(segment);
    if (buffer_.size() == most) finish();
  }
  void finish() {
    if (!buffer_.empty()) sink_(buffer_);
    buffer_.clear();
  }

 private:
  static constexpr std::size_t most = 512;
  const SegmentSink<Segment>& sink_;
  std::vector<Segment> buffer_;
};

DrawingWork draw_in_plane(const LSystem& system, int steps, int /*threads*/,
                          const SegmentSink<PlanarSegment>& sink) {
  struct Turtle {
    double x = 0.0, y = 0.0, degrees = 0.0;
  };
  const TurtleSettings& settings = system.turtle;
  const Rewritten string = rewritten(system, steps);
  const double left = signs_of(settings.convention).turn * settings.angle_deg;
  Handover<PlanarSegment> handover(sink);
  std::vector<Turtle> stack;
  Turtle turtle{.degrees = settings.start == TurtleStart::upwards ? 90.0 : 0.0};
  for (const char c : string.word) {
    const bool draws = settings.draws.find(c) != std::string::npos;
    if (draws || settings.moves.find(c) != std::string::npos) {
      const PlaneDirection heading = plane_direction(turtle.degrees);
      const PlanarSegment segment{turtle.x, turtle.y, turtle.x + settings.step * heading.x,
                                  turtle.y + settings.step * heading.y};
      turtle.x = segment.to_x;
      turtle.y = segment.to_y;
      if (draws) handover.add(segment);
    } else if (c == '+') {
      turtle.degrees += left;
    } else if (c == '-') {
      turtle.degrees -= left;
    } else if (c == '|') {
      turtle.degrees += 180.0;
    } else if (c == '[') {
      stack.push_back(turtle);
    } else if (c == ']') {
      turtle = stack.back();
      stack.pop_back();
    }
  }
  handover.finish();
  return string.work;
}

/// Turns `a` towards `b`, and `b` away from `a`.
void rotate(Vector3& a, Vector3& b, double degrees) {
  const PlaneDirection by = plane_direction(degrees);
  const Vector3 turned = by.x * a + by.y * b;
  b = by.x * b - by.y * a;
  a = turned;
}

DrawingWork draw_in_space(const LSystem& system, int steps, int /*threads*/,
                          const SegmentSink<SpatialSegment>& sink) {
  struct Turtle {
    Vector3 position, heading, left, up;
  };
  const TurtleSettings& settings = system.turtle;
  const Rewritten string = rewritten(system, steps);
  const TurtleSigns signs = signs_of(settings.convention);
  const double turn = signs.turn * settings.angle_deg, pitch = signs.pitch * settings.angle_deg,
               roll = signs.roll * settings.angle_deg;
  Handover<SpatialSegment> handover(sink);
  std::vector<Turtle> stack;
  Turtle turtle{{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (settings.start == TurtleStart::upwards) turtle = {{}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
  for (const char c : string.word) {
    const bool draws = settings.draws.find(c) != std::string::npos;
    if (draws || settings.moves.find(c) != std::string::npos) {
      const Vector3 from = turtle.position;
      turtle.position = from + settings.step * turtle.heading;
      if (draws) handover.add({from, turtle.position});
      continue;
    }
    switch (c) {
      case '+':
        rotate(turtle.heading, turtle.left, turn);
        break;
      case '-':
        rotate(turtle.heading, turtle.left, -turn);
        break;
      case '|':
        rotate(turtle.heading, turtle.left, 180.0);
        break;
      case '&':
        rotate(turtle.up, turtle.heading, pitch);
        break;
      case '^':
        rotate(turtle.up, turtle.heading, -pitch);
        break;
      case '\\':
        rotate(turtle.up, turtle.left, roll);
        break;
      case '/':
        rotate(turtle.up, turtle.left, -roll);
        break;
      case '[':
        stack.push_back(turtle);
        break;
      case ']':
        turtle = stack.back();
        stack.pop_back();
        break;
      default:
        break;
    }
  }
  handover.finish();
  return string.work;
}

}  // namespace

extern const DerivationEngine string_rewriting;
constinit const DerivationEngine string_rewriting{
    .name = "string_rewriting",
    .summary = "Rewrites a string of letters with a map, and draws the last one with a turtle.",
    .source = "the definition; [Liebemann2017] sec. 2.1 to 2.3",
    .objection = objection_to_strings,
    .draw = draw_in_space,
    .draw_planar = draw_in_plane,
};

}  // namespace phytobench::derivation_engines
