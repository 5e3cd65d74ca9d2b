// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/validation.hpp"

namespace phytobench {

/// What the report says of its own statistics and models, as ready texts; only for a validation
/// with any(). Left out on request: what rests on times.
nlohmann::ordered_json validation_document(const Validation& validation, bool without_varying);

}  // namespace phytobench
