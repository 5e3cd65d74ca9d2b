// SPDX-License-Identifier: MIT
// For tests: whether a page can be used without seeing it.
#pragma once

#include "reports/browser/page_checks.hpp"

namespace phytobench {

/// In all of the page, also where it is folded: a table without a caption, a picture or drawing
/// without a name, a page without a language.
Problems name_problems(Page& page);

/// In the accessibility tree, which is what a screen reader gets: more or fewer than one heading of
/// the first level, skipped levels, nameless headings, tables, pictures, links and controls, and
/// the landmarks main, navigation and banner.
Problems accessibility_problems(Page& page);

}  // namespace phytobench
