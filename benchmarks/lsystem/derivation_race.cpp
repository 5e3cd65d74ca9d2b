// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/derivation_race.hpp"

#include <chrono>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/lsystem/derive.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

class DerivationRace {
 public:
  explicit DerivationRace(const DerivationRaceRequest& request) : request_(request) {}

  std::vector<DerivationEntry> run() {
    std::vector<const DerivationCase*> cases;
    for (const DerivationCase& one : request_.cases)
      for (const int threads : request_.threads) {
        cases.push_back(&one);
        DerivationEntry& entry = entries_.emplace_back();
        entry.name = one.name;
        entry.steps = one.steps;
        entry.threads = threads;
        entry.every_word = one.every_word;
        check(one, entry);
      }
    for (int round = 0; round < request_.rounds; ++round) {
      CounterStream order(request_.order_seed, 500 + static_cast<std::uint64_t>(round));
      for (const std::size_t i : random_order(entries_.size(), order))
        time(*cases[i], entries_[i], round);
    }
    return std::move(entries_);
  }

 private:
  void progress(const std::string& what, const DerivationEntry& entry) const {
    if (request_.is_interrupted && request_.is_interrupted()) throw Interrupted("no result");
    if (request_.show_progress)
      request_.show_progress(fmt::format("{} {}, {} steps", what, entry.name, entry.steps));
  }

  static DeriveOptions options_of(const DerivationEntry& entry) {
    DeriveOptions options;
    options.steps = entry.steps;
    options.threads = entry.threads;
    options.most_modules = 1'000'000'000;
    if (entry.every_word) options.each_word = [](int, const Word&) {};
    return options;
  }

  void check(const DerivationCase& one, DerivationEntry& entry) const {
    progress("checking", entry);
    DeriveOptions options = options_of(entry);
    if (entry.every_word)
      options.each_word = [&](int step, const Word& word) {
        if (step > 0) entry.modules_made += word.size();
      };
    const Word word = derive(one.system, options);
    if (!entry.every_word) entry.modules_made = word.size();
    entry.objection = one.objection(word);
    if (entry.threads > 1 && entry.objection.empty()) {
      DeriveOptions alone = options_of(entry);
      alone.threads = 1;
      if (word_hash(one.system, word) != word_hash(one.system, derive(one.system, alone)))
        entry.objection = "another word with another number of threads";
    }
    entry.modules = word.size();
    entry.bytes_per_module = static_cast<double>(word.bytes()) / static_cast<double>(word.size());
  }

  void time(const DerivationCase& one, DerivationEntry& entry, int round) const {
    if (!entry.objection.empty()) return;
    progress(fmt::format("round {}:", round + 1), entry);
    const DeriveOptions options = options_of(entry);
    const auto start = std::chrono::steady_clock::now();
    const Word word = derive(one.system, options);
    const auto end = std::chrono::steady_clock::now();
    PHYTOBENCH_ENSURE(word.size() == entry.modules);
    entry.seconds.push_back(std::chrono::duration<double>(end - start).count());
  }

  const DerivationRaceRequest& request_;
  std::vector<DerivationEntry> entries_;
};

}  // namespace

std::vector<DerivationEntry> race_derivations(const DerivationRaceRequest& request) {
  return DerivationRace(request).run();
}

}  // namespace phytobench
