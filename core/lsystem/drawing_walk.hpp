// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/contract/work_counting.hpp"
#include "core/lsystem/drawing_blocks.hpp"

namespace phytobench {

/// Goes through a drawing from its beginning to its end, kept drawing by kept drawing. Copies go on
/// from where the original is.
template <class Turtle>
class DrawingWalk {
 public:
  using Entry = typename DrawingBlocks<Turtle>::Entry;
  using State = typename Turtle::State;
  using Index = SymbolDrawings::Index;

  /// `parts` are of the axiom, or of a drawing whose entry is of that kind; all that is given must
  /// outlive the walk.
  DrawingWalk(const SymbolDrawings& drawings, const std::vector<Entry>& entries,
              const Turtle& turtle, std::span<const Index> parts, const State& start)
      : parts_(drawings.parts().data()),
        entries_(entries.data()),
        turtle_(&turtle),
        state_(start),
        at_{parts.data(), parts.data() + parts.size()} {}

  bool finished() const { return at_.next == at_.end && open_.empty(); }
  const State& state() const { return state_; }
  /// Parts that it went through, kept drawings and all others; 0 unless counts_inner_loop.
  std::uint64_t parts_taken() const { return parts_taken_.count(); }

  /// Calls each(entry, state) for kept drawings, until they have `enough` segments or all is done.
  /// Returns how many they had.
  template <class Each>
  std::uint64_t run(std::uint64_t enough, const Each& each) {
    std::uint64_t segments = 0;
    while (segments < enough) {
      if (at_.next == at_.end) {
        if (open_.empty()) break;
        at_ = open_.back();
        open_.pop_back();
        continue;
      }
      const Index part = *at_.next++;
      parts_taken_.add(1);
      if (part == SymbolDrawings::store) {
        stored_.push_back(state_);
      } else if (part == SymbolDrawings::restore) {
        state_ = stored_.back();
        stored_.pop_back();
      } else {
        segments += take(part, each);
      }
    }
    return segments;
  }

 private:
  /// Parts that are still to come.
  struct Rest {
    const Index* next = nullptr;
    const Index* end = nullptr;
  };

  template <class Each>
  std::uint64_t take(Index drawing, const Each& each) {
    const Entry& entry = entries_[drawing];
    if (entry.kind == Entry::Kind::parts) {
      // A last part needs no way back: however deep such a chain is, it takes no memory.
      if (at_.next != at_.end) open_.push_back(at_);
      at_ = {parts_ + entry.first, parts_ + entry.first + entry.count};
      return 0;
    }
    std::uint64_t segments = 0;
    if (entry.kind == Entry::Kind::block) {
      each(entry, state_);
      segments = entry.count;
    }
    turtle_->move(state_, entry.motion);
    return segments;
  }

  const Index* parts_;
  const Entry* entries_;
  const Turtle* turtle_;
  State state_;
  Rest at_;
  std::vector<Rest> open_;
  std::vector<State> stored_;
  InnerLoopCounter parts_taken_;
};

}  // namespace phytobench
