// SPDX-License-Identifier: MIT
// The Dockerfile by rules that need no engine: dated images, small layers, nothing that is not
// there.
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cmake/tidy/project_files.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

/// Instructions without comments, each in one line, with the defaults of ARG in FROM put in.
std::vector<std::string> instructions_of(const std::string& text) {
  std::vector<std::string> found;
  std::map<std::string, std::string> defaults;
  std::istringstream lines(text);
  std::string instruction;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    const bool goes_on = line.back() == '\\';
    instruction += goes_on ? line.substr(0, line.size() - 1) : line;
    if (goes_on) continue;
    std::smatch match;
    if (std::regex_match(instruction, match, std::regex("ARG ([A-Z]+)=(.*)")))
      defaults[match[1]] = match[2];
    if (instruction.starts_with("FROM "))
      for (const auto& [name, value] : defaults)
        instruction = std::regex_replace(instruction, std::regex("\\$\\{" + name + "\\}"), value);
    found.push_back(instruction);
    instruction.clear();
  }
  return found;
}

/// Names and groups of cmake/packages.txt, groups as "group build".
std::set<std::string> packages_of(const std::string& list) {
  std::set<std::string> names;
  std::istringstream lines(list);
  for (std::string line; std::getline(lines, line);) {
    std::smatch match;
    if (std::regex_search(line, match, std::regex("^# group: ([a-z]+)")))
      names.insert("group " + match[1].str());
    else if (!line.empty() && line[0] != '#')
      names.insert(line);
  }
  return names;
}

std::string base_problem(const std::string& image, const std::set<std::string>& stages) {
  if (stages.contains(image)) return "";
  const std::regex dated(R"((@sha256:[0-9a-f]{64}$|:[a-z]+-20[0-9]{6}(-|$)))");
  return std::regex_search(image, dated) ? "" : "FROM " + image + " has no digest and no date";
}

std::vector<std::string> run_problems(const std::string& run, const std::set<std::string>& known) {
  std::vector<std::string> problems;
  const bool installs = run.find("install-packages ") != std::string::npos ||
                        run.find("apt-get") != std::string::npos;
  if (installs && run.find("rm -rf /var/lib/apt/lists/*") == std::string::npos)
    problems.push_back("package lists stay in the layer: " + run);
  const std::regex apt("apt-get[^&|]* install([^&|]*)"), groups("install-packages([^&|]*)");
  if (std::regex_search(run, std::regex("curl |wget ")))
    problems.push_back("fetches something unsigned: " + run);
  std::smatch match;
  if (std::regex_search(run, match, apt)) {
    if (match[0].str().find("--no-install-recommends") == std::string::npos)
      problems.push_back("installs what is only recommended: " + run);
    for (const std::string& name : words_of(match[1]))
      if (name[0] != '-' && !known.contains(name))
        problems.push_back(name + " is not in packages.txt");
  }
  if (std::regex_search(run, match, groups))
    for (const std::string& name : words_of(match[1]))
      if (!known.contains("group " + name))
        problems.push_back(name + " is no group of packages.txt");
  return problems;
}

std::vector<std::string> copy_problems(const std::string& copy) {
  std::vector<std::string> problems, words = words_of(copy);
  if (words.size() < 3 || words[1].starts_with("--from=")) return problems;
  for (std::size_t i = 1; i + 1 < words.size(); ++i)
    if (!fs::exists(root / words[i]))
      problems.push_back("COPY of " + words[i] + ", which is not there");
  return problems;
}

std::vector<std::string> container_problems(const std::string& text,
                                            const std::set<std::string>& known) {
  std::vector<std::string> problems;
  std::set<std::string> stages;
  std::string user = "root", entry;
  const auto add = [&](const std::vector<std::string>& more) {
    problems.insert(problems.end(), more.begin(), more.end());
  };
  for (const std::string& instruction : instructions_of(text)) {
    const std::vector<std::string> words = words_of(instruction);
    if (words[0] == "FROM") {
      if (const std::string problem = base_problem(words.at(1), stages); !problem.empty())
        problems.push_back(problem);
      if (words.size() == 4) stages.insert(words[3]);
      user = "root";
    }
    if (words[0] == "RUN") add(run_problems(instruction, known));
    if (words[0] == "COPY") add(copy_problems(instruction));
    if (words[0] == "ADD") problems.push_back("ADD may fetch; use COPY");
    if (words[0] == "USER") user = words.at(1);
    if (words[0] == "ENTRYPOINT") entry = instruction;
  }
  if (user == "root") problems.push_back("the program runs as root");
  if (entry != "ENTRYPOINT [\"phytobench\"]") problems.push_back("it does not start phytobench");
  if (text.find("LC_ALL=C") == std::string::npos) problems.push_back("the language is left open");
  return problems;
}

const std::set<std::string> some = {"gnuplot-nox", "group build"};
const std::string end = "ENV LC_ALL=C\nUSER me\nENTRYPOINT [\"phytobench\"]\n";

TEST(ContainerTidy, CheckFindsWhatIsWrong) {
  const std::string dated = "ARG DAY=20250101\nFROM debian:bookworm-${DAY}-slim AS base\n";
  EXPECT_TRUE(container_problems(dated + "FROM base\n" + end, some).empty());
  EXPECT_EQ(container_problems("FROM debian:latest\n" + end, some).size(), 1u);
  EXPECT_EQ(container_problems("FROM debian:bookworm-slim\n" + end, some).size(), 1u);
  EXPECT_EQ(container_problems(dated, some).size(), 3u) << "root, no program, no language";
  const std::string update = "RUN apt-get update && apt-get -y ",
                    clean = " && rm -rf /var/lib/apt/lists/*\n";
  const std::string lean = "--no-install-recommends install ";
  EXPECT_TRUE(
      container_problems(dated + update + lean + "gnuplot-nox" + clean + end, some).empty());
  EXPECT_EQ(container_problems(dated + update + lean + "gnuplot-nox\n" + end, some).size(), 1u);
  EXPECT_EQ(container_problems(dated + update + "install gnuplot-nox" + clean + end, some).size(),
            1u);
  EXPECT_EQ(container_problems(dated + update + lean + "vim" + clean + end, some).size(), 1u);
  EXPECT_EQ(container_problems(dated + "RUN cmake/install-packages all" + clean + end, some).size(),
            1u);
  EXPECT_EQ(container_problems(dated + "RUN cmake/install-packages build \\\n" + clean + end, some)
                .size(),
            0u);
  EXPECT_EQ(container_problems(dated + "COPY nowhere.txt /\n" + end, some).size(), 1u);
  EXPECT_EQ(container_problems(dated + "RUN curl -O something\n" + end, some).size(), 1u);
}

TEST(ContainerTidy, DockerfileKeepsTheRules) {
  const std::string text = read("Dockerfile");
  ASSERT_GE(instructions_of(text).size(), 15u);
  for (const std::string& problem :
       container_problems(text, packages_of(read("cmake/packages.txt"))))
    ADD_FAILURE() << problem;
}

}  // namespace
}  // namespace phytobench
