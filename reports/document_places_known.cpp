// SPDX-License-Identifier: MIT
#include "reports/document_places_known.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "reference/data_folder.hpp"
#include "reference/toml_table.hpp"

namespace phytobench {

namespace {

constexpr std::array<std::pair<const char*, PlaceKind>, 5> known_place_kinds = {
    {{"section", PlaceKind::section},
     {"equation", PlaceKind::equation},
     {"figure", PlaceKind::figure},
     {"table", PlaceKind::table},
     {"listing", PlaceKind::listing}}};

/// "45" or "43-45".
void read_pages(const TomlTable& table, const std::string& text, KnownPlace& known) {
  const char* const end = text.data() + text.size();
  std::from_chars_result read = std::from_chars(text.data(), end, known.first_page);
  known.last_page = known.first_page;
  if (read.ec == std::errc() && read.ptr != end && *read.ptr == '-')
    read = std::from_chars(read.ptr + 1, end, known.last_page);
  if (read.ec != std::errc() || read.ptr != end || known.first_page < 1 ||
      known.last_page < known.first_page)
    table.fail(fmt::format("'{}' are no pages; write \"45\" or \"43-45\"", text));
}

/// "3.4" of the section "3.4.1"; empty for a chapter.
std::string section_around(const std::string& section) {
  const std::size_t dot = section.rfind('.');
  return dot == std::string::npos ? "" : section.substr(0, dot);
}

KnownPlace known_place(const TomlTable& table, PlaceKind kind, const std::string& number) {
  const std::vector<std::string> entry = table.texts(number);
  const std::size_t wanted = kind == PlaceKind::section ? 1 : 2;
  if (entry.size() != wanted) table.fail("a section has its pages, all else a section, too");
  KnownPlace known{.place = {kind, number}, .section = {}};
  read_pages(table, entry[0], known);
  known.section = kind == PlaceKind::section ? section_around(number) : entry[1];
  return known;
}

}  // namespace

std::vector<KnownPlace> known_places_of(const std::string& file) {
  const TomlTable root = TomlTable::read(file);
  root.allow_only({"section", "equation", "figure", "table", "listing"});
  std::vector<KnownPlace> known;
  for (const auto& [name, kind] : known_place_kinds) {
    if (!root.has(name)) continue;
    const TomlTable table = root.table(name);
    for (const std::string& number : table.keys())
      known.push_back(known_place(table, kind, number));
  }
  std::sort(known.begin(), known.end(),
            [](const KnownPlace& a, const KnownPlace& b) { return a.place < b.place; });
  return known;
}

std::vector<KnownPlace> known_places(const std::string& paper) {
  const std::filesystem::path file = paper_folder(paper) / "places.toml";
  return std::filesystem::exists(file) ? known_places_of(file.string()) : std::vector<KnownPlace>{};
}

std::string shown_pages(const KnownPlace& known) {
  return known.first_page == known.last_page
             ? fmt::format("p. {}", known.first_page)
             : fmt::format("p. {}-{}", known.first_page, known.last_page);
}

}  // namespace phytobench
