// SPDX-License-Identifier: MIT
#include "reports/judge/validation.hpp"

#include <algorithm>
#include <charconv>

#include "core/statistics/binomial_interval.hpp"
#include "reports/judge/record_paths.hpp"

namespace phytobench {

namespace {

constexpr const char* certified_prefix = "suite/certified-statistics/nist/";
constexpr const char* exact_prefix = "suite/exact-distributions/exact/";
constexpr const char* ranks_prefix = "suite/interval-coverage/ranks/";
constexpr const char* coverage_prefix = "suite/interval-coverage/";

/// What follows the prefix of a record's name, in parts.
std::vector<std::string> parts_below(const Record& record, std::string_view prefix) {
  return path_parts(std::string_view(record.measurement).substr(prefix.size()));
}

/// "coefficient_3" -> "coefficient": one of several answers of a kind.
std::string kind_of(const std::string& statistic) {
  const std::size_t last = statistic.rfind('_');
  const bool numbered = last != std::string::npos && last + 1 < statistic.size() &&
                        statistic.find_first_not_of("0123456789", last + 1) == std::string::npos;
  return numbered ? statistic.substr(0, last) : statistic;
}

/// Polynomials are fitted, and the deviation of values in memory is taken, on certified sets alone:
/// experiments and judge use straight lines, power laws and running moments.
bool is_unused(const std::string& statistic, const std::string& function) {
  return function == "polynomial_regression" ||
         (function == "moments" && statistic == "standard_deviation");
}

/// "09" -> 9; 0 for what is no number.
std::int64_t count_in(const std::string& text) {
  std::int64_t count = 0;
  std::from_chars(text.data(), text.data() + text.size(), count);
  return count;
}

/// Keeps of both the one with fewer digits.
void merge(CertifiedAnswer& kept, CertifiedAnswer more) {
  more.answers = kept.answers + 1;
  if (more.digits < kept.digits)
    kept = std::move(more);
  else
    kept.answers = more.answers;
}

std::optional<RankedInterval> ranked_interval(const RecordsBelow& records,
                                              const std::string& name) {
  const auto low = records.count(name + "/low"), high = records.count(name + "/high");
  const auto coverage = records.number(name + "/coverage");
  if (!low || !high || !coverage) return std::nullopt;
  return RankedInterval{{static_cast<std::size_t>(*low), static_cast<std::size_t>(*high)},
                        *coverage};
}

/// What the data have lost is lost for every function.
void share_reachable_digits(std::vector<CertifiedAnswer>& answers) {
  for (CertifiedAnswer& answer : answers)
    for (const CertifiedAnswer& other : answers)
      if (!answer.reachable && other.set == answer.set && other.statistic == answer.statistic)
        answer.reachable = other.reachable;
}

void count_samples(const RunContents& run, Validation& validation) {
  for (const Record& record : run.records) {
    if (record.sample_size < 2) continue;
    ++validation.sampled_records;
    validation.spread_records += record.spread.has_value();
  }
}

}  // namespace

bool Validation::any() const {
  return !certified.empty() || !exact.empty() || !transcriptions.empty() || !orders.empty() ||
         !kept.empty() || !ranks.empty() || !coverage.empty() || !rounds.empty();
}

std::vector<CertifiedAnswer> certified_answers(const RunContents& run) {
  const RecordsBelow records(run.records, certified_prefix);
  std::vector<CertifiedAnswer> answers;
  // In the order of the experiment: sets from easy to hard.
  for (const Record& record : run.records) {
    if (!record.measurement.starts_with(certified_prefix)) continue;
    const auto parts = path_parts(
        std::string_view(record.measurement).substr(std::string_view(certified_prefix).size()));
    if (parts.size() != 4 || parts[3] != "digits") continue;
    const std::string name = parts[0] + "/" + parts[1] + "/" + parts[2];
    const auto certified = records.number(name + "/certified");
    const auto computed = records.number(name + "/computed");
    const auto digits = number_of(record);
    if (!certified || !computed || !digits) continue;
    CertifiedAnswer answer{.set = parts[0],
                           .statistic = kind_of(parts[1]),
                           .function = parts[2],
                           .certified = *certified,
                           .computed = *computed,
                           .digits = *digits,
                           .reachable = records.number(name + "/reachable_digits"),
                           .is_counter_example = parts[2] == "sums_of_squares",
                           .is_unused = is_unused(parts[1], parts[2])};
    const auto same = std::find_if(answers.begin(), answers.end(), [&](const auto& other) {
      return other.set == answer.set && other.statistic == answer.statistic &&
             other.function == answer.function;
    });
    if (same == answers.end())
      answers.push_back(std::move(answer));
    else
      merge(*same, std::move(answer));
  }
  share_reachable_digits(answers);
  return answers;
}

std::vector<ExactAnswer> exact_answers(const RunContents& run) {
  const RecordsBelow records(run.records, exact_prefix);
  std::vector<ExactAnswer> answers;
  for (const Record& record : run.records) {
    if (!record.measurement.starts_with(exact_prefix)) continue;
    const auto parts = parts_below(record, exact_prefix);
    if (parts.size() != 3 || parts[2] != "digits") continue;
    const std::string path = parts[0] + "/" + parts[1];
    answers.push_back(
        {.function = parts[0],
         .question = parts[1],
         .judge = records.text(path + "/judge"),
         .values = record.sample_size,
         .digits = number_of(record).value_or(0.0),
         .largest_difference = records.number(path + "/largest_difference").value_or(0.0)});
  }
  return answers;
}

std::vector<IntervalRanks> interval_ranks(const RunContents& run) {
  const RecordsBelow records(run.records, ranks_prefix);
  std::vector<IntervalRanks> rows;
  for (const auto& [name, record] : records.by_name()) {
    const auto parts = path_parts(name);
    if (parts.size() != 3 || parts[1] != "bootstrap" || parts[2] != "other_ends") continue;
    const auto bootstrap = ranked_interval(records, parts[0] + "/bootstrap");
    if (!bootstrap) continue;
    rows.push_back({.values = count_in(parts[0]),
                    .bootstrap = *bootstrap,
                    .other_ends = records.count(name).value_or(0),
                    .tried = record->sample_size,
                    .order_statistics = ranked_interval(records, parts[0] + "/order_statistics")});
  }
  return rows;
}

std::vector<SimulatedCoverage> simulated_coverage(const RunContents& run) {
  std::vector<SimulatedCoverage> rows;
  for (const Record& record : run.records) {
    if (!record.measurement.starts_with(coverage_prefix)) continue;
    const auto parts = parts_below(record, coverage_prefix);
    const auto* const covered = std::get_if<std::int64_t>(&record.value);
    if (parts.size() != 5 || parts[4] != "covered" || !covered) continue;
    rows.push_back({.statistic = parts[0],
                    .values = count_in(parts[1]),
                    .law = parts[2],
                    .method = parts[3],
                    .covered = *covered,
                    .sets = record.sample_size,
                    .share = share_estimate(*covered, record.sample_size)});
  }
  return rows;
}

Validation validation_of(const RunContents& run) {
  Validation validation{.certified = certified_answers(run),
                        .exact = exact_answers(run),
                        .transcriptions = transcriptions(run),
                        .orders = observed_orders(run),
                        .kept = kept_quantities(run),
                        .ranks = interval_ranks(run),
                        .coverage = simulated_coverage(run),
                        .rounds = round_memories(run)};
  count_samples(run, validation);
  return validation;
}

}  // namespace phytobench
