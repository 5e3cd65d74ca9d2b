// SPDX-License-Identifier: MIT
#include "core/lsystem/derivation_engine.hpp"

#include <array>

#include "core/contract/registered.hpp"

namespace phytobench {

namespace derivation_engines {
#define DERIVATION(name, dependency) extern const DerivationEngine name;
#include "core/lsystem/derivation_engines.def"
#undef DERIVATION
}  // namespace derivation_engines

namespace {

constexpr auto table = std::to_array<const DerivationEngine*>({
#define DERIVATION(name, dependency) &derivation_engines::name,
#include "core/lsystem/derivation_engines.def"
#undef DERIVATION
});

}  // namespace

std::span<const DerivationEngine* const> all_derivation_engines() {
  return table;
}

const DerivationEngine& derivation_engine_named(std::string_view name) {
  return registered_as(name, "engine", all_derivation_engines());
}

}  // namespace phytobench
