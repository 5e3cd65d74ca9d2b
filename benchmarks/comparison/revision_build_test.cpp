// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/revision_build.hpp"

#include "benchmarks/comparison/side_fixture.hpp"
#include "benchmarks/comparison/variable_fixture.hpp"
#include "core/record/folder_lock.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

namespace fs = std::filesystem;

constexpr const char* presets = R"({
  "version": 6,
  "configurePresets": [{"name": "release", "generator": "Ninja",
                        "binaryDir": "${sourceDir}/build/${presetName}"}],
  "buildPresets": [{"name": "release", "configurePreset": "release"}]
})";

/// The "compiler" copies a program, and writes down what it was started with.
constexpr const char* project = R"(cmake_minimum_required(VERSION 3.25)
project(sample LANGUAGES NONE)
add_custom_target(paper_files COMMAND ${CMAKE_COMMAND} -E make_directory ${CMAKE_BINARY_DIR}/share/papers)
file(WRITE ${CMAKE_BINARY_DIR}/worker_build.json
     "{\"commit\": \"${PHYTOBENCH_COMMIT}\", \"source_changed\": true, \"compiler\": \"none\"}")
add_custom_target(phytobench_worker
  COMMAND sh ${CMAKE_SOURCE_DIR}/compile.sh
  WORKING_DIRECTORY ${CMAKE_BINARY_DIR} VERBATIM)
)";

constexpr const char* compile = R"(
echo "$CCACHE_BASEDIR $CCACHE_NOHASHDIR" >>compiled
cp -L /bin/sh phytobench_worker
)";

class RevisionBuilds : public SideFolder {
 protected:
  void SetUp() override {
    SideFolder::SetUp();
    start_repository();
    write("repository/.gitignore", "/build/\n");
    write("repository/CMakePresets.json", presets);
    write("repository/CMakeLists.txt", project);
    write("repository/compile.sh", compile);
    options_.show_progress = [this](const std::string& line) { lines_.push_back(line); };
    options_.tell = [this](const std::string& line) { told_.push_back(line); };
  }

  fs::path built(const std::string& commit) {
    return build_revision(repository(), commit, options_);
  }

  fs::path cached(const std::string& commit) const {
    return repository() / "build" / "compare" / commit.substr(0, 12);
  }

  RevisionBuildOptions options_;
  std::vector<std::string> lines_, told_;
  Variable flags_{"CXXFLAGS"}, compiler_{"CXX"};
};

TEST_F(RevisionBuilds, AreMadeOnceInAFolderOfTheirOwn) {
  const std::string id = commit(), name = "revision " + id.substr(0, 12);
  write("repository/compile.sh", "exit 1");  // what is not committed is not built
  const fs::path folder = built(id);
  EXPECT_EQ(folder, cached(id) / "source" / "build" / "release");
  EXPECT_TRUE(fs::exists(folder / "phytobench_worker"));
  EXPECT_TRUE(fs::exists(folder / "share" / "papers"));
  EXPECT_EQ(read_text_file(folder / "compiled"), (cached(id) / "source").string() + " 1\n");
  EXPECT_THAT(lines_,
              ElementsAre(name + ": unpacking", name + ": configuring", name + ": compiling"));
  EXPECT_THAT(read_text_file(cached(id) / "build.log"), HasSubstr("Configuring done"));

  EXPECT_EQ(built(id), folder);
  EXPECT_EQ(lines_.size(), 3u);
  EXPECT_EQ(git({"worktree", "list"}).find('\n'), std::string::npos);
  EXPECT_EQ(git({"status", "--porcelain"}), " M compile.sh");
}

TEST_F(RevisionBuilds, KnowTheirCommitWithoutARepository) {
  const std::string id = commit();
  Side named;
  named.origin.given = "main";
  named.origin.kind = "revision";
  named.origin.commit = "short";
  named.repository = repository();
  named.whole_commit = id;
  named.note = "note";
  const Side side = built_side(named, {}, options_);
  EXPECT_EQ(side.origin.given, "main");
  EXPECT_EQ(side.origin.kind, "revision");
  EXPECT_EQ(side.origin.commit, "short");
  EXPECT_FALSE(side.origin.changed);
  EXPECT_EQ(side.origin.compiler, "none");
  EXPECT_EQ(side.origin.program_digest.size(), 64u);
  EXPECT_EQ(side.worker, cached(id) / "source" / "build" / "release" / "phytobench_worker");
  EXPECT_EQ(side.note, "note");
  EXPECT_THAT(read_text_file(side.worker.parent_path() / "worker_build.json"),
              HasSubstr(id.substr(0, 12)));
}

TEST_F(RevisionBuilds, OfOtherSidesAreNotMade) {
  Side named;
  named.origin.given = "x";
  named.origin.kind = "build";
  const Side side = built_side(named, {}, options_);
  EXPECT_EQ(side.origin.given, "x");
  EXPECT_TRUE(lines_.empty());
}

TEST_F(RevisionBuilds, ThatFailNameTheirLogAndAreContinued) {
  write("repository/compile.sh",
        "echo the reason; test -e repaired && cp -L /bin/sh phytobench_worker");
  const std::string id = commit();
  const std::string message = message_of<EnvironmentError>([&] { built(id); });
  EXPECT_THAT(message, HasSubstr("cannot build revision " + id.substr(0, 12) + ": cmake --build"));
  EXPECT_THAT(message, HasSubstr("see " + (cached(id) / "build.log").string()));
  EXPECT_THAT(read_text_file(cached(id) / "build.log"), HasSubstr("the reason"));

  write(cached(id) / "source" / "build" / "release" / "repaired", "");
  EXPECT_TRUE(fs::exists(built(id) / "phytobench_worker"));
}

TEST_F(RevisionBuilds, ThatLeaveNoProgramAreFailures) {
  write("repository/compile.sh", "exit 0");
  const std::string id = commit();
  EXPECT_THAT(message_of<EnvironmentError>([&] { built(id); }),
              HasSubstr("left no phytobench_worker"));
}

TEST_F(RevisionBuilds, WithoutTheTargetAreOlderThanComparisons) {
  write("repository/CMakeLists.txt",
        "cmake_minimum_required(VERSION 3.25)\nproject(old LANGUAGES NONE)\n"
        "add_custom_target(no_phytobench_worker)\nadd_custom_target(phytobench_worker_2)\n");
  const std::string id = commit();
  EXPECT_THAT(message_of<InputError>([&] { built(id); }),
              HasSubstr("revision " + id.substr(0, 12) + " is older than comparisons: it has no "));
  git({"rm", "--quiet", "CMakePresets.json"});
  EXPECT_THAT(message_of<InputError>([&] { built(commit()); }),
              HasSubstr("is older than comparisons"));
}

TEST_F(RevisionBuilds, AreNotMadeByTwoAtOnce) {
  const std::string id = commit();
  fs::create_directories(cached(id));
  const FolderLock other(cached(id));
  EXPECT_THAT(message_of<InputError>([&] { built(id); }),
              HasSubstr("another comparison is building revision"));
}

TEST_F(RevisionBuilds, CanBeInterruptedAndContinued) {
  write("repository/compile.sh", "echo $$ > part; mv part started; exec sleep 60");
  const std::string id = commit();
  const fs::path folder = cached(id) / "source" / "build" / "release";
  options_.is_interrupted = [&] { return fs::exists(folder / "started"); };
  EXPECT_THROW(built(id), Interrupted);
  EXPECT_TRUE(ends(last_line(read_text_file(folder / "started"))));
  EXPECT_FALSE(fs::exists(cached(id) / "finished"));
  options_.is_interrupted = {};
  write(cached(id) / "source" / "compile.sh", compile);
  EXPECT_TRUE(fs::exists(built(id) / "phytobench_worker"));
}

TEST_F(RevisionBuilds, WithAWrongMarkAreMadeAgain) {
  const std::string id = commit();
  fs::create_directories(cached(id) / "source");
  write(cached(id) / "source" / "CMakeLists.txt", "damaged");
  write(cached(id) / "unpacked", "another\n");
  write(cached(id) / "finished", "another\n");
  EXPECT_TRUE(fs::exists(built(id) / "phytobench_worker"));
}

TEST_F(RevisionBuilds, MadeWithOtherFlagsAreMadeAgainAndSayWhy) {
  const std::string id = commit();
  flags_.set("-O1");
  const fs::path folder = built(id);
  write(folder / "CMakeCache.txt.of-before", "");
  flags_.set("-O2");
  EXPECT_EQ(built(id), folder);
  EXPECT_THAT(told_, ElementsAre("revision " + id.substr(0, 12) +
                                 " is built again: CXXFLAGS was '-O1' and is '-O2'"));
  EXPECT_FALSE(fs::exists(folder / "CMakeCache.txt.of-before")) << "CMake keeps the flags there";
  EXPECT_TRUE(fs::exists(folder / "phytobench_worker"));
  const std::size_t steps = lines_.size();
  built(id);
  EXPECT_EQ(lines_.size(), steps) << "it is used again now";
}

TEST_F(RevisionBuilds, MadeWithAnotherCompilerOfTheSameNameAreMadeAgain) {
  const std::string id = commit();
  compiler_.set(write_script("compiler", "echo compiler 1").string());
  built(id);
  write_script("compiler", "echo compiler 2");
  built(id);
  ASSERT_EQ(told_.size(), 1u);
  EXPECT_THAT(told_.front(), HasSubstr("compiler was 'compiler 1' and is 'compiler 2'"));
}

TEST_F(RevisionBuilds, OfUnknownMakingAreMadeAgain) {
  const std::string id = commit();
  built(id);
  fs::remove(cached(id) / "made_with");
  built(id);
  ASSERT_EQ(told_.size(), 1u);
  EXPECT_THAT(told_.front(), HasSubstr("nobody knows what it was built with"));
}

TEST_F(RevisionBuilds, OnlyBegunWithOtherFlagsAreBegunAnewInSilence) {
  write("repository/compile.sh", "test -e repaired && cp -L /bin/sh phytobench_worker");
  const std::string id = commit();
  flags_.set("-O1");
  EXPECT_THROW(built(id), EnvironmentError);
  const fs::path begun = cached(id) / "source" / "build" / "release";
  write(begun / "repaired", "");
  flags_.set("-O2");
  EXPECT_THROW(built(id), EnvironmentError) << "what was begun is gone";
  EXPECT_FALSE(fs::exists(begun / "repaired"));
  EXPECT_TRUE(told_.empty());
}

TEST_F(RevisionBuilds, GoIntoTheCacheThatIsAskedFor) {
  const std::string id = commit();
  options_.cache = folder_ / "cache";
  EXPECT_EQ(built(id), folder_ / "cache" / id.substr(0, 12) / "source" / "build" / "release");
  EXPECT_FALSE(fs::exists(repository() / "build"));
  write("cache/file", "");
  options_.cache = folder_ / "cache" / "file";
  EXPECT_THROW(built(id), EnvironmentError);
}

}  // namespace
}  // namespace phytobench
