// SPDX-License-Identifier: MIT
#include <memory>

#include "benchmarks/faulty_shadow_engines/right_maps.hpp"

namespace phytobench::shadow_engines {

namespace {

class Engine final : public ShadowEngine {
 public:
  ShadowWork cast(const HeightField& field, std::span<const SunDirection> suns,
                  const ShadowSetup& setup, LitMaps& lit) override {
    const ShadowWork work =
        shadow_engine_named("exact_traversal").create()->cast(field, suns, setup, lit);
    // The last word that has a vertex in the sun loses one.
    for (std::size_t s = suns.size(); s-- > 0;)
      for (int row = field.rows(); row-- > 0;)
        for (std::size_t w = lit.words_per_row(); w-- > 0;)
          if (std::uint64_t& word = lit.row(s, row)[w]; word != 0) {
            word &= word - 1;
            return work;
          }
    return work;
  }
};

std::unique_ptr<ShadowEngine> create() {
  return std::make_unique<Engine>();
}

}  // namespace

extern const ShadowEngineDescriptor forgets_one_vertex;
constinit const ShadowEngineDescriptor forgets_one_vertex{
    .name = "forgets_one_vertex",
    .summary = "Wrong on purpose: one vertex of the last map stays dark.",
    .source = "a loop that ends too early",
    .create = create,
};

}  // namespace phytobench::shadow_engines
