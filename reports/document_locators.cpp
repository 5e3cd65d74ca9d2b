// SPDX-License-Identifier: MIT
#include "reports/document_locators.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <utility>

#include "reports/characters.hpp"
#include "reports/natural_order.hpp"

namespace phytobench {

namespace {

bool is_capital(char c) {
  return std::isupper(static_cast<unsigned char>(c)) != 0;
}

std::string lower(std::string_view text) {
  std::string low(text);
  for (char& c : low) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return low;
}

std::optional<PlaceKind> kind_named(const std::string& word) {
  constexpr std::array<std::pair<std::string_view, PlaceKind>, 18> names = {
      {{"eq", PlaceKind::equation},
       {"eqs", PlaceKind::equation},
       {"equation", PlaceKind::equation},
       {"equations", PlaceKind::equation},
       {"fig", PlaceKind::figure},
       {"figs", PlaceKind::figure},
       {"figure", PlaceKind::figure},
       {"figures", PlaceKind::figure},
       {"table", PlaceKind::table},
       {"tables", PlaceKind::table},
       {"sec", PlaceKind::section},
       {"section", PlaceKind::section},
       {"sections", PlaceKind::section},
       {"ch", PlaceKind::section},
       {"chapter", PlaceKind::section},
       {"chapters", PlaceKind::section},
       {"listing", PlaceKind::listing},
       {"listings", PlaceKind::listing}}};
  const auto found =
      std::find_if(names.begin(), names.end(), [&](const auto& n) { return n.first == word; });
  return found == names.end() ? std::nullopt : std::optional(found->second);
}

/// A panel's letter or side: the next number is another figure's.
bool is_part_of_a_figure(const std::string& word) {
  return word.size() == 1 || word == "left" || word == "middle" || word == "right";
}

/// Reads a locator from left to right; a word says of what kind the numbers after it are.
class LocatorReader {
 public:
  explicit LocatorReader(std::string_view text) : text_(text) {}

  std::vector<Place> read() {
    while (at_ < text_.size()) {
      if (is_numeral())
        take_number();
      else if (is_letter(text_[at_]))
        take_word();
      else
        take_sign();
    }
    if (places_.empty()) places_.push_back({PlaceKind::other, std::string(text_)});
    return places_;
  }

 private:
  /// 3.4.4, or A.2 inside brackets.
  bool is_numeral() const {
    if (is_digit(text_[at_])) return true;
    return at_ + 2 < text_.size() && is_capital(text_[at_]) && text_[at_ + 1] == '.' &&
           is_digit(text_[at_ + 2]);
  }

  void take_number() {
    const std::size_t start = at_;
    const bool is_in_a_name = start > 0 && is_letter(text_[start - 1]);  // p1 of an L-system
    while (at_ < text_.size() &&
           (is_digit(text_[at_]) || text_[at_] == '.' || (at_ == start && is_capital(text_[at_]))))
      ++at_;
    std::string number(text_.substr(start, at_ - start));
    if (is_in_a_name) return;
    if (number.back() == '.') number.pop_back();
    const bool in_brackets = start > 0 && text_[start - 1] == '(';
    const bool dotted = number.find('.') != std::string::npos;
    if (in_brackets)
      add({PlaceKind::equation, number});
    else if (kind_)
      add({*kind_, number});
    else if (dotted && !is_detail_)
      add({PlaceKind::section, number});
  }

  void take_word() {
    const std::size_t start = at_;
    while (at_ < text_.size() && is_letter(text_[at_])) ++at_;
    const std::string_view word = text_.substr(start, at_ - start);
    if (word.size() >= 2 && std::all_of(word.begin(), word.end(), is_capital) &&
        at_ < text_.size() && is_digit(text_[at_])) {
      while (at_ < text_.size() && is_digit(text_[at_])) ++at_;
      add({PlaceKind::requirement, std::string(text_.substr(start, at_ - start))});
      return;
    }
    use_word(word);
  }

  void use_word(std::string_view word) {
    const std::string low = lower(word);
    if (low == "and" || low == "or") return;
    if (low == "to") {
      in_range_ = true;
      return;
    }
    in_range_ = false;
    if (after_appendix_ && word.size() == 1 && is_capital(word[0]))
      add({PlaceKind::section, std::string(word)});
    if (is_part_of_a_figure(low)) return;
    if (after_appendix_ && low == "table") add({PlaceKind::table, "appendix"});
    kind_ = kind_named(low);
    if (after_appendix_ && low == "table") kind_.reset();
    is_detail_ = low == "step" || low == "steps" || low == "row" || low == "rows" ||
                 low == "column" || low == "columns" || low == "page" || low == "pages" ||
                 low == "pp" || low == "line" || low == "lines";
    after_appendix_ = low == "appendix" || low == "appendices";
  }

  void take_sign() {
    if (text_[at_] == ';') kind_.reset();
    in_range_ |= text_[at_] == '-' || text_.substr(at_).starts_with("\xe2\x80\x93");
    ++at_;
  }

  void add(const Place& place) {
    if (in_range_ && !places_.empty() && places_.back().kind == place.kind) fill_up_to(place);
    in_range_ = false;
    if (std::find(places_.begin(), places_.end(), place) == places_.end()) places_.push_back(place);
  }

  /// The numbers between the last place and this one, where only their last parts differ.
  void fill_up_to(const Place& place) {
    const auto split = [](const std::string& number) {
      const std::size_t dot = number.rfind('.');
      const std::size_t start = dot == std::string::npos ? 0 : dot + 1;
      return std::pair(number.substr(0, start), number.substr(start));
    };
    const auto [first_part, first] = split(places_.back().number);
    const auto [last_part, last] = split(place.number);
    const auto is_small = [](const std::string& digits) {
      return !digits.empty() && digits.size() < 4 &&
             std::all_of(digits.begin(), digits.end(), is_digit);
    };
    if (first_part != last_part || !is_small(first) || !is_small(last)) return;
    for (int next = std::stoi(first) + 1; next < std::stoi(last); ++next)
      places_.push_back({place.kind, first_part + std::to_string(next)});
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::optional<PlaceKind> kind_;
  bool is_detail_ = false;
  bool after_appendix_ = false;
  bool in_range_ = false;
  std::vector<Place> places_;
};

bool is_lettered(const std::string& number) {
  return number.size() == 1 && is_capital(number[0]);
}

}  // namespace

bool operator<(const Place& a, const Place& b) {
  if (a.kind != b.kind) return a.kind < b.kind;
  return a.number != b.number && is_naturally_before(a.number, b.number);
}

std::vector<Place> places_of(std::string_view locator) {
  return LocatorReader(locator).read();
}

std::string shown(const Place& place) {
  switch (place.kind) {
    case PlaceKind::equation:
      return "Equation " + place.number;
    case PlaceKind::figure:
      return "Figure " + place.number;
    case PlaceKind::table:
      return place.number == "appendix" ? "Appendix table" : "Table " + place.number;
    case PlaceKind::section:
      if (is_lettered(place.number)) return "Appendix " + place.number;
      return (place.number.find('.') == std::string::npos ? "Chapter " : "Section ") + place.number;
    case PlaceKind::listing:
      return "Listing " + place.number;
    default:
      return place.number;
  }
}

std::string search_token(const Place& place) {
  switch (place.kind) {
    case PlaceKind::equation:
      return "eq:" + place.number;
    case PlaceKind::figure:
      return "fig:" + place.number;
    case PlaceKind::table:
      return "tab:" + place.number;
    case PlaceKind::section:
      return "sec:" + place.number;
    case PlaceKind::listing:
      return "lst:" + place.number;
    default:
      return "";
  }
}

std::string_view heading_of(PlaceKind kind) {
  switch (kind) {
    case PlaceKind::equation:
      return "Equations (Gleichungen)";
    case PlaceKind::figure:
      return "Figures (Abbildungen)";
    case PlaceKind::table:
      return "Tables (Tabellen)";
    case PlaceKind::section:
      return "Chapters and sections (Kapitel, Abschnitte)";
    case PlaceKind::listing:
      return "Listings";
    case PlaceKind::requirement:
      return "Requirements (Anforderungen)";
    case PlaceKind::other:
      return "Elsewhere";
  }
  return "";
}

}  // namespace phytobench
