// SPDX-License-Identifier: MIT
// What a paper claims (reference/papers/<key>/claims/*.toml). Only reports/ and tests may include
// this: no experiment can be tuned to a number it cannot see.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/record/record.hpp"

namespace phytobench {

enum class Verdict {
  reproduced,
  reproduced_with_erratum,
  not_reproduced,
  inconclusive,
  not_comparable,
  underspecified,
  not_measured,
};
inline constexpr Verdict all_verdicts[] = {
    Verdict::reproduced,   Verdict::reproduced_with_erratum, Verdict::not_reproduced,
    Verdict::inconclusive, Verdict::not_comparable,          Verdict::underspecified,
    Verdict::not_measured};

/// "reproduced with erratum", ...: always words.
std::string_view name_of(Verdict verdict);

/// What one check compares.
enum class CheckSubject {
  value,            ///< each term {m}
  ratio,            ///< each term {a, b}: a / b
  ratio_of_ratios,  ///< each term {a, b, c, d}: (a / b) / (c / d)
  sum,              ///< each term {"+a", "-b", ...}
  same,             ///< all measurements of a term are identical
  different,        ///< not all measurements of a term are identical
  exponent,         ///< each term {y1, x1, y2, x2, y3, x3, ...}: k of the fit y = c x^k
  matches,          ///< each term {prefix}: how many measurements that start so are `equals_text`
};

/// One condition on measurements; its bounds are inclusive.
struct ClaimCheck {
  CheckSubject subject = CheckSubject::value;
  std::vector<std::vector<std::string>> terms;  ///< full measurement ids (with sign for sum)
  std::optional<double> low;
  std::optional<double> high;
  std::optional<double> equals;
  std::optional<std::string> equals_text;
  /// Of `matches` with texts of two whole numbers: the steps in which each of them varies. Says how
  /// many matches to expect by accident.
  std::vector<double> accident_steps;
  std::size_t required = 0;  ///< how many terms must hold
  std::string why;           ///< kind of reason for the bounds
};

/// The measurement that a part of a term names: without the sign it has in a sum. Of `matches` it
/// is the start of their names.
std::string measurement_of(const ClaimCheck& check, const std::string& part);

struct Claim {
  std::string id;
  std::string paper;
  std::string locator;
  std::string kind;
  std::string text;
  std::string published;
  std::string unit;
  std::optional<int> digits;
  std::string basis;
  Tier tier = Tier::smoke;
  Verdict expected_verdict = Verdict::reproduced;
  /// The verdict we predicted from the text; what the run gives is compared
  /// with it in the report. Every claim of a file has one.
  std::optional<Verdict> predicted_verdict;
  std::string difference;  ///< why the expected verdict is not the predicted one; else empty
  /// Of a claim on times: on which processors it came out how. Such a verdict is nowhere
  /// unexpected.
  std::string machine_dependence;
  std::string missing_model;  ///< model that is not built yet and keeps it unmeasured; else empty
  std::string topic;          ///< heading of its file
  std::string erratum;        ///< id of the erratum that makes it hold; empty: none
  std::optional<Verdict> fixed_verdict;  ///< for claims without checks
  std::string reason;
  std::vector<ClaimCheck> checks;
};

/// A published table, to be shown in its own layout beside what was measured.
struct PublishedTable {
  std::string id;
  std::string paper;
  std::string title;
  std::string unit;
  std::string note;
  std::vector<std::string> rows, columns, row_labels, column_labels;
  std::string measurement;  ///< pattern with {row} and {column}, full id
  std::vector<std::string>
      companions;          ///< other quantities of the same cells: last part of their ids
  std::string per;         ///< companion the values are also divided by; empty: none
  std::string origin;      ///< "published" or "derived" (by us, before the run)
  std::string discussion;  ///< why ours differs, in our words; empty: nothing to say
  std::vector<std::vector<double>> values;

  std::string measurement_at(std::size_t row, std::size_t column) const;
  std::string companion_at(std::size_t row, std::size_t column, const std::string& companion) const;
};

struct PaperClaims {
  std::vector<Claim> claims;
  std::vector<PublishedTable> tables;
  double order = 0.0;  ///< of a file: its place among the paper's files
};

/// In the order of the files' `order` (root key, with `topic`), then of their names. Throws
/// InputError with file and line for a missing or unknown key, an unknown word, a duplicate id, a
/// claim with neither checks nor fixed verdict, a check without bounds, or a prediction that did
/// not come true without a word why.
PaperClaims load_claims(const std::string& paper);

/// The same from a file; `paper` prefixes the measurements.
PaperClaims load_claims_file(const std::string& file, const std::string& paper);

}  // namespace phytobench
