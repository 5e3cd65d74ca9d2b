// SPDX-License-Identifier: MIT
#include "core/nearest_node/node_driven/row_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/nearest_node/perception.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

/// Beyond this many points within the reach of one node, most of them have a nearer node already,
/// and an index that knows so is better.
constexpr double most_points_in_reach = 2048.0;

/// More layers share the work more evenly, but a node that reaches two of them is looked at twice.
constexpr int layers_per_thread = 4;

/// Whether rows of cells suit the points: a node must not reach most of them, nor coordinates be so
/// coarse that rounding outweighs the reach.
bool suits(const BoundingBox& box, std::size_t count, double reach) {
  if (box.empty()) return true;
  const Vector3 extent = box.extent();
  const double longest = std::max({extent.x, extent.y, extent.z});
  if (!(reach <= longest)) return false;
  double in_reach = static_cast<double>(count);
  for (const double length : {extent.x, extent.y, extent.z})
    if (length > 0.0) in_reach *= std::min(1.0, 2.0 * reach / length);
  if (in_reach > most_points_in_reach) return false;
  const RowShape shape = row_shape(box, count, reach);
  constexpr double most_rows_in_reach = 4.0;
  return reach + shape.margin <= most_rows_in_reach * shape.row_edge;
}

/// Not worth sorting.
constexpr std::size_t few_nodes = 64;

/// Points lie anywhere in memory: asked for so many steps before they are needed.
constexpr std::size_t steps_ahead = 16;

/// 40^3 bricks have 16-bit numbers.
constexpr std::uint32_t bricks_per_edge = 40;

bool same(const SearchableNode& a, const SearchableNode& b) {
  return a.position == b.position && a.direction == b.direction;
}

}  // namespace

bool RowSearch::reset(std::span<const Vector3> points, const EngineSetup& setup) {
  setup_ = setup;
  work_ = {};
  scanned_.clear();
  slots_ = points.size();
  empty_slots_ = 0;
  associations_ = 0;
  sees_kills_only_ = false;
  BoundingBox box;
  for (const Vector3& point : points) box.extend(point);
  const double reach = setup.influence_distance;
  if (!suits(box, points.size(), reach)) return false;
  const Perception perception(reach, setup.perception_half_angle_rad);
  const RowShape shape = row_shape(box, points.size(), reach);
  if (!index_.reset(points, shape, perception.beyond_reach(), setup.threads)) return false;
  stencil_.reset(shape, reach);
  within_reach_ = box.widened(reach + shape.margin);
  const Vector3 extent = within_reach_.extent();
  bricks_per_length_ = 0.999 * bricks_per_edge / std::max({extent.x, extent.y, extent.z, reach});
  cut_into_layers();
  return true;
}

void RowSearch::cut_into_layers() {
  const RowShape& shape = index_.shape();
  const int wanted = setup_.threads > 1 ? setup_.threads * layers_per_thread : 1;
  // Thinner than its reach on both sides a layer would mostly repeat its neighbours' work.
  const std::int32_t thinnest = 2 * stencil_.span();
  const auto count = static_cast<std::size_t>(
      std::clamp(shape.rows_z / std::max(thinnest, 1), 1, std::max(wanted, 1)));
  layers_.resize(count);
  const auto border = [&](std::size_t layer) {
    return static_cast<std::int32_t>(static_cast<std::size_t>(shape.rows_z) * layer / count);
  };
  for (std::size_t i = 0; i < count; ++i) {
    Layer& layer = layers_[i];
    layer.first_z = border(i);
    layer.end_z = border(i + 1);
    const double reach = setup_.influence_distance + shape.margin + 1e-9 * shape.row_edge;
    layer.low = shape.low.z + layer.first_z * shape.row_edge - reach;
    layer.high = shape.low.z + layer.end_z * shape.row_edge + reach;
  }
}

template <class Body>
void RowSearch::for_each_layer(const Body& body) {
  for_tasks(layers_.size(), setup_.threads, [&](std::size_t layer) { body(layers_[layer]); });
}

void RowSearch::choose_nodes(Layer& layer, std::span<const SearchableNode> nodes) const {
  layer.chosen.clear();
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Vector3& position = nodes[i].position;
    if (within_reach_.contains(position) && position.z >= layer.low && position.z <= layer.high)
      layer.chosen.push_back(static_cast<std::int32_t>(i));
  }
}

/// Neighbours look at the same cells: taken one after the other they find them in the cache. Two
/// passes of a counting sort, each over one byte of the brick's number, keep the order of equals.
void RowSearch::sort_by_brick(Layer& layer, std::span<const SearchableNode> nodes) const {
  const Vector3 low = within_reach_.low();
  const auto step = [&](double value, double from) {
    return static_cast<std::uint32_t>((value - from) * bricks_per_length_);
  };
  layer.bricks.resize(nodes.size());
  for (const std::int32_t i : layer.chosen) {
    const Vector3& p = nodes[static_cast<std::size_t>(i)].position;
    const std::uint32_t brick =
        (step(p.z, low.z) * bricks_per_edge + step(p.y, low.y)) * bricks_per_edge +
        step(p.x, low.x);
    layer.bricks[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(brick);
  }
  layer.sorted.resize(layer.chosen.size());
  for (const int shift : {0, 8}) {
    std::array<std::uint32_t, 257> begin{};
    const auto byte_of = [&](std::int32_t i) {
      return static_cast<std::size_t>(layer.bricks[static_cast<std::size_t>(i)] >> shift) & 0xff;
    };
    for (const std::int32_t i : layer.chosen) ++begin[byte_of(i) + 1];
    for (std::size_t b = 1; b < begin.size(); ++b) begin[b] += begin[b - 1];
    for (const std::int32_t i : layer.chosen) layer.sorted[begin[byte_of(i)]++] = i;
    layer.chosen.swap(layer.sorted);
  }
}

void RowSearch::look_as_far_as(double distance) {
  stencil_.reset(index_.shape(), distance);
  sees_kills_only_ = distance < setup_.influence_distance;
}

void RowSearch::scan(std::span<const SearchableNode> nodes, double squared_kill) {
  for_each_layer([&](Layer& layer) {
    choose_nodes(layer, nodes);
    if (nodes.size() > few_nodes) sort_by_brick(layer, nodes);
    const ScanJob job{.nodes = nodes,
                      .chosen = layer.chosen,
                      .first_z = layer.first_z,
                      .end_z = layer.end_z,
                      .squared_kill = squared_kill,
                      .cosine = std::cos(setup_.perception_half_angle_rad),
                      .all_around = setup_.perception_half_angle_rad >= std::numbers::pi,
                      .count_pairs = setup_.count_work};
    scan_rows(index_, stencil_, job, layer.result);
  });
}

bool RowSearch::was_scanned(std::span<const SearchableNode> nodes) const {
  return scanned_.size() >= nodes.size() &&
         std::equal(nodes.begin(), nodes.end(),
                    scanned_.end() - static_cast<std::ptrdiff_t>(nodes.size()), same);
}

void RowSearch::associate(std::span<const SearchableNode> nodes, NodeIndex first,
                          std::span<NodeIndex> node_of_point, std::vector<PointIndex>& reached) {
  std::size_t from = 0;
  ++associations_;
  if (sees_kills_only_) look_as_far_as(setup_.influence_distance);
  if (was_scanned(nodes)) {
    from = scanned_.size() - nodes.size();
  } else {
    scan(nodes, -1.0);
    for (const Layer& layer : layers_) {
      work_.search_evaluations += layer.result.pairs;
      work_.cells_visited += layer.result.blocks;
    }
  }
  scanned_.clear();
  for_each_layer([&](Layer& layer) { apply(layer, from, first, node_of_point); });
  for (const Layer& layer : layers_)
    reached.insert(reached.end(), layer.reached.begin(), layer.reached.end());
}

void RowSearch::apply(Layer& layer, std::size_t from, NodeIndex first,
                      std::span<NodeIndex> node_of_point) {
  layer.reached.clear();
  const std::span<const ScanHit> hits = layer.result.hits.items();
  for (std::size_t i = 0; i < hits.size(); ++i) {
    const PointIndex soon = index_.original(hits[std::min(i + steps_ahead, hits.size() - 1)].slot);
    __builtin_prefetch(&node_of_point[static_cast<std::size_t>(soon)], 1);
    const ScanHit& hit = hits[i];
    if (static_cast<std::size_t>(hit.node) < from) continue;
    double& best = index_.best(hit.slot);
    if (hit.squared_distance > best) continue;
    // Equal only if another of these nodes came as near.
    const bool tie = hit.squared_distance == best;
    best = hit.squared_distance;
    const PointIndex point = index_.original(hit.slot);
    const NodeIndex number = first + hit.node - static_cast<NodeIndex>(from);
    NodeIndex& node = node_of_point[static_cast<std::size_t>(point)];
    if (node == no_node) layer.reached.push_back(point);
    if (!tie || number < node) node = number;
  }
  layer.result.hits.clear();
}

void RowSearch::remove(std::span<const SearchableNode> killers, double squared_kill,
                       std::vector<PointIndex>& removed) {
  compact_if_worthwhile();  // associate() has used what the last scan noted, or nobody will
  const bool is_last = setup_.associations > 0 && associations_ >= setup_.associations;
  if (is_last) look_as_far_as(std::sqrt(squared_kill));
  scan(killers, squared_kill);
  scanned_.clear();
  if (!is_last) scanned_.assign(killers.begin(), killers.end());
  for (const Layer& layer : layers_) {
    work_.kill_evaluations += layer.result.pairs;
    work_.cells_visited += layer.result.blocks;
    for (const std::int32_t slot : layer.result.removed) {
      removed.push_back(index_.original(slot));
      if (setup_.count_work) index_.settle(slot);
    }
    empty_slots_ += layer.result.removed.size();
  }
}

/// Point by point it would cost as much as the scan itself, and a scan hardly notices an empty
/// slot.
void RowSearch::compact_if_worthwhile() {
  if (2 * empty_slots_ <= slots_) return;
  index_.compact(setup_.threads);
  slots_ -= empty_slots_;
  empty_slots_ = 0;
}

std::size_t RowSearch::bytes() const {
  std::size_t bytes = index_.bytes();
  for (const Layer& layer : layers_)
    bytes += layer.result.bytes() + layer.chosen.capacity() * sizeof(std::int32_t) +
             layer.sorted.capacity() * sizeof(std::int32_t) +
             layer.bricks.capacity() * sizeof(std::uint16_t) +
             layer.reached.capacity() * sizeof(PointIndex);
  return bytes;
}

}  // namespace phytobench
