// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <functional>
#include <memory>

#include "core/terrain/shadow/shadow_engine.hpp"

namespace phytobench::cli {

/// Another engine's shadows, a few hours at a time, so that a user who waits sees how far it is and
/// can stop it.
class ShadowsByTheHour final : public ShadowEngine {
 public:
  /// before(hour, hours) is called before each of the steps; it may throw.
  ShadowsByTheHour(std::unique_ptr<ShadowEngine> engine,
                   std::function<void(std::size_t, std::size_t)> before)
      : engine_(std::move(engine)), before_(std::move(before)) {}

  ShadowWork cast(const HeightField& field, std::span<const SunDirection> suns,
                  const ShadowSetup& setup, LitMaps& lit) override {
    lit.reset(field.columns(), field.rows(), suns.size());
    ShadowWork work;
    const auto step = static_cast<std::size_t>(std::max(1, setup.threads));
    for (std::size_t first = 0; first < suns.size(); first += step) {
      before_(first, suns.size());
      const std::size_t count = std::min(step, suns.size() - first);
      work = work + engine_->cast(field, suns.subspan(first, count), setup, part_);
      const std::size_t words = part_.words_per_row() * static_cast<std::size_t>(field.rows());
      for (std::size_t hour = 0; hour < count; ++hour)
        std::copy_n(part_.row(hour, 0), words, lit.row(first + hour, 0));
    }
    return work;
  }

 private:
  std::unique_ptr<ShadowEngine> engine_;
  std::function<void(std::size_t, std::size_t)> before_;
  LitMaps part_;
};

}  // namespace phytobench::cli
