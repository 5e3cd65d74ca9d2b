// SPDX-License-Identifier: MIT
#include "reports/plot/smaller_svg.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(SmallerSvg, LosesEmptyGroupsOnly) {
  EXPECT_EQ(smaller_svg("<svg><g a='1'>\n</g><g b='2'><path/></g><g>text</g></svg>"),
            "<svg><g b='2'><path/></g><g>text</g></svg>");
  EXPECT_EQ(smaller_svg("<svg><g id=\"a\" >\n<title>t</title>\n</g></svg>"),
            "<svg><g id=\"a\" >\n<title>t</title>\n</g></svg>");
}

TEST(SmallerSvg, KeepsDefinitionsInUseAndWhatTheyUse) {
  const std::string defs =
      "<defs>\n<path id='a'/>\n<use href='#a' id='b'/>\n<use href='#b' id='c'/>\n"
      "<path id='b1'/>\n</defs>";
  EXPECT_EQ(smaller_svg(defs + "<use href='#b'/>"),
            "<defs>\n<path id='a'/>\n<use href='#a' id='b'/>\n</defs><use href='#b'/>");
  EXPECT_EQ(smaller_svg(defs), "<defs>\n</defs>");
}

std::string dot(const std::string& x, const std::string& y, const std::string& colour) {
  return "<use xlink:href='#gpDot' x='" + x + "' y='" + y + "' color='" + colour + "'/>\n\n";
}

TEST(SmallerSvg, JoinsDotsOfOneColour) {
  const std::string start = " stroke-width='2' stroke-linecap='round' d='";
  EXPECT_EQ(smaller_svg("<a/>" + dot("1.26", "2.00", "red") + dot("3.50", "4.00", "red") + "<b/>"),
            "<a/><path stroke='red'" + start + "M1.3 2.0h0M3.5 4.0h0'/>\n\n<b/>");
  EXPECT_EQ(
      smaller_svg(dot("1", "2", "red") + dot("3", "4", "blue") + "<b/>" + dot("5", "6", "blue")),
      "<path stroke='red'" + start + "M1.0 2.0h0'/><path stroke='blue'" + start +
          "M3.0 4.0h0'/>\n\n<b/><path stroke='blue'" + start + "M5.0 6.0h0'/>");
}

}  // namespace
}  // namespace phytobench
