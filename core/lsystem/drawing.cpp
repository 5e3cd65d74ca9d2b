// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing.hpp"

#include "core/lsystem/turtle.hpp"

namespace phytobench {

namespace {

struct DrawingActor : TurtleActor {
  explicit DrawingActor(Drawing& all) : drawing(all) {}

  void segment(const Vector3& from, const Vector3& to, const TurtlePen& pen, Mark&) {
    const TurtleSegment drawn{from, to, static_cast<float>(pen.width), pen.colour};
    drawing.segments.push_back(drawn);
  }
  void open_polygon(const TurtlePen& pen) {
    drawing.polygons.push_back({drawing.corners.size(), 0, pen.colour});
  }
  void corner(const Vector3& position) {
    drawing.corners.push_back(position);
    ++drawing.polygons.back().count;
  }
  void end(const Vector3& position, const TurtleFrame& frame) {
    drawing.end = position;
    drawing.end_frame = frame;
  }

  Drawing& drawing;
};

}  // namespace

Drawing draw(const LSystem& system, const Word& word) {
  TurtleCommands commands = turtle_commands(system);
  Drawing drawing;
  drawing.planar = commands.planar;
  drawing.width_source = width_source(system, commands, word);
  drawing.segments.reserve(count_drawing_modules(commands, word));
  DrawingActor actor(drawing);
  interpret(system, commands, word, actor);
  return drawing;
}

}  // namespace phytobench
