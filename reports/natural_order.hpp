// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace phytobench {

/// Order in which step-40 comes before step-100, 4.9 before 4.11 and numbers before letters.
bool is_naturally_before(std::string_view a, std::string_view b);

}  // namespace phytobench
