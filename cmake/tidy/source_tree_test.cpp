// SPDX-License-Identifier: MIT
// House rules that a machine can check, on the files git tracks. Each rule is a pure function,
// tried on a file that breaks it before it is applied to the tree.
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
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

struct File {
  std::string path;  ///< from the project's root
  std::string text;
};

std::string output_of(const std::string& command) {
  std::string output;
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(::popen(command.c_str(), "r"),
                                                             ::pclose);
  std::array<char, 4096> buffer{};
  while (pipe && std::fgets(buffer.data(), static_cast<int>(buffer.size()), pipe.get()))
    output += buffer.data();
  return output;
}

std::vector<File> tracked_files(const std::regex& name) {
  std::vector<File> files;
  std::istringstream listing(
      output_of("git -C '" + root.string() + "' ls-files --cached --others --exclude-standard"));
  for (std::string path; std::getline(listing, path);)
    if (std::regex_search(path, name) && fs::exists(root / path))
      files.push_back({path, read(path)});
  return files;
}

const std::regex cpp_name(R"(\.(cpp|hpp)$)");

std::string layer_of(const std::string& path) {
  return path.substr(0, path.find('/'));
}

/// Position from the bottom. A file may include its own layer and those below.
int height_of(const std::string& layer) {
  const std::vector<std::string> layers = {"core",        "reference", "benchmarks",
                                           "experiments", "reports",   "cli"};
  for (std::size_t i = 0; i < layers.size(); ++i)
    if (layers[i] == layer) return static_cast<int>(i);
  return -1;
}

bool is_test(const std::string& path) {
  return path.ends_with("_test.cpp");
}

/// What is wrong with one include of a file; empty if nothing.
std::string include_problem(const std::string& path, const std::string& included) {
  const std::string from = layer_of(path), to = layer_of(included);
  if (height_of(to) < 0 || height_of(from) < 0) return "";
  if (path.starts_with("reference/oracles/") && !is_test(path) &&
      !included.starts_with("reference/oracles/"))
    return "an oracle shares no code with anything";
  if (from == "reports" && (to == "experiments" || to == "benchmarks"))
    return "reports judge records and run nothing";
  if (included == "reference/claims.hpp" || included == "reference/errata.hpp") {
    if (from == "reports" || from == "reference" || is_test(path)) return "";
    return "only reports and tests may see claims";
  }
  return height_of(to) > height_of(from) ? "includes point down the layers" : "";
}

std::vector<std::string> layering_problems(const File& file) {
  std::vector<std::string> problems;
  const std::regex include(R"rx(#include "([^"]+)")rx");
  for (auto match = std::sregex_iterator(file.text.begin(), file.text.end(), include);
       match != std::sregex_iterator(); ++match)
    if (const std::string problem = include_problem(file.path, (*match)[1]); !problem.empty())
      problems.push_back(file.path + " includes " + (*match)[1].str() + ": " + problem);
  return problems;
}

std::vector<std::string> marker_problems(const File& file) {
  // Put together from pieces, so that this file does not find itself.
  const std::regex marker(
      "\\b(TO"
      "DO|FIX"
      "ME|XX"
      "X|HA"
      "CK)\\b");
  std::vector<std::string> problems;
  if (std::regex_search(file.text, marker))
    problems.push_back(file.path + " has a leftover marker");
  return problems;
}

/// A document that was never filled in.
std::vector<std::string> placeholder_problems(const File& file) {
  std::vector<std::string> problems;
  if (std::regex_search(file.text, std::regex("@[A-Z_]+@")))
    problems.push_back(file.path + " has an unfilled @NAME@");
  return problems;
}

std::vector<std::string> licence_problems(const File& file) {
  std::vector<std::string> problems;
  if (!file.text.starts_with("// SPDX-License-Identifier: MIT\n"))
    problems.push_back(file.path + " does not start with its licence line");
  return problems;
}

std::set<std::string> paper_keys() {
  std::set<std::string> keys;
  const std::string text = read("reference/papers.def");
  const std::regex line(R"(\nPAPER\(([a-z0-9]+), )");
  for (auto match = std::sregex_iterator(text.begin(), text.end(), line);
       match != std::sregex_iterator(); ++match)
    keys.insert((*match)[1]);
  return keys;
}

/// Citations look like [Brzoska2019]; each key must exist in lower case.
std::vector<std::string> citation_problems(const File& file, const std::set<std::string>& keys) {
  std::vector<std::string> problems;
  const std::regex citation(R"(\[([A-Z][a-z]+[12][0-9]{3})\])");
  for (auto match = std::sregex_iterator(file.text.begin(), file.text.end(), citation);
       match != std::sregex_iterator(); ++match) {
    std::string key = (*match)[1];
    for (char& c : key) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    if (!keys.contains(key))
      problems.push_back(file.path + " cites " + (*match)[1].str() +
                         ", which is no paper of the suite");
  }
  return problems;
}

std::vector<std::string> machine_problems(const File& file) {
  const std::regex path(R"((^|[^A-Za-z0-9_.$}])/(home|root|work)/[a-z])");
  std::vector<std::string> problems;
  if (std::regex_search(file.text, path))
    problems.push_back(file.path + " names a path of some machine");
  return problems;
}

/// Names registered in a .def list: "voxel_grid", "brzoska2019/table_1".
std::set<std::string> registered(const std::string& text) {
  std::set<std::string> names;
  const std::regex line(R"((^|\n)[A-Z]+\(([a-z0-9_]+)(, ([a-z0-9_]+))?, [A-Za-z0-9_:]+\))");
  for (auto match = std::sregex_iterator(text.begin(), text.end(), line);
       match != std::sregex_iterator(); ++match)
    names.insert((*match)[4].matched ? (*match)[2].str() + "/" + (*match)[4].str()
                                     : (*match)[2].str());
  return names;
}

std::vector<std::string> registration_problems(const std::set<std::string>& names,
                                               const std::set<std::string>& files) {
  std::vector<std::string> problems;
  for (const std::string& name : names)
    if (!files.contains(name)) problems.push_back(name + " is registered, but has no file");
  for (const std::string& file : files)
    if (!names.contains(file)) problems.push_back(file + " has a file, but is not registered");
  return problems;
}

void expect_none(const std::vector<std::string>& problems) {
  for (const std::string& problem : problems) ADD_FAILURE() << problem;
}

void expect_clean(const std::regex& name,
                  const std::function<std::vector<std::string>(const File&)>& rule) {
  const std::vector<File> files = tracked_files(name);
  ASSERT_GT(files.size(), 10u) << "no files found: is this a git checkout?";
  for (const File& file : files) expect_none(rule(file));
}

TEST(LayeringTidy, IncludesPointDownTheLayers) {
  EXPECT_EQ(layering_problems({"core/a.cpp", "#include \"reports/b.hpp\"\n"}).size(), 1u);
  EXPECT_EQ(layering_problems({"experiments/a.cpp", "#include \"reference/claims.hpp\"\n"}).size(),
            1u);
  EXPECT_EQ(layering_problems({"reports/a.cpp", "#include \"experiments/b.hpp\"\n"}).size(), 1u);
  EXPECT_EQ(layering_problems({"reference/oracles/a.cpp", "#include \"core/b.hpp\"\n"}).size(), 1u);
  EXPECT_EQ(layering_problems({"cli/a.cpp", "#include \"core/b.hpp\"\n"}).size(), 0u);
  expect_clean(cpp_name, layering_problems);
}

TEST(MarkersTidy, NothingIsLeftOver) {
  EXPECT_EQ(marker_problems({"a.cpp", std::string("// TO") + "DO: later\n"}).size(), 1u);
  EXPECT_EQ(marker_problems({"a.cpp", "int hacksaw;\n"}).size(), 0u);
  expect_clean(std::regex(R"(\.(cpp|hpp|def|toml|md|cmake|mustache)$)"), marker_problems);
}

TEST(PlaceholdersTidy, EveryDocumentIsFilledIn) {
  EXPECT_EQ(placeholder_problems({"a.md", "it takes @TIME@\n"}).size(), 1u);
  const std::vector<File> documents = tracked_files(std::regex(R"(\.md$)"));
  ASSERT_GE(documents.size(), 3u);
  for (const File& file : documents) expect_none(placeholder_problems(file));
}

TEST(LicenceTidy, EverySourceStartsWithIt) {
  EXPECT_EQ(licence_problems({"a.cpp", "int x;\n"}).size(), 1u);
  expect_clean(cpp_name, licence_problems);
}

TEST(CitationsTidy, EveryCitedPaperExists) {
  const std::set<std::string> keys = paper_keys();
  ASSERT_TRUE(keys.contains("brzoska2019"));
  EXPECT_EQ(citation_problems({"a.cpp", "// [Nobody1999] eq. 1\n"}, {"brzoska2019"}).size(), 1u);
  expect_clean(
      std::regex(R"((core|reference|experiments|benchmarks|reports|cli)/.*\.(cpp|hpp|toml)$)"),
      [&](const File& file) { return citation_problems(file, keys); });
}

TEST(MachinePathsTidy, NoFileNamesOne) {
  EXPECT_EQ(machine_problems({"a.md", std::string("see /ho") + "me/someone\n"}).size(), 1u);
  expect_clean(std::regex(R"(.)"), machine_problems);
}

TEST(RegistrationTidy, EveryEngineAndExperimentHasOneLineAndOneFile) {
  EXPECT_EQ(registration_problems({"a"}, {"b"}).size(), 2u);
  struct List {
    const char* def;
    const char* folder;
  };
  for (const List& list :
       {List{"core/nearest_node/engines.def", "core/nearest_node/engines/"},
        List{"core/overlap/overlap_engines.def", "core/overlap/engines/"},
        List{"core/competition/competition_rules.def", "core/competition/rules/"},
        List{"core/lsystem/derivation_engines.def", "core/lsystem/engines/"},
        List{"core/terrain/shadow/shadow_engines.def", "core/terrain/shadow/engines/"},
        List{"core/component_graph/components.def", "core/component_graph/components/"},
        List{"core/component_graph/extra_components/extra_components.def",
             "core/component_graph/extra_components/"},
        List{"benchmarks/broken/broken_engines.def", "benchmarks/broken/"},
        List{"benchmarks/regression/families.def", "benchmarks/regression/families/"},
        List{"benchmarks/faulty_engines/faulty_engines.def", "benchmarks/faulty_engines/"},
        List{"benchmarks/faulty_overlap_engines/faulty_overlap_engines.def",
             "benchmarks/faulty_overlap_engines/"},
        List{"benchmarks/faulty_shadow_engines/faulty_shadow_engines.def",
             "benchmarks/faulty_shadow_engines/"}}) {
    std::set<std::string> files;
    for (const File& file :
         tracked_files(std::regex(std::string("^") + list.folder + R"([a-z0-9_]+\.cpp$)")))
      if (!is_test(file.path)) files.insert(fs::path(file.path).stem().string());
    expect_none(registration_problems(registered(read(list.def)), files));
  }
  // An experiment's folder also holds helpers; what defines a descriptor must be registered.
  std::set<std::string> experiments;
  for (const File& file : tracked_files(std::regex(R"(^experiments/[a-z0-9]+/[a-z0-9_]+\.cpp$)")))
    if (file.text.find("constinit const ExperimentDescriptor") != std::string::npos)
      experiments.insert(fs::path(file.path).parent_path().filename().string() + "/" +
                         fs::path(file.path).stem().string());
  expect_none(registration_problems(registered(read("experiments/experiments.def")), experiments));
  // A paper is a folder.
  std::set<std::string> papers;
  for (const File& file : tracked_files(std::regex(R"(^reference/papers/[a-z0-9]+/paper\.toml$)")))
    papers.insert(fs::path(file.path).parent_path().filename().string());
  expect_none(registration_problems(registered(read("reference/papers.def")), papers));
}

TEST(FormattingTidy, ClangFormatWouldChangeNothing) {
  if (std::system("clang-format --version >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "clang-format is not installed; ./check installs it";
  for (const File& file : tracked_files(cpp_name)) {
    const std::string path = (root / file.path).string();
    EXPECT_EQ(output_of("clang-format --style=file '" + path + "'"), file.text)
        << file.path << ": run clang-format -i on it";
  }
}

}  // namespace
}  // namespace phytobench
