// SPDX-License-Identifier: MIT
#include "benchmarks/regression/watched_benchmarks.hpp"

#include <array>
#include <set>

#include "core/contract/errors.hpp"
#include "core/contract/name_selection.hpp"

namespace phytobench {

namespace families {
#define FAMILY(name, dependency) extern const BenchmarkFamily name;
#include "benchmarks/regression/families.def"
#undef FAMILY
}  // namespace families

namespace {

constexpr auto table = std::to_array<const BenchmarkFamily*>({
#define FAMILY(name, dependency) &families::name,
#include "benchmarks/regression/families.def"
#undef FAMILY
});

/// An engine from elsewhere may have the name of one of ours: times would go to either.
void refuse_equal_names(const std::vector<WatchedBenchmark>& benchmarks) {
  std::set<std::string> names;
  for (const WatchedBenchmark& benchmark : benchmarks)
    if (!names.insert(benchmark.name).second)
      throw InputError("there are two benchmarks '" + benchmark.name +
                       "'; give the engine that was added a name of its own");
}

}  // namespace

std::vector<const BenchmarkFamily*> benchmark_families() {
  return {table.begin(), table.end()};
}

std::vector<WatchedBenchmark> watched_benchmarks(const FamilyRequest& request) {
  std::vector<WatchedBenchmark> all;
  for (const BenchmarkFamily* family : table)
    for (WatchedBenchmark& benchmark : family->list(request)) all.push_back(std::move(benchmark));
  refuse_equal_names(all);
  return all;
}

std::vector<WatchedBenchmark> chosen_benchmarks(const std::vector<WatchedBenchmark>& all,
                                                const std::vector<std::string>& globs) {
  std::vector<std::string> names;
  for (const WatchedBenchmark& benchmark : all) names.push_back(benchmark.name);
  std::vector<WatchedBenchmark> chosen;
  for (const std::size_t i : selected_names(names, globs, {"benchmark", "phytobench bench list"}))
    chosen.push_back(all[i]);
  return chosen;
}

}  // namespace phytobench
