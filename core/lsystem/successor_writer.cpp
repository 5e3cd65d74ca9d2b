// SPDX-License-Identifier: MIT
#include "core/lsystem/successor_writer.hpp"

#include <bit>
#include <cstring>

#include "core/contract/check.hpp"
#include "core/lsystem/derive.hpp"

namespace phytobench {

template <class Index>
void write_symbols(std::span<const Index> outcomes, const SymbolRun* runs,
                   std::span<SymbolIndex> out) {
  SymbolIndex* to = out.data();
  SymbolIndex* const end = to + out.size();
  const Index* outcome = outcomes.data();
  const Index* const last = outcome + outcomes.size();
  // A short run is copied with what lies behind it, in one move; the next one goes over that.
  while (outcome != last && end - to >= static_cast<std::ptrdiff_t>(SymbolRun::readable)) {
    const SymbolRun run = runs[*outcome++];
    if (run.count <= SymbolRun::readable)
      std::memcpy(to, run.first, SymbolRun::readable);
    else
      std::memcpy(to, run.first, run.count);
    to += run.count;
  }
  for (; outcome != last; ++outcome) {
    const SymbolRun run = runs[*outcome];
    std::memcpy(to, run.first, run.count);
    to += run.count;
  }
  PHYTOBENCH_ENSURE(to == end);
}

namespace {

void write_expressions(const ParameterSource& source, const ParameterRun& run, OutcomeIndex outcome,
                       std::size_t position, const double* in, double* out) {
  const CompiledExpression* const expressions = source.table->expressions() + run.first;
  if (run.work == ParameterRun::Work::contextual) {
    // The production was chosen because its contexts fit; only their parameters are wanted now.
    source.contexts->fits(source.table->pattern_of(outcome), position, source.gathered);
    in = source.gathered;
  }
  const ExpressionRandom random = random_place_of(source.seed, source.step, position);
  for (std::size_t i = 0; i < run.count; ++i) out[i] = expressions[i].evaluate(in, random);
}

}  // namespace

template <class Index>
void write_parameters(const ParameterSource& source, std::span<const Index> outcomes,
                      std::size_t position, const double* in, std::span<double> out) {
  const ParameterRun* const runs = source.table->parameter_runs();
  const LinearParameter* const linear = source.table->linear_parameters();
  double* __restrict to = out.data();
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const ParameterRun& run = runs[outcomes[i]];
    if (run.work == ParameterRun::Work::linear) {
      const LinearParameter* const parameters = linear + run.first;
      for (std::size_t p = 0; p < run.count; ++p) to[p] = parameters[p].value(in);
    } else {
      write_expressions(source, run, outcomes[i], position + i, in, to);
    }
    to += run.count;
    in += run.consumed;
  }
  PHYTOBENCH_ENSURE(to == out.data() + out.size());
}

bool all_finite(std::span<const double> numbers) {
  // An exponent of ones runs over into the sign, which is cleared before.
  constexpr std::uint64_t exponent = 0x7ff0000000000000u;
  constexpr std::uint64_t one = 0x0010000000000000u;
  std::uint64_t seen = 0;
  for (const double number : numbers)
    seen |= (std::bit_cast<std::uint64_t>(number) & exponent) + one;
  return (seen >> 63) == 0;
}

template void write_symbols(std::span<const SymbolIndex>, const SymbolRun*, std::span<SymbolIndex>);
template void write_symbols(std::span<const OutcomeIndex>, const SymbolRun*,
                            std::span<SymbolIndex>);
template void write_parameters(const ParameterSource&, std::span<const SymbolIndex>, std::size_t,
                               const double*, std::span<double>);
template void write_parameters(const ParameterSource&, std::span<const OutcomeIndex>, std::size_t,
                               const double*, std::span<double>);

}  // namespace phytobench
