// SPDX-License-Identifier: MIT
#include "reference/data_folder.hpp"

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "reference/data_folder_fixture.hpp"
#include "reference/papers.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A fresh folder for one test; both it and the environment are put back afterwards.
class DataFolder : public testing::Test {
 protected:
  DataFolder()
      : folder_(fs::path(testing::TempDir()) / ("phytobench_data_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~DataFolder() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  void point_to(const fs::path& folder) const { ::setenv(data_folder_variable, folder.c_str(), 1); }
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
  KeptDataFolderVariable kept_variable_;
};

TEST_F(DataFolder, HoldsEveryPaper) {
  ASSERT_FALSE(paper_keys().empty());
  for (const std::string& key : paper_keys()) {
    EXPECT_EQ(paper_folder(key), data_folder() / "papers" / key);
    for (const char* file : {"paper.toml", "parameters.toml"})
      EXPECT_TRUE(fs::is_regular_file(paper_folder(key) / file)) << key << "/" << file;
    for (const char* kind : {"claims", "errata"}) EXPECT_FALSE(paper_files(key, kind).empty());
    const Paper paper = load_paper(key);
    EXPECT_EQ(paper.key, key);
    for (const std::string& text :
         {paper.title, paper.author, paper.year, paper.kind, paper.summary})
      EXPECT_FALSE(text.empty()) << key;
  }
}

TEST_F(DataFolder, TakesOneFileOrAFolderOfFilesInOrderOfName) {
  const fs::path paper = folder() / "papers" / "other2020";
  fs::create_directories(paper / "claims");
  point_to(folder());
  EXPECT_THROW(paper_files("other2020", "claims"), InputError);
  for (const char* name : {"b.toml", "a.toml", "notes.txt"}) std::ofstream(paper / "claims" / name);
  EXPECT_EQ(paper_files("other2020", "claims"),
            (std::vector{paper / "claims" / "a.toml", paper / "claims" / "b.toml"}));
  std::ofstream(paper / "claims.toml").put('\n');
  EXPECT_THROW(paper_files("other2020", "claims"), InputError);
  fs::remove_all(paper / "claims");
  EXPECT_EQ(paper_files("other2020", "claims"), (std::vector{paper / "claims.toml"}));
}

TEST_F(DataFolder, RefusesAnUnknownPaperByName) {
  try {
    load_paper("nobody1999");
    FAIL() << "an unknown paper was loaded";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("unknown paper 'nobody1999'"));
  }
  EXPECT_THROW(paper_folder("nobody1999"), InputError);
}

TEST_F(DataFolder, IsWhereTheVariablePoints) {
  fs::create_directories(folder() / "papers" / "other2020");
  point_to(folder());
  EXPECT_EQ(data_folder(), folder());
  EXPECT_EQ(paper_folder("other2020"), folder() / "papers" / "other2020");
  EXPECT_THROW(paper_folder(paper_keys().at(0)), InputError);
}

TEST_F(DataFolder, IsAnEnvironmentErrorWhereTheVariablePointsNowhere) {
  for (const fs::path& wrong : {folder() / "absent", folder()}) {
    point_to(wrong);
    try {
      data_folder();
      FAIL() << wrong << " was taken";
    } catch (const EnvironmentError& error) {
      EXPECT_THAT(error.what(), HasSubstr("PHYTOBENCH_DATA=" + wrong.string()));
    }
    EXPECT_THROW(paper_folder(paper_keys().at(0)), EnvironmentError);
  }
}

TEST_F(DataFolder, OfAnInstalledProgramIsShareSlashPhytobench) {
  const fs::path bin = folder() / "bin", installed = folder() / "share" / "phytobench";
  fs::create_directories(bin);
  fs::create_directories(installed / "papers");
  EXPECT_EQ(data_folder_of_program(bin / "phytobench"), installed);
  // A build's own comes first, a folder without papers never.
  fs::create_directories(bin / "share");
  EXPECT_EQ(data_folder_of_program(bin / "phytobench"), installed);
  fs::create_directories(bin / "share" / "papers");
  EXPECT_EQ(data_folder_of_program(bin / "phytobench"), bin / "share");
  EXPECT_EQ(data_folder_of_program(folder() / "phytobench"), installed);
}

TEST_F(DataFolder, IsNothingWhereNoFolderAboveTheProgramHasOne) {
  fs::create_directories(folder() / "bin");
  EXPECT_EQ(data_folder_of_program(folder() / "bin" / "phytobench"), std::nullopt);
}

TEST_F(DataFolder, StandsAboveTheProgramWithoutTheVariable) {
  ::unsetenv(data_folder_variable);
  const fs::path found = data_folder();
  EXPECT_TRUE(fs::is_directory(found / "papers"));
  EXPECT_EQ(found.filename(), "share");
  ::setenv(data_folder_variable, "", 1);
  EXPECT_EQ(data_folder(), found);
}

}  // namespace
}  // namespace phytobench
