// SPDX-License-Identifier: MIT
#include "core/contract/errors.hpp"
#include "core/lsystem/drawing.hpp"
#include "core/lsystem/turtle.hpp"

namespace phytobench {

namespace {

/// Whether the turtle has left its node. One that came back, along the outline of a leaf, stands
/// there up to rounding.
bool is_adrift(const Vector3& node, const Vector3& from, const Vector3& to) {
  constexpr double share_of_length = 1e-6;
  return from != node && !(norm(from - node) <= share_of_length * norm(to - from));
}

struct TreeActor : TurtleActor {
  using Mark = std::int32_t;  // the node where the turtle stands

  TreeActor(const LSystem& of, TurtleTree& all) : system(of), tree(all) {}

  void segment(const Vector3& from, const Vector3& to, const TurtlePen& pen, Mark& mark) {
    if (is_adrift(tree.skeleton.position(mark), from, to))
      throw InputError(system.source +
                       ": the turtle draws after a move without drawing, so that its lines are no "
                       "connected tree; let it draw there, or go back before");
    mark = tree.skeleton.append(mark, to);
    tree.widths.push_back(static_cast<float>(pen.width));
    tree.colours.push_back(pen.colour);
  }

  const LSystem& system;
  TurtleTree& tree;
};

}  // namespace

TurtleTree turtle_tree(const LSystem& system, const Word& word) {
  TurtleCommands commands = turtle_commands(system);
  TurtleTree tree;
  tree.width_source = width_source(system, commands, word);
  const std::size_t nodes = count_drawing_modules(commands, word) + 1;
  tree.skeleton.reserve(nodes);
  tree.widths.reserve(nodes);
  tree.colours.reserve(nodes);
  tree.widths.push_back(static_cast<float>(system.turtle.width));
  tree.colours.push_back(0);
  TreeActor actor(system, tree);
  interpret(system, commands, word, actor);
  if (tree.widths.size() > 1) {
    tree.widths[0] = tree.widths[1];
    tree.colours[0] = tree.colours[1];
  }
  return tree;
}

}  // namespace phytobench
