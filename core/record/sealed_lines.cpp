// SPDX-License-Identifier: MIT
#include "core/record/sealed_lines.hpp"

#include <algorithm>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"
#include "core/record/digest_chain.hpp"

namespace phytobench {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

/// Whether a line without line end is the beginning of one, as opposed to a damaged one.
bool breaks_off(std::string_view line) {
  try {
    const ordered_json whole = ordered_json::parse(line.begin(), line.end());
    return whole.is_object();  // nothing but the line end is missing
  } catch (const ordered_json::parse_error& error) {
    return error.byte > line.size();
  }
}

/// For a terminal: a damaged file's text may hold any byte.
std::string in_printable_letters(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

/// Goes through the text of a file and keeps the place.
class SealedLines {
 public:
  SealedLines(std::string_view text, const SealedLineUse& use) : text_(text), use_(use) {}

  bool is_at_end() const { return line_start_ == text_.size(); }
  int number() const { return number_; }

  /// Uses the next line.
  void next() {
    ++number_;
    const std::size_t end = text_.find('\n', line_start_);
    const std::string_view line = text_.substr(line_start_, end - line_start_);
    if (end == std::string_view::npos) {
      if (!breaks_off(line)) throw InputError("damaged line; run the experiments again");
      line_start_ = text_.size();
      return;
    }
    const ordered_json json = ordered_json::parse(line.begin(), line.end());
    if (json.contains("sha256"))
      end_section(json, end);
    else
      use_.line(json);
    line_start_ = end + 1;
  }

 private:
  void end_section(const ordered_json& json, std::size_t end) {
    if (!chain_.accept(text_.substr(section_start_, end - section_start_)))
      throw InputError(fmt::format(
          "lines {} to {} were changed, lost, repeated or moved since they were written (their "
          "SHA-256 is not the one that stands here); put an intact copy in the place of this "
          "folder, or run the experiments again",
          section_number_, number_));
    use_.seal(json, {.line = number_, .end = end + 1, .digest = chain_.seal()});
    section_start_ = end + 1;
    section_number_ = number_ + 1;
  }

  std::string_view text_;
  const SealedLineUse& use_;
  DigestChain chain_;
  std::size_t section_start_ = 0;
  std::size_t line_start_ = 0;
  int section_number_ = 1;  ///< line in which the section begins
  int number_ = 0;
};

}  // namespace

void read_sealed_lines(const fs::path& file, std::string_view text, const SealedLineUse& use) {
  SealedLines lines(text, use);
  const auto where = [&] { return fmt::format("{}:{}: ", file.string(), lines.number()); };
  while (!lines.is_at_end()) {
    try {
      lines.next();
    } catch (const ordered_json::parse_error& error) {
      // The library's text repeats what it has read, and knows only line 1.
      throw InputError(fmt::format("{}damaged line (no JSON from its byte {} on); {}", where(),
                                   error.byte, "run the experiments again"));
    } catch (const ordered_json::exception& error) {
      throw InputError(where() + "damaged line (" + in_printable_letters(error.what()) +
                       "); run the experiments again");
    } catch (const InputError& error) {
      throw InputError(where() + in_printable_letters(error.what()));
    }
  }
}

}  // namespace phytobench
