// SPDX-License-Identifier: MIT
// FLANN's randomised k-d trees, KDTreeIndex. They can grow: a new node splits a leaf of each tree,
// and all are built anew only when there are twice as many nodes as at the last time.
//
// They miss nodes for two reasons. A search ends after so many leaves; and it adds up the distances
// to all cuts it crosses, even of the same axis, and so gives up branches that are near enough. In
// three dimensions that happens all the time: no number of leaves makes one tree exact.
//
// Nothing repeats. The axes of the cuts come from rand(), which flann::seed_random() could seed,
// but the nodes are shuffled first by a generator that every build seeds from std::random_device,
// and the first 101 of a branch decide where it is cut. So the state of rand(), which the whole
// program shares, is left alone: seeding it would settle nothing.
#include "benchmarks/nearest_node/flann_randomised.hpp"

#include <optional>
#include <vector>

#include <flann/config.h>
#include <flann/flann.hpp>

#include "core/nearest_node/nearest_perceiving.hpp"
#include "core/nearest_node/node_list.hpp"

namespace phytobench {

namespace {

/// The shape in which FLANN wants it.
class Candidates final : public flann::ResultSet<double> {
 public:
  explicit Candidates(NearestPerceiving& nearest) : nearest_(nearest) {}
  void addPoint(double, std::size_t row) override { nearest_.offer(row); }
  double worstDist() const override { return nearest_.bound(); }
  /// Always, as in FLANN's own RadiusResultSet: no limit holds before this is true, which it would
  /// never be for a point that no node perceives.
  bool full() const override { return true; }

 private:
  NearestPerceiving& nearest_;
};

template <int checks>
class RandomisedTrees : public NodeList {
 public:
  static constexpr int trees = 4;                   ///< FLANN's default
  static constexpr float rebuild_threshold = 2.0F;  ///< times the nodes of the last build; default

  void reset(std::span<const Vector3> points, double influence_distance) {
    NodeList::reset(points, influence_distance);
    index_.reset();
    batches_.clear();
  }

  std::uint64_t insert(std::span<const SearchableNode> nodes) {
    if (nodes.empty()) return 0;
    NodeList::insert(nodes);
    std::vector<double>& batch = batches_.emplace_back();
    for (const SearchableNode& node : nodes)
      batch.insert(batch.end(), {node.position.x, node.position.y, node.position.z});
    const flann::Matrix<double> rows(batch.data(), nodes.size(), 3);
    if (index_) {
      index_->addPoints(rows, rebuild_threshold);
    } else {
      index_.emplace(rows, flann::KDTreeIndexParams(trees));
      index_->buildIndex();
    }
    return nodes.size();
  }

  NearestHit nearest(PointIndex, const Vector3& point, const Perception& perception,
                     WorkCounters& work) const {
    NearestPerceiving found(nodes_, point, perception, work);
    Candidates candidates(found);
    const double query[] = {point.x, point.y, point.z};
    if (index_) index_->findNeighbors(candidates, query, flann::SearchParams(checks));
    return found.best();
  }

 private:
  /// x, y, z of the nodes of one call of insert(), row by row. FLANN keeps pointers to the rows:
  /// the outer vector may move its elements, but no row ever moves.
  std::vector<std::vector<double>> batches_;
  std::optional<flann::KDTreeIndex<flann::L2_Simple<double>>> index_;
};

template <int checks>
constexpr EngineDescriptor randomised_trees(std::string_view name, std::string_view summary) {
  return {.name = name,
          .summary = summary,
          .source = "FLANN (Muja and Lowe), KDTreeIndex",
          .library = "FLANN " FLANN_VERSION_,
          .create = make_point_driven_engine<RandomisedTrees<checks>, KillBy::grid>};
}

constexpr EngineDescriptor engines[] = {
    randomised_trees<16>("flann_randomised_16",
                         "Asks FLANN's 4 randomised k-d trees and looks into 16 leaves at most."),
    randomised_trees<64>("flann_randomised_64",
                         "Asks FLANN's 4 randomised k-d trees and looks into 64 leaves at most."),
    randomised_trees<256>("flann_randomised_256",
                          "Asks FLANN's 4 randomised k-d trees and looks into 256 leaves at most."),
};

}  // namespace

std::span<const EngineDescriptor> approximate_engines() {
  return engines;
}

}  // namespace phytobench
