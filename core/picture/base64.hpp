// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace phytobench {

/// Bytes as text (RFC 4648), for pictures inside a page.
std::string to_base64(std::string_view bytes);

}  // namespace phytobench
