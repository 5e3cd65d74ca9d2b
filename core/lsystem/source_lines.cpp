// SPDX-License-Identifier: MIT
#include "core/lsystem/source_lines.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

constexpr auto nowhere = std::string_view::npos;

/// Whether `text` belongs to a list of colours, in which "#rrggbb" is no comment.
bool lists_colours(std::string_view text) {
  return text.find("colours") != nowhere;
}

/// Where the comment of a line begins.
std::size_t comment_start(std::string_view line, bool goes_on_with_colours) {
  for (std::size_t at = line.find('#'); at != nowhere; at = line.find('#', at + 1)) {
    if (at == 0) return at;
    if (!is_blank(line[at - 1])) continue;
    const bool touches = at + 1 < line.size() && !is_blank(line[at + 1]);
    if (!touches || !(goes_on_with_colours || lists_colours(line.substr(0, at)))) return at;
  }
  return line.size();
}

class LineReader {
 public:
  explicit LineReader(std::string_view name) : name_(name) {}

  void read(std::string_view line) {
    ++number_;
    refuse_strange_characters(line);
    for (const std::string_view word : {"#ignore", "#define", "#consider"})
      if (line.starts_with(word))
        fail_in_text(name_, {number_, 1},
                     fmt::format("'{}' would be a comment; write 'ignore: + -' for a list, "
                                 "'name = 2' for a constant, or a blank after '#'",
                                 word));
    const bool goes_on = !line.empty() && is_blank(line.front()) && !lines_.empty();
    line = line.substr(0, comment_start(line, goes_on && in_colours_));
    if (std::all_of(line.begin(), line.end(), is_blank)) return;
    if (!goes_on) lines_.push_back({name_, {}, {}});
    in_colours_ = (goes_on && in_colours_) || lists_colours(line);
    SourceLine& last = lines_.back();
    last.pieces.push_back({last.text.size(), number_});
    last.text += line;
  }

  std::vector<SourceLine> take() { return std::move(lines_); }

 private:
  void refuse_strange_characters(std::string_view line) const {
    int column = 1;
    for (std::size_t at = 0; at < line.size(); ++column) {
      const std::size_t length = utf8_length(line.substr(at));
      if (length == 0)
        fail_in_text(name_, {number_, column}, "is not UTF-8 text; save the file as UTF-8");
      const auto byte = static_cast<unsigned char>(line[at]);
      if ((byte < 0x20 && byte != '\t') || byte == 0x7f)
        fail_in_text(
            name_, {number_, column},
            fmt::format("a control character (code {}) has no place in a text; remove it", byte));
      at += length;
    }
  }

  std::string_view name_;
  int number_ = 0;
  bool in_colours_ = false;  ///< the last statement
  std::vector<SourceLine> lines_;
};

}  // namespace

void fail_in_text(std::string_view name, const TextPlace& place, const std::string& problem) {
  throw InputError(fmt::format("{}:{}:{}: {}", name, place.line, place.column, problem));
}

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const auto byte = static_cast<unsigned char>(text[0]);
  const std::size_t length = byte < 0x80                   ? 1
                             : byte >= 0xc2 && byte < 0xe0 ? 2
                             : byte >= 0xe0 && byte < 0xf0 ? 3
                             : byte >= 0xf0 && byte < 0xf5 ? 4
                                                           : 0;
  if (length == 0 || length > text.size()) return 0;
  const bool goes_on =
      std::all_of(text.begin() + 1, text.begin() + static_cast<long>(length),
                  [](char c) { return (static_cast<unsigned char>(c) >> 6) == 2; });
  return goes_on ? length : 0;
}

bool is_colour(std::string_view text) {
  return text.size() == 7 && text[0] == '#' &&
         std::all_of(text.begin() + 1, text.end(),
                     [](char c) { return std::isxdigit(static_cast<unsigned char>(c)) != 0; });
}

TextPlace SourceLine::place(std::size_t offset) const {
  const auto after =
      std::upper_bound(pieces.begin(), pieces.end(), offset,
                       [](std::size_t at, const Piece& piece) { return at < piece.offset; });
  const Piece& piece = *(after - 1);
  int column = 1;
  for (std::size_t at = piece.offset; at < std::min(offset, text.size());
       at += std::max<std::size_t>(1, utf8_length(std::string_view(text).substr(at))))
    ++column;
  return {piece.line, column};
}

void SourceLine::fail(std::size_t offset, const std::string& problem) const {
  fail_in_text(name, place(offset), problem);
}

std::vector<SourceLine> source_lines(std::string_view text, std::string_view name) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  LineReader reader(name);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    reader.read(text.substr(0, end));
    text.remove_prefix(end);
    if (!text.empty()) text.remove_prefix(text.starts_with("\r\n") ? 2 : 1);
  }
  return reader.take();
}

}  // namespace phytobench
