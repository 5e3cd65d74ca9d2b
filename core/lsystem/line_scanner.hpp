// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/lsystem/source_lines.hpp"

namespace phytobench {

/// Reads a part of a statement from left to right. Blanks between what it takes mean nothing, and
/// are stepped over before anything is looked at.
class LineScanner {
 public:
  /// The bytes from begin to end of line.text; `line` must outlive the scanner.
  LineScanner(const SourceLine& line, std::size_t begin, std::size_t end)
      : line_(&line), text_(std::string_view(line.text).substr(0, end)), at_(begin) {
    skip_blanks();
  }
  explicit LineScanner(const SourceLine& line) : LineScanner(line, 0, line.text.size()) {}

  const SourceLine& line() const { return *line_; }
  std::size_t offset() const { return at_; }  ///< in line().text, of what comes next
  bool at_end() const { return at_ == text_.size(); }
  std::string_view rest() const { return text_.substr(at_); }
  bool next_is(std::string_view text) const { return rest().starts_with(text); }

  /// Steps over `text` if it comes next.
  bool take(std::string_view text);
  /// Up to the next blank.
  std::string_view take_word();
  /// A name: an ASCII letter or _, then letters, digits and _. Empty if none comes next.
  std::string_view take_name();
  std::string_view next_name() const { return LineScanner(*this).take_name(); }
  /// A decimal number without sign. Throws InputError if no double can hold it.
  std::optional<double> take_number();
  /// One character, which may be several bytes; not at the end.
  std::string_view take_character();
  void advance(std::size_t bytes);

  /// What comes next as messages show it: "'x'" or "the end".
  std::string next_shown() const;
  TextPlace place() const { return line_->place(at_); }
  /// Throws InputError with the place of what comes next.
  [[noreturn]] void fail(const std::string& problem) const { line_->fail(at_, problem); }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }

  const SourceLine* line_;
  std::string_view text_;
  std::size_t at_;
};

}  // namespace phytobench
