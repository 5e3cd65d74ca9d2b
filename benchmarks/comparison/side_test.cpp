// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/side.hpp"

#include "benchmarks/comparison/program_digest.hpp"
#include "benchmarks/comparison/side_fixture.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

class Sides : public SideFolder {
 protected:
  void SetUp() override {
    SideFolder::SetUp();
    start_repository();
    write("repository/file", "first");
    first_ = commit();
    git({"tag", "version-1"});
    write("repository/file", "second");
    second_ = commit();
    context_ = {.folder = repository(), .program = folder_ / "own" / "phytobench"};
  }

  Side resolved(const std::string& given) const { return resolve_side(given, context_); }

  std::string refusal(const std::string& given) const {
    return message_of<InputError>([&] { resolved(given); });
  }

  SideContext context_;
  std::string first_, second_;
};

TEST_F(Sides, AreRevisionsByAnyNameThatGitKnows) {
  for (const char* given : {"HEAD~1", "version-1", "main^"}) {
    const Side side = resolved(given);
    EXPECT_EQ(side.origin.kind, "revision");
    EXPECT_EQ(side.origin.given, given);
    EXPECT_EQ(side.whole_commit, first_);
    EXPECT_EQ(side.origin.commit, first_.substr(0, 12));
    EXPECT_EQ(side.repository, repository());
    EXPECT_TRUE(side.worker.empty());
    EXPECT_EQ(side.note, "");
  }
  EXPECT_EQ(resolved(second_.substr(0, 7)).whole_commit, second_);
  EXPECT_EQ(title_of(resolved("HEAD")), "HEAD (" + second_.substr(0, 12) + ")");
  EXPECT_EQ(title_of(resolved(second_.substr(0, 7))), second_.substr(0, 7));
}

TEST_F(Sides, AreFoundFromAFolderInsideTheRepository) {
  fs::create_directories(repository() / "deep");
  context_.folder = repository() / "deep";
  EXPECT_EQ(resolved("HEAD").whole_commit, second_);
  EXPECT_EQ(resolved("HEAD").repository, repository());
}

TEST_F(Sides, ThatAreNothingAreRefusedWithWhatWasTried) {
  for (const char* given : {"nothing", "HEAD~99", "file", ".", "HEAD:file", "--all", "-x", "a b"}) {
    EXPECT_THAT(refusal(given), HasSubstr("is no build folder (one that holds phytobench_worker)"));
    EXPECT_THAT(refusal(given), HasSubstr("git knows no such revision"));
  }
  EXPECT_THAT(refusal(""), HasSubstr("without a name"));
  EXPECT_THAT(refusal("version-2"), HasSubstr("did you mean 'version-1'?"));
}

TEST_F(Sides, OutsideOfARepositoryAreNoRevisions) {
  context_.folder = folder_;
  EXPECT_THAT(refusal("HEAD"), HasSubstr("git says: fatal: not a git repository"));
}

TEST_F(Sides, OfAShallowCloneSayWhyCommitsAreMissing) {
  run_child({.command = {"git", "clone", "--quiet", "--depth=1", "file://" + repository().string(),
                         (folder_ / "clone").string()}});
  context_.folder = folder_ / "clone";
  EXPECT_EQ(resolved("HEAD").whole_commit, second_);
  EXPECT_THAT(refusal("HEAD~1"), HasSubstr("git fetch --unshallow"));
}

TEST_F(Sides, AreBuildsWhereAFolderHoldsAWorker) {
  const fs::path worker = write_program("repository/build/release/phytobench_worker");
  Side side = resolved("build/release");
  EXPECT_EQ(side.origin.kind, "build");
  EXPECT_EQ(side.worker, worker);
  EXPECT_EQ(side.origin.program_digest, program_digest(worker));
  EXPECT_EQ(side.origin.commit, "");
  EXPECT_EQ(title_of(side), "build/release");

  write(
      "repository/build/release/worker_build.json",
      R"({"commit": "0123456789ab", "source_changed": true, "compiler": "GNU 12", "flags": "-O3"})");
  side = resolved((repository() / "build" / "release").string());
  EXPECT_EQ(side.origin.commit, "0123456789ab");
  EXPECT_TRUE(side.origin.changed);
  EXPECT_EQ(side.origin.compiler, "GNU 12");
  EXPECT_EQ(side.origin.flags, "-O3");
}

TEST_F(Sides, AreBuildsOfUnknownCommitsWithoutGit) {
  write_program("build/phytobench_worker");
  write("build/worker_build.json", R"({"commit": "unknown"})");
  context_.folder = folder_;
  EXPECT_EQ(resolved("build").origin.commit, "");
}

TEST_F(Sides, WithDamagedBuildsAreRefused) {
  write("build/phytobench_worker", "no program");
  const std::string build = (folder_ / "build").string();
  EXPECT_THAT(refusal(build), HasSubstr("cannot be run"));
  write_script("build/phytobench_worker", "exit 0");
  EXPECT_THAT(refusal(build), HasSubstr("is no ELF file"));
  for (const char* text : {"", "[]", "7", R"({"commit": 7})", R"({"source_changed": "no"})"}) {
    write("build/worker_build.json", text);
    EXPECT_THAT(refusal(build), HasSubstr("worker_build.json: is damaged")) << text;
  }
}

TEST_F(Sides, WithBuildsOlderThanComparisonsSaySo) {
  write_program("build/phytobench");
  EXPECT_THAT(refusal((folder_ / "build").string()), HasSubstr("older than comparisons"));
}

TEST_F(Sides, ArePluginsRunByTheProgramsOwnWorker) {
  const fs::path plugin = write_program("repository/engine.so");
  EXPECT_THAT(message_of<EnvironmentError>([&] { resolved("engine.so"); }),
              HasSubstr("phytobench_worker is missing"));
  write_program("own/phytobench");
  const fs::path worker = write_program("own/phytobench_worker");
  const Side side = resolved("engine.so");
  EXPECT_EQ(side.origin.kind, "plugin");
  EXPECT_EQ(side.worker, worker);
  EXPECT_EQ(side.worker_options, (std::vector<std::string>{"--plugin", plugin.string()}));
  EXPECT_EQ(side.origin.commit, "");
  write_program("repository/copy.so");
  EXPECT_EQ(resolved("copy.so").origin.program_digest, side.origin.program_digest);
  write("repository/text.so", "no library");
  EXPECT_THAT(refusal("text.so"), HasSubstr("is no ELF file"));
}

TEST_F(Sides, AreStoredResults) {
  for (const char* name : {"old.json", "run/timings.jsonl"}) {
    const fs::path file = write(fs::path("repository") / name, "{}");
    const Side side = resolved(name);
    EXPECT_EQ(side.origin.kind, "result");
    EXPECT_EQ(side.file, file);
    EXPECT_TRUE(side.worker.empty());
  }
  EXPECT_EQ(resolved("run").file, repository() / "run");
}

TEST_F(Sides, OfTwoMeaningsAreFilesAndSaySo) {
  write_program("repository/version-1/phytobench_worker");
  const Side side = resolved("version-1");
  EXPECT_EQ(side.origin.kind, "build");
  EXPECT_EQ(side.note, "'version-1' is a build and a revision, too: the build is compared; give " +
                           first_.substr(0, 12) + " for the revision");
  fs::remove(repository() / "version-1" / "phytobench_worker");
  EXPECT_EQ(resolved("version-1").origin.kind, "revision");
}

TEST_F(Sides, GetDataOnlyWhereTheWorkerHasNoneOfItsOwn) {
  write_program("build/phytobench_worker");
  context_.data_folder = folder_ / "data";
  const std::string build = (folder_ / "build").string();
  EXPECT_EQ(resolved(build).data_folder, folder_ / "data");
  fs::create_directories(folder_ / "build" / "share" / "papers");
  EXPECT_EQ(resolved(build).data_folder, "");
}

TEST(SideContexts, IsThatOfTheRunningProgram) {
  const SideContext context = side_context();
  EXPECT_EQ(context.folder, fs::current_path());
  EXPECT_EQ(context.program, fs::canonical("/proc/self/exe"));
}

}  // namespace
}  // namespace phytobench
