// SPDX-License-Identifier: MIT
#include "reports/compact_svg.hpp"

#include <gtest/gtest.h>

namespace phytobench {
namespace {

TEST(CompactSvg, JoinsNeighbouringGroupsOfEqualAttributes) {
  EXPECT_EQ(compact_svg("<g a=\"1\"><b/></g>\n<g a=\"1\"><c/></g><g a=\"2\"><d/></g>"),
            "<g a=\"1\"><b/><c/></g><g a=\"2\"><d/></g>");
  EXPECT_EQ(compact_svg("<g><g a=\"1\"><b/></g></g><g a=\"1\"><c/></g>"),
            "<g><g a=\"1\"><b/></g></g><g a=\"1\"><c/></g>");
}

TEST(CompactSvg, KeepsGroupsThatAreComposedOrNamed) {
  for (const char* attribute : {"opacity=\"0.5\"", "id=\"x\"", "mask=\"url(#m)\""}) {
    const std::string group = std::string("<g ") + attribute + "><b/></g>";
    EXPECT_EQ(compact_svg(group + group), group + group);
  }
}

TEST(CompactSvg, DrawsAxesAndGridsInOneGoAndLettersAfterThem) {
  const auto letters = [](const std::string& place, const std::string& text) {
    return "<g transform=\"translate(" + place + ")\" font-size=\"9\"><text>" + text +
           "</text></g>";
  };
  const std::string grid = "<path stroke='currentColor' opacity='0.3' class=\"gridline\" d='";
  EXPECT_EQ(compact_svg("<g fill=\"none\">" + grid + "M1,2L3,2'/>" + letters("1,2", "a") + grid +
                        "M1,4L3,4'/>" + letters("1,4", "b c") + "</g>"),
            "<g fill=\"none\">" + grid +
                "M1 2h2M1 4h2'/><g font-size=\"9\"><text x=\"1\" y=\"2\">a</text>"
                "<text x=\"1\" y=\"4\">b c</text></g></g>");
}

TEST(CompactSvg, KeepsTheOrderOfCurves) {
  const std::string curves =
      "<g fill=\"none\"><path stroke='red' d='M1 2h2'/><path stroke='blue' d='M1 2h2'/>"
      "<path stroke='red' d='M5 6h2'/></g>";
  EXPECT_EQ(compact_svg(curves), curves);
}

TEST(CompactSvg, KeepsTurnedLettersTurned) {
  EXPECT_EQ(compact_svg("<g transform=\"translate(1,2) rotate(270)\"><text>a</text></g>"),
            "<g><text transform=\"translate(1,2) rotate(270)\">a</text></g>");
}

TEST(CompactSvg, JoinsCirclesThatAreOnlyOutlined) {
  const std::string circles =
      "<circle cx=\"5\" cy=\"6\" r=\"2\"/>\n<circle cx=\"9.5\" cy=\"6\" r=\"2\"/>";
  EXPECT_EQ(compact_svg("<g fill=\"none\">" + circles + "</g>"),
            "<g fill=\"none\"><path d=\"M3 6a2 2 0 104 0 2 2 0 10-4 0"
            "m4.5 0a2 2 0 104 0 2 2 0 10-4 0\"/></g>");
  const std::string filled =
      "<g fill=\"red\"><circle cx=\"5\" cy=\"6\" r=\"2\"/><circle cx=\"9\" "
      "cy=\"6\" r=\"2\"/></g>";
  EXPECT_EQ(compact_svg(filled), filled);
  const std::string named =
      "<g fill=\"none\"><circle cx=\"5\" cy=\"6\" r=\"2\" id=\"a\"/>"
      "<circle cx=\"9\" cy=\"6\" r=\"2\" id=\"b\"/></g>";
  EXPECT_EQ(compact_svg(named), named);
}

TEST(CompactSvg, RoundsGnuplotsCornersOnly) {
  const std::string path = "<path d='M1.23,4.56L7.89,4.56'/>";
  EXPECT_EQ(compact_svg(path), path);
  EXPECT_EQ(compact_svg("<g id=\"gnuplot_canvas\">" + path + "</g>"),
            "<g id=\"gnuplot_canvas\"><path d='M1.2 4.6h6.7'/></g>");
}

TEST(CompactSvg, KeepsTheShapeOfMarksThatAreEnlarged) {
  const std::string start =
      "<g id=\"gnuplot_canvas\"><defs><path id='m' d='M0,1.330L1.265,0.411L0.782,-1.067z'/></defs>"
      "<use xlink:href='#m' transform='translate(1.23,4.56) scale(4.20)'/>";
  EXPECT_EQ(compact_svg(start + "<path d='M1.23,4.56L7.89,4.56'/></g>"),
            start + "<path d='M1.2 4.6h6.7'/></g>");
}

TEST(CompactSvgLaw, ChangesNothingMore) {
  const std::string svg =
      "<svg viewBox=\"0 0 9 9\"><g fill=\"none\" stroke=\"a\"><circle cx=\"1\" cy=\"2\" r=\"1\"/>"
      "<circle cx=\"3\" cy=\"2\" r=\"1\"/></g><g fill=\"none\" stroke=\"a\"><path d=\"M0 0L1 1L1 "
      "5\"/>"
      "</g><text> a </text></svg>";
  const std::string once = compact_svg(svg);
  EXPECT_LT(once.size(), svg.size());
  EXPECT_EQ(compact_svg(once), once);
}

}  // namespace
}  // namespace phytobench
