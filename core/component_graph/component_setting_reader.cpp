// SPDX-License-Identifier: MIT
#include "core/component_graph/component_setting_reader.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/component_graph/parameter_expression.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

constexpr std::size_t most_frames = 1000;

/// What a function gets is not limited to what the parameter may be, as long as it is finite.
constexpr NumberRange any_number{.low = -largest_parameter, .high = largest_parameter};

NumberRange finite(NumberRange range) {
  range.low = std::max(range.low, -largest_parameter);
  range.high = std::min(range.high, largest_parameter);
  return range;
}

/// "file:12: ball.count".
std::string where(const TomlValue& value) {
  return fmt::format("{}:{}: {}", value.file.string(), value.node.source().begin.line, value.name);
}

std::string_view range_word(RangeOver over) {
  return over == RangeOver::siblings ? "siblings" : "children";
}

class NumberReader {
 public:
  NumberReader(const TomlValue& value, const RangedNumber& kind) : value_(value), kind_(kind) {}

  ParameterRange read() {
    range_.where = where(value_);
    const toml::node& node = value_.node;
    if (const toml::table* table = node.as_table()) {
      read_table(*table);
    } else if (node.is_string()) {
      read_function(value_);
      add_frame(0.0, {kind_.default_value, kind_.default_value});
    } else {
      add_frame(0.0, read_span(value_));
    }
    return std::move(range_);
  }

 private:
  void read_table(const toml::table& table) {
    for (const auto& [key, node] : table)
      refuse_unknown(key, node, {"value", "function", "frames"});
    if (const toml::node* function = table.get("function")) {
      has_function_ = true;
      read_function(inside(*function));
    }
    const toml::node* frames = table.get("frames");
    const toml::node* value = table.get("value");
    if (frames != nullptr && value != nullptr)
      value_.fail(set_the_same(value_name("frames"), value_name("value")));
    if (frames != nullptr) return read_frames(inside(*frames));
    if (value != nullptr) return add_frame(0.0, read_span(inside(*value)));
    if (!has_function_)
      value_.fail(fmt::format("{} is empty; give value, frames or function", value_.name));
    add_frame(0.0, {kind_.default_value, kind_.default_value});
  }

  void read_frames(const TomlValue& frames) {
    const toml::array* array = frames.node.as_array();
    if (array == nullptr || array->empty() || array->size() > most_frames)
      frames.fail(fmt::format("{} must be 1 to {} key frames, as in [{{ time = 0, value = 1.0 }}]",
                              frames.name, most_frames));
    for (const toml::node& node : *array) read_frame(inside(node));
  }

  void read_frame(const TomlValue& frame) {
    const toml::table* table = frame.node.as_table();
    if (table == nullptr || table->get("time") == nullptr || table->get("value") == nullptr)
      frame.fail(fmt::format("{} holds what is no key frame; write {{ time = 0, value = 1.0 }}",
                             frame.name));
    for (const auto& [key, node] : *table) refuse_unknown(key, node, {"time", "value"});
    const double time = read_number({frame.file, "time", *table->get("time")}, any_number);
    if (!range_.frames.empty() && !(time > range_.frames.back().time))
      frame.fail(fmt::format("{}: time = {} does not come after {}; order the key frames by time",
                             frame.name, time, range_.frames.back().time));
    add_frame(time, read_span({frame.file, value_.name, *table->get("value")}));
  }

  NumberSpan read_span(const TomlValue& value) const {
    const NumberRange range = limits();
    if (value.node.is_array()) {
      const auto [first, last] = read_pair(value, range);
      return {first, last};
    }
    if (!value.node.is_number())
      value.fail(
          fmt::format("{} must be a number {}, a range [first, last], a function in quotes, "
                      "or a table with value, frames or function",
                      value.name, allowed(range)));
    const double number = read_number(value, range);
    return {number, number};
  }

  /// With a function only its results are held against the range. Numbers between two whole ones
  /// are rounded in the end.
  NumberRange limits() const {
    if (range_.function) return any_number;
    return finite(kind_.range);
  }

  void read_function(const TomlValue& value) {
    range_.function = parse_parameter_function(read_text(value), where(value));
  }

  void add_frame(double time, NumberSpan span) { range_.frames.push_back({time, span}); }

  std::string value_name(std::string_view key) const {
    return fmt::format("{}.{}", value_.name, key);
  }

  TomlValue inside(const toml::node& node) const { return {value_.file, value_.name, node}; }

  void refuse_unknown(const toml::key& key, const toml::node& node,
                      const std::vector<std::string>& known) const {
    if (std::find(known.begin(), known.end(), key.str()) == known.end())
      inside(node).fail(unknown_key(value_name(key.str()), qualified(known),
                                    "phytobench build --example simple"));
  }

  std::vector<std::string> qualified(const std::vector<std::string>& keys) const {
    std::vector<std::string> names;
    for (const std::string& key : keys) names.push_back(value_name(key));
    return names;
  }

  const TomlValue& value_;
  const RangedNumber& kind_;
  ParameterRange range_;
  bool has_function_ = false;
};

GivenNumbers read_list(const TomlValue& value, const NumberList& kind) {
  const toml::array* array = value.node.as_array();
  if (array == nullptr || array->size() < kind.fewest || array->size() > kind.most)
    value.fail(
        fmt::format("{} must be {} to {} numbers in [...]", value.name, kind.fewest, kind.most));
  const NumberRange range = finite(kind.range);
  GivenNumbers given{{}, where(value)};
  for (const toml::node& node : *array)
    given.numbers.push_back(read_number({value.file, value.name, node}, range));
  return given;
}

Colour read_colour(const TomlValue& value) {
  try {
    return parse_colour(value.node.value_or(std::string_view()));
  } catch (const InputError& error) {
    value.fail(fmt::format("{}: {}", value.name, error.what()));
  }
}

std::shared_ptr<const VectorField> read_field(const TomlValue& value) {
  const toml::array* array = value.node.as_array();
  std::array<std::string, 3> texts;
  if (array == nullptr || array->size() != 3)
    value.fail(
        fmt::format("{} must be three functions of x, y, z and t, as in [\"0\", \"1\", "
                    "\"-0.1 * y\"]",
                    value.name));
  for (std::size_t i = 0; i < 3; ++i) {
    const toml::node& node = (*array)[i];
    const auto number = node.is_number() ? node.value<double>() : std::nullopt;
    texts[i] = number ? fmt::format("{}", *number) : read_text({value.file, value.name, node});
  }
  return std::make_shared<const VectorField>(
      parse_vector_field({texts[0], texts[1], texts[2]}, where(value)));
}

}  // namespace

ComponentSetting read_component_setting(const TomlValue& value, const ComponentKey& key,
                                        std::size_t position) {
  const auto number = [&](const RangedNumber& kind) -> ComponentSetting {
    ParameterRange range = NumberReader(value, kind).read();
    range.random_stream = position;
    return range;
  };
  return std::visit(
      Overloaded{number,
                 [&](const WordChoice& kind) -> ComponentSetting {
                   return read_choice(value, kind.words);
                 },
                 [&](const ColourValue&) -> ComponentSetting { return read_colour(value); },
                 [&](const NumberList& kind) -> ComponentSetting { return read_list(value, kind); },
                 [&](const FieldExpressions&) -> ComponentSetting { return read_field(value); }},
      key.kind);
}

std::string allowed_setting(const ComponentKey& key) {
  return std::visit(
      Overloaded{
          [](const RangedNumber& kind) {
            return fmt::format("a number {}; a range goes over its {}", allowed(kind.range),
                               range_word(kind.over));
          },
          [](const WordChoice& kind) {
            return fmt::format("\"{}\"", fmt::join(kind.words, "\" or \""));
          },
          [](const ColourValue&) { return std::string("\"#rrggbb\""); },
          [](const NumberList& kind) {
            return fmt::format("{} to {} numbers {}", kind.fewest, kind.most, allowed(kind.range));
          },
          [](const FieldExpressions&) { return std::string("three functions of x, y, z and t"); }},
      key.kind);
}

}  // namespace phytobench
