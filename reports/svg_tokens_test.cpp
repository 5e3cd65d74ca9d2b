// SPDX-License-Identifier: MIT
#include "reports/svg_tokens.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(SvgTokens, DropSpaceBetweenElementsOnly) {
  EXPECT_EQ(
      svg_tokens("<svg>\n <title>a  b</title>\n<text> </text>\n</svg>\n"),
      (SvgTokens{"<svg>", "<title>", "a  b", "</title>", "<text>", " ", "</text>", "</svg>"}));
}

TEST(SvgTokens, SeeNoEndOfATagInItsValues) {
  EXPECT_EQ(svg_tokens("<g  aria-label=\"a > b\"  id='c  d' ><path/></g>"),
            (SvgTokens{"<g aria-label=\"a > b\" id='c  d'>", "<path/>", "</g>"}));
}

TEST(SvgTokens, ShortenColoursAndPaths) {
  EXPECT_EQ(svg_tokens("<path stroke='rgb( 36, 123, 224)'  d='M1,2 L3,4  ' />"),
            (SvgTokens{"<path stroke='#247be0' d='M1,2L3,4'/>"}));
  for (const char* tag : {"<path stroke='rgb(300, 0, 0)'/>", "<path stroke='rgb(1, 2'/>"})
    EXPECT_EQ(svg_tokens(tag), SvgTokens{tag});
}

TEST(SvgTokens, EndWhereTheTextDoes) {
  EXPECT_EQ(svg_tokens("<g a=\"b"), (SvgTokens{"<g a=\"b"}));
  EXPECT_EQ(svg_tokens(""), SvgTokens{});
}

TEST(SvgTags, TellNamesAndAttributes) {
  EXPECT_TRUE(opens("<g>", "g"));
  EXPECT_TRUE(opens("<g a=\"b\">", "g"));
  EXPECT_FALSE(opens("<g/>", "g"));
  EXPECT_FALSE(opens("<glyph>", "g"));
  EXPECT_EQ(attribute_of("<g stroke=\"a\" fill=\"none\">", "fill"), "none");
  EXPECT_EQ(attribute_of("<g>", "fill"), "");
}

}  // namespace
}  // namespace phytobench
