// SPDX-License-Identifier: MIT
// For tests: what can be wrong with a page that is open. Each check returns one line for each
// problem; none means that all is well.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/browser/page.hpp"

namespace phytobench {

using Problems = std::vector<std::string>;

/// Errors and warnings, and requests for anything but the file itself.
Problems loading_problems(Page& page);

/// Ids that occur twice; references to an id that does not exist, be they links or names of labels;
/// links to files that do not lie in `folder`.
Problems link_problems(Page& page, const std::filesystem::path& folder);

/// What makes the page wider than its window. Boxes that scroll on their own do not.
Problems width_problems(Page& page);

/// Visible controls in `container` that are less than 24 pixels wide or high: [WCAG] 2.2, 2.5.8.
Problems target_problems(Page& page, const std::string& container);

/// Texts whose contrast with their ground is below 4.5, or 3 for large letters: [WCAG] 2.2, 1.4.3.
/// Letters inside drawings are left out: what lies beneath them cannot be asked for.
Problems contrast_problems(Page& page);

/// How light the ground of the page is: 0 black, 1 white.
double ground_luminance(Page& page);

}  // namespace phytobench
