// SPDX-License-Identifier: MIT
// For tests: every instruction set that Highway compiled and this processor has, one at a time.
#pragma once

#include <cstdint>
#include <vector>

#include <hwy/targets.h>

namespace phytobench {

inline std::vector<std::int64_t> vector_targets() {
  std::vector<std::int64_t> targets;
  for (std::int64_t left = hwy::SupportedTargets(); left != 0; left &= left - 1)
    targets.push_back(left & -left);
  return targets;
}

/// While it lives, dispatch takes this target.
class ForcedTarget {
 public:
  explicit ForcedTarget(std::int64_t target) { force(target); }
  ~ForcedTarget() { force(0); }
  ForcedTarget(const ForcedTarget&) = delete;
  ForcedTarget& operator=(const ForcedTarget&) = delete;

 private:
  static void force(std::int64_t target) {
    hwy::SetSupportedTargetsForTest(target);
    hwy::GetChosenTarget().Update(hwy::SupportedTargets());
  }
};

}  // namespace phytobench
