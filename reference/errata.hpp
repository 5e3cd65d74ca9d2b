// SPDX-License-Identifier: MIT
// Misprints and missing cases of a paper (reference/papers/<key>/errata.toml, or errata/*.toml).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace phytobench {

/// A number that shows an erratum: an oracle evaluated as printed and as corrected.
struct CounterExample {
  std::string oracle;  ///< "equation-22": as in reference/errata_test.cpp
  std::vector<double> arguments;
  std::vector<std::string> inputs;  ///< what each argument is: "radius of the smaller disc"
  std::string result;               ///< what both forms compute: "area of the overlap"
  std::optional<double> printed;    ///< absent where the printed form is undefined
  double corrected = 0.0;
  double tolerance = 0.0;
  std::string why;               ///< the example in words
  std::string tolerance_reason;  ///< "exact", "printed rounding"; empty: `why` says it
};

/// What sort of mistake it is.
enum class ErratumKind {
  formula,       ///< a formula, or a sentence about one, gives something else than is meant
  number,        ///< a printed number, or a part of the work that it is ascribed to
  missing_case,  ///< what is printed has no value, or no sense, for some inputs
  wording,       ///< a word or sentence that contradicts the rest of the work
  bookkeeping,   ///< labels, references, symbols
  program,       ///< sound as printed, but the program of the work does something else
};

/// "missing case", "differs from the program", ...: always words.
std::string name_of(ErratumKind kind);

struct Erratum {
  std::string id;
  std::string paper;
  std::string section;  ///< "3.4.4", "A": the order of errata in the work; empty: unknown
  std::string locator;  ///< "eq. 9", "fig. 4.5, caption"
  std::optional<ErratumKind> kind;
  std::string printed;
  std::string corrected;  ///< of kind program: what the program does
  std::string consequence;
  std::string check;       ///< how a reader checks it without this suite; empty: not written yet
  std::string confidence;  ///< "certain" or "probable"
  std::vector<std::string> claims;
  std::optional<CounterExample> counter_example;
};

/// In the order of the files and of the entries in them. Throws InputError with file and line for a
/// missing or unknown key, an unknown word, a duplicate id, or inputs that do not name each
/// argument.
std::vector<Erratum> load_errata(const std::string& paper);

/// Whether a section ("2.4.3", "A") stands before another in a work: by numbers, appendices after
/// chapters, unknown sections last.
bool section_is_before(const std::string& a, const std::string& b);

}  // namespace phytobench
