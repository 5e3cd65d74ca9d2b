// SPDX-License-Identifier: MIT
// L-systems that come with the suite: those of the works, and our own.
#include "reference/lsystem_presets.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/lsystem/derive.hpp"
#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "reference/predicted_counts.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

LSystem preset_system(const std::string& name) {
  return read_lsystem(lsystem_preset_file(name));
}

Word word_of(const LSystem& system, int steps) {
  DeriveOptions options;
  options.steps = steps;
  options.seed = system.seed;
  return derive(system, options);
}

Drawing drawing_of(const std::string& name, int steps) {
  const LSystem system = preset_system(name);
  return draw(system, word_of(system, steps));
}

TEST(LSystemPresets, AreThereForEveryGrammarOfTheWorks) {
  std::set<std::string> names;
  for (const LSystemPreset& preset : lsystem_presets()) names.insert(preset.name);
  for (const char* name : {"figure-2.1", "equation-2.2", "figure-2.4", "figure-2.5a", "figure-2.5b",
                           "figure-2.6a", "figure-2.6b", "bush", "bush-abop-slashes", "figure-11",
                           "figure-13", "figure-14", "figure-16", "l-system-1", "l-system-2"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(LSystemPresets, SayWhatTheyAreAndWhereTheyAreFrom) {
  std::set<std::string> names;
  for (const LSystemPreset& preset : lsystem_presets()) {
    SCOPED_TRACE(preset.name);
    EXPECT_GT(preset.summary.size(), 20u);
    EXPECT_TRUE(names.insert(preset.name).second);
    const std::string text = read_text_file(preset.file);
    if (preset.file.string().find("/papers/") != std::string::npos)
      EXPECT_THAT(preset.summary, HasSubstr("["));
    else if (preset.name != "explained")
      EXPECT_THAT(text, HasSubstr("\n# Source: "));
  }
}

TEST(LSystemPresets, AreCountedAsTheirMatrixSaysAndDrawn) {
  const std::set<std::string> undrawn = {"figure-2.1", "equation-2.2", "figure-11", "l-system-1"};
  std::size_t predicted_ones = 0;
  for (const LSystemPreset& one : lsystem_presets()) {
    SCOPED_TRACE(one.name);
    const LSystem system = read_lsystem(one.file);
    const Word word = word_of(system, system.steps);
    const Drawing drawing = draw(system, word);
    EXPECT_EQ(drawing.segments.empty(), undrawn.contains(one.name));
    const auto predicted = predicted_symbols(system, system.steps);
    if (!predicted) continue;
    ++predicted_ones;
    EXPECT_EQ(symbol_count_disagreement(system, symbol_counts(system, word), *predicted), "");
    EXPECT_EQ(segment_count_disagreement(drawing.segments.size(), *predicted), "");
  }
  EXPECT_GE(predicted_ones, 23u);
}

/// By the numbers of segments that their comments promise.
TEST(LSystemPresets, CurvesAreAsLongAsTheySay) {
  struct Case {
    const char* name;
    double factor, base, rest;
  };
  for (const Case& curve :
       {Case{"hilbert", 1, 4, -1}, Case{"peano", 1, 9, -1}, Case{"dragon", 1, 2, 0},
        Case{"sierpinski", 1, 3, 0}, Case{"koch-island", 4, 8, 0},
        Case{"quadratic-snowflake", 1, 5, 0}, Case{"hilbert-3d", 1, 8, -1}}) {
    SCOPED_TRACE(curve.name);
    for (int steps = 1; steps <= 4; ++steps) {
      const Drawing drawing = drawing_of(curve.name, steps);
      EXPECT_EQ(static_cast<double>(drawing.segments.size()),
                curve.factor * std::pow(curve.base, steps) + curve.rest);
      EXPECT_TRUE(is_one_line(drawing));
      EXPECT_EQ(distinct_parts(drawing, 1e-9).most_often, 1u);
    }
  }
}

/// A curve through n cells has n different corners and no more segments than it takes.
TEST(LSystemPresets, CurvesFillTheirCells) {
  struct Case {
    const char* name;
    int steps;
    std::size_t cells;
  };
  for (const Case& curve :
       {Case{"hilbert", 4, 256}, Case{"peano", 2, 81}, Case{"hilbert-3d", 2, 64}}) {
    SCOPED_TRACE(curve.name);
    const Drawing drawing = drawing_of(curve.name, curve.steps);
    EXPECT_EQ(drawing.segments.size(), curve.cells - 1);
    EXPECT_EQ(distinct_parts(drawing, 1e-9).vertices, curve.cells);
    const Vector3 sides = segment_box(drawing).extent() + Vector3{1, 1, drawing.planar ? 0.0 : 1};
    const double volume = sides.x * sides.y * (drawing.planar ? 1.0 : sides.z);
    EXPECT_NEAR(volume, static_cast<double>(curve.cells), 1e-9);
  }
}

TEST(LSystemPresets, TheIslandKeepsItsArea) {
  for (int steps = 0; steps <= 3; ++steps) {
    const Drawing drawing = drawing_of("koch-island", steps);
    EXPECT_EQ(closing_gap(drawing), 0.0);
    EXPECT_EQ(std::abs(signed_area(drawing)), std::pow(16.0, steps));
  }
}

TEST(LSystemPresets, SlashesDecideWhetherTheBushLiesInAPlane) {
  const auto depth = [](const std::string& name) {
    const LSystem system = preset_system(name);
    return segment_box(drawing_of(name, system.steps)).extent().x;
  };
  EXPECT_LT(depth("bush"), 1e-9);
  EXPECT_GT(depth("bush-abop-slashes"), 10.0);
}

/// Twigs that woke earlier have less left to grow, and stand below.
TEST(LSystemPresets, TheSignalWakesBudsFromBelow) {
  const LSystem system = preset_system("signal");
  const SymbolIndex twig = *find_symbol(system, "T", 1);
  std::size_t twigs_before = 0;
  for (int steps = 0; steps <= system.steps; ++steps) {
    const Word word = word_of(system, steps);
    const auto count = [&](const char* letter) {
      return symbol_counts(system, word)[*find_symbol(system, letter, 0)];
    };
    EXPECT_EQ(count("F") + count("G"), static_cast<std::uint64_t>(steps));
    EXPECT_EQ(count("S"), steps > 5 ? 1u : 0u);
    std::vector<double> left;
    const double* parameter = word.parameters.data();
    for (const SymbolIndex symbol : std::span(word.symbols.data(), word.size())) {
      if (symbol == twig) left.push_back(*parameter);
      parameter += system.symbols[symbol].arity;
    }
    EXPECT_TRUE(std::is_sorted(left.begin(), left.end()));
    EXPECT_EQ(left.size(), steps > 7 ? twigs_before + 1 : 0u);
    twigs_before = left.size();
  }
}

TEST(LSystemPresets, AnUnknownNameGetsTheClosestOne) {
  EXPECT_EQ(lsystem_preset_file("figure-2.4").filename(), "figure-2.4.lsys");
  try {
    lsystem_preset_file("dragoon");
    ADD_FAILURE() << "an unknown preset was found";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown preset 'dragoon'; did you mean 'dragon'?"));
    EXPECT_THAT(error.what(), testing::EndsWith("see phytobench list lsystems"));
  }
}

}  // namespace
}  // namespace phytobench
