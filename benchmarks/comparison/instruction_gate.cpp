// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/instruction_gate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/parallel/for_blocks.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {

namespace {

using Verdict = InstructionVerdict;

/// What can be said without comparing counts; nothing if they are to be compared.
std::optional<std::pair<Verdict, std::string>> without_counts(const CountedPair& pair) {
  if (!pair.is_in_new) return {{Verdict::gone, "only base has it"}};
  if (pair.is_same_binary) return {{Verdict::same_binary, ""}};
  if (!pair.objection.empty()) return {{Verdict::wrong_answer, pair.objection}};
  const auto verdict_on = [](CountOutcome outcome) {
    return outcome == CountOutcome::unsupported ? Verdict::unsupported : Verdict::failed;
  };
  if (pair.other.outcome != CountOutcome::counted)
    return {{verdict_on(pair.other.outcome), pair.other.reason}};
  if (!pair.verified_answer.empty() && pair.other.answer != pair.verified_answer)
    return {{Verdict::wrong_answer, "the counted run gave another answer than was verified"}};
  if (!pair.is_in_base) return {{Verdict::appeared, "base lacks it"}};
  if (pair.base.outcome == CountOutcome::unsupported)
    return {{Verdict::unsupported, "base: " + pair.base.reason}};
  if (pair.base.outcome == CountOutcome::failed)
    return {{Verdict::other_work, "base gives no count: " + pair.base.reason}};
  if (pair.base.inputs != pair.other.inputs) return {{Verdict::other_work, "its inputs differ"}};
  if (pair.base.answer != pair.other.answer)
    return {{Verdict::other_work, "base gives another answer"}};
  return std::nullopt;
}

/// The acceptance that reaches furthest, of those for this benchmark and base; or null.
const AcceptedIncrease* acceptance_of(const CountedPair& pair,
                                      const std::vector<AcceptedIncrease>& accepted,
                                      std::string_view base_commit) {
  const AcceptedIncrease* best = nullptr;
  for (const AcceptedIncrease& one : accepted)
    if (one.applies_to(pair.benchmark, base_commit) &&
        (best == nullptr || one.percent > best->percent))
      best = &one;
  return best;
}

void judge_increase(JudgedInstructions& judged, const AcceptedIncrease* acceptance) {
  judged.verdict = Verdict::more;
  judged.reason = fmt::format("more than {:.1f} %", 100.0 * judged.limit);
  if (acceptance == nullptr) return;
  const bool is_accepted = 100.0 * *judged.change <= acceptance->percent;
  if (is_accepted) judged.verdict = Verdict::accepted;
  judged.reason = is_accepted ? fmt::format("accepted up to {:g} %: {}", acceptance->percent,
                                            acceptance->reason)
                              : fmt::format("more than the accepted {:g} %", acceptance->percent);
}

/// One run of one side.
struct Count {
  const CountedBuild* build;
  const std::string* benchmark;
  InstructionCount* result;
};

std::vector<CountedPair> empty_pairs(const InstructionGateRequest& request) {
  std::map<std::string, CountedPair> pairs;
  for (const std::string& name : request.base.benchmarks) pairs[name].is_in_new = false;
  for (const std::string& name : request.other.benchmarks) {
    const auto [pair, is_only_here] = pairs.try_emplace(name);
    pair->second.is_in_new = true;
    pair->second.is_in_base = !is_only_here;
  }
  std::vector<CountedPair> list;
  for (auto& [name, pair] : pairs) {
    pair.benchmark = name;
    pair.is_same_binary = request.is_same_binary;
    if (pair.is_in_new && !pair.is_same_binary && request.objection_to)
      pair.objection = request.objection_to(name);
    if (pair.is_in_new && !pair.is_same_binary && request.verified_answer_of)
      pair.verified_answer = request.verified_answer_of(name);
    if (request.earlier_changes) pair.earlier_changes = request.earlier_changes(name);
    list.push_back(std::move(pair));
  }
  return list;
}

/// Both sides of a benchmark one after the other; what is refused anyway is not run.
std::vector<Count> counts_of(const InstructionGateRequest& request,
                             std::vector<CountedPair>& pairs) {
  std::vector<Count> counts;
  for (CountedPair& pair : pairs) {
    if (!pair.is_in_new || pair.is_same_binary || !pair.objection.empty()) continue;
    if (pair.is_in_base) counts.push_back({&request.base, &pair.benchmark, &pair.base});
    counts.push_back({&request.other, &pair.benchmark, &pair.other});
  }
  return counts;
}

}  // namespace

std::string_view name_of(InstructionVerdict verdict) {
  switch (verdict) {
    case Verdict::wrong_answer:
      return "wrong answer";
    case Verdict::failed:
      return "failed";
    case Verdict::more:
      return "more";
    case Verdict::unsupported:
      return "unsupported";
    case Verdict::accepted:
      return "accepted";
    case Verdict::slightly_more:
      return "slightly more";
    case Verdict::other_work:
      return "other work";
    case Verdict::appeared:
      return "new";
    case Verdict::gone:
      return "gone";
    case Verdict::fewer:
      return "fewer";
    case Verdict::same:
      return "same";
    case Verdict::same_binary:
      return "same binary";
  }
  return "";
}

double change_limit(std::span<const double> earlier_changes, const InstructionRules& rules) {
  if (earlier_changes.size() < rules.least_history) return rules.least_limit;
  std::vector<double> sizes;
  for (const double change : earlier_changes) sizes.push_back(std::abs(change));
  const double q1 = quantile(sizes, 0.25), q3 = quantile(sizes, 0.75);
  return std::max(rules.least_limit, q3 + 3.0 * (q3 - q1));
}

JudgedInstructions judge_instructions(const CountedPair& pair,
                                      const std::vector<AcceptedIncrease>& accepted,
                                      std::string_view base_commit, const InstructionRules& rules) {
  JudgedInstructions judged{.benchmark = pair.benchmark,
                            .limit = change_limit(pair.earlier_changes, rules),
                            .pair = pair};
  if (const auto known = without_counts(pair)) {
    judged.verdict = known->first;
    judged.reason = known->second;
    return judged;
  }
  const auto before = static_cast<double>(pair.base.totals.instructions);
  PHYTOBENCH_EXPECT(before > 0.0);
  judged.change = static_cast<double>(pair.other.totals.instructions) / before - 1.0;
  if (*judged.change > judged.limit)
    judge_increase(judged, acceptance_of(pair, accepted, base_commit));
  else if (*judged.change > rules.noted)
    judged.verdict = Verdict::slightly_more;
  else
    judged.verdict = *judged.change < -rules.noted ? Verdict::fewer : Verdict::same;
  return judged;
}

bool is_failure(InstructionVerdict verdict) {
  return verdict == Verdict::wrong_answer || verdict == Verdict::failed || verdict == Verdict::more;
}

int exit_code_of(const std::vector<JudgedInstructions>& judged) {
  const auto any = [&](const auto& test) {
    return std::any_of(judged.begin(), judged.end(),
                       [&](const JudgedInstructions& one) { return test(one.verdict); });
  };
  if (any(is_failure)) return 1;
  if (any([](Verdict verdict) { return verdict == Verdict::unsupported; })) return 3;
  const auto compares = [](Verdict verdict) {
    return verdict != Verdict::other_work && verdict != Verdict::appeared &&
           verdict != Verdict::gone;
  };
  return any(compares) ? 0 : 4;
}

CountedBuild counted_build(const Side& side, std::vector<std::string> benchmarks) {
  CountedBuild build{side.worker, side.data_folder, std::move(benchmarks)};
  if (!build.data.empty()) return build;
  for (std::filesystem::path folder = side.worker.parent_path(); folder.has_relative_path();
       folder = folder.parent_path()) {
    std::error_code ignored;
    if (!std::filesystem::is_directory(folder / "share" / "papers", ignored)) continue;
    build.data = folder / "share";
    break;
  }
  return build;
}

std::vector<CountedPair> count_pairs(const InstructionGateRequest& request) {
  std::vector<CountedPair> pairs = empty_pairs(request);
  const std::vector<Count> counts = counts_of(request, pairs);
  std::mutex mutex;
  std::size_t done = 0;
  for_tasks(counts.size(), request.threads, [&](std::size_t i) {
    if (request.is_interrupted && request.is_interrupted()) throw Interrupted("nothing is judged");
    *counts[i].result = count_instructions({.worker = counts[i].build->worker,
                                            .data = counts[i].build->data,
                                            .benchmark = *counts[i].benchmark,
                                            .simulate_cache = request.simulate_cache,
                                            .is_interrupted = request.is_interrupted});
    const std::lock_guard<std::mutex> lock(mutex);
    ++done;
    if (request.show_progress)
      request.show_progress(fmt::format("counting instructions: {} of {} runs, {}", done,
                                        counts.size(), *counts[i].benchmark));
  });
  return pairs;
}

}  // namespace phytobench
