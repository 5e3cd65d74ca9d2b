// SPDX-License-Identifier: MIT
#include "core/nearest_node/plugin/plugin_pulse.hpp"

#include <fmt/format.h>

namespace phytobench {

std::string described(PluginCall call, std::int32_t number) {
  switch (call) {
    case PluginCall::none:
      return "no call";
    case PluginCall::load:
      return "loading";
    case PluginCall::create:
      return "create()";
    case PluginCall::associate:
      return fmt::format("associate() in iteration {}", number);
    case PluginCall::remove:
      return fmt::format("remove() in removal {}", number);
    case PluginCall::removed:
      return fmt::format("removed() in removal {}", number);
    case PluginCall::destroy:
      return "destroy()";
    case PluginCall::last_error:
      return "last_error()";
  }
  return "an unknown call";
}

}  // namespace phytobench
