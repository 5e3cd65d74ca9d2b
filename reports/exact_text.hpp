// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/record/record.hpp"

namespace phytobench {

/// Shortest text that reads back as the same number.
std::string exact_text(double value);

/// The same of a recorded value; a text is left as it is.
std::string exact_text(const RecordValue& value);

}  // namespace phytobench
