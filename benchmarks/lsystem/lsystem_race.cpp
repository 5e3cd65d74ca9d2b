// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/lsystem_race.hpp"

#include <chrono>
#include <cstring>

#include <fmt/format.h>

#include "benchmarks/lsystem/drawing_judge.hpp"
#include "benchmarks/lsystem/engine_drawing.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/large_array.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

template <class Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Segment>
class DrawingRace {
 public:
  DrawingRace(const DrawingRaceRequest& request, const DrawingJudge& judge)
      : request_(request), workload_(*request.workload), judge_(judge) {}

  std::vector<DrawingEntry> run() {
    for (const DrawingContestant& contestant : request_.contestants)
      static_cast<DrawingContestant&>(entries_.emplace_back()) = contestant;
    for (DrawingEntry& entry : entries_) check(entry);
    for (int round = 0; round < request_.rounds; ++round) {
      CounterStream order(request_.order_seed, static_cast<std::uint64_t>(round));
      for (const std::size_t i : random_order(entries_.size(), order)) time(entries_[i], round);
    }
    return std::move(entries_);
  }

 private:
  using State = DrawingEntry::State;

  void progress(const std::string& what, const DrawingEntry& entry) const {
    if (request_.is_interrupted && request_.is_interrupted()) throw Interrupted("no result");
    if (request_.show_progress)
      request_.show_progress(fmt::format("{}: {} {}", workload_.name, what, entry.engine->name));
  }

  void check(DrawingEntry& entry) {
    if (!entry.engine->built()) return;
    progress("checking", entry);
    entry.objection = entry.engine->objection(workload_.system);
    entry.state = entry.objection.empty() ? State::timed : State::refused;
    if (entry.state == State::refused) return;
    try {
      entry.objection = judge_.disagreement(digest_of(entry));
      if (!entry.objection.empty()) entry.state = State::wrong;
    } catch (const InputError& error) {
      entry.objection = error.what();
      entry.state = State::refused;
    }
  }

  DrawingDigest digest_of(DrawingEntry& entry) {
    DrawingDigest digest;
    if (entry.lane == DrawingLane::stream) {
      entry.bytes_held =
          draw(entry, [&](std::span<const Segment> block) { digest.add(block); }).bytes_held;
    } else {
      array_.resize_for_overwrite(workload_.segments);
      std::memset(static_cast<void*>(array_.data()), 0xff, array_.size() * sizeof(Segment));
      const std::uint64_t written = write(entry);
      if (written == workload_.segments)
        digest.add(std::span<const Segment>(array_.data(), array_.size()));
      else
        for (std::uint64_t i = 0; i < written; ++i) digest.add(DrawingDigest::Ends{});
    }
    return digest;
  }

  DrawingWork draw(const DrawingEntry& entry, const SegmentSink<Segment>& sink) const {
    return draw_function<Segment>(*entry.engine)(workload_.system, workload_.steps, entry.threads,
                                                 sink);
  }

  /// Returns how many segments there were; more than expected are not written.
  std::uint64_t write(DrawingEntry& entry) {
    const std::span<Segment> out(array_.data(), array_.size());
    if (const auto function = write_function<Segment>(*entry.engine)) {
      entry.bytes_held = function(workload_.system, workload_.steps, entry.threads, out).bytes_held;
      return out.size();
    }
    const CopiedDrawing copied = copy_drawing(*entry.engine, workload_, entry.threads, out);
    entry.bytes_held = copied.work.bytes_held;
    return copied.segments;
  }

  void time(DrawingEntry& entry, int round) {
    if (entry.state != State::timed) return;
    progress(fmt::format("round {}:", round + 1), entry);
    entry.seconds.push_back(seconds_of([&] {
      if (entry.lane == DrawingLane::memory) {
        write(entry);
        return;
      }
      // One number of each block, so that nobody can leave the blocks out.
      double sum = 0.0;
      draw(entry, [&](std::span<const Segment> block) { sum += ends_of(block.back())[3]; });
      volatile double seen = sum;
      static_cast<void>(seen);
    }));
  }

  const DrawingRaceRequest& request_;
  const LSystemWorkload& workload_;
  const DrawingJudge& judge_;
  std::vector<DrawingEntry> entries_;
  LargeArray<Segment> array_;
};

}  // namespace

std::string_view name_of(DrawingLane lane) {
  return lane == DrawingLane::stream ? "stream" : "memory";
}

std::vector<DrawingContestant> drawing_contestants(
    const std::vector<const DerivationEngine*>& engines, const std::vector<int>& threads) {
  std::vector<DrawingContestant> all;
  for (const DrawingLane lane : {DrawingLane::stream, DrawingLane::memory})
    for (const DerivationEngine* engine : engines) {
      const bool uses_threads =
          lane == DrawingLane::stream ? engine->uses_threads : engine->uses_threads_to_write;
      if (!uses_threads)
        all.push_back({engine, 1, lane});
      else
        for (const int count : threads) all.push_back({engine, count, lane});
    }
  return all;
}

DrawingRaceResult race_drawings(const DrawingRaceRequest& request) {
  if (request.show_progress) request.show_progress(request.workload->name + ": asking the oracle");
  const DrawingJudge judge(*request.workload);
  DrawingRaceResult result;
  result.planar = judge.planar();
  result.bound = judge.bound();
  result.entries = judge.planar() ? DrawingRace<PlanarSegment>(request, judge).run()
                                  : DrawingRace<SpatialSegment>(request, judge).run();
  return result;
}

}  // namespace phytobench
