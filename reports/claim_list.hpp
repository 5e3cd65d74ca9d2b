// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace phytobench {

/// A claim as the command line lists it: without the published value, which is for reports.
struct ListedClaim {
  std::string id;
  std::string kind;
  std::string locator;
  std::string text;
  std::string tier;
};

/// All claims of all papers.
std::vector<ListedClaim> listed_claims();

}  // namespace phytobench
