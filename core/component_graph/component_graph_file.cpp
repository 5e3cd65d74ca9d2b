// SPDX-License-Identifier: MIT
#include "core/component_graph/component_graph_file.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include <fmt/format.h>

#include "core/component_graph/component_registry.hpp"
#include "core/component_graph/component_setting_reader.hpp"
#include "core/component_graph/recursions.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {

namespace {

// Every example has all keys but those of other kinds.
constexpr std::string_view some_example = "phytobench build --example simple";
constexpr std::array<std::string_view, 3> link_words{"child", "branch", "leaf"};
constexpr NumberRange seed_range{.low = 0.0, .high = 0x1p53, .whole = true};
constexpr NumberRange time_range{.low = -1e15, .high = 1e15};
constexpr NumberRange recursion_range{.low = 1.0, .high = most_recursions_allowed, .whole = true};

void refuse_unknown(const TomlValue& value, const std::vector<std::string>& known) {
  if (std::find(known.begin(), known.end(), value.name) == known.end())
    value.fail(unknown_key(value.name, known, some_example));
}

class GraphReader {
 public:
  GraphReader(std::filesystem::path file, const toml::table& root)
      : file_(std::move(file)), root_(root) {}

  ComponentGraph read() {
    for (const auto& [key, node] : root_)
      refuse_unknown({file_, key.str(), node}, {"graph", "component", "link"});
    read_components();
    read_graph();
    read_links();
    check_recursions();
    check_reached();
    return std::move(graph_);
  }

 private:
  [[noreturn]] void fail(const toml::node& node, const std::string& problem) const {
    fail_at(file_, node, problem);
  }

  const toml::table& table_named(std::string_view name, std::string_view example) const {
    const toml::node* node = root_.get(name);
    const toml::node& place = node != nullptr ? *node : static_cast<const toml::node&>(root_);
    if (node == nullptr || node->as_table() == nullptr)
      fail(place, fmt::format("there is no table [{}]; begin one, as in {}", name, example));
    return *node->as_table();
  }

  void read_components() {
    const toml::table& tables = table_named("component", "[component.stem] with kind = \"horn\"");
    if (tables.empty() || tables.size() > most_components)
      fail(tables,
           fmt::format("there are {} components; give 1 to {}", tables.size(), most_components));
    for (const auto& [name, node] : in_file_order(tables)) {
      check_name(name, *node);
      if (!node->is_table())
        fail(*node, fmt::format("component.{0} is no table; write [component.{0}]", name));
      read_component(name, *node->as_table());
    }
  }

  /// The library sorts them by name.
  static std::vector<std::pair<std::string, const toml::node*>> in_file_order(
      const toml::table& tables) {
    std::vector<std::pair<std::string, const toml::node*>> nodes;
    for (const auto& [key, node] : tables) nodes.emplace_back(key.str(), &node);
    std::stable_sort(nodes.begin(), nodes.end(), [](const auto& a, const auto& b) {
      return a.second->source().begin < b.second->source().begin;
    });
    return nodes;
  }

  void check_name(std::string_view name, const toml::node& node) const {
    constexpr std::size_t longest_name = 60;
    const bool allowed = !name.empty() && name.size() <= longest_name &&
                         std::all_of(name.begin(), name.end(), [](unsigned char c) {
                           return std::isalnum(c) != 0 || c == '_' || c == '-';
                         });
    if (!allowed)
      fail(node,
           fmt::format("'{}' is no name for a component; use 1 to {} letters, digits, - and _",
                       in_one_line(name), longest_name));
  }

  void read_component(std::string name, const toml::table& table) {
    const ComponentKind& kind = kind_of(name, table);
    Prototype prototype = make_prototype(name, kind);
    for (const auto& [key, node] : table) {
      if (key.str() == "kind") continue;
      const std::string full_name = fmt::format("{}.{}", name, key.str());
      const TomlValue value{file_, full_name, node};
      refuse_quoted_name(value, key.str());
      if (key.str() == "most_recursions") {
        prototype.most_recursions = static_cast<std::uint32_t>(read_number(value, recursion_range));
      } else {
        read_setting(prototype, value, key.str());
      }
    }
    graph_.prototypes.push_back(std::move(prototype));
    tables_.push_back(&table);
  }

  const ComponentKind& kind_of(const std::string& name, const toml::table& table) const {
    const toml::node* node = table.get("kind");
    if (node == nullptr)
      fail(table, fmt::format("component '{}' has no kind; give one of {}", name,
                              known_component_kind_names()));
    const std::string key = name + ".kind";
    try {
      return component_kind_named(in_one_line(read_text({file_, key, *node})));
    } catch (const InputError& error) {
      if (!node->is_string()) throw;
      fail(*node, fmt::format("{}: {}", key, error.what()));
    }
  }

  static void read_setting(Prototype& prototype, const TomlValue& value, std::string_view key) {
    const auto keys = prototype.kind->keys;
    std::vector<std::string> known{prototype.name + ".kind", prototype.name + ".most_recursions"};
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (keys[i].name == key) {
        prototype.settings[i] = read_component_setting(value, keys[i], i);
        return;
      }
      known.push_back(fmt::format("{}.{}", prototype.name, keys[i].name));
    }
    value.fail(unknown_key(value.name, known,
                           fmt::format("phytobench build --example {}", prototype.kind->name)));
  }

  void read_graph() {
    const toml::table& table = table_named("graph", "[graph] with root = \"stem\"");
    for (const auto& [key, node] : table)
      refuse_unknown({file_, key.str(), node}, {"root", "seed", "time"});
    graph_.root = component_of(table, "root", "graph");
    if (const toml::node* seed = table.get("seed"))
      graph_.seed =
          static_cast<std::uint64_t>(read_number({file_, "graph.seed", *seed}, seed_range));
    if (const toml::node* time = table.get("time"))
      graph_.time = read_number({file_, "graph.time", *time}, time_range);
  }

  /// The component that a key names.
  std::uint32_t component_of(const toml::table& table, std::string_view key,
                             std::string_view section) const {
    const toml::node* node = table.get(key);
    if (node == nullptr)
      fail(table, fmt::format("{} has no {}; give the name of a component", section, key));
    const std::string full_name = fmt::format("{}.{}", section, key);
    const std::string name = read_text({file_, full_name, *node});
    std::vector<std::string> known;
    for (const Prototype& prototype : graph_.prototypes) known.push_back(prototype.name);
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end())
      fail(*node,
           fmt::format("{}: there is no component '{}'{}; give the name of one, or begin "
                       "[component.NAME]",
                       full_name, in_one_line(name), did_you_mean(in_one_line(name), known)));
    return static_cast<std::uint32_t>(found - known.begin());
  }

  void read_links() {
    const toml::node* node = root_.get("link");
    if (node == nullptr) return;
    const toml::array* array = node->as_array();
    if (array == nullptr || array->size() > most_links)
      fail(*node, fmt::format("links are written as [[link]] with from and to, at most {} of them",
                              most_links));
    for (const toml::node& entry : *array) {
      const toml::table* table = entry.as_table();
      if (table == nullptr) fail(entry, "a link is no table; write [[link]] with from and to");
      read_link(*table);
    }
  }

  void read_link(const toml::table& table) {
    for (const auto& [key, node] : table)
      refuse_unknown({file_, key.str(), node}, {"from", "to", "kind"});
    ComponentLink link;
    link.from = component_of(table, "from", "link");
    link.to = component_of(table, "to", "link");
    if (const toml::node* kind = table.get("kind"))
      link.kind = static_cast<LinkKind>(read_choice({file_, "link.kind", *kind}, link_words));
    const Prototype& source = graph_.prototypes[link.from];
    if (link.kind == LinkKind::branch && !source.kind->carries_branches)
      fail(table, fmt::format("the branch link {} -> {} begins at a {}, which bears no branches; "
                              "use kind = \"child\", or begin it at a component that does ({})",
                              source.name, graph_.prototypes[link.to].name, source.kind->name,
                              kinds_with_branches()));
    graph_.links.push_back(link);
    link_tables_.push_back(&table);
  }

  static std::string kinds_with_branches() {
    std::string names;
    for (const ComponentKind* kind : all_component_kinds())
      if (kind->carries_branches) names += (names.empty() ? "" : ", ") + std::string(kind->name);
    return names;
  }

  void check_recursions() const {
    if (const auto problem = recursion_problem(graph_))
      fail(*link_tables_[problem->link], problem->text);
  }

  void check_reached() const {
    const std::vector<bool> reached = reached_prototypes(graph_)[graph_.root];
    for (std::size_t i = 0; i < reached.size(); ++i)
      if (!reached[i] && i != graph_.root)
        fail(*tables_[i],
             fmt::format("no links lead from the root '{}' to component '{}'; add a "
                         "[[link]] to it, or take it out",
                         graph_.prototypes[graph_.root].name, graph_.prototypes[i].name));
  }

  std::filesystem::path file_;
  const toml::table& root_;
  ComponentGraph graph_;
  std::vector<const toml::table*> tables_;  // of the prototypes, and of the links
  std::vector<const toml::table*> link_tables_;
};

}  // namespace

ComponentGraph read_component_graph(const std::filesystem::path& file) {
  const toml::table root = parse_toml(read_text_file(file), file.string());
  return GraphReader(file, root).read();
}

ComponentGraph parse_component_graph(std::string_view text, std::string_view name) {
  const toml::table root = parse_toml(text, name);
  return GraphReader(name, root).read();
}

}  // namespace phytobench
