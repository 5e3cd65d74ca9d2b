// SPDX-License-Identifier: MIT
// What the loaders of errata and assumptions refuse, in files written for one test.
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "reference/assumptions.hpp"
#include "reference/data_folder_fixture.hpp"
#include "reference/errata.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A data folder with one paper of our own; the environment is put back afterwards.
class PaperNotes : public testing::Test {
 protected:
  PaperNotes()
      : folder_(fs::path(testing::TempDir()) / ("phytobench_notes_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(paper());
    ::setenv(data_folder_variable, folder_.c_str(), 1);
  }
  ~PaperNotes() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  fs::path paper() const { return folder_ / "papers" / "other2020"; }
  void write(const std::string& file, const std::string& text) const {
    write_file_atomically(paper() / file, text);
  }

 private:
  fs::path folder_;
  KeptDataFolderVariable kept_variable_;
};

/// The message of the InputError, or nothing if there is none.
template <class Load>
std::string refusal(const Load& load) {
  try {
    load();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string erratum_text(const std::string& more) {
  return "[[erratum]]\nid = \"E1\"\nlocator = \"eq. 1\"\nprinted = \"a\"\ncorrected = \"b\"\n"
         "consequence = \"c\"\nconfidence = \"certain\"\nclaims = []\n" +
         more;
}

TEST_F(PaperNotes, ErrataTakeWhatALetterNeedsAndDoWithoutIt) {
  write("errata.toml", erratum_text("section = \"2.1\"\nkind = \"missing case\"\ncheck = \"d\"\n"
                                    "[erratum.counter_example]\noracle = \"o\"\n"
                                    "arguments = [1.0, 2.0]\ninputs = [\"x\", \"y\"]\n"
                                    "result = \"z\"\ncorrected = 3.0\ntolerance = 0.0\n"
                                    "why = \"e\"\n"));
  const std::vector<Erratum> full = load_errata("other2020");
  ASSERT_EQ(full.size(), 1u);
  EXPECT_EQ(full[0].section, "2.1");
  EXPECT_EQ(full[0].kind, ErratumKind::missing_case);
  EXPECT_EQ(full[0].check, "d");
  ASSERT_TRUE(full[0].counter_example);
  EXPECT_EQ(full[0].counter_example->inputs, (std::vector<std::string>{"x", "y"}));
  EXPECT_EQ(full[0].counter_example->result, "z");
  EXPECT_FALSE(full[0].counter_example->printed);

  write("errata.toml", erratum_text("kind = \"differs from the program\"\n"));
  EXPECT_EQ(load_errata("other2020").at(0).kind, ErratumKind::program);

  write("errata.toml", erratum_text(""));
  const std::vector<Erratum> bare = load_errata("other2020");
  ASSERT_EQ(bare.size(), 1u);
  EXPECT_FALSE(bare[0].kind);
  EXPECT_EQ(bare[0].section + bare[0].check, "");
}

TEST_F(PaperNotes, BrokenErrataAreRefusedWithTheirLine) {
  const auto refused = [&](const std::string& text) {
    write("errata.toml", text);
    return refusal([] { load_errata("other2020"); });
  };
  EXPECT_THAT(refused(erratum_text("kind = \"typo\"\n")), HasSubstr("'kind' must be"));
  EXPECT_THAT(refused(erratum_text("suggestion = \"x\"\n")), HasSubstr("suggestion"));
  EXPECT_THAT(refused(erratum_text("") + erratum_text("")), HasSubstr("errata.toml:9"));
  EXPECT_THAT(refused(erratum_text("[erratum.counter_example]\noracle = \"o\"\n"
                                   "arguments = [1.0, 2.0]\ninputs = [\"x\"]\ncorrected = 3.0\n"
                                   "tolerance = 0.0\nwhy = \"e\"\n")),
              HasSubstr("1 names for 2 arguments"));
}

std::string assumption_text(const std::string& claims) {
  return "[[assumption]]\nid = \"A1\"\nlocator = \"sec. 1\"\nquestion = \"a\"\nreading = \"b\"\n"
         "alternatives = \"c\"\nclaims = " +
         claims + "\n";
}

TEST_F(PaperNotes, AssumptionsNeedAClaimAndAnIdOfTheirOwn) {
  EXPECT_TRUE(load_assumptions("other2020").empty()) << "a paper may have none";
  const auto refused = [&](const std::string& text) {
    write("assumptions.toml", text);
    return refusal([] { load_assumptions("other2020"); });
  };
  EXPECT_EQ(refused(assumption_text("[\"other2020/a\"]")), "");
  EXPECT_THAT(refused(assumption_text("[]")), HasSubstr("names no claim"));
  EXPECT_THAT(refused(assumption_text("[\"a\"]") + assumption_text("[\"b\"]")),
              HasSubstr("stands here twice"));
  EXPECT_THAT(refused(assumption_text("[\"a\"]\nkind = \"x\"")), HasSubstr("kind"));
}

}  // namespace
}  // namespace phytobench
