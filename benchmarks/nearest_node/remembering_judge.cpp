// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/remembering_judge.hpp"

#include <algorithm>

namespace phytobench {

namespace {

/// A question and its answer.
struct Call {
  enum class Kind { association, removal };

  struct Change {
    PointIndex point;
    NodeIndex node;
  };

  Kind kind;
  std::vector<SearchableNode> nodes;
  double distance = 0.0;        // of a removal
  std::vector<int> removed;     // by a removal
  bool expected = true;         // whether there should have been the removal
  std::size_t answered = 0;     // points covered by an association: all, or none
  std::vector<Change> changes;  // by an association, against the one before

  bool asks(Kind other, std::span<const SearchableNode> other_nodes, double other_distance) const {
    return kind == other && distance == other_distance && std::ranges::equal(nodes, other_nodes);
  }
};

class RememberingJudge final : public GrowthJudge {
 public:
  explicit RememberingJudge(std::unique_ptr<GrowthJudge> judge) : judge_(std::move(judge)) {}

  void restart() override {
    next_ = 0;
    is_known_so_far_ = true;
    std::ranges::fill(answer_, -1);
  }

  std::span<const int> associate(std::span<const SearchableNode> new_nodes) override {
    if (remembers(Call::Kind::association, new_nodes, 0.0)) return recall();
    const std::span<const int> truth = judge_->associate(new_nodes);
    if (is_known_so_far_) remember_association(new_nodes, truth);
    return truth;
  }

  std::vector<int> remove(std::span<const SearchableNode> killers, double distance,
                          bool& expected) override {
    if (remembers(Call::Kind::removal, killers, distance)) {
      expected = calls_[next_].expected;
      return calls_[next_++].removed;
    }
    std::vector<int> removed = judge_->remove(killers, distance, expected);
    if (is_known_so_far_)
      add({.kind = Call::Kind::removal,
           .nodes = {killers.begin(), killers.end()},
           .distance = distance,
           .removed = removed,
           .expected = expected});
    return removed;
  }

  std::string tree_hash() const override { return judge_->tree_hash(); }
  std::string name() const override { return judge_->name(); }

 private:
  /// Whether this is the next known question. If not, the judge is ready for it.
  bool remembers(Call::Kind kind, std::span<const SearchableNode> nodes, double distance) {
    if (!is_known_so_far_) return false;
    if (next_ < calls_.size() && calls_[next_].asks(kind, nodes, distance)) return true;
    is_known_so_far_ = next_ == calls_.size();
    if (asked_ != next_) ask_again();
    asked_ = is_known_so_far_ ? next_ : nothing_to_go_on_from;
    return false;
  }

  /// Takes the judge to where the growth is.
  void ask_again() {
    judge_->restart();
    for (std::size_t i = 0; i < next_; ++i) {
      const Call& call = calls_[i];
      bool expected = false;
      if (call.kind == Call::Kind::association)
        judge_->associate(call.nodes);
      else
        judge_->remove(call.nodes, call.distance, expected);
    }
  }

  std::span<const int> recall() {
    const Call& call = calls_[next_++];
    for (const auto& [point, node] : call.changes) answer_[static_cast<std::size_t>(point)] = node;
    return std::span(answer_).first(call.answered);
  }

  void remember_association(std::span<const SearchableNode> nodes, std::span<const int> truth) {
    Call call{.kind = Call::Kind::association,
              .nodes = {nodes.begin(), nodes.end()},
              .answered = truth.size()};
    answer_.resize(std::max(answer_.size(), truth.size()), -1);
    for (std::size_t point = 0; point < truth.size(); ++point)
      if (answer_[point] != truth[point]) {
        call.changes.push_back({static_cast<PointIndex>(point), truth[point]});
        answer_[point] = truth[point];
      }
    add(std::move(call));
  }

  void add(Call call) {
    call.changes.shrink_to_fit();
    calls_.push_back(std::move(call));
    asked_ = ++next_;
  }

  static constexpr std::size_t nothing_to_go_on_from = static_cast<std::size_t>(-1);

  std::unique_ptr<GrowthJudge> judge_;
  std::vector<Call> calls_;
  std::vector<int> answer_;                    // of the last association
  std::size_t next_ = 0;                       // the question that comes next
  std::size_t asked_ = nothing_to_go_on_from;  // what the judge has been asked since its restart
  bool is_known_so_far_ = true;
};

}  // namespace

std::unique_ptr<GrowthJudge> make_remembering_judge(std::unique_ptr<GrowthJudge> judge) {
  return std::make_unique<RememberingJudge>(std::move(judge));
}

}  // namespace phytobench
