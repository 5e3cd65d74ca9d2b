// SPDX-License-Identifier: MIT
#include "core/overlap/discs.hpp"

#include <algorithm>
#include <cstring>
#include <numeric>

#include <fmt/format.h>

#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

template <class T>
void grow(LargeArray<T>& array, std::size_t used, std::size_t capacity) {
  LargeArray<T> larger;
  larger.resize_for_overwrite(capacity);
  if (used > 0) std::memcpy(larger.data(), array.data(), used * sizeof(T));
  array = std::move(larger);
}

template <class T>
void copy_behind(LargeArray<T>& to, std::size_t used, std::span<const T> from) {
  if (!from.empty()) std::memcpy(to.data() + used, from.data(), from.size_bytes());
}

struct Partner {
  DiscIndex second;
  double area;
};

}  // namespace

void OverlapPairs::make_room(std::size_t count) {
  if (size_ + count <= area_.size()) return;
  // Of what there is, not of what is used: the steps are the same however pairs come in batches,
  // which differ with the width of a processor's vectors.
  const std::size_t capacity = std::max(size_ + count, area_.size() + area_.size() / 2 + 1024);
  grow(first_, size_, capacity);
  grow(second_, size_, capacity);
  grow(area_, size_, capacity);
}

void OverlapPairs::append_all(std::span<const OverlapPairs> parts, int threads) {
  std::vector<std::size_t> begin{size_};
  for (const OverlapPairs& part : parts) begin.push_back(begin.back() + part.size());
  make_room(begin.back() - size_);
  for_tasks(parts.size(), threads, [&](std::size_t p) {
    copy_behind(first_, begin[p], parts[p].first());
    copy_behind(second_, begin[p], parts[p].second());
    copy_behind(area_, begin[p], parts[p].area());
  });
  size_ = begin.back();
}

void OverlapPairs::sort(std::size_t disc_count) {
  // By counting for the first disc; the few partners of each are sorted on their own.
  std::vector<std::size_t> begin(disc_count + 1, 0);
  for (const DiscIndex i : first()) ++begin[static_cast<std::size_t>(i) + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  LargeArray<Partner> partners;
  partners.resize_for_overwrite(size_);
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::size_t p = 0; p < size_; ++p)
    partners[next[static_cast<std::size_t>(first_[p])]++] = {second_[p], area_[p]};
  for (std::size_t i = 0; i < disc_count; ++i) {
    std::sort(partners.data() + begin[i], partners.data() + begin[i + 1],
              [](const Partner& a, const Partner& b) {
                return a.second != b.second ? a.second < b.second : a.area < b.area;
              });
    for (std::size_t p = begin[i]; p < begin[i + 1]; ++p) {
      first_[p] = static_cast<DiscIndex>(i);
      second_[p] = partners[p].second;
      area_[p] = partners[p].area;
    }
  }
}

void OverlapPairs::sort_and_merge(std::size_t disc_count) {
  sort(disc_count);
  std::size_t kept = 0;
  for (std::size_t p = 0; p < size_; ++p) {
    if (kept > 0 && first_[kept - 1] == first_[p] && second_[kept - 1] == second_[p]) {
      area_[kept - 1] += area_[p];
      continue;
    }
    first_[kept] = first_[p];
    second_[kept] = second_[p];
    area_[kept++] = area_[p];
  }
  size_ = kept;
}

std::optional<DiscProblem> problem_with(const Discs& discs, const Ground& ground) {
  constexpr double largest = 1e60, smallest = 1e-60;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    const double x = discs.x[i], y = discs.y[i], r = discs.radius[i];
    const auto refuse = [&](std::string what) { return DiscProblem{i, std::move(what)}; };
    if (!(std::abs(x) <= largest && std::abs(y) <= largest))
      return refuse(fmt::format("center ({:g}, {:g}) is beyond 1e60; use a larger unit", x, y));
    if (r < 0.0) return refuse(fmt::format("radius {:g} is negative; give 0 or more", r));
    if (!(r <= largest) || (r > 0.0 && r < smallest))
      return refuse(fmt::format("radius {:g} is not within 1e-60 to 1e60; use another unit", r));
    if (!ground.torus) continue;
    if (!ground.torus->contains({x, y}))
      return refuse(fmt::format("center ({:g}, {:g}) lies outside the window; widen it", x, y));
    if (2.0 * r >= std::min(ground.period_x(), ground.period_y()))
      return refuse(fmt::format(
          "diameter {:g} reaches round the torus to the disc itself; widen the window", 2.0 * r));
  }
  return std::nullopt;
}

}  // namespace phytobench
