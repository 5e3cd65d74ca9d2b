// SPDX-License-Identifier: MIT
#include "core/component_graph/link_kind.hpp"

namespace phytobench {

std::string_view name_of(LinkKind kind) {
  switch (kind) {
    case LinkKind::child:
      return "child";
    case LinkKind::branch:
      return "branch";
    case LinkKind::leaf:
      break;
  }
  return "leaf";
}

}  // namespace phytobench
