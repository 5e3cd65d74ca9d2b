// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/revision_build.hpp"

#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/comparison/build_inputs.hpp"
#include "benchmarks/comparison/child_process.hpp"
#include "benchmarks/comparison/found_program.hpp"
#include "benchmarks/comparison/git_revision.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/record/folder_lock.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

/// Empty if there is no such file.
std::string text_in(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) ? read_text_file(file) : "";
}

bool says(const fs::path& file, const std::string& commit) {
  return text_in(file) == commit + "\n";
}

/// One revision's folder in the cache.
class RevisionBuild {
 public:
  RevisionBuild(fs::path repository, std::string commit, const RevisionBuildOptions& options)
      : repository_(std::move(repository)),
        commit_(std::move(commit)),
        options_(options),
        folder_(fs::absolute(options.cache.empty() ? repository_ / "build" / "compare"
                                                   : options.cache) /
                short_commit()),
        inputs_(build_inputs()) {}

  /// The worker's folder.
  fs::path finished() {
    make_folder(folder_);
    const FolderLock lock = locked();
    if (!is_finished()) build();
    return binaries();
  }

 private:
  std::string short_commit() const { return commit_.substr(0, commit_digits); }
  fs::path source() const { return folder_ / "source"; }
  fs::path binaries() const { return source() / "build" / "release"; }
  fs::path log() const { return folder_ / "build.log"; }

  FolderLock locked() const {
    try {
      return FolderLock(folder_);
    } catch (const InputError&) {
      throw InputError(
          fmt::format("{}: another comparison is building revision {} there; wait until it is done",
                      folder_.string(), short_commit()));
    }
  }

  bool is_finished() const {
    return says(folder_ / "finished", commit_) && text_in(folder_ / "made_with") == inputs_ &&
           found_program((binaries() / worker_name).string());
  }

  void build() {
    demand_these_inputs();
    show("unpacking");
    unpack();
    write_file_atomically(log(), "");
    show("configuring");
    demand({"cmake", "--preset", "release", "-DPHYTOBENCH_COMMIT=" + short_commit()});
    demand_target();
    show("compiling");
    demand({"cmake", "--build", "--preset", "release", "--target", worker_name, "paper_files"});
    if (!found_program((binaries() / worker_name).string()))
      fail("building revision {} left no {} in {}", short_commit(), worker_name,
           binaries().string());
    write_file_atomically(folder_ / "finished", commit_ + "\n");
  }

  void show(const char* step) const {
    if (options_.show_progress)
      options_.show_progress(fmt::format("revision {}: {}", short_commit(), step));
  }

  /// CMake keeps the compiler and the flags that it was first called with, so what was made, or
  /// only begun, with others must go.
  void demand_these_inputs() const {
    const fs::path mark = folder_ / "made_with";
    const std::string change = change_of_inputs(text_in(mark), inputs_);
    if (change.empty()) return;
    if (options_.tell && says(folder_ / "finished", commit_))
      options_.tell(fmt::format("revision {} is built again: {}", short_commit(), change));
    std::error_code error;
    if (fs::remove(folder_ / "finished", error); !error) fs::remove_all(binaries(), error);
    if (error)
      throw EnvironmentError(
          fmt::format("cannot empty {}: {}", binaries().string(), error.message()));
    write_file_atomically(mark, inputs_);
  }

  /// Unless it was done before.
  void unpack() const {
    const fs::path mark = folder_ / "unpacked";
    if (says(mark, commit_)) return;
    std::error_code error;
    fs::remove(folder_ / "finished", error);
    fs::remove(mark, error);
    fs::remove_all(source(), error);
    if (error)
      throw EnvironmentError(
          fmt::format("cannot empty {}: {}", source().string(), error.message()));
    make_folder(source());
    unpack_commit(repository_, commit_, source());
    write_file_atomically(mark, commit_ + "\n");
  }

  ChildResult run(std::vector<std::string> command, const fs::path& log) const {
    // Objects compiled for another revision, or in the user's own folder, serve again where their
    // sources are equal; so the language stays the user's, too, which ccache takes into account.
    // The repository above must not be taken for the one of this source.
    return run_child({.command = std::move(command),
                      .folder = source(),
                      .environment = {{"CCACHE_BASEDIR", source().string()},
                                      {"CCACHE_NOHASHDIR", "1"},
                                      {"GIT_CEILING_DIRECTORIES", folder_.string()},
                                      {"GIT_DIR", std::nullopt},
                                      {"GIT_WORK_TREE", std::nullopt},
                                      {"GIT_INDEX_FILE", std::nullopt}},
                      .limit_s = options_.limit_s,
                      .log = log,
                      .is_interrupted = options_.is_interrupted});
  }

  /// A step that must succeed.
  void demand(const std::vector<std::string>& command) const {
    if (!fs::exists(source() / "CMakePresets.json")) fail_as_too_old();
    const ChildResult result = run(command, log());
    if (result.is_ok()) return;
    fail("cannot build revision {}: {} {}", short_commit(), fmt::join(command, " "),
         ending_of(result, options_.limit_s));
  }

  /// Asks for nothing but a plan. Presets name Ninja, which knows English only.
  void demand_target() const {
    const ChildResult plan =
        run({"cmake", "--build", "--preset", "release", "--target", worker_name, "--", "-n"}, {});
    const std::string said = plan.out + plan.err;
    if (!plan.is_ok() && said.find("unknown target") != std::string::npos) fail_as_too_old();
  }

  [[noreturn]] void fail_as_too_old() const {
    throw InputError(
        fmt::format("revision {} is older than comparisons: it has no {}; compare "
                    "newer ones",
                    short_commit(), worker_name));
  }

  template <class... Values>
  [[noreturn]] void fail(fmt::format_string<Values...> message, Values&&... values) const {
    throw EnvironmentError(fmt::format(message, std::forward<Values>(values)...) + "; see " +
                           log().string());
  }

  fs::path repository_;
  std::string commit_;
  const RevisionBuildOptions& options_;
  fs::path folder_;
  std::string inputs_;
};

}  // namespace

fs::path build_revision(const fs::path& repository, const std::string& commit,
                        const RevisionBuildOptions& options) {
  PHYTOBENCH_EXPECT(commit.size() >= commit_digits);
  return RevisionBuild(repository, commit, options).finished();
}

Side built_side(const Side& side, const SideContext& context, const RevisionBuildOptions& options) {
  if (side.origin.kind != "revision") return side;
  const fs::path folder = build_revision(side.repository, side.whole_commit, options);
  Side built = side_of_build(folder, side.origin.given, context);
  built.origin.kind = side.origin.kind;
  built.origin.commit = side.origin.commit;
  built.origin.changed = false;
  built.repository = side.repository;
  built.whole_commit = side.whole_commit;
  built.note = side.note;
  return built;
}

}  // namespace phytobench
