// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/processor_split.hpp"

#include <sched.h>

#include <utility>

namespace phytobench {

namespace {

bool keep_on(const std::vector<int>& processors) {
  cpu_set_t set;
  CPU_ZERO(&set);
  for (const int processor : processors) CPU_SET(static_cast<std::size_t>(processor), &set);
  return ::sched_setaffinity(0, sizeof set, &set) == 0;
}

}  // namespace

std::vector<int> allowed_processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  std::vector<int> processors;
  if (::sched_getaffinity(0, sizeof set, &set) != 0) return processors;
  for (int processor = 0; processor < CPU_SETSIZE; ++processor)
    if (CPU_ISSET(static_cast<std::size_t>(processor), &set)) processors.push_back(processor);
  return processors;
}

std::optional<ProcessorSplit> processor_split(const std::vector<int>& allowed) {
  if (allowed.size() < 2) return std::nullopt;
  return ProcessorSplit{.runner = allowed.front(), .worker = allowed.back()};
}

PinnedThread::PinnedThread(std::optional<int> processor) {
  if (!processor) return;
  std::vector<int> before = allowed_processors();
  if (keep_on({*processor})) before_ = std::move(before);
}

PinnedThread::~PinnedThread() {
  if (!before_.empty()) keep_on(before_);
}

}  // namespace phytobench
