// SPDX-License-Identifier: MIT
// Statistics of point patterns, and the sampler that most of them start from.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "benchmarks/regression/checks/pattern_checks.hpp"
#include "benchmarks/regression/families/kernel_digest.hpp"
#include "benchmarks/regression/watched_benchmarks.hpp"
#include "core/point_pattern/close_pairs.hpp"
#include "core/point_pattern/dart_throwing.hpp"
#include "core/point_pattern/nearest_distances.hpp"
#include "core/point_pattern/random_patterns.hpp"
#include "core/point_pattern/ripley.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench::families {

namespace {

constexpr std::uint64_t seed = 8;
constexpr Rectangle plot{{0.0, 0.0}, {3.0, 2.0}};

/// What all have in common: random points in a plot with edges.
class PatternKernel : public WatchedKernel {
 public:
  explicit PatternKernel(std::size_t count) : window_(Window::rectangle(plot)) {
    CounterStream stream(seed, 0);
    points_ = uniform_points(window_, count, stream);
  }

  std::string inputs() const override {
    return KernelDigest()
        .add(points_)
        .add({plot.low.x, plot.low.y, plot.high.x, plot.high.y})
        .hex();
  }

 protected:
  Window window_;
  std::vector<Point2> points_;
};

class HopkinsKernel final : public PatternKernel {
 public:
  using PatternKernel::PatternKernel;

  void run() override { index_ = hopkins_exact(points_, window_); }
  std::string answer() const override {
    return KernelDigest().add({index_.mean_ratio, index_.squared_ratio}).hex();
  }
  WorkCounts work() const override { return {{"cells", points_.size()}}; }
  std::string objection() override { return objection_to_hopkins(index_, points_, plot); }

 private:
  HopkinsIndex index_;
};

class RipleyKernel final : public PatternKernel {
 public:
  explicit RipleyKernel(std::size_t count)
      : PatternKernel(count), distances_(default_distances(count, window_)) {}

  std::string inputs() const override {
    return KernelDigest().add(PatternKernel::inputs()).add(distances_).hex();
  }
  void run() override {
    values_ = ripley_k(points_, window_, distances_, EdgeCorrection::translation);
  }
  std::string answer() const override { return KernelDigest().add(values_).hex(); }
  WorkCounts work() const override {
    const auto pairs = close_pair_counts(points_, window_, distances_).back();
    return {{"pairs", static_cast<std::uint64_t>(pairs)}};
  }
  std::string objection() override {
    return objection_to_ripley_k(values_, points_, plot, distances_);
  }

 private:
  std::vector<double> distances_, values_;
};

class NearestKernel final : public PatternKernel {
 public:
  using PatternKernel::PatternKernel;

  void run() override { distances_ = nearest_distances(points_, window_); }
  std::string answer() const override { return KernelDigest().add(distances_).hex(); }
  WorkCounts work() const override { return {{"queries", distances_.size()}}; }
  std::string objection() override { return objection_to_nearest_distances(distances_, points_); }

 private:
  std::vector<double> distances_;
};

/// Numbers taken from another stream.
class CountedStream final : public UnitStream {
 public:
  explicit CountedStream(UnitStream& stream) : stream_(stream) {}
  double next_unit() override {
    ++taken_;
    return stream_.next_unit();
  }
  std::uint64_t taken() const { return taken_; }

 private:
  UnitStream& stream_;
  std::uint64_t taken_ = 0;
};

/// Until no further dart fits.
class DartKernel final : public WatchedKernel {
 public:
  explicit DartKernel(double darts)
      : window_(Window::rectangle(plot)),
        distance_(std::sqrt(jamming_coverage * plot.area() / darts)) {}

  std::string inputs() const override {
    return KernelDigest()
        .add({plot.low.x, plot.low.y, plot.high.x, plot.high.y, distance_, digest_number(seed)})
        .hex();
  }
  void run() override {
    CounterStream stream(seed, 0);
    darts_ = dart_points(window_, distance_, until_saturated, stream);
  }
  std::string answer() const override { return KernelDigest().add(darts_).hex(); }
  WorkCounts work() const override {
    CounterStream stream(seed, 0);
    CountedStream counted(stream);
    dart_points(window_, distance_, until_saturated, counted);
    return {{"darts", darts_.size()}, {"random_numbers", counted.taken()}};
  }
  std::string objection() override { return objection_to_darts(darts_, window_, distance_, seed); }

 private:
  static constexpr double jamming_coverage = 0.6966;  // see dart_throwing.hpp

  Window window_;
  double distance_;
  std::vector<Point2> darts_;
};

template <class Kernel, class Size>
WatchedBenchmark pattern_benchmark(const char* name, std::string summary, Size size) {
  return {.name = std::string("point-pattern/") + name,
          .summary = std::move(summary),
          .is_own = true,
          .prepare = [size] { return std::make_unique<Kernel>(size); }};
}

std::vector<WatchedBenchmark> list_patterns(const FamilyRequest&) {
  constexpr std::size_t few = 2000, many = 8000;
  return {
      pattern_benchmark<HopkinsKernel>(
          "hopkins-exact",
          fmt::format("The Hopkins index of {} points by integration over Voronoi cells.", few),
          few),
      pattern_benchmark<RipleyKernel>(
          "ripley-k", fmt::format("Ripley's K of {} points with the translation correction.", few),
          few),
      pattern_benchmark<NearestKernel>(
          "nearest-distances",
          fmt::format("Distance of each of {} points to the nearest other one.", many), many),
      pattern_benchmark<DartKernel>(
          "dart-throwing", fmt::format("A maximal hard-core pattern of about {} points.", few),
          static_cast<double>(few)),
  };
}

}  // namespace

extern const BenchmarkFamily point_pattern;
constinit const BenchmarkFamily point_pattern{
    .name = "point_pattern",
    .summary = "Statistics of point patterns, and throwing darts.",
    .list = list_patterns,
};

}  // namespace phytobench::families
