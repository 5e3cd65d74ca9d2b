// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/record/record.hpp"

namespace phytobench {

/// Where an experiment puts what it measures, and what it may ask of the run. It may read a paper's
/// parameters, never its claims.
class ExperimentContext {
 public:
  ExperimentContext(std::string id, Tier tier, std::uint64_t seed, int threads)
      : id_(std::move(id)), tier_(tier), seed_(seed), threads_(threads) {}

  Tier tier() const { return tier_; }
  std::uint64_t seed() const { return seed_; }  ///< for the suite's own random numbers (--seed)
  int threads() const { return threads_; }      ///< of the engines, timed or not
  /// For work that is not timed and has the same result with any number: threads(), or all of the
  /// machine's processors if these are more.
  int untimed_threads() const;

  /// Adds the measurement "<experiment>/<name>".
  void record(const std::string& name, RecordValue value, const std::string& unit = "1");
  /// The same for a value that rests on random numbers started from `seed`, or on a sample.
  void record(Record record);
  void timing(const std::string& name, std::int64_t round, std::int64_t position, double seconds);
  /// The same with another number of threads, or another unit than seconds.
  void timing(TimingSample sample);
  /// A file for the run's artifacts folder.
  void artifact(const std::string& name, std::string content);

  /// Says what is going on (shown on a terminal only) and throws Interrupted after Ctrl-C. Never
  /// call it inside timed code.
  void progress(const std::string& what);

  std::function<void(const std::string&)> show_progress = {};
  std::function<bool()> is_interrupted = {};

  struct Artifact {
    std::string name;
    std::string content;
  };
  const std::vector<Record>& records() const { return records_; }
  const std::vector<TimingSample>& timings() const { return timings_; }
  const std::vector<Artifact>& artifacts() const { return artifacts_; }

 private:
  std::string id_;
  Tier tier_;
  std::uint64_t seed_;
  int threads_;
  std::vector<Record> records_;
  std::vector<TimingSample> timings_;
  std::vector<Artifact> artifacts_;
};

/// A count as records hold it.
inline std::int64_t whole(std::size_t number) {
  return static_cast<std::int64_t>(number);
}

/// One question, one file, one line in experiments.def.
struct ExperimentDescriptor {
  std::string_view id;        ///< "<paper key>/<name>", unique
  std::string_view question;  ///< one sentence ending in a question mark
  std::string_view source;    ///< "[Key] where"
  double seconds[3];          ///< rough duration on a two-core machine: smoke, quick, full
  void (*run)(ExperimentContext&);
};

}  // namespace phytobench
