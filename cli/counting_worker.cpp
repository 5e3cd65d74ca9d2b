// SPDX-License-Identifier: MIT
#include "cli/counting_worker.hpp"

#include <array>
#include <filesystem>

#include "benchmarks/comparison/counter_gate.hpp"
#include "benchmarks/comparison/found_program.hpp"
#include "benchmarks/comparison/worker_client.hpp"
#include "build_information.hpp"
#include "cli/source_tree.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"

namespace phytobench::cli {

namespace {

namespace fs = std::filesystem;

SideOrigin this_program() {
  SideOrigin origin{.given = "this program",
                    .kind = "build",
                    .commit = build_information::commit,
                    .changed = build_information::source_changed};
  if (origin.commit == "unknown") origin.commit.clear();  // as worker_build.json is read
  return origin;
}

Side named_worker(const std::string& given, const SideContext& context) {
  const fs::path path = context.folder / given;
  if (fs::is_directory(path)) return side_of_build(path, given, context);
  if (!found_program(path.string()))
    throw InputError(given + ": no such program; name a phytobench_worker or its folder");
  return {.origin = {.given = given, .kind = "build"},
          .worker = fs::canonical(path),
          .data_folder = context.data_folder};
}

/// Whether it counts; what it says of itself completes its origin.
bool counts_work(Side& side) {
  const WorkerDescription description =
      WorkerClient(side, {.is_interrupted = is_interrupted}).describe();
  if (side.origin.compiler.empty()) side.origin.compiler = description.compiler;
  if (side.origin.flags.empty()) side.origin.flags = description.flags;
  return description.counts_work;
}

}  // namespace

Side counting_worker(const std::string& given) {
  const SideContext context = side_context();
  if (!given.empty()) {
    Side side = named_worker(given, context);
    if (counts_work(side)) return side;
    throw InputError(given + ": was built without counters; name one of the preset 'counters'");
  }
  for (const fs::path& folder :
       std::array{context.program.parent_path(), source_tree() / "build" / "counters"}) {
    if (!found_program((folder / worker_name).string())) continue;
    Side side = side_of_build(folder, folder.string(), context);
    if (!counts_work(side)) continue;
    refuse_stale_worker(side.origin, this_program());
    return side;
  }
  throw InputError(
      "no worker that counts is built; run: cmake --preset counters && cmake --build --preset "
      "counters --target phytobench_worker, or name one with --worker");
}

}  // namespace phytobench::cli
