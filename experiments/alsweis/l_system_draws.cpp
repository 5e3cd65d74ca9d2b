// SPDX-License-Identifier: MIT
// Words of L-system 1 drawn by chance, beside the law that follows from its probabilities.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "experiments/alsweis/chapter_3_l_systems.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace literal = oracles::alsweis;

/// Upper tail of chi-square with an even number of degrees of freedom.
double chi_square_tail(std::size_t freedom, double statistic) {
  const double x = 0.5 * statistic;
  double term = std::exp(-x), sum = 0.0;
  for (std::size_t k = 0; k < freedom / 2; ++k) {
    sum += term;
    term *= x / static_cast<double>(k + 1);
  }
  return sum;
}

/// Pearson's test; the least likely words share a cell of at least ten, and the freedom is even.
double chi_square_p_value(const WordLaw& law, const std::map<std::string, int>& times, int draws) {
  std::vector<std::pair<double, double>> cells;  // expected, observed
  for (const auto& [word, p] : law) {
    const auto found = times.find(word);
    cells.push_back({value_of(p) * draws, found == times.end() ? 0.0 : found->second});
  }
  std::sort(cells.begin(), cells.end());
  while (cells.size() > 3 && (cells[0].first < 10.0 || cells.size() % 2 == 0)) {
    cells[1].first += cells[0].first;
    cells[1].second += cells[0].second;
    cells.erase(cells.begin());
  }
  double statistic = 0.0;
  for (const auto& [expected, observed] : cells)
    statistic += (observed - expected) * (observed - expected) / expected;
  return chi_square_tail(cells.size() - 1, statistic);
}

int draws_of(Tier tier) {
  return tier == Tier::full ? 1'000'000 : tier == Tier::quick ? 100'000 : 20'000;
}

class Draws {
 public:
  explicit Draws(ExperimentContext& context) : context_(context), draws_(draws_of(context.tier())) {
    const LSystem system = l_system(l_system_1_text());
    DeriveOptions options;
    options.steps = most_steps_of_l_system_1;
    options.each_word = [&](int n, const Word& word) {
      ++times_[static_cast<std::size_t>(n)][text_of(system, word)];
    };
    for (int i = 0; i < draws_; ++i) {
      if (i % 1000 == 0) context.progress(fmt::format("word {} of {}", i, draws_));
      options.seed = (context.seed() << 32) + static_cast<std::uint64_t>(i);
      derive(system, options);
    }
  }

  void record_step(int n) const {
    const WordLaw law = literal::outcomes_of_lsystem_1(n);
    const auto& times = times_[static_cast<std::size_t>(n)];
    double impossible = 0.0, letters_A = 0.0, squares = 0.0, mean = 0.0;
    for (const auto& [word, count] : times) {
      if (!law.contains(word)) impossible += count;
      letters_A += count * static_cast<double>(std::count(word.begin(), word.end(), 'A'));
    }
    for (const auto& [word, p] : law) {
      const auto A = static_cast<double>(std::count(word.begin(), word.end(), 'A'));
      mean += value_of(p) * A;
      squares += value_of(p) * A * A;
      if (n == 1)
        record("n-1/deviation/" + name_of_word(word), deviation(value_of(p), word),
               "standard errors");
    }
    const std::string step = fmt::format("n-{}/", n);
    record(step + "impossible", impossible, "words");
    record(step + "chi_square_p_value", chi_square_p_value(law, times, draws_), "1");
    record(step + "a_deviation",
           (letters_A / draws_ - mean) / std::sqrt((squares - mean * mean) / draws_),
           "standard errors");
  }

 private:
  double deviation(double p, const std::string& word) const {
    const auto found = times_[1].find(word);
    const double times = found == times_[1].end() ? 0.0 : found->second;
    return (times - p * draws_) / std::sqrt(p * (1.0 - p) * draws_);
  }
  void record(const std::string& name, double value, const std::string& unit) const {
    context_.record({.experiment = {},
                     .measurement = name,
                     .value = value,
                     .unit = unit,
                     .sample_size = draws_,
                     .seed = context_.seed()});
  }

  ExperimentContext& context_;
  int draws_;
  std::array<std::map<std::string, int>, most_steps_of_l_system_1 + 1> times_;
};

void run(ExperimentContext& context) {
  const Draws draws(context);
  for (int n = 1; n <= most_steps_of_l_system_1; ++n) draws.record_step(n);
}

}  // namespace

extern const ExperimentDescriptor l_system_draws;
constinit const ExperimentDescriptor l_system_draws{
    .id = "alsweis/l-system-draws",
    .question = "Does chance choose the words of L-system 1 by its probabilities?",
    .source = "[Alsweis] section 3.2, L-system 1",
    .seconds = {0.4, 1.5, 22},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
