// SPDX-License-Identifier: MIT
// Ground that several zones cover is divided once among all of them, not once for every pair.
#include <numeric>
#include <vector>

#include "core/competition/competition_rule.hpp"
#include "core/competition/zone_laws.hpp"
#include "core/overlap/ground_shares.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench::competition_rules {

namespace {

/// Pairs as other rules count them: across a border a plant meets an image of the other, and the
/// other one of it.
std::uint64_t pairs_of_plants(const OverlapPairs& pairs, std::size_t plants) {
  std::uint64_t inside = 0, across = 0;
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const bool first = static_cast<std::size_t>(pairs.first()[k]) < plants;
    const bool second = static_cast<std::size_t>(pairs.second()[k]) < plants;
    inside += first && second;
    across += first != second;
  }
  return inside + across / 2;
}

class ExactShares final : public CompetitionRule {
 public:
  explicit ExactShares(const CompetitionParameters& parameters)
      : exponent_(parameters.asymmetry_exponent), ties_(parameters.ties) {}

  void assess(const CompetingPlants& plants, const Ground& ground, PairSearch& search,
              std::span<double> loss) override {
    const Discs& zone = plants.below;
    const SharingLaw law{.exponent = exponent_, .tie_order = tie_order(plants)};
    // The search knows the plane alone: images come as discs of their own, behind the plants.
    const PairFinder find = [&](const Discs& discs) -> const OverlapPairs& {
      const OverlapPairs& pairs = search.find_uncounted(discs, {});
      search.count_pairs(pairs_of_plants(pairs, plants.size()));
      return pairs;
    };
    ground_shares(zone, ground, law, search.threads(), find, loss);
    for_blocks(loss.size(), search.threads(), [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const double area = disc_area(zone.radius[i]);
        loss[i] = area > 0.0 ? 1.0 - loss[i] / area : 0.0;
      }
    });
  }

 private:
  std::span<const std::uint64_t> tie_order(const CompetingPlants& plants) {
    if (ties_ == TieRule::share) return {};
    if (!plants.id.empty()) return plants.id;
    index_.resize(plants.size());
    std::iota(index_.begin(), index_.end(), std::uint64_t{0});
    return index_;
  }

  double exponent_;
  TieRule ties_;
  std::vector<std::uint64_t> index_;
};

}  // namespace

extern const CompetitionRuleDescriptor exact_shares;
constinit const CompetitionRuleDescriptor exact_shares{
    .name = "exact_shares",
    .summary =
        "Every piece of ground is divided once among all plants whose zones cover it, by their "
        "area to a power.",
    .source = "assimilation model of siplab (Garcia 2014), without its cells",
    .create = [](const CompetitionParameters& parameters) -> std::unique_ptr<CompetitionRule> {
      return std::make_unique<ExactShares>(parameters);
    },
};

}  // namespace phytobench::competition_rules
