// SPDX-License-Identifier: MIT
// Letters, modules and words as they are written in a text.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/lsystem/expression_parser.hpp"
#include "core/lsystem/line_scanner.hpp"
#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// What a letter can be: any printable ASCII character but blanks and ( ) , : < > = # *, the
/// queries ?P ?H ?L ?U, and whatever is declared.
class Alphabet {
 public:
  /// Reads letters up to the end, with blanks or commas between them, perhaps all in { }. Letters
  /// of one ASCII character need no declaration. Throws InputError.
  void declare(LineScanner& scanner);
  /// The letter that comes next, the longest that fits. Throws InputError if it is none.
  std::string_view take_letter(LineScanner& scanner) const;

 private:
  void add(LineScanner& scanner, std::string_view letter);

  std::vector<std::string> declared_;  ///< long ones first
};

/// Gives symbols their indices in order of their first use.
class SymbolTable {
 public:
  explicit SymbolTable(std::vector<Symbol>& symbols) : symbols_(symbols) {}

  /// Adds the symbol unless it is there. Throws InputError with that place if there are too many.
  SymbolIndex index_of(std::string_view letter, std::size_t arity, const SourceLine& line,
                       std::size_t place);

 private:
  std::vector<Symbol>& symbols_;
  std::map<std::pair<std::string, std::size_t>, SymbolIndex> indices_;
};

/// What reading a module needs to know and adds to.
struct ModuleContext {
  const Alphabet& alphabet;
  SymbolTable& symbols;
  const Constants& constants;
};

/// A word up to the end, with brackets [ ] and { } that match. A plain name that stands for nothing
/// is 0 as a parameter of a query. Throws InputError.
std::vector<SuccessorModule> parse_word(LineScanner& scanner, const ModuleContext& context,
                                        const ExpressionScope& scope);

enum class PatternBrackets {
  refused,   ///< left contexts, predecessors
  balanced,  ///< right contexts: branches
};

/// Modules up to '<', '>' or the end; their parameters are names, which are added to `parameters`.
/// Throws InputError.
std::vector<PatternModule> parse_pattern(LineScanner& scanner, const ModuleContext& context,
                                         PatternBrackets brackets,
                                         std::vector<std::string>& parameters);

}  // namespace phytobench
