// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/git_revision.hpp"

#include "benchmarks/comparison/side_fixture.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

class GitRevisions : public SideFolder {
 protected:
  void SetUp() override {
    SideFolder::SetUp();
    start_repository();
    write("repository/deep/file", "first");
    first_ = commit();
    write("repository/deep/file", "second");
    commit();
    write("repository/deep/file", "not committed");
    fs::create_directories(folder_ / "target");
  }

  std::string first_;
};

TEST_F(GitRevisions, AreUnpackedAsTheyWereCommitted) {
  const std::string before = git({"status", "--porcelain"});
  unpack_commit(repository(), first_, folder_ / "target");
  EXPECT_EQ(read_text_file(folder_ / "target" / "deep" / "file"), "first");
  EXPECT_FALSE(fs::exists(folder_ / "target.tar"));
  EXPECT_EQ(git({"status", "--porcelain"}), before);
  EXPECT_EQ(git({"worktree", "list"}).find('\n'), std::string::npos);
}

TEST_F(GitRevisions, ThatAreMissingCannotBeUnpacked) {
  EXPECT_THAT(message_of<EnvironmentError>(
                  [&] { unpack_commit(repository(), std::string(40, '0'), folder_ / "target"); }),
              testing::HasSubstr("git archive ended with exit code 128: fatal: "));
  EXPECT_THROW(unpack_commit(repository(), first_, folder_ / "missing" / "target"),
               EnvironmentError);
}

TEST_F(GitRevisions, AreBranchesAndTags) {
  git({"tag", "old", first_});
  git({"branch", "topic"});
  EXPECT_THAT(revision_names(repository()), testing::UnorderedElementsAre("main", "topic", "old"));
  EXPECT_EQ(commit_named("old", repository()), first_);
  EXPECT_EQ(commit_named("older", repository()), std::nullopt);
  EXPECT_FALSE(is_shallow(repository()));
}

TEST_F(GitRevisions, ThatAreNoCommitsAreNone) {
  for (const char* name : {"", "-", "--all", "HEAD~1..HEAD", "HEAD:deep/file", "HEAD^{tree}", "^"})
    EXPECT_EQ(commit_named(name, repository()), std::nullopt) << name;
}

TEST_F(GitRevisions, BelongToTheRepositoryAround) {
  EXPECT_EQ(repository_around(repository() / "deep"), repository());
  EXPECT_EQ(repository_around(folder_), std::nullopt);
}

}  // namespace
}  // namespace phytobench
