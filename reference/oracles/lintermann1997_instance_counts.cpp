// SPDX-License-Identifier: MIT
#include "reference/oracles/lintermann1997_instance_counts.hpp"

#include <limits>
#include <map>
#include <tuple>

namespace phytobench::oracles::lintermann1997 {

namespace {

constexpr std::uint64_t greatest = std::numeric_limits<std::uint64_t>::max();

std::uint64_t sum(std::uint64_t a, std::uint64_t b) {
  return a > greatest - b ? greatest : a + b;
}

std::uint64_t product(std::uint64_t a, std::uint64_t b) {
  return b != 0 && a > greatest / b ? greatest : a * b;
}

void add(InstanceCounts& to, const InstanceCounts& from, std::uint64_t times) {
  for (std::size_t i = 0; i < to.size(); ++i)
    to[i] = to[i] && from[i] ? std::optional(sum(*to[i], product(times, *from[i]))) : std::nullopt;
}

using PathCounters = std::vector<int>;  // instances of each component on the way from the root

struct TooMany {};

class Counting {
 public:
  Counting(const std::vector<CountedComponent>& graph, std::size_t most_productions)
      : graph_(graph), most_productions_(most_productions) {}

  InstanceCounts below_root(std::size_t root) { return siblings(root, PathCounters(size(), 0), 1); }

 private:
  // A nonterminal: the component, the counters with which it is reached, and, where it matters,
  // which sibling it is.
  using Letter = std::tuple<std::size_t, PathCounters, std::uint64_t, std::uint64_t>;

  std::size_t size() const { return graph_.size(); }

  bool is_refused(std::size_t Q, const PathCounters& counters) const {
    const std::optional<int>& most = graph_[Q].maximal_recursions;
    return most && counters[Q] + 1 > *most;
  }

  bool siblings_are_alike(std::size_t Q, const PathCounters& outside) const {
    for (const CountedEdge& edge : graph_[Q].edges)
      if (edge.link != Link::leaf && !graph_[Q].times(edge.link, outside[Q] + 1, std::nullopt))
        return false;
    return true;
  }

  // Of B^n.
  InstanceCounts siblings(std::size_t B, const PathCounters& outside, std::uint64_t n) {
    InstanceCounts counts(size(), 0);
    if (siblings_are_alike(B, outside)) {
      add(counts, production(B, outside, std::nullopt), n);
      return counts;
    }
    for (std::uint64_t i = 1; i <= n; ++i) add(counts, production(B, outside, Sibling{i, n}), 1);
    return counts;
  }

  const InstanceCounts& production(std::size_t A, const PathCounters& outside,
                                   const std::optional<Sibling>& sibling) {
    const Letter letter{A, outside, sibling ? sibling->i : 0, sibling ? sibling->n : 0};
    const auto known = counts_of_.find(letter);
    if (known != counts_of_.end()) return known->second;
    if (++productions_ > most_productions_) throw TooMany{};
    InstanceCounts counts = successor(A, outside, sibling);
    return counts_of_.emplace(letter, std::move(counts)).first->second;
  }

  // Of A_i and all that stands beside it in the production.
  InstanceCounts successor(std::size_t A, const PathCounters& outside,
                           const std::optional<Sibling>& sibling) {
    PathCounters inside = outside;
    ++inside[A];
    InstanceCounts counts(size(), 0);
    counts[A] = 1;
    bool has_ended = false, may_have_ended = false;
    for (const auto& [B, link] : graph_[A].edges) {
      if (link == Link::leaf) continue;
      const auto n = graph_[A].times(link, inside[A], sibling);
      if (is_refused(B, inside)) {
        has_ended = has_ended || (n && *n > 0);
        may_have_ended = may_have_ended || !n;
      } else if (n && *n > 0) {
        add(counts, siblings(B, inside, *n), 1);
      } else if (!n) {
        leave_to_chance(B, counts);
      }
    }
    if (has_ended || may_have_ended) add_leaves(A, inside, has_ended, counts);
    return counts;
  }

  void add_leaves(std::size_t A, const PathCounters& inside, bool has_ended,
                  InstanceCounts& counts) {
    for (const auto& [B, link] : graph_[A].edges) {
      if (link != Link::leaf || is_refused(B, inside)) continue;
      if (has_ended)
        add(counts, siblings(B, inside, 1), 1);
      else
        leave_to_chance(B, counts);
    }
  }

  // B and whatever edges lead to from there.
  void leave_to_chance(std::size_t B, InstanceCounts& counts) const {
    if (!counts[B]) return;
    counts[B] = std::nullopt;
    for (const CountedEdge& edge : graph_[B].edges) leave_to_chance(edge.target, counts);
  }

  const std::vector<CountedComponent>& graph_;
  std::size_t most_productions_;
  std::size_t productions_ = 0;
  std::map<Letter, InstanceCounts> counts_of_;
};

}  // namespace

std::optional<InstanceCounts> instance_counts(const std::vector<CountedComponent>& graph,
                                              std::size_t root, std::size_t most_productions) {
  try {
    return Counting(graph, most_productions).below_root(root);
  } catch (const TooMany&) {
    return std::nullopt;
  }
}

}  // namespace phytobench::oracles::lintermann1997
