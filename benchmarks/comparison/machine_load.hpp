// SPDX-License-Identifier: MIT
// How much of the machine others took while something was timed.
#pragma once

#include <cstdint>
#include <string>

namespace phytobench {

/// Since the machine was started, over all processors, in ticks of the system (1/100 s mostly).
struct ProcessorTicks {
  std::uint64_t total = 0;
  std::uint64_t idle = 0;   ///< with waiting for disks
  std::uint64_t steal = 0;  ///< taken by other virtual machines; 0 where the system does not know
};

/// From the content of /proc/stat (proc(5)). Throws EnvironmentError if it is not of that form.
ProcessorTicks processor_ticks_from(const std::string& stat);

/// Now. Throws EnvironmentError.
ProcessorTicks processor_ticks();

/// Part of the time between two readings that other virtual machines took, 0 to 1; 0 if no tick
/// has passed.
double steal_share(const ProcessorTicks& before, const ProcessorTicks& after);

/// Part of the time between two readings in which processors worked, 0 to 1; one busy processor of
/// two gives 0.5. 0 if no tick has passed.
double busy_share(const ProcessorTicks& before, const ProcessorTicks& after);

/// Programs that were running or waiting for a processor, on average over the last minute; 0 where
/// the system does not tell.
double load_average();

/// Asked again and again.
class StealMeter {
 public:
  /// Begins now. Throws EnvironmentError.
  StealMeter() : last_(processor_ticks()) {}

  /// steal_share() since the last call, or since the beginning. Throws EnvironmentError.
  double share_since_last();

 private:
  ProcessorTicks last_;
};

}  // namespace phytobench
