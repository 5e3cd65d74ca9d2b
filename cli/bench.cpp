// SPDX-License-Identifier: MIT
// phytobench bench list: what is watched for loss of speed.
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/regression/watched_benchmarks.hpp"
#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/terminal.hpp"

namespace phytobench::cli {

using nlohmann::ordered_json;

int bench_list(const BenchListOptions& options) {
  const auto benchmarks = chosen_benchmarks(watched_benchmarks(), options.benchmarks);
  ordered_json json{{"schema", "phytobench/bench-list-1"}, {"benchmarks", ordered_json::array()}};
  std::string text;
  for (const WatchedBenchmark& one : benchmarks) {
    json["benchmarks"].push_back(
        {{"name", one.name}, {"summary", one.summary}, {"own", one.is_own}});
    text += fmt::format("{:<44} {}{}\n", one.name, one.summary,
                        one.is_own ? "" : " (mostly another library's work)");
  }
  print(options.json ? json_text(json) + "\n" : text);
  return 0;
}

}  // namespace phytobench::cli
