// SPDX-License-Identifier: MIT
// What phytobench_engine.h lets callers do, but no growth does.
#pragma once

#include <string>

#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// Calls two engines of that kind in turns, one of them with two threads and started twice, then
/// one without points; adds no nodes and removes with no killers now and then. Every answer is
/// compared with squared_scan's. Returns the first that differs, or what the engine of a plugin
/// did wrong; empty if there is nothing.
std::string wrong_in_unusual_calls(const EngineDescriptor& engine);

}  // namespace phytobench
