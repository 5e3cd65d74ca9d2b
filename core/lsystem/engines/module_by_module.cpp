// SPDX-License-Identifier: MIT
#include <vector>

#include "core/lsystem/derivation_engine.hpp"
#include "core/lsystem/derive.hpp"
#include "core/lsystem/turtle.hpp"

namespace phytobench::derivation_engines {

namespace {

constexpr std::uint64_t most_modules = 4'000'000'000;

PlanarSegment segment_between(const Vector3& from, const Vector3& to, PlanarSegment*) {
  return {from.x, from.y, to.x, to.y};
}
SpatialSegment segment_between(const Vector3& from, const Vector3& to, SpatialSegment*) {
  return {from, to};
}

/// Hands over what draw() would keep.
template <class Segment>
struct HandoverActor : TurtleActor {
  static constexpr std::size_t most = 512;

  explicit HandoverActor(const SegmentSink<Segment>& taker) : sink(taker) { buffer.reserve(most); }

  void segment(const Vector3& from, const Vector3& to, const TurtlePen&, Mark&) {
    constexpr Segment* kind = nullptr;
    buffer.push_back(segment_between(from, to, kind));
    if (buffer.size() == most) hand_over();
  }
  void end(const Vector3&, const TurtleFrame&) {
    if (!buffer.empty()) hand_over();
  }
  void hand_over() {
    sink(buffer);
    buffer.clear();
  }

  const SegmentSink<Segment>& sink;
  std::vector<Segment> buffer;
};

template <class Segment>
DrawingWork draw_segments(const LSystem& system, int steps, int threads,
                          const SegmentSink<Segment>& sink) {
  DeriveOptions options;
  options.steps = steps;
  options.threads = threads;
  options.seed = system.seed;
  options.most_modules = most_modules;
  options.most_parameters = most_modules;
  DerivationWork work;
  options.work = &work;
  const Word word = derive(system, options);
  TurtleCommands commands = turtle_commands(system);
  HandoverActor<Segment> actor(sink);
  interpret(system, commands, word, actor);
  return {.bytes_held = word.bytes(), .modules_made = work.modules_written};
}

std::string no_objection(const LSystem& /*system*/) {
  return "";
}

}  // namespace

extern const DerivationEngine module_by_module;
constinit const DerivationEngine module_by_module{
    .name = "module_by_module",
    .summary = "Derives the word of any system, a byte a module, and then lets the turtle walk it.",
    .source = "[Liebemann2017] sec. 2.2 and 2.3, by the same derivation and turtle as derive",
    .uses_threads = true,
    .uses_threads_to_write = true,
    .objection = no_objection,
    .draw = draw_segments<SpatialSegment>,
    .draw_planar = draw_segments<PlanarSegment>,
};

}  // namespace phytobench::derivation_engines
