// SPDX-License-Identifier: MIT
#include "core/lsystem/segment_stream.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/lsystem/drawing_walk.hpp"
#include "core/lsystem/growth_counter.hpp"
#include "core/lsystem/turtle.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

/// Segments that a sink gets at a time, about: with the kept drawing that is being moved they stay
/// in the first cache.
constexpr std::size_t sink_segments = 512;

/// Larger arrays are no longer in any cache when they are read.
constexpr std::size_t cached_bytes = std::size_t{1} << 25;

/// What one thread writes at a time, at least.
constexpr std::uint64_t task_segments = 65'536;

void put(std::span<const PlanarSegment> drawing, SpatialSegment* out) {
  for (const PlanarSegment& s : drawing)
    *out++ = {{s.from_x, s.from_y, 0.0}, {s.to_x, s.to_y, 0.0}};
}

std::uint64_t modules_after(const LSystem& system, int steps) {
  GrowthCounter counter(system);
  for (int step = 0; step < steps; ++step) counter.advance();
  return counter.modules();
}

/// Kept drawings of one kind of turtle, and how to go through them.
template <class Turtle>
class Streamer {
 public:
  static constexpr std::uint32_t most_segments = DrawingBlocks<Turtle>::most_segments;

  Streamer(const LSystem& system, const SymbolDrawings& drawings)
      : drawings_(drawings), turtle_(system.turtle), kept_(drawings, turtle_) {}

  std::size_t bytes() const { return kept_.blocks().bytes(); }

  template <class Segment>
  std::uint64_t stream(const SegmentSink<Segment>& sink) const {
    std::vector<Segment> buffer(sink_segments + most_segments);
    Walk walk = start();
    while (!walk.finished()) {
      Segment* const end = write(walk, sink_segments, buffer.data(), Stores::cached);
      if (end != buffer.data()) sink(std::span<const Segment>(buffer.data(), end));
    }
    return walk.parts_taken();
  }

  template <class Segment>
  std::uint64_t write(std::span<Segment> out, int threads) const {
    const Stores stores = out.size_bytes() > cached_bytes ? Stores::past_cache : Stores::cached;
    std::vector<Task> tasks = tasks_of(out.size(), threads);
    for_tasks(tasks.size(), threads, [&](std::size_t i) {
      Walk walk = tasks[i].walk;
      write(walk, tasks[i].segments, out.data() + tasks[i].first, stores);
      tasks[i].parts_taken = walk.parts_taken() - tasks[i].walk.parts_taken();
      if (stores == Stores::past_cache) finish_stores();
    });
    std::uint64_t parts_taken = 0;
    for (const Task& task : tasks) parts_taken += task.parts_taken;
    return parts_taken;
  }

 private:
  using Walk = DrawingWalk<Turtle>;
  using Entry = typename Walk::Entry;
  using State = typename Walk::State;

  struct Task {
    Walk walk;  ///< as far as where the task begins
    std::uint64_t first = 0;
    std::uint64_t segments = 0;
    std::uint64_t parts_taken = 0;
  };

  Walk start() const {
    return {drawings_, kept_.entries(), turtle_, drawings_.parts_of_axiom(), turtle_.start()};
  }

  /// Goes ahead as all tasks will, without writing, so that each starts with the same bits.
  std::vector<Task> tasks_of(std::uint64_t segments, int threads) const {
    constexpr std::uint64_t tasks_per_thread = 16;  // they take turns where some are slower
    if (threads <= 1 || segments <= task_segments) return {{start(), 0, segments, 0}};
    const auto parts = static_cast<std::uint64_t>(threads) * tasks_per_thread;
    const std::uint64_t enough = std::max(task_segments, segments / parts + 1);
    std::vector<Task> tasks;
    std::uint64_t first = 0;
    for (Walk walk = start(); !walk.finished();) {
      tasks.push_back({walk, first, 0, 0});
      tasks.back().segments = walk.run(enough, [](const Entry&, const State&) {});
      first += tasks.back().segments;
    }
    return tasks;
  }

  /// Writes at least `enough` segments, or all that are left; returns the end of what it wrote.
  typename Turtle::Segment* write(Walk& walk, std::uint64_t enough, typename Turtle::Segment* out,
                                  Stores stores) const {
    walk.run(enough, [&](const Entry& entry, const State& state) {
      turtle_.write(kept_.blocks(), entry.first, entry.count, state, out, stores);
      out += entry.count;
    });
    return out;
  }

  /// Of a planar system in space.
  template <class Segment>
  requires(!std::is_same_v<Segment, typename Turtle::Segment>) Segment* write(Walk& walk,
                                                                              std::uint64_t enough,
                                                                              Segment* out,
                                                                              Stores) const {
    std::array<typename Turtle::Segment, most_segments> block;
    walk.run(enough, [&](const Entry& entry, const State& state) {
      turtle_.write(kept_.blocks(), entry.first, entry.count, state, block.data(), Stores::cached);
      put(std::span(block).first(entry.count), out);
      out += entry.count;
    });
    return out;
  }

  const SymbolDrawings& drawings_;
  Turtle turtle_;
  DrawingBlocks<Turtle> kept_;
};

}  // namespace

struct SegmentStream::Parts {
  Parts(const LSystem& system, int steps)
      : drawings(system, steps), modules(modules_after(system, steps)) {
    if (is_planar(system))
      plane.emplace(system, drawings);
    else
      space.emplace(system, drawings);
  }
  Parts(const Parts&) = delete;  // both turtles refer to the drawings
  Parts& operator=(const Parts&) = delete;

  SymbolDrawings drawings;
  std::uint64_t modules;
  std::optional<Streamer<PlaneTurtle>> plane;
  std::optional<Streamer<SpaceTurtle>> space;
};

SegmentStream::SegmentStream(const LSystem& system, int steps) {
  if (const std::string objection = objection_to_streaming(system); !objection.empty())
    throw InputError(system.source + ": " + objection);
  parts_ = std::make_unique<Parts>(system, steps);
}

SegmentStream::~SegmentStream() = default;
SegmentStream::SegmentStream(SegmentStream&&) noexcept = default;
SegmentStream& SegmentStream::operator=(SegmentStream&&) noexcept = default;

bool SegmentStream::planar() const {
  return parts_->plane.has_value();
}

std::uint64_t SegmentStream::segment_count() const {
  return parts_->drawings.segments();
}

std::uint64_t SegmentStream::module_count() const {
  return parts_->modules;
}

std::size_t SegmentStream::block_bytes() const {
  return parts_->plane ? parts_->plane->bytes() : parts_->space->bytes();
}

std::uint64_t SegmentStream::stream(const SegmentSink<PlanarSegment>& sink) const {
  PHYTOBENCH_EXPECT(planar());
  return parts_->plane->stream(sink);
}

std::uint64_t SegmentStream::write(std::span<PlanarSegment> out, int threads) const {
  PHYTOBENCH_EXPECT(planar() && out.size() == segment_count());
  return parts_->plane->write(out, threads);
}

std::uint64_t SegmentStream::stream(const SegmentSink<SpatialSegment>& sink) const {
  return planar() ? parts_->plane->stream(sink) : parts_->space->stream(sink);
}

std::uint64_t SegmentStream::write(std::span<SpatialSegment> out, int threads) const {
  PHYTOBENCH_EXPECT(out.size() == segment_count());
  return planar() ? parts_->plane->write(out, threads) : parts_->space->write(out, threads);
}

}  // namespace phytobench
