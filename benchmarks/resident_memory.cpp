// SPDX-License-Identifier: MIT
#include "benchmarks/resident_memory.hpp"

#include <malloc.h>

#include <fstream>
#include <string>

namespace phytobench {

namespace {

/// "VmRSS:     1234 kB" of /proc/self/status.
std::optional<std::int64_t> status_bytes(const std::string& key) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    std::int64_t kilobytes = 0;
    if (word == key && status >> kilobytes) return kilobytes * 1024;
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::int64_t> resident_bytes() {
  return status_bytes("VmRSS:");
}

std::optional<std::int64_t> peak_resident_bytes() {
  return status_bytes("VmHWM:");
}

bool reset_peak_memory() {
  ::malloc_trim(0);
  std::ofstream file("/proc/self/clear_refs");
  file << 5 << std::flush;  // proc(5): the peak becomes what is resident now
  return file.good();
}

}  // namespace phytobench
