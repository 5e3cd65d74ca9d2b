// SPDX-License-Identifier: MIT
#include "core/random/unit_stream.hpp"

#include "core/random/counter_stream.hpp"
#include "core/random/subtractive_stream.hpp"

namespace phytobench {

std::string_view name_of(StreamKind kind) {
  return kind == StreamKind::counter ? "counter" : "subtractive";
}

std::unique_ptr<UnitStream> make_stream(StreamKind kind, std::uint64_t seed, std::uint64_t stream) {
  if (kind == StreamKind::counter) return std::make_unique<CounterStream>(seed, stream);
  return std::make_unique<SubtractiveStream>(seed);
}

}  // namespace phytobench
