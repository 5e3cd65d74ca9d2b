// SPDX-License-Identifier: MIT
#include "experiments/cost_meter.hpp"

#include <fcntl.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

namespace phytobench {

namespace {

bool reset_high_water_mark() {
  const int file = ::open("/proc/self/clear_refs", O_WRONLY | O_CLOEXEC);
  if (file < 0) return false;
  const bool written = ::write(file, "5", 1) == 1;
  ::close(file);
  return written;
}

std::optional<double> high_water_mark_mib() {
  const std::string key = "VmHWM:";
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) return std::stod(line.substr(key.size())) / 1024.0;  // is in KiB
  return std::nullopt;
}

}  // namespace

CostMeter::CostMeter() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
  is_mark_fresh_ = reset_high_water_mark();
  start_ = std::chrono::steady_clock::now();
}

ExperimentCost CostMeter::cost() const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  return {.seconds = std::max(passed.count(), 1e-9),
          .peak_memory_mib = is_mark_fresh_ ? high_water_mark_mib() : std::nullopt};
}

}  // namespace phytobench
