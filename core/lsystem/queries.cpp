// SPDX-License-Identifier: MIT
#include <algorithm>

#include "core/lsystem/drawing.hpp"
#include "core/lsystem/turtle.hpp"

namespace phytobench {

namespace {

struct QueryActor : TurtleActor {
  explicit QueryActor(double* of_word) : parameters(of_word) {}

  void query(std::size_t first, std::size_t count, const Vector3& answer) {
    const double coordinates[] = {answer.x, answer.y, answer.z};
    std::copy_n(coordinates, std::min<std::size_t>(count, 3), parameters + first);
  }

  double* parameters;
};

}  // namespace

void answer_queries(const LSystem& system, Word& word) {
  TurtleCommands commands = turtle_commands(system);
  if (!commands.queries) return;
  QueryActor actor(word.parameters.data());
  interpret(system, commands, word, actor);
}

}  // namespace phytobench
