// SPDX-License-Identifier: MIT
// Texts of files that tests damage.
#pragma once

#include <string>

#include <gtest/gtest.h>

namespace phytobench {

/// The text with the first `place` of it replaced; a test without that place fails.
inline std::string replaced(std::string text, const std::string& place, const std::string& by) {
  const std::size_t found = text.find(place);
  EXPECT_NE(found, std::string::npos) << place;
  if (found != std::string::npos) text.replace(found, place.size(), by);
  return text;
}

}  // namespace phytobench
