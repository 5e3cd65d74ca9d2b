// SPDX-License-Identifier: MIT
#include "reference/toml_table.hpp"

#include <unistd.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;
using Texts = std::vector<std::string>;

/// What an InputError says, or that there was none.
std::string error_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

/// A fresh folder for one test, removed afterwards.
class TomlTableFile : public testing::Test {
 protected:
  TomlTableFile()
      : folder_(fs::path(testing::TempDir()) / ("phytobench_toml_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~TomlTableFile() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  const fs::path& folder() const { return folder_; }
  fs::path file() const { return folder_ / "table.toml"; }
  std::string at_line(int line) const { return file().string() + ":" + std::to_string(line) + ":"; }

  TomlTable table_of(const std::string& text) const {
    write_file_atomically(file(), text);
    return TomlTable::read(file());
  }

 private:
  fs::path folder_;
};

TEST_F(TomlTableFile, GivesValuesOfEachKind) {
  const TomlTable table = table_of(
      "text = \"a\"\n"
      "real = 0.5\n"
      "whole = 3\n"
      "texts = [\"a\", \"b\"]\n"
      "numbers = [1, 2.5]\n"
      "text_lists = [[\"a\"], [\"b\", \"c\"], []]\n"
      "number_lists = [[1.0], [2, 3]]\n");
  EXPECT_EQ(table.text("text"), "a");
  EXPECT_EQ(table.number("real"), 0.5);
  EXPECT_EQ(table.number("whole"), 3.0);
  EXPECT_EQ(table.texts("texts"), (Texts{"a", "b"}));
  EXPECT_EQ(table.numbers("numbers"), (std::vector<double>{1.0, 2.5}));
  const std::vector<Texts> text_lists = table.text_lists("text_lists");
  ASSERT_EQ(text_lists.size(), 3u);
  EXPECT_EQ(text_lists[0], Texts{"a"});
  EXPECT_EQ(text_lists[1], (Texts{"b", "c"}));
  EXPECT_TRUE(text_lists[2].empty());
  const std::vector<std::vector<double>> number_lists = table.number_lists("number_lists");
  ASSERT_EQ(number_lists.size(), 2u);
  EXPECT_EQ(number_lists[1], (std::vector<double>{2.0, 3.0}));
}

TEST_F(TomlTableFile, FallsBackOnlyForAbsentKeys) {
  const TomlTable table = table_of("given = \"\"\nnumber = 0.0\n");
  EXPECT_EQ(table.text_or("given", "fallback"), "");
  EXPECT_EQ(table.text_or("absent", "fallback"), "fallback");
  EXPECT_TRUE(table.number_if_given("number").has_value());
  EXPECT_FALSE(table.number_if_given("absent").has_value());
  EXPECT_TRUE(table.has("given"));
  EXPECT_FALSE(table.has("absent"));
}

TEST_F(TomlTableFile, ListsKeysInTheOrderOfTheFile) {
  const TomlTable table = table_of("zebra = 1\nant = 2\nmole = 3\n[bee]\nx = 1\n");
  EXPECT_EQ(table.keys(), (Texts{"zebra", "ant", "mole", "bee"}));
}

TEST_F(TomlTableFile, GivesTablesWithinTables) {
  const TomlTable table = table_of("[a.b]\nx = 1\n[[row]]\nx = 2\n[[row]]\nx = 3\n");
  EXPECT_EQ(table.table("a").table("b").number("x"), 1.0);
  const std::vector<TomlTable> rows = table.tables("row");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].number("x"), 2.0);
  EXPECT_EQ(rows[1].number("x"), 3.0);
  EXPECT_TRUE(table.tables("absent").empty());
}

TEST_F(TomlTableFile, OutlivesTheTableItWasTakenFrom) {
  const TomlTable inner = table_of("[a.b]\nx = 1\n").table("a").table("b");
  EXPECT_EQ(inner.number("x"), 1.0);
}

TEST_F(TomlTableFile, NamesFileLineAndKeyOfAWrongValue) {
  const TomlTable table = table_of(
      "text = \"a\"\n"
      "number = 1\n"
      "texts = [\"a\",\n"
      "         1]\n"
      "lists = [[1.0], 2.0]\n");
  struct Wrong {
    std::function<void()> access;
    int line;
    const char* key;
  };
  const std::vector<Wrong> wrongs = {
      {[&] { table.number("text"); }, 1, "'text' must be a number"},
      {[&] { table.text("number"); }, 2, "'number' must be text"},
      {[&] { table.texts("number"); }, 2, "'number' must be a list"},
      {[&] { table.texts("texts"); }, 4, "'texts' must be"},
      {[&] { table.number_lists("lists"); }, 5, "'lists' must be a list"},
      {[&] { table.table("number"); }, 2, "'number' must be a table"},
      {[&] { table.tables("number"); }, 2, "'number' must be a list of tables"},
      {[&] { table.tables("texts"); }, 3, "'texts' must hold tables"},
  };
  for (const Wrong& wrong : wrongs) {
    const std::string error = error_of(wrong.access);
    EXPECT_THAT(error, StartsWith(at_line(wrong.line)));
    EXPECT_THAT(error, HasSubstr(wrong.key));
  }
}

TEST_F(TomlTableFile, NamesTheTableOfAMissingKey) {
  const TomlTable table = table_of("\n[[row]]\nx = 1\n[[row]]\ny = 1\n");
  const TomlTable second = table.tables("row")[1];
  const std::string error = error_of([&] { second.number("x"); });
  EXPECT_THAT(error, StartsWith(at_line(4)));
  EXPECT_THAT(error, HasSubstr("'x' is missing"));
  EXPECT_THAT(error_of([&] { second.fail("too green"); }), StartsWith(at_line(4)));
  EXPECT_THAT(error_of([&] { second.fail("too green"); }), HasSubstr("too green"));
}

TEST_F(TomlTableFile, RefusesUnknownKeysAndSuggestsTheNearest) {
  const TomlTable table = table_of("title = \"a\"\nlocater = \"b\"\n");
  EXPECT_NO_THROW(table.allow_only({"title", "locater", "unused"}));
  const std::string error = error_of([&] { table.allow_only({"title", "locator"}); });
  EXPECT_THAT(error, StartsWith(at_line(2)));
  EXPECT_THAT(error, HasSubstr("unknown key 'locater'"));
  EXPECT_THAT(error, HasSubstr("did you mean 'locator'?"));
}

TEST_F(TomlTableFile, NamesThePlaceOfASyntaxError) {
  const std::string error = error_of([&] { table_of("a = 1\nb = = 2\n"); });
  EXPECT_THAT(error, StartsWith(at_line(2)));
  EXPECT_THAT(error, HasSubstr("not valid TOML"));
  EXPECT_EQ(error.find('\n'), std::string::npos) << "errors are one line";
}

TEST_F(TomlTableFile, RefusesAKeyThatStandsThereTwice) {
  EXPECT_THAT(error_of([&] { table_of("a = 1\na = 2\n"); }), StartsWith(at_line(2)));
}

TEST_F(TomlTableFile, MustBeAFileThatExists) {
  EXPECT_THROW(TomlTable::read(folder() / "absent.toml"), InputError);
  EXPECT_THROW(TomlTable::read(folder()), InputError);
}

}  // namespace
}  // namespace phytobench
