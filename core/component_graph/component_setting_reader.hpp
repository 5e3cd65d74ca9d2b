// SPDX-License-Identifier: MIT
// For component_graph_file.cpp only: sees the TOML library.
#pragma once

#include "core/component_graph/component_key.hpp"
#include "core/component_graph/component_values.hpp"
#include "core/contract/toml_values.hpp"

namespace phytobench {

/// What a file gives for a key of a component. `position` is that of the key in its kind. Throws
/// InputError with file, line and key.
///
/// A number may be written as 2.0; a range as [1.0, 2.0]; a function as "value * random(0.9, 1.1)",
/// whose value is the default; all together as { value = 2.0 or [1.0, 2.0], function = "..." }; and
/// key frames as { frames = [{ time = 0, value = 1.0 }, ...], function = "..." }.
ComponentSetting read_component_setting(const TomlValue& value, const ComponentKey& key,
                                        std::size_t position);

/// What may be written for a key: "a number >= 0, or a range over its children".
std::string allowed_setting(const ComponentKey& key);

}  // namespace phytobench
