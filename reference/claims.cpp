// SPDX-License-Identifier: MIT
#include "reference/claims.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "reference/claim_bases.hpp"
#include "reference/data_folder.hpp"
#include "reference/toml_table.hpp"

namespace phytobench {

namespace {

constexpr std::array<std::string_view, 8> kinds = {
    "value", "count", "ratio", "ordering", "exponent", "identity", "distribution", "qualitative"};
constexpr std::array<std::string_view, 7> whys = {
    "chosen bound",   "exact",          "printed rounding", "figure reading",
    "sampling error", "floating point", "stated bound"};
constexpr std::array<std::string_view, 3> tiers = {"smoke", "quick", "full"};
constexpr std::array<std::string_view, 2> origins = {"published", "derived"};
constexpr std::array<std::string_view, 8> subjects = {
    "value", "ratio", "ratio-of-ratios", "sum", "same", "different", "exponent", "matches"};

/// The text of a key, which must be one of the words.
template <std::size_t Count>
std::size_t word(const TomlTable& table, const std::string& key,
                 const std::array<std::string_view, Count>& words) {
  const std::string text = table.text(key);
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end())
    table.fail(fmt::format("'{}' is '{}'; use one of: {}", key, text, fmt::join(words, ", ")));
  return static_cast<std::size_t>(found - words.begin());
}

Verdict verdict_of(const TomlTable& table, const std::string& key) {
  const std::string text = table.text(key);
  for (const Verdict verdict : all_verdicts)
    if (text == name_of(verdict)) return verdict;
  table.fail(fmt::format("'{}' is '{}', which is no verdict", key, text));
}

std::string full_id(const std::string& measurement, const std::string& paper) {
  const bool is_signed = measurement.starts_with('+') || measurement.starts_with('-');
  const std::string sign = is_signed ? measurement.substr(0, 1) : "";
  return sign + paper + "/" + measurement.substr(sign.size());
}

void check_term_size(const TomlTable& table, CheckSubject subject, std::size_t size) {
  const bool right = subject == CheckSubject::value             ? size == 1
                     : subject == CheckSubject::matches         ? size == 1
                     : subject == CheckSubject::ratio           ? size == 2
                     : subject == CheckSubject::ratio_of_ratios ? size == 4
                     : subject == CheckSubject::exponent        ? size >= 6 && size % 2 == 0
                                                                : size >= 2;
  if (!right) table.fail("a term of this check has the wrong number of measurements");
}

/// Bounds that contradict each other, or that the subject cannot have.
void check_bounds(const TomlTable& table, const ClaimCheck& check) {
  const bool counts = check.subject == CheckSubject::matches;
  if (counts && !(check.equals_text && (check.low || check.high || check.equals)))
    table.fail("'matches' needs 'equals_text', and bounds of how many there are");
  const std::vector<double>& steps = check.accident_steps;
  if (!steps.empty() && !(counts && steps.size() == 2 && steps[0] >= 1.0 && steps[1] >= 1.0))
    table.fail("'accident_steps' are two numbers of at least 1 and go with of = \"matches\" only");
  const int forms = (check.low || check.high ? 1 : 0) + (check.equals ? 1 : 0) +
                    (check.equals_text && !counts ? 1 : 0);
  if (forms > 1) table.fail("use either 'low' and 'high', or 'equals', or 'equals_text'");
  if (check.low && check.high && !(*check.low <= *check.high))
    table.fail("'low' must not exceed 'high'");
  if (check.equals_text && check.subject != CheckSubject::value && !counts)
    table.fail("'equals_text' goes with of = \"value\" or \"matches\" only");
}

ClaimCheck check_from(const TomlTable& table, const std::string& paper) {
  table.allow_only(
      {"of", "terms", "low", "high", "equals", "equals_text", "accident_steps", "required", "why"});
  ClaimCheck check;
  check.subject = static_cast<CheckSubject>(word(table, "of", subjects));
  for (const std::vector<std::string>& term : table.text_lists("terms")) {
    check_term_size(table, check.subject, term.size());
    for (const std::string& measurement : term)
      if ((measurement.starts_with('+') || measurement.starts_with('-')) !=
          (check.subject == CheckSubject::sum))
        table.fail("the measurements of a sum, and only those, start with + or -");
    std::vector<std::string> full;
    for (const std::string& measurement : term) full.push_back(full_id(measurement, paper));
    check.terms.push_back(std::move(full));
  }
  check.low = table.number_if_given("low");
  check.high = table.number_if_given("high");
  check.equals = table.number_if_given("equals");
  if (table.has("equals_text")) check.equals_text = table.text("equals_text");
  if (table.has("accident_steps")) check.accident_steps = table.numbers("accident_steps");
  const bool compares =
      check.subject == CheckSubject::same || check.subject == CheckSubject::different;
  const bool bounded = check.low || check.high || check.equals || check.equals_text;
  if (compares == bounded || check.terms.empty())
    table.fail("a check needs terms, and bounds unless it is 'same' or 'different'");
  check_bounds(table, check);
  const double required =
      table.number_if_given("required").value_or(static_cast<double>(check.terms.size()));
  if (!(required >= 1.0 && required <= static_cast<double>(check.terms.size())) ||
      required != std::floor(required))
    table.fail("'required' must be a whole number between 1 and the number of terms");
  check.required = static_cast<std::size_t>(required);
  check.why = whys[word(table, "why", whys)];
  return check;
}

Claim claim_from(const TomlTable& table, const std::string& paper) {
  table.allow_only({"id", "locator", "kind", "text", "published", "unit", "digits", "basis", "tier",
                    "expected_verdict", "predicted_verdict", "difference", "machine_dependence",
                    "missing_model", "erratum", "verdict", "reason", "check"});
  Claim claim;
  claim.id = table.text("id");
  if (claim.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789./_-") != std::string::npos ||
      !claim.id.starts_with(paper + "/"))
    table.fail(
        fmt::format("id '{}' must start with '{}/' and use only a-z 0-9 . / _ -", claim.id, paper));
  claim.paper = paper;
  claim.locator = table.text("locator");
  claim.kind = kinds[word(table, "kind", kinds)];
  claim.text = table.text("text");
  claim.published = table.text("published");
  claim.unit = table.text_or("unit", "1");
  if (const auto digits = table.number_if_given("digits")) claim.digits = static_cast<int>(*digits);
  claim.basis = claim_bases[word(table, "basis", claim_bases)];
  claim.tier = static_cast<Tier>(word(table, "tier", tiers));
  claim.expected_verdict = verdict_of(table, "expected_verdict");
  claim.predicted_verdict = verdict_of(table, "predicted_verdict");
  claim.difference = table.text_or("difference", "");
  claim.machine_dependence = table.text_or("machine_dependence", "");
  claim.missing_model = table.text_or("missing_model", "");
  claim.erratum = table.text_or("erratum", "");
  claim.reason = table.text("reason");
  for (const TomlTable& check : table.tables("check"))
    claim.checks.push_back(check_from(check, paper));
  if (table.has("verdict")) claim.fixed_verdict = verdict_of(table, "verdict");
  if (claim.fixed_verdict.has_value() != claim.checks.empty())
    table.fail("a claim has either checks or a fixed verdict");
  if (claim.reason.empty()) table.fail("a claim needs a reason");
  if (claim.difference.empty() != (claim.predicted_verdict == claim.expected_verdict))
    table.fail(
        "'difference' says why the expected verdict is not the predicted one, and only then");
  if (!claim.machine_dependence.empty() && claim.tier == Tier::smoke)
    table.fail("'machine_dependence' is for claims on times, which no smoke run measures");
  if (!claim.missing_model.empty() && claim.fixed_verdict != Verdict::not_measured)
    table.fail("'missing_model' goes with verdict = \"not measured\" only");
  return claim;
}

PublishedTable published_table_from(const TomlTable& table, const std::string& paper) {
  table.allow_only({"id", "title", "unit", "note", "rows", "columns", "row_labels", "column_labels",
                    "measurement", "values", "companions", "per", "origin", "discussion"});
  PublishedTable result{.id = table.text("id"),
                        .paper = paper,
                        .title = table.text("title"),
                        .unit = table.text("unit"),
                        .note = table.text_or("note", ""),
                        .rows = table.texts("rows"),
                        .columns = table.texts("columns"),
                        .row_labels = table.texts("row_labels"),
                        .column_labels = table.texts("column_labels"),
                        .measurement = full_id(table.text("measurement"), paper),
                        .companions = table.has("companions") ? table.texts("companions")
                                                              : std::vector<std::string>{},
                        .per = table.text_or("per", ""),
                        .origin = std::string(origins[word(table, "origin", origins)]),
                        .discussion = table.text_or("discussion", ""),
                        .values = table.number_lists("values")};
  const bool fits = result.values.size() == result.rows.size() &&
                    result.row_labels.size() == result.rows.size() &&
                    result.column_labels.size() == result.columns.size() &&
                    std::all_of(result.values.begin(), result.values.end(), [&](const auto& row) {
                      return row.size() == result.columns.size();
                    });
  if (!fits) table.fail("rows, columns, labels and values of the table do not fit together");
  return result;
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const std::size_t place = text.find(what);
  return place == std::string::npos ? text : text.replace(place, what.size(), with);
}

}  // namespace

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduced:
      return "reproduced";
    case Verdict::reproduced_with_erratum:
      return "reproduced with erratum";
    case Verdict::not_reproduced:
      return "not reproduced";
    case Verdict::inconclusive:
      return "inconclusive";
    case Verdict::not_comparable:
      return "not comparable";
    case Verdict::underspecified:
      return "underspecified";
    case Verdict::not_measured:
      return "not measured";
  }
  return "unknown";
}

std::string measurement_of(const ClaimCheck& check, const std::string& part) {
  return check.subject == CheckSubject::sum ? part.substr(1) : part;
}

std::string PublishedTable::measurement_at(std::size_t row, std::size_t column) const {
  return replaced(replaced(measurement, "{row}", rows[row]), "{column}", columns[column]);
}

std::string PublishedTable::companion_at(std::size_t row, std::size_t column,
                                         const std::string& companion) const {
  const std::string own = measurement_at(row, column);
  return own.substr(0, own.rfind('/') + 1) + companion;
}

PaperClaims load_claims_file(const std::string& file, const std::string& paper) {
  const TomlTable root = TomlTable::read(file);
  root.allow_only({"topic", "order", "claim", "table"});
  const std::string topic = root.text_or("topic", "");
  PaperClaims result;
  result.order = root.number_if_given("order").value_or(0.0);
  std::set<std::string> ids;
  for (const TomlTable& table : root.tables("claim")) {
    result.claims.push_back(claim_from(table, paper));
    result.claims.back().topic = topic;
    if (!ids.insert(result.claims.back().id).second)
      table.fail(fmt::format("claim '{}' stands here twice", result.claims.back().id));
  }
  std::set<std::string> table_ids;
  for (const TomlTable& table : root.tables("table")) {
    result.tables.push_back(published_table_from(table, paper));
    if (!table_ids.insert(result.tables.back().id).second)
      table.fail(fmt::format("table '{}' stands here twice", result.tables.back().id));
  }
  return result;
}

PaperClaims load_claims(const std::string& paper) {
  std::vector<std::pair<std::filesystem::path, PaperClaims>> files;
  for (const std::filesystem::path& file : paper_files(paper, "claims"))
    files.emplace_back(file, load_claims_file(file.string(), paper));
  std::stable_sort(files.begin(), files.end(),
                   [](const auto& a, const auto& b) { return a.second.order < b.second.order; });
  PaperClaims all;
  std::set<std::string> ids;
  for (auto& [file, part] : files) {
    for (Claim& claim : part.claims) {
      if (!ids.insert(claim.id).second)
        throw InputError(fmt::format("{}: claim '{}' stands in another file of the paper, too",
                                     file.string(), claim.id));
      all.claims.push_back(std::move(claim));
    }
    std::move(part.tables.begin(), part.tables.end(), std::back_inserter(all.tables));
  }
  return all;
}

}  // namespace phytobench
