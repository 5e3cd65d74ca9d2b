// SPDX-License-Identifier: MIT
#include "core/lsystem/production_parser.hpp"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/contract/parameter_keys.hpp"
#include "core/lsystem/lsystem_settings.hpp"

namespace phytobench {

namespace {

constexpr auto none = std::string_view::npos;
constexpr std::size_t most_label_bytes = 64;

/// A part of the line, without the blanks around it.
struct Part {
  std::size_t begin = 0;
  std::size_t end = 0;
};

class ProductionParser {
 public:
  ProductionParser(const SourceLine& line, const Arrow& arrow, const ModuleContext& context)
      : line_(line), text_(line.text), arrow_(arrow), context_(context) {}

  Production parse() {
    refuse_long_arrow();
    read_before_arrow();
    read_behind_arrow();
    production_.parameter_count = static_cast<std::uint16_t>(parameters_.size());
    return std::move(production_);
  }

 private:
  /// A '-' right before the arrow is a symbol only where a predecessor or context must begin.
  void refuse_long_arrow() const {
    const std::size_t arrow = arrow_.offset;
    if (arrow == 0 || text_.substr(arrow - 1, 3) != "-->") return;
    const Part before = trimmed(0, arrow - 1);
    const char last = before.begin == before.end ? ':' : text_[before.end - 1];
    if (last == ':' || last == '<' || last == '>') return;
    line_.fail(
        arrow - 1,
        "'-->' is no arrow; write '->' (or a blank before '->' if the first '-' is a symbol)");
  }

  std::string_view text_of(const Part& part) const {
    return text_.substr(part.begin, part.end - part.begin);
  }
  LineScanner scanner_of(const Part& part) const { return {line_, part.begin, part.end}; }
  ExpressionScope scope() {
    return {
        .constants = context_.constants, .parameters = parameters_, .random_calls = &random_calls_};
  }

  Part trimmed(std::size_t begin, std::size_t end) const {
    while (begin < end && is_blank(text_[begin])) ++begin;
    while (begin < end && is_blank(text_[end - 1])) --end;
    return {begin, end};
  }

  /// Between the colons before the arrow.
  std::vector<Part> parts_before_arrow() const {
    std::vector<Part> parts;
    std::size_t begin = 0;
    for (std::size_t colon = text_.find(':'); colon < arrow_.offset;
         colon = text_.find(':', begin)) {
      parts.push_back(trimmed(begin, colon));
      begin = colon + 1;
      if (parts.size() == 3)
        line_.fail(colon,
                   "a third ':' before the arrow; there is room for 'label : predecessor : "
                   "condition'");
    }
    parts.push_back(trimmed(begin, arrow_.offset));
    return parts;
  }

  void read_before_arrow() {
    std::vector<Part> parts = parts_before_arrow();
    if (parts.size() == 3 || (parts.size() == 2 && begins_with_label(parts))) {
      read_label(parts.front());
      parts.erase(parts.begin());
    }
    read_predecessor(parts[0]);
    if (parts.size() == 2) read_condition(parts[1]);
  }

  static bool is_word(std::string_view text) {
    return !text.empty() && std::all_of(text.begin(), text.end(), [](char c) {
      return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
    });
  }

  /// Whether 'x : y ->' has a label and a predecessor, not a predecessor and a condition.
  bool begins_with_label(const std::vector<Part>& parts) {
    if (!is_word(text_of(parts[0]))) return false;
    LineScanner first = scanner_of(parts[0]);
    context_.alphabet.take_letter(first);
    if (!first.at_end()) return true;  // two letters are no predecessor
    if (text_of(parts[1]) == "*" || !is_predecessor(parts[1])) return false;
    if (text_of(parts[1]).find_first_of("<>") != none && is_constant(parts[1]))
      line_.fail(parts[1].begin,
                 "may be a condition, or a predecessor with contexts; write all of 'label : "
                 "predecessor : condition', with * for no condition");
    return true;
  }

  bool is_predecessor(const Part& part) {
    std::vector<Symbol> symbols;
    SymbolTable table(symbols);
    try {
      const ModuleContext trial{context_.alphabet, table, context_.constants};
      ProductionParser(line_, arrow_, trial).read_predecessor(part);
      return true;
    } catch (const InputError&) {
      return false;
    }
  }

  bool is_constant(const Part& part) const {
    try {
      LineScanner scanner = scanner_of(part);
      parse_constant(scanner, context_.constants);
      return scanner.at_end();
    } catch (const InputError&) {
      return false;
    }
  }

  void read_label(const Part& part) {
    const std::string_view label = text_of(part);
    if (!is_word(label) || label.size() > most_label_bytes)
      line_.fail(part.begin,
                 "a label must be a word of at most 64 letters, digits and _; of 'label : "
                 "predecessor : condition', leave out what is missing with its ':'");
    if (is_setting(label))
      line_.fail(
          part.begin,
          fmt::format("'{}' takes no arrow; remove the arrow, or name the production otherwise",
                      label));
    production_.label = label;
  }

  void read_predecessor(const Part& part) {
    LineScanner scanner = scanner_of(part);
    std::size_t place = scanner.offset();
    std::vector<PatternModule> modules = pattern(scanner, PatternBrackets::refused);
    if (scanner.take("<")) {
      production_.left = std::move(modules);
      place = scanner.offset();
      modules = pattern(scanner, PatternBrackets::refused);
    }
    if (modules.size() != 1)
      line_.fail(place, modules.empty()
                            ? "no predecessor; write a module before the arrow, as in 'F -> FF'"
                            : "more than one module as predecessor; contexts stand as in 'left < "
                              "predecessor > right', and letters of more than one character need "
                              "a line 'alphabet: ar al'");
    production_.predecessor = modules[0];
    production_.place = line_.place(place);
    if (scanner.take(">")) production_.right = pattern(scanner, PatternBrackets::balanced);
    if (!scanner.at_end())
      scanner.fail(
          fmt::format("{} where the arrow or ':' belongs; '<' and '>' stand once each, "
                      "as in 'left < predecessor > right'",
                      scanner.next_shown()));
  }

  std::vector<PatternModule> pattern(LineScanner& scanner, PatternBrackets brackets) {
    return parse_pattern(scanner, context_, brackets, parameters_);
  }

  void read_condition(const Part& part) {
    if (text_of(part) == "*") return;
    LineScanner scanner = scanner_of(part);
    if (scanner.at_end()) scanner.fail("no condition after ':'; write one, or remove the ':'");
    production_.condition = parse_expression(scanner, scope());
    if (!scanner.at_end())
      scanner.fail(fmt::format("{} where an operator or the arrow belongs; check the condition",
                               scanner.next_shown()));
  }

  void read_behind_arrow() {
    const std::size_t begin = arrow_.offset + arrow_.length;
    const std::size_t colon = std::min(text_.find(':', begin), text_.size());
    const Part successor = trimmed(begin, colon);
    if (const std::string_view word = text_of(successor); word != "*" && word != "ε") {
      LineScanner scanner = scanner_of(successor);
      production_.successor = parse_word(scanner, context_, scope());
    }
    if (colon < text_.size()) read_probability(colon + 1);
  }

  void read_probability(std::size_t begin) {
    LineScanner scanner(line_, begin, text_.size());
    const std::size_t place = scanner.offset();
    const double probability = parse_constant(scanner, context_.constants);
    if (!scanner.at_end())
      scanner.fail(fmt::format("{} behind the probability; a production has a line of its own",
                               scanner.next_shown()));
    const NumberRange range{.low = 0.0, .high = 1.0, .low_is_allowed = false};
    if (!is_allowed(probability, range))
      line_.fail(place, out_of_range("the probability", probability, range));
    production_.probability = probability;
  }

  const SourceLine& line_;
  std::string_view text_;
  Arrow arrow_;
  const ModuleContext& context_;
  Production production_;
  std::vector<std::string> parameters_;  ///< names, of left, predecessor and right
  int random_calls_ = 0;
};

}  // namespace

std::optional<Arrow> find_arrow(std::string_view text) {
  std::optional<Arrow> first;
  for (const std::string_view arrow : {"->", "::=", "→"}) {
    const std::size_t found = text.find(arrow);
    if (found != none && (!first || found < first->offset)) first = Arrow{found, arrow.size()};
  }
  return first;
}

Production parse_production(const SourceLine& line, const Arrow& arrow,
                            const ModuleContext& context) {
  return ProductionParser(line, arrow, context).parse();
}

}  // namespace phytobench
