// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/judged_pair.hpp"

#include <algorithm>

namespace phytobench {

namespace {

using VerifiedByName = std::map<std::string, VerifiedBenchmark>;

VerifiedByName verified_by_name(TimedSide& side, const std::vector<std::string>& wanted) {
  const std::vector<std::string> known = side.names();
  std::vector<std::string> names;
  for (const std::string& name : wanted)
    if (std::find(known.begin(), known.end(), name) != known.end()) names.push_back(name);
  VerifiedByName verified;
  if (names.empty()) return verified;
  for (VerifiedBenchmark& benchmark : side.verify(names)) {
    const std::string name = benchmark.name;
    verified.insert_or_assign(name, std::move(benchmark));
  }
  return verified;
}

MeasuredBenchmark other_work(const std::string& name, const std::string& why) {
  return {.name = name, .objection = why, .is_same_work = false};
}

/// Either may be null: that side does not have it.
MeasuredBenchmark judged(const std::string& name, const VerifiedBenchmark* base,
                         const VerifiedBenchmark* other) {
  if (base == nullptr && other == nullptr) return other_work(name, "neither side has it");
  if (base == nullptr) return other_work(name, std::string(only_new_has_it));
  if (other == nullptr) return other_work(name, "new does not have it");
  if (!other->objection.empty()) return {.name = name, .objection = "new: " + other->objection};
  // Whoever mends a wrong answer must not be refused for it.
  if (!base->objection.empty())
    return other_work(name, std::string(base_is_wrong) + base->objection);
  if (base->inputs != other->inputs) return other_work(name, "the inputs of both sides differ");
  if (base->answer != other->answer)
    return other_work(name, "the answers of both sides are right, but differ");
  return {.name = name};
}

const VerifiedBenchmark* found(const VerifiedByName& verified, const std::string& name) {
  const auto place = verified.find(name);
  return place == verified.end() ? nullptr : &place->second;
}

}  // namespace

JudgedPair judge_pair(TimedSide& base, TimedSide& other, const std::vector<std::string>& names) {
  const VerifiedByName base_verified = verified_by_name(base, names);
  const VerifiedByName other_verified = verified_by_name(other, names);
  JudgedPair pair;
  for (const std::string& name : names) {
    pair.benchmarks.push_back(
        judged(name, found(base_verified, name), found(other_verified, name)));
    if (pair.benchmarks.back().objection.empty())
      pair.answers[name] = base_verified.at(name).answer;
  }
  return pair;
}

}  // namespace phytobench
