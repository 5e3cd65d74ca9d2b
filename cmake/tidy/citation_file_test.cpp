// SPDX-License-Identifier: MIT
// CITATION.cff, line by line: what its schema demands, and what must be as it is elsewhere.
#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cmake/tidy/project_files.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& pattern) {
  return std::regex_search(text, std::regex("(^|\n)" + pattern));
}

/// The entries of the list `references`, each without its dash.
std::vector<std::string> references_of(const std::string& text) {
  std::vector<std::string> entries;
  std::istringstream lines(text.substr(std::min(text.find("\nreferences:\n"), text.size())));
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("  - "))
      entries.push_back("    " + line.substr(4) + "\n");
    else if (!entries.empty())
      entries.back() += line + "\n";
  return entries;
}

std::vector<std::string> problems_of(const std::string& text, const std::string& version) {
  std::vector<std::string> problems;
  for (const std::string& line :
       {std::string("cff-version: 1\\.2\\.0\n"), std::string("message: \".+\"\n"),
        std::string("title: .+\n"), std::string("abstract: "), std::string("license: MIT\n"),
        std::string("authors:\n  - (name|family-names): "), std::string("keywords:\n  - "),
        "version: " + version + "\n"})
    if (!has(text, line)) problems.push_back("CITATION.cff has no line " + line);
  if (text.find('\t') != std::string::npos) problems.push_back("CITATION.cff has a tab");
  for (const std::string& entry : references_of(text))
    for (const char* key : {"type: [a-z-]+", "title: \".+\"", "authors:\n      - family-names: "})
      if (!has(entry, std::string("    ") + key))
        problems.push_back("a reference has no " + std::string(key) + ":\n" + entry);
  return problems;
}

/// The first quoted text behind `key = ` in a paper's file.
std::string value_of(const std::string& toml, const std::string& key) {
  std::smatch match;
  const std::regex line("(^|\n)" + key + " = \"([^\"]*)\"");
  return std::regex_search(toml, match, line) ? match[2].str() : "";
}

const std::string small =
    "cff-version: 1.2.0\nmessage: \"m\"\ntitle: t\nabstract: a\nlicense: MIT\nversion: 0.1.0\n"
    "authors:\n  - name: n\nkeywords:\n  - k\nreferences:\n  - type: thesis\n    authors:\n"
    "      - family-names: f\n    title: \"t\"\n";

TEST(CitationFileTidy, CheckFindsWhatIsMissing) {
  EXPECT_TRUE(problems_of(small, "0.1.0").empty());
  EXPECT_EQ(problems_of(small, "0.2.0").size(), 1u);
  for (const char* part : {"message: \"m\"\n", "title: t\n", "license: MIT\n", "    title: \"t\"\n",
                           "      - family-names: f\n", "  - name: n\n"}) {
    std::string broken = small;
    broken.erase(broken.find(part), std::string(part).size());
    EXPECT_EQ(problems_of(broken, "0.1.0").size(), 1u) << part;
  }
}

TEST(CitationFileTidy, HasWhatItsSchemaDemands) {
  std::smatch version;
  const std::string project = read("CMakeLists.txt");
  ASSERT_TRUE(
      std::regex_search(project, version, std::regex("project\\([a-z]+ VERSION ([0-9.]+)")));
  for (const std::string& problem : problems_of(read("CITATION.cff"), version[1].str()))
    ADD_FAILURE() << problem;
}

TEST(CitationFileTidy, NamesTheFiveWorksAsTheirFilesDo) {
  const std::vector<std::string> references = references_of(read("CITATION.cff"));
  EXPECT_EQ(references.size(), 5u);
  for (const auto& folder : fs::directory_iterator(root / "reference/papers")) {
    const std::string paper = read(folder.path() / "paper.toml");
    const std::string title = value_of(paper, "title"), author = value_of(paper, "author");
    ASSERT_FALSE(title.empty()) << folder.path();
    const auto cited = std::find_if(references.begin(), references.end(), [&](const auto& entry) {
      return entry.find("title: \"" + title + "\"") != std::string::npos;
    });
    ASSERT_NE(cited, references.end()) << title;
    EXPECT_NE(cited->find("family-names: " + author.substr(author.rfind(' ') + 1)),
              std::string::npos)
        << author;
  }
}

}  // namespace
}  // namespace phytobench
