// SPDX-License-Identifier: MIT
// What a paper leaves open, and the reading or parameter this suite chose
// (reference/papers/<key>/assumptions.toml).
#pragma once

#include <string>
#include <vector>

namespace phytobench {

struct Assumption {
  std::string id;            ///< "A2", as claims and code refer to it
  std::string locator;       ///< "sec. 3.4.4"
  std::string question;      ///< what the text does not say
  std::string reading;       ///< what we take
  std::string alternatives;  ///< other readings and what they would give, with numbers where known
  std::vector<std::string> claims;  ///< full ids of claims that rest on it
};

/// In the order of the file; none if the paper has no such file. Throws InputError with file and
/// line for a missing or unknown key, a duplicate id, or no claim.
std::vector<Assumption> load_assumptions(const std::string& paper);

}  // namespace phytobench
