// SPDX-License-Identifier: MIT
#include "experiments/experiment.hpp"

#include <algorithm>
#include <thread>

#include "core/contract/errors.hpp"

namespace phytobench {

int ExperimentContext::untimed_threads() const {
  return std::max(threads_, static_cast<int>(std::thread::hardware_concurrency()));
}

void ExperimentContext::record(const std::string& name, RecordValue value,
                               const std::string& unit) {
  record(Record{.experiment = {}, .measurement = name, .value = std::move(value), .unit = unit});
}

void ExperimentContext::record(Record record) {
  record.experiment = id_;
  record.measurement = id_ + "/" + record.measurement;
  records_.push_back(std::move(record));
}

void ExperimentContext::timing(const std::string& name, std::int64_t round, std::int64_t position,
                               double seconds) {
  timing({.experiment = {},
          .measurement = name,
          .round = round,
          .position = position,
          .value = seconds,
          .threads = threads_});
}

void ExperimentContext::timing(TimingSample sample) {
  sample.experiment = id_;
  sample.measurement = id_ + "/" + sample.measurement;
  timings_.push_back(std::move(sample));
}

void ExperimentContext::artifact(const std::string& name, std::string content) {
  artifacts_.push_back({name, std::move(content)});
}

void ExperimentContext::progress(const std::string& what) {
  if (is_interrupted && is_interrupted()) throw Interrupted();
  if (show_progress) show_progress(what);
}

}  // namespace phytobench
