// SPDX-License-Identifier: MIT
#include "core/lsystem/read_lsystem.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/contract/parameter_keys.hpp"
#include "core/contract/text_file.hpp"
#include "core/lsystem/lsystem_settings.hpp"
#include "core/lsystem/production_groups.hpp"
#include "core/lsystem/production_parser.hpp"

namespace phytobench {

namespace {

constexpr std::size_t most_file_bytes = 1 << 20;
constexpr std::size_t most_productions = std::numeric_limits<std::uint16_t>::max();

class LSystemReader {
 public:
  LSystemReader(std::string_view text, std::string_view name)
      : name_(name), lines_(source_lines(text, name_)) {
    system_.source = name_;
  }

  LSystem read() {
    for (const SourceLine& line : lines_) sort(line);
    for (const LineSetting& setting : settings_)
      if (setting.kind == SettingKind::alphabet) read_alphabet(setting);
    for (const SourceLine* line : constant_lines_) read_constant(*line);
    for (const LineSetting& setting : settings_) read_setting(setting);
    settle_draw_and_move(system_, settings_);
    if (system_.axiom.empty())
      throw InputError(fmt::format("{}: no axiom; add a line such as 'axiom: F'", name_));
    for (const ProductionLine& line : production_lines_) read_production(line);
    hide_ignored();
    number_groups(system_);
    return std::move(system_);
  }

 private:
  struct ProductionLine {
    const SourceLine* line;
    Arrow arrow;
  };

  ModuleContext context() { return {alphabet_, symbols_, constants_}; }

  /// By the kind of statement; the kinds are read one after the other.
  void sort(const SourceLine& line) {
    if (const auto arrow = find_arrow(line.text)) {
      production_lines_.push_back({&line, *arrow});
    } else if (is_constant(line)) {
      constant_lines_.push_back(&line);
    } else {
      for (const LineSetting& setting : line_settings(line)) {
        refuse_second(setting);
        settings_.push_back(setting);
      }
    }
  }

  static bool is_constant(const SourceLine& line) {
    LineScanner scanner(line);
    return !scanner.take_name().empty() && scanner.next_is("=") && !scanner.next_is("==");
  }

  void refuse_second(const LineSetting& setting) const {
    if (setting.kind == SettingKind::alphabet || setting.kind == SettingKind::ignore) return;
    const bool is_axiom = setting.kind == SettingKind::axiom;
    for (const LineSetting& earlier : settings_)
      if (earlier.key == setting.key || (is_axiom && earlier.kind == SettingKind::axiom))
        setting.line->fail(setting.key_offset,
                           fmt::format("a second {}, as in line {}; remove one",
                                       is_axiom ? "axiom" : fmt::format("'{}:'", setting.key),
                                       earlier.line->place(earlier.key_offset).line));
  }

  void read_alphabet(const LineSetting& setting) {
    LineScanner scanner = setting.value();
    alphabet_.declare(scanner);
  }

  void read_constant(const SourceLine& line) {
    LineScanner scanner(line);
    const std::size_t place = scanner.offset();
    const std::string_view name = scanner.take_name();
    const std::string shown = in_one_line(name, 40);
    scanner.take("=");
    if (is_setting(name))
      line.fail(place, fmt::format("'{}' is a key; write '{}: ...', or name the constant otherwise",
                                   name, name));
    if (is_function_name(name))
      line.fail(place, fmt::format("'{}' is a function; name the constant otherwise", name));
    const double value = parse_constant(scanner, constants_);
    if (!scanner.at_end())
      scanner.fail(fmt::format("{} behind the value of '{}'; a constant has a line of its own",
                               scanner.next_shown(), shown));
    if (!constants_.emplace(name, value).second)
      line.fail(place, fmt::format("a second constant '{}'; remove one", shown));
  }

  void read_setting(const LineSetting& setting) {
    LineScanner scanner = setting.value();
    if (setting.kind == SettingKind::axiom) {
      read_axiom(scanner);
    } else if (setting.kind == SettingKind::ignore) {
      read_ignored(scanner);
    } else if (setting.kind == SettingKind::value) {
      assign_value(system_, setting, alphabet_, constants_);
    }
  }

  void read_axiom(LineScanner& scanner) {
    for (const SuccessorModule& module :
         parse_word(scanner, context(), {.constants = constants_})) {
      AxiomModule own;
      own.symbol = module.symbol;
      for (const Expression& parameter : module.parameters)
        own.parameters.push_back(parameter.evaluate(nullptr));
      system_.axiom.push_back(std::move(own));
    }
  }

  void read_ignored(LineScanner& scanner) {
    for (const ListedLetter& listed : parse_letters(scanner, alphabet_)) {
      if (listed.letter == "[" || listed.letter == "]")
        scanner.line().fail(listed.place,
                            "brackets cannot be ignored; contexts step over branches "
                            "by themselves");
      ignored_letters_.emplace_back(listed.letter);
    }
  }

  void read_production(const ProductionLine& line) {
    if (system_.productions.size() == most_productions)
      line.line->fail(0, fmt::format("more than {} productions; remove some", most_productions));
    Production production = parse_production(*line.line, line.arrow, context());
    if (production.label.empty())
      production.label = fmt::format("p{}", system_.productions.size() + 1);
    system_.productions.push_back(std::move(production));
  }

  void hide_ignored() {
    for (const Symbol& symbol : system_.symbols)
      system_.ignored.push_back(std::find(ignored_letters_.begin(), ignored_letters_.end(),
                                          symbol.letter) != ignored_letters_.end());
  }

  std::string name_;
  std::vector<SourceLine> lines_;
  std::vector<ProductionLine> production_lines_;
  std::vector<const SourceLine*> constant_lines_;
  std::vector<LineSetting> settings_;
  Alphabet alphabet_;
  Constants constants_;
  std::vector<std::string> ignored_letters_;
  LSystem system_;
  SymbolTable symbols_{system_.symbols};
};

}  // namespace

LSystem parse_lsystem(std::string_view text, std::string_view name) {
  if (text.size() > most_file_bytes)
    throw InputError(fmt::format("{}: is larger than {} bytes; this cannot be the right text", name,
                                 most_file_bytes));
  return LSystemReader(text, name).read();
}

LSystem read_lsystem(const std::filesystem::path& file) {
  return parse_lsystem(read_text_file(file, most_file_bytes), file.string());
}

}  // namespace phytobench
