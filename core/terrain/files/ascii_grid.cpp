// SPDX-License-Identifier: MIT
#include "core/terrain/files/ascii_grid.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/terrain/files/coordinate_unit.hpp"
#include "core/terrain/files/number_words.hpp"

namespace phytobench {

namespace {

constexpr const char* header_keys[] = {"ncols",     "nrows",       "xllcorner", "xllcenter",
                                       "yllcorner", "yllcenter",   "cellsize",  "dx",
                                       "dy",        "nodata_value"};

std::string key_of(std::string_view word) {
  std::string key(word);
  std::transform(key.begin(), key.end(), key.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return key;
}

/// Reads a grid line by line.
class AsciiGridReader {
 public:
  AsciiGridReader(std::string_view text, const std::string& name) : rest_(text), name_(name) {}

  Raster read(const std::string& projection) {
    read_header();
    raster_.format = "ESRI ASCII grid";
    raster_.columns = whole_number("ncols");
    raster_.rows = whole_number("nrows");
    check_raster_size(raster_.columns, raster_.rows, name_);
    place(projection);
    read_numbers();
    return std::move(raster_);
  }

 private:
  struct Entry {
    double value = 0.0;
    std::size_t line = 0;
  };

  [[noreturn]] void refuse(std::size_t line, const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", name_, line, what));
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format("{}: {}", name_, what));
  }

  bool next_line() {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    ++line_number_;
    return true;
  }

  /// Stops before the first line that begins with a number.
  void read_header() {
    for (;;) {
      const std::string_view rest = rest_;
      if (!next_line()) refuse("has a header but no numbers; is it cut off?");
      std::string_view words = line_;
      const std::string_view first = next_word(words);
      if (first.empty()) continue;
      if (std::isalpha(static_cast<unsigned char>(first.front())) == 0 || is_nan_word(first)) {
        rest_ = rest;
        --line_number_;
        return;
      }
      const std::string_view value = next_word(words);
      read_entry(key_of(first), value, next_word(words));
    }
  }

  void read_entry(const std::string& key, std::string_view word, std::string_view surplus) {
    if (std::find(std::begin(header_keys), std::end(header_keys), key) == std::end(header_keys))
      refuse(line_number_, fmt::format("'{}' is no entry of an ESRI ASCII grid; remove the line or "
                                       "convert the file",
                                       shown_word(key)));
    const std::optional<double> value = number_of(word);
    const bool may_be_nan = key == "nodata_value";
    if (!value || !surplus.empty() ||
        !(std::isfinite(*value) || (may_be_nan && !std::isinf(*value))))
      refuse(line_number_, fmt::format("{} needs one number, not '{}'", key, shown_word(word)));
    if (!entries_.try_emplace(key, Entry{*value, line_number_}).second)
      refuse(line_number_, fmt::format("{} is there twice; keep one", key));
  }

  const Entry* entry(const std::string& key) const {
    const auto found = entries_.find(key);
    return found == entries_.end() ? nullptr : &found->second;
  }

  int whole_number(const std::string& key) const {
    const Entry* found = entry(key);
    if (found == nullptr) refuse(fmt::format("has no entry {}; an ESRI ASCII grid needs it", key));
    if (found->value != std::floor(found->value) || found->value < 1.0 || found->value > 2e9)
      refuse(found->line, fmt::format("{} = {} is no number of vertices; give a whole one above 0",
                                      key, found->value));
    return static_cast<int>(found->value);
  }

  double length(const std::string& key) const {
    const Entry& found = *entry(key);
    if (!(found.value > 0.0))
      refuse(found.line,
             fmt::format("{} = {} is no width of cells; give one above 0", key, found.value));
    return found.value;
  }

  void place(const std::string& projection) {
    const Entry *side = entry("cellsize"), *dx = entry("dx"), *dy = entry("dy");
    if (side != nullptr && (dx != nullptr || dy != nullptr))
      refuse(side->line, "cellsize stands beside dx or dy; keep one of them");
    if ((dx == nullptr) != (dy == nullptr))
      refuse((dx == nullptr ? dy : dx)->line, "dx and dy need each other; give both, or cellsize");
    if (side == nullptr && dx == nullptr) return;  // somebody else may say it
    const double width = length(side == nullptr ? "dx" : "cellsize");
    const double depth = length(side == nullptr ? "dy" : "cellsize");
    const double west = border("xllcorner", "xllcenter", width);
    const double south = border("yllcorner", "yllcenter", depth);
    if ((entry("xllcenter") == nullptr) != (entry("yllcenter") == nullptr) &&
        (entry("xllcorner") == nullptr) != (entry("yllcorner") == nullptr))
      refuse("counts x from a corner and y from a centre or the other way round; keep to one");
    raster_.place = GeoReference{west, south + depth * raster_.rows, width, -depth, projection};
    raster_.unit = unit_of_projection(projection);
  }

  /// Of the cell in the south-west; 0 where neither entry is there.
  double border(const std::string& corner, const std::string& centre, double side) const {
    const Entry *at_corner = entry(corner), *at_centre = entry(centre);
    if (at_corner != nullptr && at_centre != nullptr)
      refuse(at_centre->line, fmt::format("{} stands beside {}; keep one", centre, corner));
    if (at_corner != nullptr) return at_corner->value;
    return at_centre != nullptr ? at_centre->value - side / 2.0 : 0.0;
  }

  void read_numbers() {
    const std::size_t count =
        static_cast<std::size_t>(raster_.columns) * static_cast<std::size_t>(raster_.rows);
    // A digit and a blank each: what is cut off is found before memory is taken for all of it.
    if (rest_.size() + 1 < 2 * count) refuse_count(count);
    raster_.values.reserve(count);
    bool row_is_a_line = false;
    while (next_line()) {
      const std::size_t before = raster_.values.size();
      read_line(count);
      const std::size_t read = raster_.values.size() - before;
      if (read == 0) continue;
      if (before == 0) row_is_a_line = read == static_cast<std::size_t>(raster_.columns);
      if (row_is_a_line && read != static_cast<std::size_t>(raster_.columns))
        refuse(line_number_, fmt::format("{} numbers where ncols says {}; complete the row or is "
                                         "the file cut off?",
                                         read, raster_.columns));
    }
    if (raster_.values.size() < count) refuse_count(count);
  }

  [[noreturn]] void refuse_count(std::size_t count) {
    std::size_t found = raster_.values.size();
    while (next_line())
      for (std::string_view words = line_; !next_word(words).empty();) ++found;
    refuse(line_number_,
           fmt::format("the file ends after {} of {} x {} = {} numbers; is it cut off?", found,
                       raster_.columns, raster_.rows, count));
  }

  /// -9999 is what the format has where the header has no entry.
  double no_data_mark() const {
    const Entry* given = entry("nodata_value");
    return given == nullptr ? -9999.0 : given->value;
  }

  void read_line(std::size_t count) {
    const double mark = no_data_mark();
    std::string_view words = line_;
    for (std::string_view word = next_word(words); !word.empty(); word = next_word(words)) {
      const std::optional<double> value = number_of(word);
      const bool is_marked = value && (*value == mark || (std::isnan(*value) && std::isnan(mark)));
      if (!value || (!is_marked && !std::isfinite(*value)))
        refuse(line_number_, fmt::format("'{}' is no finite number; mark what has no data with "
                                         "NODATA_value",
                                         shown_word(word)));
      if (raster_.values.size() == count)
        refuse(line_number_, fmt::format("more numbers than {} x {} = {}; correct ncols or nrows",
                                         raster_.columns, raster_.rows, count));
      raster_.values.push_back(is_marked ? HeightField::no_data : *value);
    }
  }

  std::string_view rest_;
  const std::string& name_;
  std::string_view line_;
  std::size_t line_number_ = 0;
  std::map<std::string, Entry> entries_;
  Raster raster_;
};

}  // namespace

Raster parse_ascii_grid(std::string_view text, const std::string& name,
                        const std::string& projection) {
  return AsciiGridReader(text, name).read(projection);
}

}  // namespace phytobench
