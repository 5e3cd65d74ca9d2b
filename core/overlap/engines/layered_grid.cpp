// SPDX-License-Identifier: MIT
// Discs of like size share a grid. A disc looks for partners among those after it in its own grid,
// and in the grids of all smaller discs row by row inside its own circle: whatever the sizes, most
// of what it looks at overlaps it.
#include "core/overlap/layered_grid/layered_grid.hpp"

#include <algorithm>
#include <atomic>
#include <span>

#include "core/geometry/point_tree.hpp"
#include "core/overlap/candidate_pairs.hpp"
#include "core/overlap/layered_grid/pair_scan.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench::overlap_engines {

namespace {

/// Rows with about this many discs are one job. Fixed, so that pairs come in the same order for any
/// number of threads.
constexpr std::size_t discs_per_job = 4096;

std::vector<PairScanJob> jobs_of(const LayeredGrid& grid, const OverlapSetup& setup,
                                 std::atomic<std::size_t>& pairs_so_far) {
  std::vector<PairScanJob> jobs;
  for (std::size_t l = 0; l < grid.layers().size(); ++l) {
    const DiscLayer& layer = grid.layers()[l];
    const auto columns = static_cast<std::size_t>(layer.columns);
    const auto begin_of = [&](std::int32_t row) {
      return grid.cell_begin()[layer.first_cell + static_cast<std::size_t>(row) * columns];
    };
    for (std::int32_t first = 0, row = 0; row < layer.rows;) {
      ++row;
      if (row < layer.rows && begin_of(row) - begin_of(first) < discs_per_job) continue;
      jobs.push_back({&grid, l, first, row, setup.most_pairs, &pairs_so_far});
      first = row;
    }
  }
  return jobs;
}

/// Every disc asks a balanced tree for the centers within its own diameter: the smaller of a pair
/// is found by the larger. Slower than a grid, but nothing can crowd it.
OverlapWork find_by_tree(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                         OverlapPairs& pairs) {
  PairCollector collector(discs, ground, setup, pairs);
  const std::vector<DiscEntry> entries = entries_with_images(discs, ground);
  std::vector<Point2> centers;
  centers.reserve(entries.size());
  for (const DiscEntry& e : entries) centers.push_back({e.x, e.y});
  const PointTree tree(centers);
  offer_within_diameters(discs, entries, collector,
                         [&](const DiscEntry& i, double squared_reach, const auto& visit) {
                           tree.visit_all(
                               {i.x, i.y}, [squared_reach] { return squared_reach; },
                               [&](std::size_t place) { visit(tree.index(place)); });
                         });
  return collector.finish();
}

class LayeredGridEngine final : public OverlapEngine {
 public:
  OverlapWork find(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                   OverlapPairs& pairs) override {
    pairs.clear();
    grid_.build(discs, ground, setup.threads);
    if (grid_.is_clumped()) return find_by_tree(discs, ground, setup, pairs);
    std::atomic<std::size_t> pairs_so_far = 0;
    const std::vector<PairScanJob> jobs = jobs_of(grid_, setup, pairs_so_far);
    OverlapWork work;
    if (setup.threads <= 1) {
      for (const PairScanJob& job : jobs) add(scan_pairs(job, pairs), work);
      return work;
    }
    run(jobs, setup.threads, work);
    pairs.append_all(std::span(found_).first(jobs.size()), setup.threads);
    return work;
  }

  OverlapWork find_in_parts(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                            OverlapPairs& scratch, const TakePairs& take) override {
    grid_.build(discs, ground, setup.threads);
    if (grid_.is_clumped()) {
      const OverlapWork work = find_by_tree(discs, ground, setup, scratch);
      take(std::span(&scratch, 1));
      return work;
    }
    std::atomic<std::size_t> pairs_so_far = 0;
    const std::vector<PairScanJob> all = jobs_of(grid_, setup, pairs_so_far);
    // Enough jobs at a time to keep all threads busy, few enough to keep pairs near.
    const auto at_a_time = static_cast<std::size_t>(setup.threads <= 1 ? 1 : 8 * setup.threads);
    OverlapWork work;
    for (std::size_t begin = 0; begin < all.size(); begin += at_a_time) {
      const auto jobs = std::span(all).subspan(begin, std::min(at_a_time, all.size() - begin));
      run(jobs, setup.threads, work);
      take(std::span(found_).first(jobs.size()));
    }
    return work;
  }

 private:
  /// Pairs of jobs[j] to found_[j].
  void run(std::span<const PairScanJob> jobs, int threads, OverlapWork& work) {
    if (found_.size() < jobs.size()) found_.resize(jobs.size());
    std::vector<OverlapWork> done(jobs.size());
    for_tasks(jobs.size(), threads, [&](std::size_t j) {
      found_[j].clear();
      done[j] = scan_pairs(jobs[j], found_[j]);
    });
    for (const OverlapWork& more : done) add(more, work);
  }

  static void add(const OverlapWork& more, OverlapWork& work) {
    work.candidates += more.candidates;
    work.places += more.places;
  }

  LayeredGrid grid_;
  std::vector<OverlapPairs> found_;  ///< by each of the jobs that run at a time
};

std::unique_ptr<OverlapEngine> create() {
  return std::make_unique<LayeredGridEngine>();
}

}  // namespace

extern const OverlapEngineDescriptor layered_grid;
constinit const OverlapEngineDescriptor layered_grid{
    .name = "layered_grid",
    .summary = "Keeps a grid for each size of disc; larger discs look into the grids of smaller.",
    .source = "phytobench; hierarchical grids, Mirtich 1996",
    .uses_threads = true,
    .create = create,
};

}  // namespace phytobench::overlap_engines
