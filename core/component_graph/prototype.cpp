// SPDX-License-Identifier: MIT
#include "core/component_graph/prototype.hpp"

#include <algorithm>

#include "core/component_graph/parameter_expression.hpp"
#include "core/contract/parameter_keys.hpp"

namespace phytobench {

namespace {

ComponentSetting default_setting(const ComponentKey& key, std::size_t position,
                                 const std::string& component) {
  const std::string where = component + "." + std::string(key.name);
  const auto number = [&](const RangedNumber& kind) -> ComponentSetting {
    ParameterRange range = ParameterRange::of(kind.default_value);
    range.where = where;
    range.random_stream = position;
    return range;
  };
  return std::visit(
      Overloaded{
          number, [](const WordChoice& kind) -> ComponentSetting { return kind.default_word; },
          [](const ColourValue& kind) -> ComponentSetting {
            return parse_colour(kind.default_colour);
          },
          [&](const NumberList& kind) -> ComponentSetting {
            return GivenNumbers{{kind.default_numbers.begin(), kind.default_numbers.end()}, where};
          },
          [&](const FieldExpressions& kind) -> ComponentSetting {
            return std::make_shared<const VectorField>(
                parse_vector_field({kind.default_x, kind.default_y, kind.default_z}, where));
          }},
      key.kind);
}

}  // namespace

Prototype make_prototype(std::string name, const ComponentKind& kind) {
  Prototype prototype;
  for (std::size_t i = 0; i < kind.keys.size(); ++i)
    prototype.settings.push_back(default_setting(kind.keys[i], i, name));
  prototype.name = std::move(name);
  prototype.kind = &kind;
  return prototype;
}

bool multiplicity_varies(const Prototype& prototype) {
  if (!prototype.kind->is_multiplier && !prototype.kind->carries_branches) return false;
  for (std::size_t i = 0; i < prototype.settings.size(); ++i) {
    const auto* range = std::get_if<ParameterRange>(&prototype.settings[i]);
    const auto* key = std::get_if<RangedNumber>(&prototype.kind->keys[i].kind);
    if (range != nullptr && key->over == RangeOver::siblings && range->varies()) return true;
  }
  return false;
}

}  // namespace phytobench
