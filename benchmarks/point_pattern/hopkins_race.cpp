// SPDX-License-Identifier: MIT
#include "benchmarks/point_pattern/hopkins_race.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "benchmarks/point_pattern/kdtree_hopkins.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/point_pattern/nearest_distances.hpp"
#include "core/point_pattern/random_patterns.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

class Race {
 public:
  explicit Race(const HopkinsRaceRequest& request)
      : request_(request), window_(Window::rectangle(request.window)) {
    PHYTOBENCH_EXPECT(request.points.size() >= 2);
    CounterStream stream(request.seed, 0);
    places_ = uniform_points(window_, request.points.size(), stream);
    list_ways();
  }

  std::vector<HopkinsWay> run() {
    check();
    for (int round = 0; round < request_.rounds; ++round) {
      CounterStream stream(request_.seed, 1 + static_cast<std::uint64_t>(round));
      for (const std::size_t w : random_order(ways_.size(), stream)) time(w, round);
    }
    return std::move(ways_);
  }

 private:
  using Work = std::function<HopkinsIndex()>;

  void add(std::string name, Work work) {
    ways_.push_back({.name = std::move(name)});
    works_.push_back(std::move(work));
  }

  void list_ways() {
    const auto& points = request_.points;
    add("exact, Voronoi cells", [&] { return hopkins_exact(points, window_); });
    if (request_.threads > 1)
      add(fmt::format("exact, {} threads", request_.threads),
          [&] { return hopkins_exact(points, window_, request_.threads); });
    add("sampled, cell grid", [&] {
      CounterStream stream(request_.seed, 0);
      return hopkins_sampled(points, window_, points.size(), stream);
    });
    add("sampled, k-d tree", [&] { return kdtree_hopkins(points, places_); });
    if (kdtree_library().empty()) ways_.back().missing = "nanoflann";
  }

  void progress(const std::string& what) const {
    if (request_.is_interrupted && request_.is_interrupted()) throw Interrupted();
    if (request_.show_progress) request_.show_progress(what);
  }

  bool is_sampled(std::size_t w) const { return ways_[w].name.starts_with("sampled"); }

  /// What one place more or less may change: standard error of the sampled mean, relative.
  double sampling_error() const {
    double sum = 0.0, squares = 0.0;
    for (const double d : nearest_distances_from(places_, request_.points, window_)) {
      sum += d;
      squares += d * d;
    }
    const auto n = static_cast<double>(places_.size());
    return std::sqrt(std::max(0.0, squares / n - sum * sum / n / n) / n) / (sum / n);
  }

  void check() {
    progress("checking");
    for (std::size_t w = 0; w < ways_.size(); ++w)
      if (ways_[w].missing.empty()) ways_[w].index = works_[w]();
    const HopkinsIndex& exact = ways_[0].index;
    const double tolerance = 5.0 * sampling_error();
    for (std::size_t w = 1; w < ways_.size(); ++w) {
      if (!ways_[w].missing.empty()) continue;
      ways_[w].objection = objection_to(ways_[w].index, exact, is_sampled(w) ? tolerance : 0.0);
    }
    HopkinsWay& tree = ways_.back();
    const HopkinsWay& grid = ways_[ways_.size() - 2];  // asks at the same places
    if (tree.missing.empty() && tree.objection.empty())
      tree.objection = objection_to(tree.index, grid.index, 1e-9);
  }

  void time(std::size_t w, int round) {
    HopkinsWay& way = ways_[w];
    if (!way.missing.empty() || !way.objection.empty()) return;
    progress(fmt::format("round {}: timing {}", round + 1, way.name));
    const auto start = std::chrono::steady_clock::now();
    works_[w]();
    way.seconds.push_back(
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
  }

  const HopkinsRaceRequest& request_;
  Window window_;
  std::vector<Point2> places_;
  std::vector<HopkinsWay> ways_;
  std::vector<Work> works_;
};

}  // namespace

std::string objection_to(const HopkinsIndex& found, const HopkinsIndex& expected,
                         double tolerance) {
  // The square scatters about twice as much. The larger of both would hide one that is NaN.
  const double off = std::abs(found.mean_ratio / expected.mean_ratio - 1.0);
  const double square_off = std::abs(found.squared_ratio / expected.squared_ratio - 1.0) / 3.0;
  if (off <= tolerance && square_off <= tolerance) return {};
  return fmt::format("{:.6g} is off from {:.6g} by {:.2g}, of squares by {:.2g}", found.mean_ratio,
                     expected.mean_ratio, off, 3.0 * square_off);
}

std::vector<HopkinsWay> race_hopkins(const HopkinsRaceRequest& request) {
  return Race(request).run();
}

}  // namespace phytobench
