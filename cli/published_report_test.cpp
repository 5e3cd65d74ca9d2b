// SPDX-License-Identifier: MIT
// reports/published/ holds the report of the last full run beside its records. It must be what the
// program makes of them today.
#include "cli/command_line_fixture.hpp"

#include <regex>

namespace phytobench {
namespace {

namespace fs = std::filesystem;

const fs::path published = fs::path(PHYTOBENCH_SOURCE) / "reports" / "published";
constexpr const char* accept =
    "\nLook at the difference; if it is meant, accept it with reports/published/refresh";

/// What a report consists of: all files but the run and the script beside it.
std::set<std::string> report_files_in(const fs::path& folder) {
  std::set<std::string> names;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).generic_string();
    if (entry.is_regular_file() && name != "refresh" && !name.starts_with("run/"))
      names.insert(name);
  }
  return names;
}

/// Plots depend on the version of gnuplot, and the checksums on them; their committed state is
/// checked against each other instead.
bool is_the_same_everywhere(const std::string& name) {
  return !name.ends_with(".svg") && name != "SHA256SUMS";
}

std::string first_difference(const std::string& a, const std::string& b) {
  std::istringstream first(a), second(b);
  std::string x, y;
  for (int line = 1;; ++line) {
    const bool has_first = static_cast<bool>(std::getline(first, x));
    const bool has_second = static_cast<bool>(std::getline(second, y));
    if (!has_first && !has_second) return "no line differs";
    if (has_first && has_second && x == y) continue;
    return "line " + std::to_string(line) + "\n- " + (has_first ? x : "(nothing)") + "\n+ " +
           (has_second ? y : "(nothing)");
  }
}

class PublishedReportSlow : public CommandLine {};

TEST_F(PublishedReportSlow, IsWhatTheProgramMakesOfItsRun) {
  ASSERT_TRUE(fs::is_directory(published / "run")) << "no run is published; see " << published;
  fs::create_directories(folder() / "published");
  fs::copy(published / "run", folder() / "published" / "run", fs::copy_options::recursive);
  const Outcome outcome = run({"report", "published/run", "--format", "md", "--out", "published"});
  ASSERT_LE(outcome.code, 1) << outcome.err;
  EXPECT_EQ(report_files_in(folder() / "published"), report_files_in(published)) << accept;
  for (const std::string& name : report_files_in(folder() / "published")) {
    if (!is_the_same_everywhere(name) || !fs::exists(published / name)) continue;
    const std::string now = read(fs::path("published") / name);
    const std::string committed = content_of(published / name);
    EXPECT_TRUE(now == committed) << name << ", " << first_difference(committed, now) << accept;
  }
}

TEST_F(PublishedReportSlow, HoldsTheFilesThatItsChecksumsName) {
  const std::string command =
      "cd '" + published.string() + "' && sha256sum --check --quiet --strict SHA256SUMS";
  EXPECT_EQ(std::system(command.c_str()), 0) << accept;
}

TEST_F(PublishedReportSlow, LinksToNothingThatIsMissing) {
  const std::string text = content_of(published / "report.md");
  const std::regex link(R"(\]\(([^)#]+)\))");
  std::size_t links = 0;
  for (auto i = std::sregex_iterator(text.begin(), text.end(), link); i != std::sregex_iterator();
       ++i, ++links)
    EXPECT_TRUE(fs::exists(published / (*i)[1].str())) << (*i)[1];
  EXPECT_GT(links, 0u) << "not even a picture";
}

TEST_F(PublishedReportSlow, NamesNoFolderOfTheMachineItWasMadeOn) {
  const std::string environment = content_of(published / "run" / "environment.json");
  EXPECT_FALSE(std::regex_search(environment, std::regex(R"("command_line": "[^"]*[ =]/)")));
}

}  // namespace
}  // namespace phytobench
