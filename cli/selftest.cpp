// SPDX-License-Identifier: MIT
// phytobench selftest: can what `compare` says be believed on this machine?
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/comparison/instrument_check.hpp"
#include "benchmarks/comparison/instrument_verdict.hpp"
#include "benchmarks/comparison/machine_load.hpp"
#include "benchmarks/comparison/processor_split.hpp"
#include "benchmarks/comparison/side.hpp"
#include "benchmarks/comparison/worker_client.hpp"
#include "cli/commands.hpp"
#include "cli/output_files.hpp"
#include "cli/selftest_output.hpp"
#include "cli/terminal.hpp"
#include "core/contract/check.hpp"

namespace phytobench::cli {

namespace {

/// The build of the running program, with its broken benchmarks.
Side this_build(double handicap) {
  const SideContext context = side_context();
  Side side = side_of_build(context.program.parent_path(), "this build", context);
  side.worker_options = {"--selftest", "--handicap", fmt::format("{}", handicap)};
  return side;
}

/// One engine in all that it is watched for: enough for p to be adjusted, and no more than fits
/// into the time that there is.
std::vector<std::string> usual_names(WorkerClient& client) {
  std::vector<std::string> names = client.names();
  std::erase_if(names, [](const std::string& name) {
    return !name.starts_with("nearest-node/node_driven/");
  });
  PHYTOBENCH_EXPECT(!names.empty());
  return names;
}

int exit_code_of(const InstrumentVerdict& verdict, bool is_strict) {
  switch (verdict.state) {
    case InstrumentState::proven:
      return 0;
    case InstrumentState::unproven:
      return is_strict ? 5 : 0;
    case InstrumentState::broken:
      return 1;
  }
  return 1;
}

}  // namespace

int selftest(const SelftestOptions& options) {
  catch_interrupts();
  refuse_unwritable_files({});  // a result that cannot be printed takes minutes, too
  const std::optional<ProcessorSplit> split = processor_split(allowed_processors());
  const PinnedThread runner(split ? std::optional<int>(split->runner) : std::nullopt);
  WorkerClientOptions client{.is_interrupted = is_interrupted};
  if (split) client.processor = split->worker;
  WorkerClient build(this_build(0.0), client);
  refuse_to_time_counters(build.describe(), "this build");
  StealMeter steal;
  InstrumentRequest request{.side = [&](double handicap) -> std::unique_ptr<TimedSide> {
                              return std::make_unique<WorkerClient>(this_build(handicap), client);
                            },
                            .repetitions = options.repetitions,
                            .slow_repetitions = (options.repetitions + 3) / 4,
                            .usual_names = usual_names(build),
                            .usual_repetitions = (options.repetitions + 9) / 10,
                            .seed = options.seed,
                            .show_progress = show_progress,
                            .is_interrupted = is_interrupted,
                            .stolen_share = [&] { return steal.share_since_last(); }};
  const InstrumentCheck check = check_instrument(request);
  const InstrumentVerdict verdict = judge_instrument(check);
  print(options.json ? selftest_json(check, verdict, options) : selftest_text(check, verdict));
  return exit_code_of(verdict, options.strict);
}

}  // namespace phytobench::cli
