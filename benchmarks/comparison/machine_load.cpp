// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/machine_load.hpp"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <utility>
#include <vector>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

/// Positions of the numbers after "cpu": user nice system idle iowait irq softirq steal. Two more
/// follow, guest and guest_nice, which are already in user and nice.
constexpr std::size_t idle = 3, disk_wait = 4, steal = 7, counted_times = 8;

double share(std::uint64_t part_before, std::uint64_t part_after, const ProcessorTicks& before,
             const ProcessorTicks& after) {
  // Ticks of waiting for disks may go back a little, and with them the total.
  if (after.total <= before.total || part_after <= part_before) return 0.0;
  return std::min(1.0, static_cast<double>(part_after - part_before) /
                           static_cast<double>(after.total - before.total));
}

}  // namespace

ProcessorTicks processor_ticks_from(const std::string& stat) {
  std::istringstream line(stat.substr(0, stat.find('\n')));
  std::string name;
  std::vector<std::uint64_t> ticks;
  line >> name;
  for (std::uint64_t number = 0; ticks.size() < counted_times && line >> number;)
    ticks.push_back(number);
  if (name != "cpu" || ticks.size() <= idle)
    throw EnvironmentError("/proc/stat does not begin with the times of all processors");
  ticks.resize(counted_times);
  ProcessorTicks result{.idle = ticks[idle] + ticks[disk_wait], .steal = ticks[steal]};
  for (const std::uint64_t number : ticks) result.total += number;
  return result;
}

ProcessorTicks processor_ticks() {
  std::ifstream file("/proc/stat", std::ios::binary);
  std::string first;
  std::getline(file, first);
  return processor_ticks_from(first);
}

double steal_share(const ProcessorTicks& before, const ProcessorTicks& after) {
  return share(before.steal, after.steal, before, after);
}

double busy_share(const ProcessorTicks& before, const ProcessorTicks& after) {
  return share(before.total - before.idle, after.total - after.idle, before, after);
}

double load_average() {
  double load = 0.0;
  return ::getloadavg(&load, 1) == 1 ? load : 0.0;
}

double StealMeter::share_since_last() {
  const ProcessorTicks now = processor_ticks();
  return steal_share(std::exchange(last_, now), now);
}

}  // namespace phytobench
