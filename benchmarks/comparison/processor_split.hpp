// SPDX-License-Identifier: MIT
// A timed program has a processor to itself, and whoever waits for it keeps to another: even ten
// looks a second would push it off, and its caches would fill with somebody else's data.
#pragma once

#include <optional>
#include <vector>

namespace phytobench {

struct ProcessorSplit {
  int runner = 0;  ///< the first allowed: systems handle most interrupts there
  int worker = 0;  ///< the last allowed
};

/// Processors that this thread may run on, ascending; empty where the system does not tell.
std::vector<int> allowed_processors();

/// Nothing where there are not two to choose from: programs then stay where the system puts them.
/// Ask for it before anything is pinned.
std::optional<ProcessorSplit> processor_split(const std::vector<int>& allowed);

/// Keeps this thread on one processor as long as it lives; programs started meanwhile stay there,
/// too, unless they are given another. Does nothing without a processor, or where it is refused.
class PinnedThread {
 public:
  explicit PinnedThread(std::optional<int> processor);
  ~PinnedThread();
  PinnedThread(const PinnedThread&) = delete;
  PinnedThread& operator=(const PinnedThread&) = delete;

 private:
  std::vector<int> before_;  ///< empty: nothing to restore
};

}  // namespace phytobench
