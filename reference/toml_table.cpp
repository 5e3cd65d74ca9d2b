// SPDX-License-Identifier: MIT
#include "reference/toml_table.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "core/contract/errors.hpp"
#include "core/contract/parameter_keys.hpp"
#include "core/contract/suggestion.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {

struct TomlTable::Node {
  std::string file;
  std::shared_ptr<const toml::table> root;  // keeps `table` alive
  const toml::table* table;

  const toml::node& at(const std::string& key) const {
    const toml::node* node = table->get(key);
    if (node == nullptr) fail(*table, fmt::format("'{}' is missing", key));
    return *node;
  }

  [[noreturn]] void fail(const toml::node& where, const std::string& problem) const {
    throw InputError(fmt::format("{}:{}: {}", file, where.source().begin.line, problem));
  }

  template <class Value>
  Value value(const toml::node& node, const std::string& key, const char* wanted) const {
    const auto value = node.value<Value>();
    if (!value) fail(node, fmt::format("'{}' must be {}", key, wanted));
    return *value;
  }

  const toml::array& list(const toml::node& node, const std::string& key) const {
    if (node.as_array() == nullptr) fail(node, fmt::format("'{}' must be a list", key));
    return *node.as_array();
  }

  template <class Value>
  std::vector<Value> values(const toml::node& node, const std::string& key,
                            const char* wanted) const {
    std::vector<Value> result;
    for (const toml::node& element : list(node, key))
      result.push_back(value<Value>(element, key, wanted));
    return result;
  }

  template <class Value>
  std::vector<std::vector<Value>> value_lists(const std::string& key, const char* wanted) const {
    std::vector<std::vector<Value>> result;
    for (const toml::node& element : list(at(key), key))
      result.push_back(values<Value>(element, key, wanted));
    return result;
  }
};

TomlTable TomlTable::read(const std::filesystem::path& file) {
  try {
    auto root =
        std::make_shared<const toml::table>(toml::parse(read_text_file(file), file.string()));
    const toml::table* table = root.get();
    return TomlTable(std::make_shared<const Node>(Node{file.string(), std::move(root), table}));
  } catch (const toml::parse_error& error) {
    const auto& where = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: not valid TOML: {}", file.string(), where.line,
                                 where.column, in_one_line(error.description(), 300)));
  }
}

std::string TomlTable::text(const std::string& key) const {
  return node_->value<std::string>(node_->at(key), key, "text");
}

std::string TomlTable::text_or(const std::string& key, const std::string& fallback) const {
  return has(key) ? text(key) : fallback;
}

double TomlTable::number(const std::string& key) const {
  return node_->value<double>(node_->at(key), key, "a number");
}

std::optional<double> TomlTable::number_if_given(const std::string& key) const {
  if (!has(key)) return std::nullopt;
  return number(key);
}

std::vector<std::string> TomlTable::texts(const std::string& key) const {
  return node_->values<std::string>(node_->at(key), key, "a list of texts");
}

std::vector<double> TomlTable::numbers(const std::string& key) const {
  return node_->values<double>(node_->at(key), key, "a list of numbers");
}

std::vector<std::vector<std::string>> TomlTable::text_lists(const std::string& key) const {
  return node_->value_lists<std::string>(key, "lists of texts");
}

std::vector<std::vector<double>> TomlTable::number_lists(const std::string& key) const {
  return node_->value_lists<double>(key, "lists of numbers");
}

TomlTable TomlTable::table(const std::string& key) const {
  const toml::node& node = node_->at(key);
  if (node.as_table() == nullptr) node_->fail(node, fmt::format("'{}' must be a table", key));
  return TomlTable(std::make_shared<const Node>(Node{node_->file, node_->root, node.as_table()}));
}

std::vector<TomlTable> TomlTable::tables(const std::string& key) const {
  std::vector<TomlTable> result;
  if (!has(key)) return result;
  const toml::node& node = node_->at(key);
  const toml::array* array = node.as_array();
  if (array == nullptr) node_->fail(node, fmt::format("'{}' must be a list of tables", key));
  for (const toml::node& element : *array) {
    if (element.as_table() == nullptr)
      node_->fail(element, fmt::format("'{}' must hold tables", key));
    result.push_back(TomlTable(
        std::make_shared<const Node>(Node{node_->file, node_->root, element.as_table()})));
  }
  return result;
}

bool TomlTable::has(const std::string& key) const {
  return node_->table->contains(key);
}

std::vector<std::string> TomlTable::keys() const {
  std::vector<std::pair<toml::source_position, std::string>> found;
  for (const auto& [key, node] : *node_->table)
    found.push_back({node.source().begin, std::string(key.str())});
  std::sort(found.begin(), found.end(),
            [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> names;
  for (auto& [position, name] : found) names.push_back(std::move(name));
  return names;
}

void TomlTable::fail(const std::string& problem) const {
  node_->fail(*node_->table, problem);
}

void TomlTable::allow_only(const std::vector<std::string>& known) const {
  for (const auto& [key, node] : *node_->table) {
    const std::string name(key.str());
    if (std::find(known.begin(), known.end(), name) == known.end())
      node_->fail(node, fmt::format("unknown key '{}'{}", name, did_you_mean(name, known)));
  }
}

}  // namespace phytobench
