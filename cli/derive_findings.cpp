// SPDX-License-Identifier: MIT
#include "cli/derive_findings.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/terminal.hpp"
#include "core/contract/check.hpp"
#include "core/contract/counted_noun.hpp"
#include "core/contract/errors.hpp"
#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/drawing_plant.hpp"
#include "core/lsystem/growth_counter.hpp"

namespace phytobench::cli {

namespace {

void refuse_disagreement(const std::string& problem) {
  if (!problem.empty())
    throw ContractViolation(problem + " (a bug in phytobench, please report it with the system)");
}

bool report_drawing(std::uint64_t segments) {
  show_progress("drawing: " + counted_noun(segments, "segment"));
  return !is_interrupted();
}

std::optional<std::uint64_t> unless_saturated(std::uint64_t count) {
  return count == GrowthCounter::most ? std::nullopt : std::optional(count);
}

/// Numbers that core counts; the oracle's have no limit.
void check_forecast(const DeriveFindings& findings, const LSystem& system) {
  if (!findings.predicted) return;
  for (std::size_t i = 0; i < findings.symbols.size(); ++i)
    if (findings.symbols[i] && findings.predicted->symbols[i].number != findings.symbols[i])
      refuse_disagreement(fmt::format(
          "'{}' is counted {} where the matrix counts {}", name_of(system.symbols[i]),
          counted_noun(*findings.symbols[i], "time"), findings.predicted->symbols[i].digits));
}

void count_ahead(DeriveFindings& findings, const LSystem& system,
                 const LSystemDeriveOptions& options) {
  const auto most_modules = static_cast<std::uint64_t>(options.most_modules);
  GrowthCounter counter(system);
  for (int step = 0; step <= system.steps; ++step) {
    if (step > 0) counter.advance();
    if (step % 4096 == 4095 && is_interrupted()) throw Interrupted("nothing is counted");
    const bool fits =
        counter.modules() <= most_modules && counter.parameters() <= most_parameters(options);
    if (!fits && !findings.longest_made) findings.longest_made = step - 1;
  }
  findings.modules = unless_saturated(counter.modules());
  for (const std::uint64_t count : counter.symbols())
    findings.symbols.push_back(unless_saturated(count));
}

std::string why_not_predicted(const LSystem& system) {
  const LSystemKind kind = kind_of(system);
  if (kind.contextual) return "successors depend on contexts";
  if (kind.conditional) return "successors depend on conditions";
  if (kind.stochastic_choice) return "successors are drawn by lot";
  return "counting so long numbers in so many steps by the matrix would take too long";
}

}  // namespace

std::uint64_t most_parameters(const LSystemDeriveOptions& options) {
  constexpr std::uint64_t per_module = 4;  // as DeriveOptions has it
  return per_module * static_cast<std::uint64_t>(options.most_modules);
}

DeriveFindings forecast_findings(const LSystem& system, const LSystemDeriveOptions& options) {
  DeriveFindings findings;
  if (kind_of(system).has_fixed_successors()) count_ahead(findings, system, options);
  findings.predicted = predicted_symbols(system, system.steps);
  if (!findings.predicted) findings.not_predicted = why_not_predicted(system);
  check_forecast(findings, system);
  return findings;
}

bool is_too_long(const DeriveFindings& forecast) {
  return forecast.longest_made.has_value();
}

void add_streamed_drawing(DeriveFindings& findings, const LSystem& system) {
  constexpr std::uint64_t most_segments = 10'000'000'000;  // a minute or two
  findings.not_drawn = objection_to_streaming(system);
  if (!findings.not_drawn.empty()) return;
  try {
    const SegmentStream stream(system, system.steps);
    if (stream.segment_count() > most_segments) {
      findings.not_drawn = fmt::format("would be more than {} segments", most_segments);
      return;
    }
    findings.drawn = drawn_extent(stream, report_drawing);
  } catch (const InputError& error) {  // more steps than a stream can have
    findings.not_drawn = error.what();
    return;
  }
  if (findings.predicted)
    refuse_disagreement(segment_count_disagreement(findings.drawn->segments, *findings.predicted));
}

void add_word(DeriveFindings& findings, const LSystem& system, const Word& word) {
  findings.made = true;
  findings.modules = word.size();
  findings.parameters = word.parameters.size();
  findings.word_hash = word_hash(system, word);
  const std::vector<std::uint64_t> counts = symbol_counts(system, word);
  findings.symbols.assign(counts.begin(), counts.end());
  if (findings.predicted)
    refuse_disagreement(symbol_count_disagreement(system, counts, *findings.predicted));
}

void add_drawing(DeriveFindings& findings, const LSystem& system, const Word& word) {
  findings.drawn = drawn_extent(system, word, report_drawing);
  if (findings.predicted)
    refuse_disagreement(segment_count_disagreement(findings.drawn->segments, *findings.predicted));
}

std::optional<TurtleTree> add_tree(DeriveFindings& findings, const LSystem& system,
                                   const Word& word) {
  constexpr std::uint64_t most_segments = 4'000'000;
  PHYTOBENCH_EXPECT(findings.drawn.has_value());
  if (findings.drawn->segments == 0) {
    findings.no_tree =
        findings.drawn->polygons == 0 ? "nothing is drawn" : "only polygons are drawn";
    return std::nullopt;
  }
  if (findings.drawn->segments > most_segments) {
    findings.no_tree = fmt::format("more than {} segments are not looked at", most_segments);
    return std::nullopt;
  }
  try {
    TurtleTree tree = turtle_tree(system, word);
    const Skeleton& skeleton = tree.skeleton;
    findings.tree = DrawnTree{.nodes = skeleton.node_count(),
                              .tips = tip_count(skeleton),
                              .largest_degree = child_counts(skeleton).rbegin()->first,
                              .depth = edge_depth(skeleton),
                              .root_radius = drawing_radii(tree, {}).front()};
    return tree;
  } catch (const InputError&) {  // all other errors have come up in drawn_extent()
    findings.no_tree = "the turtle draws after a move without drawing";
    return std::nullopt;
  }
}

std::string beginning_of(const LSystem& system, const Word& word, std::uint64_t modules) {
  Word beginning;
  const std::size_t count = std::min<std::uint64_t>(modules, word.size());
  std::size_t parameters = 0;
  for (std::size_t i = 0; i < count; ++i) parameters += system.symbols[word.symbols[i]].arity;
  beginning.symbols.resize_for_overwrite(count);
  beginning.parameters.resize_for_overwrite(parameters);
  std::copy_n(word.symbols.data(), count, beginning.symbols.data());
  std::copy_n(word.parameters.data(), parameters, beginning.parameters.data());
  return text_of(system, beginning);
}

}  // namespace phytobench::cli
