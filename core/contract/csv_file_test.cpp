// SPDX-License-Identifier: MIT
#include "core/contract/csv_file.hpp"

#include <unistd.h>

#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

namespace fs = std::filesystem;

using Columns = std::vector<std::vector<double>>;

const std::vector<std::string> xyz{"x", "y", "z"};

Columns parsed(std::string_view text, const std::vector<std::string>& columns = xyz) {
  return parse_number_columns(text, "cloud.csv", columns);
}

/// The message of the InputError that parsing ends with.
std::string parsing_error(std::string_view text, const std::vector<std::string>& columns = xyz) {
  try {
    parsed(text, columns);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The message for one field of column x, in line 2.
std::string field_error(const std::string& field) {
  return parsing_error("x\n" + field + "\n", {"x"});
}

/// A fresh folder per test, removed with all it holds.
class NumberColumnsFile : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) /
              (std::string("phytobench-") + test->name() + "-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  std::string reading_error(const fs::path& file) const {
    try {
      read_number_columns(file, xyz);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no error";
  }

  fs::path folder_;
};

TEST(NumberColumns, AreReadOnePerName) {
  EXPECT_EQ(parsed("x,y,z\n1,2,3\n4.5,-6,7e2\n"), (Columns{{1, 4.5}, {2, -6}, {3, 700}}));
}

TEST(NumberColumns, LastLineNeedsNoLineEnd) {
  EXPECT_EQ(parsed("x,y,z\n1,2,3"), (Columns{{1}, {2}, {3}}));
}

TEST(NumberColumns, ComeInTheOrderAskedForWhateverTheFileHas) {
  const std::string text = "z,x,y\n3,1,2\n6,4,5\n";
  EXPECT_EQ(parsed(text), (Columns{{1, 4}, {2, 5}, {3, 6}}));
  EXPECT_EQ(parsed(text, {"y", "z", "x"}), (Columns{{2, 5}, {3, 6}, {1, 4}}));
}

TEST(NumberColumns, OthersAreIgnoredWhateverTheyHold) {
  EXPECT_EQ(parsed("name,x,note,y,note,z\noak,1,,2,inf,3\n,4,nan,5,x y,6\n"),
            (Columns{{1, 4}, {2, 5}, {3, 6}}));
}

TEST(NumberColumns, OneMayBeAskedForTwice) {
  EXPECT_EQ(parsed("x\n1\n2\n", {"x", "x"}), (Columns{{1, 2}, {1, 2}}));
}

TEST(NumberColumns, NamesAreComparedWhole) {
  EXPECT_EQ(parsed("xx,x,x2\n1,2,3\n", {"x"}), (Columns{{2}}));
  EXPECT_THAT(parsing_error("X,Y,Z\n1,2,3\n"), HasSubstr("no column 'x'"));
}

TEST(NumberColumns, ByteOrderMarkIsNoPartOfTheFirstName) {
  EXPECT_EQ(parsed("\xef\xbb\xbfx,y,z\n1,2,3\n"), (Columns{{1}, {2}, {3}}));
  // Anywhere else it is no mark, but a field that is no number.
  EXPECT_THAT(parsing_error("x,y,z\n\xef\xbb\xbf"
                            "1,2,3\n"),
              StartsWith("cloud.csv:2: x = "));
}

TEST(NumberColumns, LinesMayEndAsOnWindows) {
  EXPECT_EQ(parsed("x,y,z\r\n1,2,3\r\n\r\n4,5,6\r\n"), (Columns{{1, 4}, {2, 5}, {3, 6}}));
}

TEST(NumberColumns, BlanksAroundFieldsAreIgnored) {
  EXPECT_EQ(parsed(" x ,\ty, z\n\t1 , 2,3 \n"), (Columns{{1}, {2}, {3}}));
}

TEST(NumberColumns, CommentsAndEmptyLinesAreSkippedBeforeAndAfterTheHeader) {
  EXPECT_EQ(parsed("# a cloud, in metres\n\n  # indented\nx,y,z\n# 9,9,9\n \t\n1,2,3\n\n#\n4,5,6\n"
                   "# end"),
            (Columns{{1, 4}, {2, 5}, {3, 6}}));
}

TEST(NumberColumns, NumbersComeAsPreciselyAsTheyAreWritten) {
  constexpr double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(parsed("x\n0.1\n-0\n1e-3\n1E+3\n.5\n5.\n1.7976931348623157e308\n4.9e-324\n", {"x"}),
            (Columns{{0.1, 0.0, 1e-3, 1e3, 0.5, 5.0, largest,
                      std::numeric_limits<double>::denorm_min()}}));
}

TEST(NumberColumns, LongNumbersAreNumbers) {
  EXPECT_EQ(parsed("x\n1." + std::string(5000, '0') + "\n" + std::string(5000, '0') + "2\n", {"x"}),
            (Columns{{1.0, 2.0}}));
}

TEST(NumberColumns, ManyLinesAllArrive) {
  std::string text = "i,twice\n";
  for (int i = 0; i < 20000; ++i) text += std::to_string(i) + "," + std::to_string(2 * i) + "\n";
  const Columns columns = parsed(text, {"twice", "i"});
  ASSERT_EQ(columns[0].size(), 20000u);
  ASSERT_EQ(columns[1].size(), 20000u);
  for (std::size_t i = 0; i < 20000; ++i) {
    ASSERT_EQ(columns[0][i], 2.0 * static_cast<double>(i));
    ASSERT_EQ(columns[1][i], static_cast<double>(i));
  }
}

TEST(NumberColumnsError, MissingColumnIsNamedWithAllThatAreNeeded) {
  EXPECT_THAT(parsing_error("x,y\n1,2\n"),
              AllOf(StartsWith("cloud.csv:1: no column 'z' in the header"), EndsWith("x,y,z")));
  // A file without a header: its first numbers are taken for one.
  EXPECT_THAT(parsing_error("1,2,3\n4,5,6\n"), StartsWith("cloud.csv:1: no column 'x'"));
  EXPECT_THAT(parsing_error("x;y;z\n1;2;3\n"), StartsWith("cloud.csv:1: no column 'x'"));
}

TEST(NumberColumnsError, TwiceNamedColumnIsRefused) {
  EXPECT_THAT(parsing_error("x,y,z,y\n1,2,3,4\n"),
              AllOf(StartsWith("cloud.csv:1: column 'y' is named twice"), HasSubstr("keep one")));
}

TEST(NumberColumnsError, SecondHeaderIsNoLineOfNumbers) {
  EXPECT_THAT(parsing_error("x,y,z\n1,2,3\nx,y,z\n4,5,6\n"),
              StartsWith("cloud.csv:3: x = 'x' is no finite number"));
}

TEST(NumberColumnsError, WrongNumberOfFieldsSaysBothAndWhatToDo) {
  EXPECT_THAT(parsing_error("x,y,z\n1,2,3\n1,2\n"),
              AllOf(StartsWith("cloud.csv:3: 2 fields where the header has 3"),
                    HasSubstr("complete or remove the line")));
  EXPECT_THAT(parsing_error("x,y,z\n1,2,3,\n"), StartsWith("cloud.csv:2: 4 fields where"));
  // A decimal comma makes two fields of one.
  EXPECT_THAT(parsing_error("x,y,z\n1,5,2,3\n"), StartsWith("cloud.csv:2: 4 fields where"));
  // Columns that nobody asked for count as well.
  EXPECT_THAT(parsing_error("x,y,z,note\n1,2,3\n"), StartsWith("cloud.csv:2: 3 fields where"));
}

TEST(NumberColumnsError, WhatIsNoFiniteNumberIsShownWithColumnAndWayOut) {
  for (const std::string& field : std::vector<std::string>{
           "nan",  "NaN",   "-nan",  "inf",  "-inf",  "Infinity", "1e999", "-1e999",
           "0x10", "0x1p3", "one",   "1.5m", "1 2",   "--1",      "1e",    "e5",
           ".",    "-",     "1.2.3", "\"1",  "1_000", "½"}) {
    EXPECT_THAT(field_error(field),
                AllOf(StartsWith("cloud.csv:2: x = '" + field + "' is no finite number"),
                      HasSubstr("write it like 1.5 or 2e-3")))
        << field;
  }
}

TEST(NumberColumnsError, EmptyFieldIsNoNumber) {
  EXPECT_THAT(parsing_error("x,y,z\n1,2,3\n1,,3\n"),
              StartsWith("cloud.csv:3: y = '' is no finite number"));
  EXPECT_THAT(parsing_error("x,y,z\n1,2, \n"), StartsWith("cloud.csv:2: z = ''"));
  EXPECT_THAT(parsing_error("x,y,z\n,,\n"), StartsWith("cloud.csv:2: x = ''"));
}

TEST(NumberColumnsError, ZeroByteIsNotTheEndOfANumber) {
  EXPECT_THAT(field_error(std::string("1\0", 2)), StartsWith("cloud.csv:2: x = '1"));
}

TEST(NumberColumnsError, LineNumbersCountEveryLine) {
  EXPECT_THAT(parsing_error("# one\n\nx,y,z\n\r\n# five\n1,2,3\n1,2,three\n"),
              StartsWith("cloud.csv:7: z = 'three'"));
  EXPECT_THAT(parsing_error("# one\n\nx,y\n"), StartsWith("cloud.csv:3: no column 'z'"));
}

TEST(NumberColumnsError, VeryLongFieldIsCutShort) {
  const std::string digits(100000, '7');
  const std::string message = field_error(digits + "e");
  EXPECT_THAT(message, AllOf(StartsWith("cloud.csv:2: x = '" + std::string(40, '7') + "...'"),
                             HasSubstr("write it like")));
  EXPECT_LT(message.size(), 200u);
  // As long as what is shown whole.
  EXPECT_THAT(field_error(std::string(40, 'q')), HasSubstr("'" + std::string(40, 'q') + "'"));
  EXPECT_THAT(field_error(std::string(41, 'q')), HasSubstr("'" + std::string(40, 'q') + "...'"));
}

TEST(NumberColumnsError, MessageIsOneLine) {
  for (const std::string& text : std::vector<std::string>{"", "x,y\n", "x,y,z\n", "x,y,z\n1,2\n",
                                                          "x,y,z\r\n1,2,a\r\n", "x,y,z,z\n"})
    EXPECT_THAT(parsing_error(text), Not(HasSubstr("\n"))) << text;
}

TEST(NumberColumnsError, NothingInTheFileAsksForTheHeader) {
  for (const char* text : {"", "\n", "\n\n\r\n", "# only a comment\n", "\xef\xbb\xbf", " \t "})
    EXPECT_THAT(parsing_error(text), AllOf(StartsWith("cloud.csv: is empty"), HasSubstr("x,y,z")))
        << "'" << text << "'";
}

TEST(NumberColumnsError, HeaderAloneAsksForNumbers) {
  for (const char* text : {"x,y,z", "x,y,z\n", "x,y,z\n\n# none\n"})
    EXPECT_THAT(parsing_error(text), AllOf(StartsWith("cloud.csv: has a header but no line of"),
                                           HasSubstr("give at least one")))
        << "'" << text << "'";
}

TEST_F(NumberColumnsFile, IsReadLikeItsText) {
  write_file_atomically(folder_ / "cloud.csv", "\xef\xbb\xbfz,y,x\r\n3,2,1\r\n");
  EXPECT_EQ(read_number_columns(folder_ / "cloud.csv", xyz), (Columns{{1}, {2}, {3}}));
}

TEST_F(NumberColumnsFile, ErrorsNameItAndTheLine) {
  const fs::path file = folder_ / "cloud.csv";
  write_file_atomically(file, "x,y,z\n1,2,3\n1,2,nan\n");
  EXPECT_THAT(reading_error(file),
              StartsWith(file.string() + ":3: z = 'nan' is no finite number; write it like"));
  write_file_atomically(file, "");
  EXPECT_THAT(reading_error(file), StartsWith(file.string() + ": is empty; give a line with"));
}

TEST_F(NumberColumnsFile, MissingOrAFolderIsAnInputErrorThatNamesIt) {
  EXPECT_THAT(reading_error(folder_ / "nowhere.csv"),
              StartsWith((folder_ / "nowhere.csv").string() + ": no such file"));
  EXPECT_THAT(reading_error(folder_), StartsWith(folder_.string() + ": is a folder"));
}

TEST(NumberColumns, MayBeQuotedAsRDoes) {
  EXPECT_EQ(parse_number_columns("\"\",\"x\",\"y\"\n\"1\",2,\"3.5\"\n", "r.csv", {"x", "y"}),
            (Columns{{2}, {3.5}}));
}

TEST_F(NumberColumnsFile, WordsStandBesideNumbers) {
  const fs::path file = folder_ / "plants.csv";
  write_file_atomically(file, "species,y,x\nred oak,2,1\n beech ,4,3\n");
  const CsvTable table = read_table(file, {"x", "y"}, {"species"});
  EXPECT_EQ(table.numbers, (Columns{{1, 3}, {2, 4}}));
  EXPECT_EQ(table.words, (std::vector<std::vector<std::string>>{{"red oak", "beech"}}));
  write_file_atomically(file, "species,x\n,1\n");
  EXPECT_THROW(read_table(file, {"x"}, {"species"}), InputError);
  EXPECT_THROW(read_table(file, {"x"}, {"kind"}), InputError);
}

TEST_F(NumberColumnsFile, ColumnIsThereIfTheHeaderNamesIt) {
  const fs::path file = folder_ / "plants.csv";
  write_file_atomically(file, "\xef\xbb\xbf\r\n# species, too\n x ,\"y\",radius\r\n1,species,3\n");
  for (const char* name : {"x", "y", "radius"}) EXPECT_TRUE(has_column(file, name)) << name;
  for (const char* name : {"species", "X", "", "1"}) EXPECT_FALSE(has_column(file, name)) << name;
  write_file_atomically(file, "x");
  EXPECT_TRUE(has_column(file, "x"));
  write_file_atomically(file, "");
  EXPECT_FALSE(has_column(file, "x"));
  EXPECT_THROW(has_column(folder_ / "nowhere.csv", "x"), InputError);
}

TEST_F(NumberColumnsFile, PlaceOfARowIsItsLine) {
  const fs::path file = folder_ / "cloud.csv";
  write_file_atomically(file, "\xef\xbb\xbf\r\n# a scan\nx,y,z\r\n1,2,3\n\n# more\n4,5,6\n7,8,9");
  EXPECT_EQ(place_of_row(file, 0), file.string() + ":4");
  EXPECT_EQ(place_of_row(file, 1), file.string() + ":7");
  EXPECT_EQ(place_of_row(file, 2), file.string() + ":8");
  EXPECT_EQ(place_of_row(file, 3), file.string());  // there is none
}

}  // namespace
}  // namespace phytobench
