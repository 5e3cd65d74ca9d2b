// SPDX-License-Identifier: MIT
#include "core/lsystem/module_parser.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/contract/parameter_keys.hpp"
#include "core/lsystem/bracket_balance.hpp"

namespace phytobench {

namespace {

constexpr std::string_view queries = "PHLU";
constexpr std::size_t most_query_parameters = 3;
constexpr std::size_t most_letter_bytes = 32;
constexpr std::size_t most_arity = std::numeric_limits<std::uint8_t>::max();
constexpr std::size_t most_parameters = 1000;  // of a production

/// Why a character that has another meaning cannot be a letter; nullptr if it can.
const char* objection_to_letter(char c) {
  switch (c) {
    case '(':
      return "'(' without a letter before it; write the letter that has these parameters";
    case ')':
      return "')' without a '(' before it; remove it";
    case ',':
      return "',' between modules; modules follow each other without commas";
    case ':':
      return "':' has no place here; a setting follows 'key:', a probability the successor";
    case '<':
    case '>':
      return "'<' and '>' enclose a predecessor before the arrow, once each; remove this one, or "
             "begin a new line if it is an arrow (a line that begins with a blank goes on with the "
             "one before)";
    case '=':
      return "'=' has no place here; a constant has a line of its own, 'name = 2'";
    case '*':
      return "'*' is no letter; it only says that there is no condition, context or successor";
    case '#':
      return "'#' is no letter; a comment needs a blank before it";
    default:
      return nullptr;
  }
}

[[noreturn]] void refuse_character(const LineScanner& scanner) {
  LineScanner copy = scanner;
  const std::string_view character = copy.take_character();
  // What typesetting makes of ASCII characters.
  const std::map<std::string_view, char> plain{{"−", '-'},  {"–", '-'}, {"—", '-'}, {"’", '\''},
                                               {"′", '\''}, {"∧", '^'}, {"∗", '*'}, {"∼", '~'}};
  const auto found = plain.find(character);
  scanner.fail(found != plain.end()
                   ? fmt::format("'{}' is no letter; write '{}'", character, found->second)
                   : fmt::format("'{}' is no letter; write an ASCII character, or declare it in a "
                                 "line 'alphabet: {}'",
                                 character, character));
}

bool is_bracket(std::string_view letter) {
  return letter == "[" || letter == "]" || letter == "{" || letter == "}";
}

void check_arity(std::string_view letter, std::size_t arity, const SourceLine& line,
                 std::size_t place) {
  if (is_bracket(letter) && arity > 0)
    line.fail(place, fmt::format("'{}' takes no parameters; remove them", letter));
  if (letter[0] == '?' && arity > most_query_parameters)
    line.fail(place, fmt::format("'{}' has {} parameters; a query has at most 3 (x, y, z)", letter,
                                 arity));
  if (arity > most_arity)
    line.fail(place, fmt::format("more than {} parameters; split the module", most_arity));
}

/// Whether the next parameter is one name that stands for nothing: a query fills it in.
bool is_open_name(const LineScanner& scanner, const ExpressionScope& scope) {
  LineScanner ahead = scanner;
  const std::string_view name = ahead.take_name();
  const auto& known = scope.parameters;
  return !name.empty() && (ahead.next_is(",") || ahead.next_is(")")) &&
         !scope.constants.contains(name) &&
         std::find(known.begin(), known.end(), name) == known.end();
}

/// Calls read for each of the parameters in brackets, if there are some.
template <class Read>
void read_parameters(LineScanner& scanner, std::string_view letter, const Read& read) {
  if (!scanner.take("(") || scanner.take(")")) return;
  do read();
  while (scanner.take(","));
  if (!scanner.take(")"))
    scanner.fail(fmt::format("{} where ',' or ')' belongs; close the parameters of '{}'",
                             scanner.next_shown(), letter));
}

void add_parameter_name(LineScanner& scanner, std::vector<std::string>& parameters) {
  const std::size_t place = scanner.offset();
  const std::string_view name = scanner.take_name();
  if (name.empty())
    scanner.fail(
        fmt::format("{} where the name of a parameter belongs; numbers go into the "
                    "condition, as in 'A(x) : x == 1 -> B'",
                    scanner.next_shown()));
  const std::string shown = in_one_line(name, 40);
  if (is_function_name(name))
    scanner.line().fail(place,
                        fmt::format("'{}' is a function; name the parameter otherwise", shown));
  if (std::find(parameters.begin(), parameters.end(), name) != parameters.end())
    scanner.line().fail(
        place, fmt::format("a second parameter '{}' in one production; name it otherwise", shown));
  if (parameters.size() == most_parameters)
    scanner.line().fail(place, fmt::format("more than {} parameters in one production; remove some",
                                           most_parameters));
  parameters.emplace_back(name);
}

}  // namespace

void Alphabet::add(LineScanner& scanner, std::string_view letter) {
  if (letter.size() > most_letter_bytes)
    scanner.fail(fmt::format("a letter of more than {} characters; shorten it", most_letter_bytes));
  if (letter.find_first_of("(),:<>=#*?") != std::string_view::npos)
    scanner.fail(fmt::format("'{}' cannot be a letter; leave out ( ) , : < > = # * and ?", letter));
  if (letter.size() > 1 && letter.find_first_of("[]{}") != std::string_view::npos)
    scanner.fail(fmt::format("'{}' cannot be a letter; brackets stand alone", letter));
  if (letter.size() == 1 ||
      std::find(declared_.begin(), declared_.end(), letter) != declared_.end())
    return;
  if (declared_.size() == most_symbols)
    scanner.fail(fmt::format("more than {} letters; remove some", most_symbols));
  declared_.emplace_back(letter);
}

void Alphabet::declare(LineScanner& scanner) {
  const std::string_view all = scanner.rest();
  const bool braced = scanner.next_is("{") && all.find_last_of('}') != std::string_view::npos;
  // The last brace ends the set; others are letters of it.
  const std::size_t end =
      braced ? scanner.offset() + all.find_last_of('}') : scanner.offset() + all.size();
  if (braced) {
    LineScanner behind(scanner.line(), end + 1, scanner.offset() + all.size());
    if (!behind.at_end()) behind.fail("the set of letters ends before; remove the rest");
    scanner.take("{");
  }
  LineScanner letters(scanner.line(), scanner.offset(), end);
  while (!letters.at_end()) {
    if (letters.take(",")) continue;
    const std::string_view rest = letters.rest();
    const std::string_view letter = rest.substr(0, rest.find_first_of(" \t,"));
    add(letters, letter);
    letters.advance(letter.size());
  }
  std::stable_sort(declared_.begin(), declared_.end(),
                   [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
  scanner.advance(scanner.rest().size());
}

std::string_view Alphabet::take_letter(LineScanner& scanner) const {
  for (const std::string& letter : declared_)
    if (scanner.next_is(letter)) {
      scanner.advance(letter.size());
      return letter;
    }
  const std::string_view rest = scanner.rest();
  if (rest.empty()) scanner.fail("the end where a letter belongs");
  if (rest[0] == '?') {
    if (rest.size() < 2 || queries.find(rest[1]) == std::string_view::npos)
      scanner.fail("unknown query; there are ?P (position), ?H, ?L and ?U (heading, left, up)");
    scanner.advance(2);
    return rest.substr(0, 2);
  }
  if (static_cast<unsigned char>(rest[0]) >= 0x80) refuse_character(scanner);
  if (const char* objection = objection_to_letter(rest[0])) scanner.fail(objection);
  return scanner.take_character();
}

SymbolIndex SymbolTable::index_of(std::string_view letter, std::size_t arity,
                                  const SourceLine& line, std::size_t place) {
  std::pair<std::string, std::size_t> key(letter, arity);
  if (const auto found = indices_.find(key); found != indices_.end()) return found->second;
  check_arity(letter, arity, line, place);
  if (symbols_.size() == most_symbols)
    line.fail(place, fmt::format("more than {} symbols (a letter with another number of parameters "
                                 "is another symbol); use fewer letters",
                                 most_symbols));
  const auto index = static_cast<SymbolIndex>(symbols_.size());
  symbols_.push_back({key.first, static_cast<std::uint8_t>(arity)});
  indices_.emplace(std::move(key), index);
  return index;
}

std::vector<SuccessorModule> parse_word(LineScanner& scanner, const ModuleContext& context,
                                        const ExpressionScope& scope) {
  std::vector<SuccessorModule> word;
  BracketBalance balance(scanner.line());
  while (!scanner.at_end()) {
    const std::size_t place = scanner.offset();
    const std::string_view letter = context.alphabet.take_letter(scanner);
    balance.add(letter, place);
    SuccessorModule module;
    read_parameters(scanner, letter, [&] {
      if (letter[0] == '?' && is_open_name(scanner, scope)) {
        scanner.take_name();
        module.parameters.emplace_back(0.0);
      } else {
        module.parameters.push_back(parse_expression(scanner, scope));
      }
    });
    module.symbol =
        context.symbols.index_of(letter, module.parameters.size(), scanner.line(), place);
    word.push_back(std::move(module));
  }
  balance.finish();
  return word;
}

std::vector<PatternModule> parse_pattern(LineScanner& scanner, const ModuleContext& context,
                                         PatternBrackets brackets,
                                         std::vector<std::string>& parameters) {
  std::vector<PatternModule> pattern;
  BracketBalance balance(scanner.line());
  if (scanner.take("*")) return pattern;
  while (!scanner.at_end() && !scanner.next_is("<") && !scanner.next_is(">")) {
    const std::size_t place = scanner.offset();
    const std::string_view letter = context.alphabet.take_letter(scanner);
    if (is_bracket(letter) && brackets == PatternBrackets::refused)
      scanner.line().fail(place, fmt::format("'{}' before the arrow; only the right context has "
                                             "brackets, for branches",
                                             letter));
    if (letter == "[" || letter == "]") balance.add(letter, place);
    const std::size_t first = parameters.size();
    read_parameters(scanner, letter, [&] { add_parameter_name(scanner, parameters); });
    const SymbolIndex symbol =
        context.symbols.index_of(letter, parameters.size() - first, scanner.line(), place);
    pattern.push_back({symbol, static_cast<std::uint16_t>(first)});
  }
  balance.finish();
  return pattern;
}

}  // namespace phytobench
