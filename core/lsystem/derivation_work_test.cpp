// SPDX-License-Identifier: MIT
// What derivations and drawings say of their work.
#include <gtest/gtest.h>

#include "core/contract/work_counting.hpp"
#include "core/lsystem/derivation_engine.hpp"
#include "core/lsystem/derive.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/lsystem/word.hpp"

namespace phytobench {
namespace {

DerivationWork work_of(const LSystem& system, int steps, bool every_word, int threads = 1) {
  DerivationWork work;
  DeriveOptions options;
  options.steps = steps;
  options.threads = threads;
  options.work = &work;
  if (every_word) options.each_word = [](int, const Word&) {};
  derive(system, options);
  return work;
}

/// 1 2 4 8 ... modules.
LSystem doubling() {
  return parse_lsystem("axiom: A(1)\nA(x) -> A(x)A(x + 1)\n", "doubling");
}

TEST(DerivationWork, AddsUpAllWords) {
  const DerivationWork work = work_of(doubling(), 10, false);
  EXPECT_EQ(work.modules_read, 1023u);
  EXPECT_EQ(work.modules_written, 2046u);
  EXPECT_EQ(work.parameters_written, 2046u);
  EXPECT_EQ(work.productions_tried, 0u);  // every letter has one, without a condition
}

TEST(DerivationWork, IsLessWhereWordsArePassedOver) {
  const LSystem letters = parse_lsystem("axiom: A\nA -> AA\n", "letters");
  EXPECT_EQ(work_of(letters, 12, true).modules_written, 8190u);
  EXPECT_LT(work_of(letters, 12, false).modules_written, 8190u);
  EXPECT_GE(work_of(letters, 12, false).modules_written, 4096u);
}

/// By single steps of a word of n modules it would be half of n squared.
TEST(DerivationWork, IsLinearWhereWordsGrowLinearly) {
  const LSystem chain = parse_lsystem("axiom: A\nA -> F[+A]\n", "chain");
  for (const int steps : {20'000, 100'003, 1'000'000})
    EXPECT_LT(work_of(chain, steps, false).modules_written, 70u * 4u * static_cast<unsigned>(steps))
        << steps;
}

TEST(DerivationWork, OfManyStepsAtOnceIsOfTheSameWord) {
  const LSystem system =
      parse_lsystem("axiom: AD\nA -> F[+A]\nF -> B\nB -> *\nD -> E\nE -> D-\n", "chain");
  DeriveOptions options;
  for (const int steps : {63, 64, 127, 128, 129, 1000, 4097}) {
    options.steps = steps;
    options.each_word = {};
    const Word at_once = derive(system, options);
    options.each_word = [](int, const Word&) {};
    EXPECT_EQ(word_hash(system, at_once), word_hash(system, derive(system, options))) << steps;
  }
}

TEST(DerivationWork, CountsProductionsByPolicy) {
  const LSystem chosen = parse_lsystem(
      "axiom: A(0)B\n"
      "A(x) : x > 3 -> A(0)\n"
      "A(x) : x > 2 -> A(4)\n"
      "A(x) -> A(x + 1)\n",
      "chosen");
  // Of 0, 1 and 2 all three are looked at, of 3 two, of 4 one; B has none.
  const DerivationWork work = work_of(chosen, 5, true);
  EXPECT_EQ(work.productions_tried, counts_inner_loop ? 3u + 3u + 3u + 2u + 1u : 0u);
  EXPECT_EQ(work.modules_read, 10u);
}

TEST(DerivationWork, DoesNotDependOnThreads) {
  const LSystem system =
      parse_lsystem("axiom: A(0)\nA(x) : x < 9 -> A(x + 1)A(x + 2)\nA(x) -> B(x)\n", "threads");
  const DerivationWork one = work_of(system, 17, true), several = work_of(system, 17, true, 3);
  EXPECT_EQ(one.modules_read, several.modules_read);
  EXPECT_EQ(one.modules_written, several.modules_written);
  EXPECT_EQ(one.productions_tried, several.productions_tried);
}

TEST(DrawingWork, TellsWordsThatAreBuiltFromPartsThatAreMoved) {
  const LSystem island = parse_lsystem("axiom: F-F-F-F\nF -> F-F+F+FF-F-F+F\nangle: 90\n", "x");
  const auto draw = [&](const char* engine) {
    return derivation_engine_named(engine).draw_planar(island, 3, 1,
                                                       [](std::span<const PlanarSegment>) {});
  };
  constexpr std::uint64_t words = 59 + 475 + 3803;  // [Liebemann2017] fig. 2.4
  EXPECT_EQ(draw("string_rewriting").modules_made, words);
  EXPECT_LE(draw("module_by_module").modules_made, words);
  EXPECT_GE(draw("module_by_module").modules_made, 3803u);
  EXPECT_EQ(draw("memoised").modules_made, 0u);
  // Four sides as wholes would be 2048 segments; parts are at most 512 of them each.
  const std::uint64_t parts = draw("memoised").parts_taken;
  if (counts_inner_loop) {
    EXPECT_GE(parts, 4u);
    EXPECT_LT(parts, 2048u);
  } else {
    EXPECT_EQ(parts, 0u);
  }
}

TEST(DrawingWork, DoesNotDependOnThreads) {
  const LSystem island = parse_lsystem("axiom: F-F-F-F\nF -> F-F+F+FF-F-F+F\nangle: 90\n", "x");
  const SegmentStream stream(island, 6);
  std::vector<PlanarSegment> segments(stream.segment_count());
  const std::uint64_t parts = stream.write(std::span<PlanarSegment>(segments), 1);
  EXPECT_EQ(stream.write(std::span<PlanarSegment>(segments), 3), parts);
  EXPECT_EQ(stream.stream(SegmentSink<PlanarSegment>([](std::span<const PlanarSegment>) {})),
            parts);
}

}  // namespace
}  // namespace phytobench
