// SPDX-License-Identifier: MIT
#include "core/lsystem/derive.hpp"

#include "core/contract/check.hpp"
#include "core/lsystem/derivation.hpp"

namespace phytobench {

Word derive(const LSystem& system, const DeriveOptions& options) {
  PHYTOBENCH_EXPECT(options.steps >= 0 && options.threads >= 1 && !system.axiom.empty());
  return Derivation(system, options).run();
}

ExpressionRandom random_place_of(std::uint64_t seed, int step, std::uint64_t position) {
  return {seed, 2 * static_cast<std::uint64_t>(step) + 1, 256 * position};
}

}  // namespace phytobench
