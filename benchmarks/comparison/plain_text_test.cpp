// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/plain_text.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(PlainText, IsOneLine) {
  EXPECT_EQ(one_line("a\n\tb\x1b[31m"), "a  b [31m");
  EXPECT_EQ(one_line(""), "");
}

TEST(PlainText, IsCutBetweenCharacters) {
  EXPECT_EQ(one_line("abcdef", 6), "abcdef");
  EXPECT_EQ(one_line("abcdef", 4), "abcd...");
  EXPECT_EQ(one_line("ab\xc3\xa4"
                     "cd",
                     3),
            "ab...")
      << "half an umlaut is none";
  EXPECT_EQ(one_line("ab\xc3\xa4"
                     "cd",
                     4),
            "ab\xc3\xa4...");
}

TEST(PlainText, LeavesNoMarkup) {
  EXPECT_EQ(markdown_text("a_b <!-- @all | `c` &"), "a\\_b &lt;\\!-- &#64;all \\| \\`c\\` &amp;");
}

}  // namespace
}  // namespace phytobench
