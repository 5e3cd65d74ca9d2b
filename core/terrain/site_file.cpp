// SPDX-License-Identifier: MIT
#include "core/terrain/site_file.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/contract/toml_values.hpp"
#include "core/terrain/site_checks.hpp"
#include "core/terrain/site_keys.hpp"

namespace phytobench {

namespace {

namespace fs = std::filesystem;

bool is_site_section(std::string_view name) {
  const auto keys = site_keys();
  return std::any_of(keys.begin(), keys.end(), [&](const SiteKey& key) {
    return key.name.starts_with(std::string(name) + ".");
  });
}

std::vector<std::string> read_names(const TomlValue& value, std::string_view allowed) {
  const toml::array* array = value.node.as_array();
  if (array == nullptr)
    value.fail(fmt::format("{} must be {}, as in [\"a\", \"b\"]", value.name, allowed));
  std::vector<std::string> names;
  for (const toml::node& node : *array) names.push_back(read_text({value.file, value.name, node}));
  return names;
}

void read_date(const TomlValue& value, SolarDay& day) {
  const auto date = value.node.value<toml::date>();
  if (!date) value.fail(fmt::format("{} must be a date, as in 2019-06-21", value.name));
  day.year = static_cast<int>(date->year);
  day.month = static_cast<int>(date->month);
  day.day = static_cast<int>(date->day);
}

/// One file, of a site or of entries alone.
class SiteFileReader {
 public:
  SiteFileReader(const fs::path& file, const toml::table& root, SiteFileValues& values)
      : file_(file), root_(root), values_(values) {}

  /// Everything but lists.
  void read_site() {
    values_.site.file = file_;
    read_table(root_, "");
    refuse_two_kinds_of_heights(values_.site);
    refuse_keys_of_others();
  }

  void refuse_all_but_lists() const {
    for (const auto& [key, node] : root_)
      if (!is_list_of_site(key.str()))
        fail_at(file_, node,
                fmt::format("'{}' stands in a file of entries, which holds [[biome]], [[soil]] and "
                            "[[species]]; move it to the site's own file",
                            in_one_line(key.str())));
  }

  /// After what is there already.
  void read_lists() {
    SiteDescription& site = values_.site;
    read_list("biome", values_.biome, site.biomes);
    read_list("soil", values_.soil, site.soils);
    read_list("species", values_.species, site.species);
  }

 private:
  void read_table(const toml::table& table, const std::string& path) {
    for (const auto& [key, node] : table) {
      const std::string own = path + std::string(key.str());
      const TomlValue value{file_, own, node};
      refuse_quoted_name(value, key.str());
      if (is_list_of_site(own)) continue;  // read_list() does
      values_.site.lines[own] = node.source().begin.line;
      if (!is_site_section(own)) {
        read_value(value);
      } else if (const toml::table* section = node.as_table()) {
        read_table(*section, own + ".");
      } else {
        value.fail(
            fmt::format("{} is a section; write it as [{}], once, with its keys below", own, own));
      }
    }
  }

  void read_value(const TomlValue& value) {
    const auto keys = site_keys();
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const SiteKey& candidate) {
      return candidate.name == value.name;
    });
    if (key == keys.end()) refuse_unknown(value);
    SiteFileValues& v = values_;
    std::visit(
        Overloaded{[&](const SiteNumber& kind) { kind.assign(v, read_number(value, kind.range)); },
                   [&](const SiteChoice& kind) { kind.choose(v, read_choice(value, kind.words)); },
                   [&](const SiteSwitch& kind) { kind.assign(v, read_switch(value)); },
                   [&](const SiteText& kind) { kind.place(v) = read_text(value); },
                   [&](const SiteFileName& kind) { kind.place(v) = read_file_name(value); },
                   [&](const SiteNames& kind) { kind.place(v) = read_names(value, kind.allowed); },
                   [&](const SiteDate&) { read_date(value, v.site.sun.day); }},
        key->kind);
  }

  [[noreturn]] static void refuse_unknown(const TomlValue& value) {
    std::vector<std::string> known;
    for (const SiteKey& key : site_keys()) known.emplace_back(key.name);
    value.fail(unknown_key(value.name, known, "phytobench terrain --example"));
  }

  void refuse_keys_of_others() const {
    const SiteDescription& site = values_.site;
    for (const SiteKey& key : site_keys())
      if (key.condition.holds != nullptr && site.lines.contains(key.name) &&
          !key.condition.holds(site))
        throw InputError(fmt::format("{}: {} is for {}; leave it out", site.place_of(key.name),
                                     key.name, key.condition.text));
  }

  template <class Entry>
  void read_list(const std::string& list, Entry& read, std::vector<SiteEntry<Entry>>& entries) {
    const toml::node* node = root_.get(list);
    if (node == nullptr) return;
    const toml::array* array = node->as_array();
    if (array == nullptr || !array->is_array_of_tables())
      fail_at(file_, *node,
              fmt::format("{} is a list; write [[{}]] above the keys of each entry", list, list));
    const std::size_t first = entries.size();
    for (const toml::node& element : *array) {
      const toml::table& table = *element.as_table();
      read = {};
      values_.source.clear();
      read_entry(list, table);
      refuse_name(list, table, read.name);
      for (std::size_t i = first; i < entries.size(); ++i)
        if (entries[i].entry.name == read.name)
          fail_at(file_, table,
                  fmt::format("there is a {} '{}' already, at {}; rename one", list, read.name,
                              entries[i].place));
      entries.push_back(
          {read, values_.source, fmt::format("{}:{}", file_.string(), table.source().begin.line)});
    }
  }

  void read_entry(const std::string& list, const toml::table& table) {
    for (const auto& [key, node] : table) {
      const std::string own = fmt::format("{}.{}", list, key.str());
      const TomlValue value{file_, own, node};
      refuse_quoted_name(value, key.str());
      read_value(value);
    }
    for (const SiteKey& key : site_keys())
      if (key.is_required && section_of(key.name) == list &&
          !table.contains(short_name_of(key.name)))
        fail_at(
            file_, table,
            fmt::format("{} is missing in [[{}]]; give {}", key.name, list, allowed_values(key)));
  }

  /// Names become names of files and words in tables.
  void refuse_name(const std::string& list, const toml::table& table,
                   const std::string& name) const {
    constexpr std::size_t longest_name = 60;
    const bool is_allowed = !name.empty() && name.size() <= longest_name &&
                            std::all_of(name.begin(), name.end(), [](unsigned char c) {
                              return std::isalnum(c) != 0 || c == '_' || c == '-';
                            });
    if (!is_allowed)
      fail_at(file_, *table.get("name"),
              fmt::format("'{}' is no name for a {}; use 1 to {} letters, digits, - and _",
                          in_one_line(name), list, longest_name));
  }

  const fs::path& file_;
  const toml::table& root_;
  SiteFileValues& values_;
};

/// A name of the program's own, or a file seen from the site's.
fs::path entry_file(const std::string& name, const SiteDescription& site,
                    const EntryFileFinder& find) {
  const bool is_file = name.ends_with(".toml") || name.find('/') != std::string::npos;
  if (is_file) return site.file.parent_path() / name;
  return find(name);
}

void read_entry_files(SiteFileValues& values, const EntryFileFinder& find) {
  const std::vector<std::string> names = values.site.entry_files;
  for (const std::string& name : names) {
    fs::path file;
    std::string text;
    try {
      file = entry_file(name, values.site, find);
      text = read_text_file(file);
    } catch (const InputError& error) {
      throw InputError(
          fmt::format("{}: entries: {}", values.site.place_of("entries"), error.what()));
    }
    const toml::table root = parse_toml(text, file.string());
    SiteFileReader reader(file, root, values);
    reader.refuse_all_but_lists();
    reader.read_lists();
  }
}

}  // namespace

std::string SiteDescription::place_of(std::string_view key) const {
  for (std::string_view path = key; !path.empty(); path = section_of(path))
    if (const auto found = lines.find(path); found != lines.end())
      return fmt::format("{}:{}", file.string(), found->second);
  return file.string();
}

SiteDescription read_site_file(const fs::path& file, const EntryFileFinder& find) {
  return parse_site(read_text_file(file), file, find);
}

SiteDescription parse_site(std::string_view text, const fs::path& name,
                           const EntryFileFinder& find) {
  const toml::table root = parse_toml(text, name.string());
  SiteFileValues values;
  SiteFileReader reader(name, root, values);
  reader.read_site();
  reader.read_lists();
  read_entry_files(values, find);
  check_description(values.site);
  return std::move(values.site);
}

}  // namespace phytobench
