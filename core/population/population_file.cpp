// SPDX-License-Identifier: MIT
#include "core/population/population_file.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"
#include "core/contract/text_file.hpp"
#include "core/contract/toml_values.hpp"
#include "core/population/population_keys.hpp"

namespace phytobench {

namespace {

namespace fs = std::filesystem;

bool is_section(std::string_view name) {
  const auto keys = population_keys();
  return std::any_of(keys.begin(), keys.end(), [&](const PopulationKey& key) {
    return key.name.starts_with(std::string(name) + ".");
  });
}

std::vector<PlantId> read_ids(const TomlValue& value) {
  const toml::array* array = value.node.as_array();
  if (array == nullptr || array->empty())
    value.fail(fmt::format("{} must be ids of plants, as in [0, 7]", value.name));
  std::vector<PlantId> ids;
  for (const toml::node& node : *array)
    ids.push_back(static_cast<PlantId>(
        read_number({value.file, value.name, node}, {.high = 1e15, .whole = true})));
  return ids;
}

class PopulationFileReader {
 public:
  PopulationFileReader(const fs::path& file, const toml::table& root) : file_(file), root_(root) {}

  PopulationFile read() {
    read_table(root_, "", "");
    resolve_ground();
    refuse_idle_mortality();
    read_list("species", [this](const std::string& path) { add_species(path); });
    // The lists that follow name species, and make a table of all pairs.
    refuse_problems();
    read_list("influence", [this](const std::string& path) { add_influence(path); });
    read_list("event", [this](const std::string& path) { add_event(path); });
    // Maps last: they are large, and laid over a ground that is known to be one.
    refuse_problems();
    read_maps();
    return {std::move(values_.parameters), plants_file(), named_files()};
  }

 private:
  PopulationParameters& parameters() { return values_.parameters; }

  /// Points to the first of the keys that the file gives, or else to the entry that it belongs to.
  [[noreturn]] void fail(const std::vector<std::string>& paths, const std::string& problem) const {
    for (const std::string& path : paths)
      if (const toml::node* node = root_.at_path(path).node()) fail_at(file_, *node, problem);
    for (std::string path(paths.empty() ? "" : section_of(paths[0])); !path.empty();
         path = section_of(path))
      if (const toml::node* node = root_.at_path(path).node()) fail_at(file_, *node, problem);
    fail_at(file_, root_, problem);
  }

  bool is_given(const std::string& path) const { return given_.contains(path); }

  /// `name` is that of the table's keys in the table of keys, `path` leads to it in the file; both
  /// end with a '.' unless they are empty.
  void read_table(const toml::table& table, const std::string& name, const std::string& path) {
    for (const auto& [key, node] : table) {
      const std::string own = name + std::string(key.str());
      const TomlValue value{file_, own, node};
      refuse_quoted_name(value, key.str());
      if (is_list_of_population(own)) continue;  // read_list() does
      const std::string own_path = path + std::string(key.str());
      given_.insert(own_path);
      if (!is_section(own)) {
        read_value(value);
      } else if (const toml::table* section = node.as_table()) {
        read_table(*section, own + ".", own_path + ".");
      } else {
        value.fail(
            fmt::format("{} is a section; write it as [{}], once, with its keys below", own, own));
      }
    }
  }

  void read_value(const TomlValue& value) {
    const auto keys = population_keys();
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const PopulationKey& candidate) {
      return candidate.name == value.name;
    });
    if (key == keys.end()) refuse_unknown(value);
    PopulationFileValues& v = values_;
    std::visit(
        Overloaded{
            [&](const PopulationNumber& kind) { kind.assign(v, read_number(value, kind.range)); },
            [&](const PopulationPair& kind) {
              const auto [x, y] = read_pair(value, kind.range);
              kind.assign(v, {x, y});
            },
            [&](const PopulationChoice& kind) { kind.choose(v, read_choice(value, kind.words)); },
            [&](const PopulationSwitch& kind) { kind.place(v) = read_switch(value); },
            [&](const PopulationText& kind) { kind.place(v) = read_text(value); },
            [&](const PopulationFileName& kind) { kind.place(v) = read_file_name(value); },
            [&](const PopulationIds& kind) { kind.place(v) = read_ids(value); }},
        key->kind);
  }

  [[noreturn]] static void refuse_unknown(const TomlValue& value) {
    std::vector<std::string> known;
    for (const PopulationKey& key : population_keys()) known.emplace_back(key.name);
    value.fail(unknown_key(value.name, known, "phytobench compete --example"));
  }

  /// Calls add with the path of every entry when its values are read.
  template <class Add>
  void read_list(const std::string& list, const Add& add) {
    const toml::node* node = root_.get(list);
    if (node == nullptr) return;
    const toml::array* entries = node->as_array();
    if (entries == nullptr || !entries->is_array_of_tables())
      fail_at(file_, *node,
              fmt::format("{} is a list; write [[{}]] above the keys of each entry", list, list));
    for (std::size_t i = 0; i < entries->size(); ++i) {
      const std::string path = fmt::format("{}[{}]", list, i);
      values_.species = {};
      values_.influence = {};
      values_.event = {};
      values_.event_species.clear();
      read_table(*(*entries)[i].as_table(), list + ".", path + ".");
      refuse_missing(list, path);
      add(path);
    }
  }

  void refuse_missing(const std::string& list, const std::string& path) const {
    for (const PopulationKey& key : population_keys()) {
      if (!key.is_required || section_of(key.name) != list) continue;
      const std::string_view own = short_name_of(key.name);
      if (!is_given(fmt::format("{}.{}", path, own)))
        fail({path},
             fmt::format("{} is missing in [[{}]]; give {}", key.name, list, allowed_values(key)));
    }
  }

  void resolve_ground() {
    const Point2 corner = values_.ground_corner;
    parameters().ground = {corner, corner + values_.ground_size};
  }

  void refuse_idle_mortality() const {
    if (is_given("mortality") && !root_.at_path("mortality").as_table()->empty() &&
        !is_given("mortality.rule"))
      fail({"mortality"},
           "[mortality] without mortality.rule lets every plant live; give one, or leave it out");
  }

  void add_species(const std::string& path) {
    Species& species = values_.species;
    resolve_zone(path, "root_factor", values_.root_factor, species.roots);
    resolve_zone(path, "crown_factor", values_.crown_factor, species.crown);
    parameters().species.push_back(species);
    parameters().competition.species.resize(parameters().species.size());
    parameters().competition.species.back() = species.traits;
  }

  /// One factor for all places, or two for the poorest and the richest.
  void resolve_zone(const std::string& path, const std::string& key, double factor, ZoneLaw& zone) {
    const std::string one = fmt::format("{}.{}", path, key), poor = one + "_poor",
                      rich = one + "_rich";
    const auto name = [](const std::string& full) {
      return "species." + full.substr(full.rfind('.') + 1);
    };
    if (is_given(poor) != is_given(rich)) {
      const auto& [given, missing] = is_given(poor) ? std::pair(poor, rich) : std::pair(rich, poor);
      fail({given}, fmt::format("{} is given without {}; give both, or {} alone", name(given),
                                name(missing), name(one)));
    }
    if (is_given(one) && is_given(poor)) fail({one}, set_the_same(name(one), name(poor)));
    if (is_given(one)) zone.poor_factor = zone.rich_factor = factor;
  }

  /// Indices of the species that a name, or "*", stands for.
  std::vector<std::size_t> species_named(const std::string& path, std::string_view key,
                                         const std::string& name) const {
    std::vector<std::string> known;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < values_.parameters.species.size(); ++i) {
      known.push_back(values_.parameters.species[i].name);
      if (name == "*" || name == known.back()) found.push_back(i);
    }
    if (found.empty())
      fail({path}, fmt::format("{} = \"{}\" is no species of this file{}", key, in_one_line(name),
                               did_you_mean(name, known)));
    return found;
  }

  void add_influence(const std::string& path) {
    const InfluenceEntry& entry = values_.influence;
    const bool has_above = is_given(path + ".above"), has_below = is_given(path + ".below");
    if (!has_above && !has_below)
      fail({path}, "[[influence]] says nothing; give influence.above, influence.below or both");
    const std::size_t count = parameters().species.size();
    CompetitionParameters& competition = parameters().competition;
    for (auto* table : {&competition.influence_above, &competition.influence_below})
      if (table->empty()) table->assign(count * count, Influence::harms);
    const auto acting = species_named(path + ".of", "influence.of", entry.of);
    const auto suffering = species_named(path + ".on", "influence.on", entry.on);
    for (const std::size_t i : suffering)
      for (const std::size_t j : acting) {
        if (has_above) competition.influence_above[i * count + j] = entry.above;
        if (has_below) competition.influence_below[i * count + j] = entry.below;
      }
  }

  void add_event(const std::string& path) {
    PopulationEvent& event = values_.event;
    if (is_given(path + ".species") && !values_.event_species.empty()) {
      if (values_.event_species == "*")
        fail({path + ".species"}, "event.species = \"*\" is said by leaving it out");
      const auto found = species_named(path + ".species", "event.species", values_.event_species);
      event.species = static_cast<SpeciesIndex>(found.front());
    }
    if (event.step >= parameters().steps)
      fail({path + ".step"},
           fmt::format("event.step = {} is not below steps = {}; the event would never happen",
                       event.step, parameters().steps));
    parameters().events.push_back(event);
  }

  void refuse_problems() const {
    if (const auto problem = find_problem(values_.parameters)) fail(problem->keys, problem->text);
  }

  void read_maps() {
    read_map("resources.nutrients", values_.nutrients, &Species::roots, "root_factor",
             parameters().nutrients);
    read_map("resources.light", values_.light, &Species::crown, "crown_factor", parameters().light);
  }

  void read_map(const std::string& key, const std::string& file, ZoneLaw Species::*zone,
                const std::string& factor, ResourceMap& map) {
    if (file.empty()) return;
    const auto& all = parameters().species;
    if (std::all_of(all.begin(), all.end(), [&](const Species& species) {
          return (species.*zone).poor_factor == (species.*zone).rich_factor;
        }))
      fail({key}, fmt::format("{} changes nothing: give a species {}_poor and {}_rich that differ",
                              key, factor, factor));
    try {
      map = read_resource_map(file, parameters().ground);
    } catch (const InputError& error) {
      fail({key}, fmt::format("{}: {}", key, error.what()));
    }
  }

  fs::path plants_file() const {
    std::error_code error;
    if (!values_.plants.empty() && !fs::exists(values_.plants, error))
      fail({"plants"}, fmt::format("plants: {}: no such file", values_.plants));
    return values_.plants;
  }

  std::vector<NamedFile> named_files() const {
    std::vector<NamedFile> files;
    for (const auto& [key, place] : {std::pair("plants", &values_.plants),
                                     std::pair("resources.nutrients", &values_.nutrients),
                                     std::pair("resources.light", &values_.light)}) {
      if (place->empty()) continue;
      const NamedFile file{root_.at_path(key).value_or(std::string()), *place};
      if (std::find(files.begin(), files.end(), file) == files.end()) files.push_back(file);
    }
    return files;
  }

  const fs::path& file_;
  const toml::table& root_;
  std::set<std::string> given_;  ///< paths of keys and sections
  PopulationFileValues values_;
};

}  // namespace

PopulationFile read_population_file(const fs::path& file) {
  return parse_population(read_text_file(file), file);
}

PopulationFile parse_population(std::string_view text, const fs::path& name) {
  const toml::table root = parse_toml(text, name.string());
  return PopulationFileReader(name, root).read();
}

}  // namespace phytobench
