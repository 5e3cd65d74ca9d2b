// SPDX-License-Identifier: MIT
#include "reports/report_folder.hpp"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "core/contract/errors.hpp"
#include "core/contract/sha256.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

class ReportFolder : public testing::Test {
 protected:
  ReportFolder()
      : root_(fs::path(testing::TempDir()) / ("phytobench_folder_" + std::to_string(::getpid()))) {
    fs::remove_all(root_);
    fs::create_directories(root_);
  }
  ~ReportFolder() override {
    std::error_code ignored;
    fs::remove_all(root_, ignored);
  }

  fs::path folder() const { return root_ / "report"; }

  void write(const fs::path& name, const std::string& content) const {
    fs::create_directories((folder() / name).parent_path());
    std::ofstream(folder() / name, std::ios::binary) << content;
  }

  std::string read(const fs::path& name) const {
    std::ifstream stream(folder() / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  /// Everything below the test's folder.
  std::set<std::string> names() const {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root_))
      names.insert(fs::relative(entry.path(), root_).string());
    return names;
  }

 private:
  fs::path root_;
};

const std::string verdicts_text = R"({"schema": "phytobench/verdicts-1"})";

/// What every report has, and these.
ReportFiles report_with(ReportFiles files) {
  files["verdicts.json"] = verdicts_text;
  return files;
}

const ReportFiles two_files = report_with({{"index.html", "page"}, {"figures/a.svg", "<svg/>"}});

TEST_F(ReportFolder, HoldsTheFilesAndTheirChecksums) {
  put_report(folder(), two_files);
  EXPECT_EQ(read("index.html"), "page");
  EXPECT_EQ(read("figures/a.svg"), "<svg/>");
  EXPECT_EQ(read("SHA256SUMS"), sha256_hex("<svg/>") + "  figures/a.svg\n" + sha256_hex("page") +
                                    "  index.html\n" + sha256_hex(verdicts_text) +
                                    "  verdicts.json\n");
  EXPECT_EQ(names(), (std::set<std::string>{"report", "report/SHA256SUMS", "report/figures",
                                            "report/figures/a.svg", "report/index.html",
                                            "report/verdicts.json"}));
}

TEST_F(ReportFolder, LosesFilesOfAnEarlierReportThatThisOneDoesNotHave) {
  put_report(folder(), two_files);
  put_report(folder(), report_with({{"index.html", "other page"}}));
  EXPECT_EQ(read("index.html"), "other page");
  EXPECT_EQ(names(), (std::set<std::string>{"report", "report/SHA256SUMS", "report/index.html",
                                            "report/verdicts.json"}));
}

TEST_F(ReportFolder, KeepsWhatNoReportWroteOrSomebodyChanged) {
  put_report(folder(), two_files);
  write("notes.txt", "mine");
  write("figures/a.svg", "<svg>mine</svg>");
  put_report(folder(), report_with({{"index.html", "page"}}));
  EXPECT_EQ(read("notes.txt"), "mine");
  EXPECT_EQ(read("figures/a.svg"), "<svg>mine</svg>");
}

TEST_F(ReportFolder, NeverRemovesWhatLiesOutsideOrBehindALink) {
  write("../outside.txt", "precious");
  write("kept.txt", "precious");
  const std::string digest = sha256_hex("precious");
  write("verdicts.json", verdicts_text);
  write("SHA256SUMS", digest + "  ../outside.txt\n" + digest + "  " +
                          fs::absolute(folder() / "kept.txt").string() + "\n" + digest +
                          "  link.txt\n" + sha256_hex(verdicts_text) + "  verdicts.json\n");
  fs::create_symlink(folder() / "kept.txt", folder() / "link.txt");
  put_report(folder(), report_with({{"index.html", "page"}}));
  EXPECT_EQ(read("../outside.txt"), "precious");
  EXPECT_EQ(read("kept.txt"), "precious");
  EXPECT_TRUE(fs::is_symlink(folder() / "link.txt"));
}

TEST_F(ReportFolder, TakesNoOtherProgramsChecksumsForItsOwn) {
  write("thesis.tex", "mine");
  write("SHA256SUMS", sha256_hex("mine") + "  thesis.tex\n");
  EXPECT_THROW(put_report(folder(), two_files), InputError);
  EXPECT_EQ(read("thesis.tex"), "mine");
  EXPECT_EQ(names(), (std::set<std::string>{"report", "report/SHA256SUMS", "report/thesis.tex"}));
}

TEST_F(ReportFolder, ReplacesNoFileThatNoReportWrote) {
  write("index.html", "my own page");
  EXPECT_THROW(put_report(folder(), two_files), InputError);
  EXPECT_EQ(read("index.html"), "my own page");
  EXPECT_EQ(names(), (std::set<std::string>{"report", "report/index.html"}));
}

TEST_F(ReportFolder, KeepsTheOldReportWholeWhereANewOneCannotBeWritten) {
  put_report(folder(), two_files);
  const auto before = names();
  // "index.html/x" needs a folder where a file is; the files before it could be written.
  EXPECT_THROW(put_report(folder(), {{"figures/a.svg", "new"}, {"index.html/x", "new"}}),
               EnvironmentError);
  EXPECT_EQ(names(), before);
  EXPECT_EQ(read("figures/a.svg"), "<svg/>");
}

TEST_F(ReportFolder, KeepsTheOldReportWholeWhereAFolderIsInTheWay) {
  put_report(folder(), two_files);
  fs::create_directories(folder() / "report.md");
  const auto before = names();
  EXPECT_THROW(put_report(folder(), report_with({{"index.html", "new"}, {"report.md", "new"}})),
               InputError);
  EXPECT_EQ(names(), before);
  EXPECT_EQ(read("index.html"), "page");
}

TEST_F(ReportFolder, LeavesNoFolderBehindWhereItFails) {
  fs::create_directories(folder());
  write("regular", "a file");
  const auto before = names();
  EXPECT_THROW(put_report(folder(), {{"a/b/c.txt", "x"}, {"regular/x", "x"}}), EnvironmentError);
  EXPECT_EQ(names(), before);
}

volatile std::sig_atomic_t signals = 0;

TEST_F(ReportFolder, LetsSignalsThroughAgain) {
  const auto before = std::signal(SIGTERM, [](int) { signals = signals + 1; });
  put_report(folder(), two_files);
  std::raise(SIGTERM);
  std::signal(SIGTERM, before);
  EXPECT_EQ(signals, 1);
}

TEST(Checksums, ReadBack) {
  const auto digests = checksums_in(checksum_lines(two_files));
  EXPECT_EQ(digests,
            (std::map<std::string, std::string>{{"index.html", sha256_hex("page")},
                                                {"figures/a.svg", sha256_hex("<svg/>")},
                                                {"verdicts.json", sha256_hex(verdicts_text)}}));
}

TEST(Checksums, LeaveOutWhatIsNoLineOfTheirs) {
  const std::string digest = sha256_hex("x");
  for (const std::string& line :
       {std::string("hello"), digest, digest + "  ", digest + " a", digest.substr(1) + "  a",
        digest + "  ../a", digest + "  a/../../b", digest + "  /a", "G" + digest.substr(1) + "  a"})
    EXPECT_TRUE(checksums_in(line + "\n").empty()) << line;
  EXPECT_EQ(checksums_in("hello\n" + digest + "  a b").size(), 1u) << "the last line may be open";
}

}  // namespace
}  // namespace phytobench
