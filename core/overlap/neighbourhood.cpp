// SPDX-License-Identifier: MIT
#include "core/overlap/neighbourhood.hpp"

#include <memory>
#include <numeric>

#include "core/overlap/candidate_pairs.hpp"
#include "core/overlap/overlap_registry.hpp"

namespace phytobench {

namespace {

void list_neighbours(const OverlapPairs& pairs, Neighbourhood& n) {
  n.begin.assign(n.size() + 1, 0);
  for (const auto& side : {pairs.first(), pairs.second()})
    for (const DiscIndex i : side) ++n.begin[static_cast<std::size_t>(i) + 1];
  std::partial_sum(n.begin.begin(), n.begin.end(), n.begin.begin());
  n.neighbour.resize(n.begin.back());
  std::vector<std::size_t> next(n.begin.begin(), n.begin.end() - 1);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const DiscIndex i = pairs.first()[p], j = pairs.second()[p];
    n.neighbour[next[static_cast<std::size_t>(i)]++] = j;
    n.neighbour[next[static_cast<std::size_t>(j)]++] = i;
  }
}

}  // namespace

Neighbourhood neighbourhood_of(const Discs& discs, const Ground& ground, const Point2& origin,
                               const PairFinder& find) {
  Neighbourhood n;
  std::vector<double> x, y;
  for (const DiscEntry& e : entries_with_images(discs, ground)) {
    x.push_back(e.x - origin.x);
    y.push_back(e.y - origin.y);
    n.center.push_back({x.back(), y.back()});
    n.radius.push_back(e.radius);
    n.disc.push_back(e.disc);
    n.originals += !e.is_image();
  }
  list_neighbours(find({x, y, n.radius}), n);
  return n;
}

PairFinder own_pair_finder(const OverlapSetup& setup) {
  struct Search {
    std::unique_ptr<OverlapEngine> engine = overlap_engine_named("layered_grid").create();
    OverlapPairs pairs;
  };
  return [search = std::make_shared<Search>(), setup](const Discs& discs) -> const OverlapPairs& {
    search->engine->find(discs, {}, setup, search->pairs);
    return search->pairs;
  };
}

}  // namespace phytobench
