// SPDX-License-Identifier: MIT
// The checks themselves: each passes a sound page and finds what was broken in it.
#include "reports/browser/page_checks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/text_file.hpp"
#include "reports/browser/accessibility_checks.hpp"
#include "reports/browser/browser_fixture.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Parts {
  std::string body;
  std::string banner = "<header><h1>Title</h1></header>";
  std::string language = " lang='en'";
};

class BrowserChecksSlow : public BrowserSlow {
 protected:
  /// Opens a page that nothing is wrong with but what `parts` says.
  Page& page_with(const Parts& parts) {
    const std::filesystem::path file = folder_ / "page.html";
    write_file_atomically(file, "<!doctype html><html" + parts.language +
                                    "><meta name='viewport' content='width=device-width'>"
                                    "<title>Page</title><body>" +
                                    parts.banner + "<nav aria-label='Contents'></nav><main>" +
                                    parts.body + "</main>");
    if (!page_) page_ = std::make_unique<Page>(*browser_);
    page_->open(file);
    return *page_;
  }

  std::unique_ptr<Page> page_;
};

TEST_F(BrowserChecksSlow, ASoundPageHasNoProblems) {
  Page& page = page_with(
      {"<h2 id='a'>A</h2><p><a href='#a'>A</a> <a href='page.html'>file</a></p>"
       "<table><caption>T</caption><tr><td>1</td></tr></table><img alt='P' src='data:image/gif;"
       "base64,R0lGODlhAQABAIAAAAAAAP///yH5BAEAAAAALAAAAAABAAEAAAIBRAA7'>"
       "<div style='overflow-x: auto'><div style='width: 3000px'>wide</div></div>"
       "<svg><title>S</title></svg><label>Word <input style='height: 2rem'></label>"});
  EXPECT_THAT(loading_problems(page), IsEmpty());
  EXPECT_THAT(link_problems(page, folder_), IsEmpty());
  EXPECT_THAT(width_problems(page), IsEmpty());
  EXPECT_THAT(target_problems(page, "body"), IsEmpty());
  EXPECT_THAT(contrast_problems(page), IsEmpty());
  EXPECT_THAT(name_problems(page), IsEmpty());
  EXPECT_THAT(accessibility_problems(page), IsEmpty());
}

TEST_F(BrowserChecksSlow, FindsErrorsWarningsAndExceptions) {
  EXPECT_THAT(loading_problems(page_with({"<script>console.error('a', 1)</script>"})),
              ElementsAre("console: \"a\" 1"));
  EXPECT_THAT(loading_problems(page_with({"<script>console.warn('b')</script>"})),
              ElementsAre("console: \"b\""));
  EXPECT_THAT(loading_problems(page_with({"<script>throw new Error('c')</script>"})),
              ElementsAre(HasSubstr("Error: c")));
  EXPECT_THAT(loading_problems(page_with({"<script>console.log('fine')</script>"})), IsEmpty());
}

TEST_F(BrowserChecksSlow, FindsRequests) {
  EXPECT_THAT(loading_problems(page_with({"<img src='https://example.org/a.png' alt='a'>"})),
              testing::Contains("asks for https://example.org/a.png"));
  EXPECT_THAT(loading_problems(page_with({"<link rel='stylesheet' href='beside.css'>"})),
              testing::Contains(HasSubstr("/beside.css")));
  Page& late = page_with({"<button onclick='fetch(\"https://example.org\").catch(() => 0)'>x"});
  EXPECT_THAT(loading_problems(late), IsEmpty());
  late.click("document.querySelector('button')");
  late.evaluate("new Promise(done => setTimeout(done, 50))");
  EXPECT_THAT(loading_problems(late), testing::Contains("asks for https://example.org/"));
}

TEST_F(BrowserChecksSlow, FindsDeadLinksAndIdsThatOccurTwice) {
  EXPECT_THAT(link_problems(page_with({"<a href='#gone'>x</a>"}), folder_),
              ElementsAre(HasSubstr("href=\"#gone\"")));
  EXPECT_THAT(link_problems(page_with({"<label for='gone'>x</label>"}), folder_),
              ElementsAre(HasSubstr("for=\"gone\"")));
  EXPECT_THAT(link_problems(page_with({"<p id='a'><p id='a'>"}), folder_),
              ElementsAre("two elements have the id a"));
  EXPECT_THAT(link_problems(page_with({"<a href='figures/gone.svg'>x</a>"}), folder_),
              ElementsAre("no file figures/gone.svg"));
}

TEST_F(BrowserChecksSlow, FindsWhatIsTooWideOrTooSmall) {
  EXPECT_THAT(width_problems(page_with({"<pre style='width: 3000px'>x</pre>"})),
              ElementsAre(HasSubstr("pixels wide, its window 1280"), HasSubstr("<pre")));
  EXPECT_THAT(target_problems(page_with({"<button style='height: 20px'>word</button>"}), "main"),
              ElementsAre(HasSubstr("x 20 pixels: <button")));
  EXPECT_THAT(target_problems(page_with({"<button hidden>word</button>"}), "main"), IsEmpty());
}

TEST_F(BrowserChecksSlow, FindsFaintText) {
  const auto contrast = [&](const std::string& style) {
    return contrast_problems(page_with({"<p style='" + style + "'>text</p>"}));
  };
  EXPECT_THAT(contrast("color: #777"), ElementsAre(HasSubstr("4.48")));
  EXPECT_THAT(contrast("color: #767676"), IsEmpty());
  EXPECT_THAT(contrast("color: #767676; opacity: 0.9"), testing::SizeIs(1));
  EXPECT_THAT(contrast("color: #000; background: #666"), ElementsAre(HasSubstr("3.66")));
  EXPECT_THAT(contrast("color: #000; background: #666; font-size: 24px"), IsEmpty());
  EXPECT_THAT(contrast_problems(page_with({"<style>::placeholder { color: #aaa }</style>"
                                           "<input placeholder='word' aria-label='A'>"})),
              ElementsAre(HasSubstr("<input placeholder")));
  Page& dark = page_with({"<style>:root { color-scheme: dark }</style><p>light on dark</p>"});
  EXPECT_THAT(contrast_problems(dark), IsEmpty());
  EXPECT_LT(ground_luminance(dark), 0.05);
  EXPECT_EQ(ground_luminance(page_with({"<p>x</p>"})), 1.0);
}

TEST_F(BrowserChecksSlow, FindsWhatHasNoName) {
  for (const char* nameless :
       {"<table><tr><td>1</td></tr></table>", "<svg><text>x</text></svg>", "<img src='data:,'>",
        "<details><table><caption> </caption></table></details>"})
    EXPECT_THAT(name_problems(page_with({nameless})), testing::SizeIs(1)) << nameless;
  EXPECT_THAT(name_problems(page_with({.body = "<p>x</p>", .language = ""})),
              ElementsAre("the page says no language"));
}

TEST_F(BrowserChecksSlow, FindsWhatAScreenReaderDoesNotGet) {
  const auto problems = [&](const Parts& parts) {
    return accessibility_problems(page_with(parts));
  };
  EXPECT_THAT(problems({"<h3>x</h3>"}), ElementsAre("heading of level 3 after one of level 1: x"));
  EXPECT_THAT(problems({"<h1>x</h1>"}), ElementsAre("2 headings of level 1, not one"));
  EXPECT_THAT(problems({.body = "<p>x</p>", .banner = "<h1>x</h1>"}),
              ElementsAre("0 landmarks banner, not one"));
  EXPECT_THAT(problems({"<input>"}), ElementsAre("nameless: textbox"));
  EXPECT_THAT(problems({"<button></button>"}), ElementsAre("nameless: button"));
  EXPECT_THAT(problems({"<a href='#x'></a>"}), ElementsAre("nameless: link"));
  EXPECT_THAT(problems({"<table><tr><th>1</th></tr><tr><td>2</td></tr></table>"}),
              ElementsAre("nameless: table"));
}

TEST_F(BrowserChecksSlow, SaysWhatItCannotDo) {
  Page& page = page_with({"<p>x</p><div style='position: fixed; inset: 0'></div>"});
  EXPECT_THROW(page.click("document.querySelector('p')"), std::runtime_error);
  EXPECT_THROW(page.click("document.querySelector('b')"), std::runtime_error);
  EXPECT_THROW(page.evaluate("nonsense()"), std::runtime_error);
  EXPECT_THROW(page.call("No.method"), std::runtime_error);
  EXPECT_THROW(page.open(folder_ / "gone.html"), std::runtime_error);
  EXPECT_THROW(BrowserProcess("/no/such/program"), std::runtime_error);
}

}  // namespace
}  // namespace phytobench
