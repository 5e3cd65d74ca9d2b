// SPDX-License-Identifier: MIT
// The innermost loops of the node-driven engine, vectorised by Highway and chosen for the processor
// at run time. Every target gives the same bits.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/nearest_node/engine.hpp"
#include "core/nearest_node/node_driven/row_index.hpp"
#include "core/nearest_node/node_driven/row_stencil.hpp"

namespace phytobench {

/// A growing list that the innermost loops write through a raw pointer.
template <class T>
class ScanList {
 public:
  /// Room for `count` more. Call it before writing behind end().
  void make_room(std::size_t count) {
    if (used_ + count > room_.size()) room_.resize(used_ + used_ / 2 + count);
  }
  T* end() { return room_.data() + used_; }
  void set_end(const T* end) { used_ = static_cast<std::size_t>(end - room_.data()); }
  void clear() { used_ = 0; }
  std::size_t size() const { return used_; }
  std::span<const T> items() const { return {room_.data(), used_}; }
  std::size_t bytes() const { return room_.size() * sizeof(T); }

 private:
  std::vector<T> room_;
  std::size_t used_ = 0;
};

/// A point that a node perceives and is nearer to than any node before the scan.
struct ScanHit {
  double squared_distance;
  std::int32_t slot;
  std::int32_t node;  ///< place in the scanned nodes
};

/// A block in which a node may have hits.
struct PromisingBlock {
  std::int32_t block;
  std::int32_t node;
};

/// What a scan finds, and its scratch memory. Kept from scan to scan, so that nothing is allocated
/// once the lists have had their largest size.
struct ScanResult {
  ScanList<ScanHit> hits;
  std::vector<std::int32_t> removed;  ///< slots; empty already
  std::uint64_t pairs = 0;            ///< live points in the runs of all nodes; only if counted
  std::uint64_t blocks = 0;           ///< blocks looked at

  ScanList<std::int32_t> candidates;  ///< blocks of the runs, node by node
  ScanList<PromisingBlock> promising;

  std::size_t bytes() const;
};

struct ScanJob {
  std::span<const SearchableNode> nodes;
  std::span<const std::int32_t> chosen;  ///< which of them to scan, in this order
  std::int32_t first_z = 0;              ///< rows of these layers only
  std::int32_t end_z = 0;
  double squared_kill = -1.0;  ///< removes points at most so far away; negative: none
  double cosine = -1.0;        ///< of half the perception angle
  bool all_around = true;      ///< perceives in every direction
  bool count_pairs = true;
};

/// Looks at every live point that one of the chosen nodes may reach; all of them must lie within
/// reach of the index' box. Removes the points within squared_kill, notes those among the others
/// that a node comes nearer to. Overwrites `result`.
void scan_rows(RowIndex& index, const RowStencil& stencil, const ScanJob& job, ScanResult& result);

}  // namespace phytobench
