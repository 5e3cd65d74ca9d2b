// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace phytobench {

/// An erratum as the command line lists it.
struct ListedErratum {
  std::string paper;
  std::string id;  ///< "E16"
  std::string locator;
  std::string printed;
  std::string corrected;  ///< or what the program does
  std::string consequence;
  bool is_of_program = false;  ///< the text is right, and the program differs
};

/// All errata of all papers.
std::vector<ListedErratum> listed_errata();

}  // namespace phytobench
