// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace phytobench {

/// What stands in place of `from` is not searched again.
inline void replace_all(std::string& text, std::string_view from, std::string_view to) {
  for (std::size_t i = text.find(from); i != std::string::npos; i = text.find(from, i + to.size()))
    text.replace(i, from.size(), to);
}

}  // namespace phytobench
