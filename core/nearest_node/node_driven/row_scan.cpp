// SPDX-License-Identifier: MIT
#include "core/nearest_node/node_driven/row_scan.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/nearest_node/node_driven/row_scan.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace phytobench {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Four doubles at most, so that no vector crosses a block; two on older processors. Only Mul, Add
// and what is exact: MulAdd would round differently from target to target.
using Doubles = hn::CappedTag<double, PointBlock::width>;
using Integers = hn::CappedTag<std::int32_t, RowStencil::lanes>;
using Floats = hn::Rebind<float, Integers>;
using DoubleVector = hn::Vec<Doubles>;
using IntegerVector = hn::Vec<Integers>;

constexpr std::size_t double_lanes = hn::MaxLanes(Doubles());
constexpr std::size_t integer_lanes = hn::MaxLanes(Integers());

/// Nodes are scanned in tiles: the runs of all, then their blocks, then the few blocks with hits.
/// Each of these is a loop without surprises, and with many points in flight at a time.
constexpr std::size_t tile = 16;

/// Beyond this an index does not stay in a cache, and asking for memory ahead of time pays.
constexpr std::size_t large_index_bytes = std::size_t{1} << 23;

/// A node's cell, and where in it the node is (0 ... 1).
struct Place {
  std::int32_t x, y, z;
  float in_x, in_y, in_z;
  RowStencil::List rows;
};

/// In the order of phytobench::squared_norm(): every engine and every target rounds alike.
HWY_INLINE DoubleVector squared_norm(DoubleVector x, DoubleVector y, DoubleVector z) {
  return hn::Add(hn::Add(hn::Mul(x, x), hn::Mul(y, y)), hn::Mul(z, z));
}

HWY_INLINE unsigned bits_of(hn::Mask<Doubles> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Doubles(), mask, bytes);
  return bytes[0];
}

class RowScan {
 public:
  RowScan(RowIndex& index, const RowStencil& stencil, const ScanJob& job, ScanResult& result)
      : index_(index),
        stencil_(stencil),
        shape_(index.shape()),
        job_(job),
        result_(result),
        inverse_x_(1.0 / shape_.cell_x),
        inverse_row_(1.0 / shape_.row_edge),
        just_above_kill_(std::nextafter(job.squared_kill, std::numeric_limits<double>::infinity())),
        is_large_(index.bytes() > large_index_bytes) {}

  void run() {
    result_.hits.clear();
    result_.removed.clear();
    result_.pairs = result_.blocks = 0;
    for (std::size_t next = 0; next < job_.chosen.size(); next += tile)
      scan_tile(job_.chosen.subspan(next, std::min(tile, job_.chosen.size() - next)));
  }

 private:
  HWY_INLINE void scan_tile(std::span<const std::int32_t> chosen) {
    std::array<Place, tile> places;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      places[i] = place_of(job_.nodes[static_cast<std::size_t>(chosen[i])].position);
      if (is_large_) prefetch_entries(places[i]);
    }
    std::array<std::size_t, tile + 1> ends{};
    result_.candidates.clear();
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      list_blocks(places[i]);
      ends[i + 1] = result_.candidates.size();
    }
    const std::span<const std::int32_t> candidates = result_.candidates.items();
    result_.blocks += candidates.size();
    if (is_large_) prefetch_blocks(candidates);
    result_.promising.clear();
    result_.promising.make_room(candidates.size() + 1);
    for (std::size_t i = 0; i < chosen.size(); ++i)
      keep_promising(chosen[i], candidates.subspan(ends[i], ends[i + 1] - ends[i]));
    for (const PromisingBlock& promising : result_.promising.items()) examine(promising);
  }

  Place place_of(const Vector3& node) const {
    const double x = (node.x - shape_.low.x) * inverse_x_;
    const double y = (node.y - shape_.low.y) * inverse_row_;
    const double z = (node.z - shape_.low.z) * inverse_row_;
    const double cell_x = std::floor(x), cell_y = std::floor(y), cell_z = std::floor(z);
    const auto place = [this](double in_cell) {
      return static_cast<std::int32_t>(stencil_.places() * in_cell);
    };
    return {static_cast<std::int32_t>(cell_x),
            static_cast<std::int32_t>(cell_y),
            static_cast<std::int32_t>(cell_z),
            static_cast<float>(x - cell_x),
            static_cast<float>(y - cell_y),
            static_cast<float>(z - cell_z),
            stencil_.rows(place(y - cell_y), place(z - cell_z))};
  }

  /// Whether all rows that the stencil names exist.
  bool is_inside(const Place& place) const {
    const std::int32_t span = stencil_.span();
    return place.y >= span && place.y < shape_.rows_y - span && place.z >= job_.first_z + span &&
           place.z < job_.end_z - span;
  }

  std::int32_t row_of(const Place& place, std::int32_t slab) const {
    return (slab * shape_.rows_z + place.z) * shape_.rows_y + place.y;
  }

  HWY_INLINE void prefetch_entries(const Place& place) const {
    if (!is_inside(place)) return;
    const std::int32_t slab = std::clamp(place.x / shape_.cells(), 0, shape_.slabs - 1);
    const std::int32_t x = std::clamp(place.x - slab * shape_.cells(), 0, shape_.cells() - 1);
    const std::uint16_t* const own =
        index_.entries() + row_of(place, slab) * shape_.row_entries() + RowShape::entry_of(x);
    for (std::size_t r = place.rows.begin; r < place.rows.end; ++r)
      __builtin_prefetch(own + stencil_.entry()[r]);
  }

  HWY_INLINE void prefetch_blocks(std::span<const std::int32_t> candidates) const {
    for (const std::int32_t block : candidates) {
      __builtin_prefetch(&index_.blocks()[block].x);
      __builtin_prefetch(&index_.blocks()[block].z);
    }
  }

  /// Appends the blocks of all runs that a node there may reach.
  HWY_INLINE void list_blocks(const Place& place) {
    const std::int32_t cells = shape_.cells();
    const std::int32_t first = std::max(place.x - stencil_.span_x(), 0) / cells;
    const std::int32_t last = std::min((place.x + stencil_.span_x()) / cells, shape_.slabs - 1);
    for (std::int32_t slab = first; slab <= last; ++slab) {
      if (is_inside(place))
        list_blocks<true>(place, slab);
      else
        list_blocks<false>(place, slab);
    }
  }

  template <bool Inside>
  HWY_INLINE void list_blocks(const Place& place, std::int32_t slab) {
    for (std::size_t r = place.rows.begin; r < place.rows.end; r += integer_lanes) {
      const RowCells cells = cells_of_rows(place, slab, r);
      const auto exists = rows_exist<Inside>(place, r);
      append_runs(row_of(place, slab), r, cells, hn::And(cells.reached, exists));
    }
  }

  /// What a node reaches of several rows: cells first ... last.
  struct RowCells {
    IntegerVector first;
    IntegerVector last;
    hn::Mask<Integers> reached;
  };

  /// In single precision, rounded outwards by far more than it loses.
  HWY_INLINE RowCells cells_of_rows(const Place& place, std::int32_t slab, std::size_t r) const {
    const Integers i;
    const Floats f;
    const auto none = hn::Zero(f);
    const auto y = hn::ConvertTo(f, hn::LoadU(i, stencil_.y() + r));
    const auto z = hn::ConvertTo(f, hn::LoadU(i, stencil_.z() + r));
    const auto gap_y = hn::Max(
        hn::Max(hn::Sub(y, hn::Set(f, place.in_y)), hn::Sub(hn::Set(f, place.in_y - 1.0f), y)),
        none);
    const auto gap_z = hn::Max(
        hn::Max(hn::Sub(z, hn::Set(f, place.in_z)), hn::Sub(hn::Set(f, place.in_z - 1.0f), z)),
        none);
    const auto rest = hn::Sub(hn::Sub(hn::Set(f, stencil_.squared_reach()), hn::Mul(gap_y, gap_y)),
                              hn::Mul(gap_z, gap_z));
    const auto half =
        hn::Add(hn::Mul(hn::Sqrt(hn::Max(rest, none)), hn::Set(f, stencil_.cells_per_row_edge())),
                hn::Set(f, 1e-3f));
    // A float this large has no fraction, so adding it rounds, and its last bits are the integer.
    // Half is taken off to round downwards; what that may lose, the 1e-3 above gives back.
    constexpr float rounding = 12582912.0f;
    const auto in_x = hn::Set(f, place.in_x - 0.5f);
    const auto low = hn::BitCast(i, hn::Add(hn::Sub(in_x, half), hn::Set(f, rounding)));
    const auto high = hn::BitCast(i, hn::Add(hn::Add(in_x, half), hn::Set(f, rounding)));
    const auto cell =
        hn::Set(i, place.x - slab * shape_.cells() - std::bit_cast<std::int32_t>(rounding));
    const auto first = hn::Max(hn::Add(cell, low), hn::Zero(i));
    const auto last = hn::Min(hn::Add(cell, high), hn::Set(i, shape_.cells() - 1));
    const auto any = hn::Lt(first, hn::Add(last, hn::Set(i, 1)));
    return {first, last, hn::And(any, hn::RebindMask(i, hn::Ge(rest, none)))};
  }

  template <bool Inside>
  HWY_INLINE hn::Mask<Integers> rows_exist(const Place& place, std::size_t r) const {
    const Integers i;
    const auto away_y = hn::LoadU(i, stencil_.y() + r);
    if constexpr (Inside) return hn::Lt(away_y, hn::Set(i, shape_.rows_y));  // or they fill a list
    const auto y = hn::Add(hn::Set(i, place.y), away_y);
    const auto z = hn::Add(hn::Set(i, place.z), hn::LoadU(i, stencil_.z() + r));
    return hn::And(
        hn::And(hn::Gt(y, hn::Set(i, -1)), hn::Lt(y, hn::Set(i, shape_.rows_y))),
        hn::And(hn::Gt(z, hn::Set(i, job_.first_z - 1)), hn::Lt(z, hn::Set(i, job_.end_z))));
  }

  HWY_INLINE void append_runs(std::int32_t own_row, std::size_t r, const RowCells& cells,
                              hn::Mask<Integers> valid) {
    const Integers i;
    const auto one = hn::Set(i, 1);
    const auto row = hn::Add(hn::Set(i, own_row), hn::LoadU(i, stencil_.row() + r));
    const auto row_begin = hn::GatherIndex(i, index_.row_begins(), hn::IfThenElseZero(valid, row));
    const auto row_entry =
        hn::Add(hn::Set(i, own_row * shape_.row_entries()), hn::LoadU(i, stencil_.entry() + r));
    const auto first_entry = hn::Add(row_entry, entry_of(cells.first));
    const auto end_entry = hn::Add(row_entry, hn::Add(entry_of(cells.last), one));
    const auto begin = entry(hn::IfThenElseZero(valid, first_entry));
    const auto end = entry(hn::IfThenElseZero(valid, end_entry));
    const auto first = hn::ShiftRight<2>(hn::Add(row_begin, begin));
    const auto behind =
        hn::ShiftRight<2>(hn::Add(hn::Add(row_begin, end), hn::Set(i, PointBlock::width - 1)));
    const auto many = hn::IfThenElseZero(hn::Lt(begin, end), hn::Sub(behind, first));
    append_blocks(first, many);
    if (HWY_UNLIKELY(job_.count_pairs))
      count_live(hn::Add(row_begin, begin), hn::Add(row_begin, end));
  }

  static HWY_INLINE IntegerVector entry_of(IntegerVector cell) {
    static_assert(RowShape::chunk_cells == 8);
    return hn::Add(cell, hn::ShiftRight<3>(cell));
  }

  /// Entries are half as wide as what can be gathered.
  HWY_INLINE IntegerVector entry(IntegerVector number) const {
    const Integers i;
    const auto* const entries = reinterpret_cast<const std::int32_t*>(index_.entries());
    return hn::And(hn::GatherOffset(i, entries, hn::ShiftLeft<1>(number)), hn::Set(i, 0xffff));
  }

  /// Runs are short. Of all of them the first block, then the second, then the third; the few
  /// longer ones after that.
  HWY_INLINE void append_blocks(IntegerVector first, IntegerVector many) {
    const Integers i;
    constexpr std::int32_t at_once = 3;
    result_.candidates.make_room(at_once * integer_lanes);
    std::int32_t* out = result_.candidates.end();
    for (std::int32_t block = 0; block < at_once; ++block) {
      const auto exists = hn::Gt(many, hn::Set(i, block));
      hn::StoreU(hn::Compress(hn::Add(first, hn::Set(i, block)), exists), i, out);
      out += hn::CountTrue(i, exists);
    }
    result_.candidates.set_end(out);
    if (HWY_LIKELY(hn::AllFalse(i, hn::Gt(many, hn::Set(i, at_once))))) return;
    HWY_ALIGN std::int32_t firsts[RowStencil::lanes];
    HWY_ALIGN std::int32_t counts[RowStencil::lanes];
    hn::Store(first, i, firsts);
    hn::Store(many, i, counts);
    for (std::size_t lane = 0; lane < integer_lanes; ++lane)
      append_rest(firsts[lane] + at_once, counts[lane] - at_once);
  }

  void append_rest(std::int32_t first, std::int32_t count) {
    if (count <= 0) return;
    result_.candidates.make_room(static_cast<std::size_t>(count));
    std::int32_t* out = result_.candidates.end();
    for (std::int32_t block = first; block < first + count; ++block) *out++ = block;
    result_.candidates.set_end(out);
  }

  /// The points that the runs select, as they were when the scan began: in which order nodes are
  /// taken must not matter. What else is in their first and last vectors comes along
  /// unasked and does not count.
  void count_live(IntegerVector begin, IntegerVector end) {
    HWY_ALIGN std::int32_t begins[RowStencil::lanes];
    HWY_ALIGN std::int32_t ends[RowStencil::lanes];
    hn::Store(begin, Integers(), begins);
    hn::Store(end, Integers(), ends);
    for (std::size_t lane = 0; lane < integer_lanes; ++lane)
      for (std::int32_t slot = begins[lane]; slot < ends[lane]; ++slot)
        result_.pairs += index_.holds_point(slot);
  }

  /// Keeps the blocks in which some point comes nearer to its node than to any before, or is to be
  /// removed.
  HWY_INLINE void keep_promising(std::int32_t number, std::span<const std::int32_t> candidates) {
    const Doubles d;
    const PointBlock* const blocks = index_.blocks();
    const Vector3& node = job_.nodes[static_cast<std::size_t>(number)].position;
    const auto x = hn::Set(d, node.x), y = hn::Set(d, node.y), z = hn::Set(d, node.z);
    const auto kill = hn::Set(d, just_above_kill_);  // so that < includes the distance itself
    PromisingBlock* out = result_.promising.end();
    for (const std::int32_t candidate : candidates) {
      const PointBlock& block = blocks[candidate];
      bool any = false;
      for (std::size_t lane = 0; lane < PointBlock::width; lane += double_lanes) {
        const auto squared = squared_norm(hn::Sub(x, hn::Load(d, block.x + lane)),
                                          hn::Sub(y, hn::Load(d, block.y + lane)),
                                          hn::Sub(z, hn::Load(d, block.z + lane)));
        const auto limit = hn::Max(hn::Load(d, block.best + lane), kill);
        any |= !hn::AllFalse(d, hn::Lt(squared, limit));
      }
      *out = {candidate, number};
      out += any;
    }
    result_.promising.set_end(out);
  }

  /// Notes the hits of a block and removes what is too near.
  HWY_INLINE void examine(const PromisingBlock& promising) {
    const Doubles d;
    const PointBlock& block = index_.blocks()[promising.block];
    const SearchableNode& node = job_.nodes[static_cast<std::size_t>(promising.node)];
    for (std::size_t lane = 0; lane < PointBlock::width; lane += double_lanes) {
      const auto x = hn::Sub(hn::Load(d, block.x + lane), hn::Set(d, node.position.x));
      const auto y = hn::Sub(hn::Load(d, block.y + lane), hn::Set(d, node.position.y));
      const auto z = hn::Sub(hn::Load(d, block.z + lane), hn::Set(d, node.position.z));
      const auto squared = squared_norm(x, y, z);
      const auto removed = hn::Le(squared, hn::Set(d, job_.squared_kill));
      auto hit = hn::AndNot(removed, hn::Lt(squared, hn::Load(d, block.best + lane)));
      if (!job_.all_around) {
        const auto along = hn::Add(hn::Add(hn::Mul(hn::Set(d, node.direction.x), x),
                                           hn::Mul(hn::Set(d, node.direction.y), y)),
                                   hn::Mul(hn::Set(d, node.direction.z), z));
        hit = hn::And(hit, hn::Ge(along, hn::Mul(hn::Set(d, job_.cosine), hn::Sqrt(squared))));
      }
      const auto slot = promising.block * PointBlock::width + static_cast<std::int32_t>(lane);
      append_hits(squared, bits_of(hit), slot, promising.node);
      if (HWY_UNLIKELY(!hn::AllFalse(d, removed)))
        for (unsigned bits = bits_of(removed); bits != 0; bits &= bits - 1)
          remove(slot + std::countr_zero(bits));
    }
  }

  /// Writes all lanes and keeps those with a bit: cheaper than a branch nobody can foresee.
  HWY_INLINE void append_hits(DoubleVector squared, unsigned bits, std::int32_t slot,
                              std::int32_t node) {
    HWY_ALIGN double distances[PointBlock::width];
    hn::Store(squared, Doubles(), distances);
    result_.hits.make_room(PointBlock::width);
    ScanHit* out = result_.hits.end();
    for (std::size_t lane = 0; lane < double_lanes; ++lane) {
      *out = {distances[lane], slot + static_cast<std::int32_t>(lane), node};
      out += (bits >> lane) & 1u;
    }
    result_.hits.set_end(out);
  }

  /// Whoever comes next must not find the point again.
  void remove(std::int32_t slot) {
    result_.removed.push_back(slot);
    index_.remove(slot);
  }

  RowIndex& index_;
  const RowStencil& stencil_;
  const RowShape shape_;
  const ScanJob& job_;
  ScanResult& result_;
  double inverse_x_;
  double inverse_row_;
  double just_above_kill_;
  bool is_large_;
};

void scan(RowIndex& index, const RowStencil& stencil, const ScanJob& job, ScanResult& result) {
  RowScan(index, stencil, job, result).run();
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace phytobench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace phytobench {

HWY_EXPORT(scan);

void scan_rows(RowIndex& index, const RowStencil& stencil, const ScanJob& job, ScanResult& result) {
  HWY_DYNAMIC_DISPATCH(scan)(index, stencil, job, result);
}

std::size_t ScanResult::bytes() const {
  return hits.bytes() + removed.capacity() * sizeof(std::int32_t) + candidates.bytes() +
         promising.bytes();
}

}  // namespace phytobench
#endif
