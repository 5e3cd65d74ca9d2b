// SPDX-License-Identifier: MIT
// What can be counted in the list of references: entries and where the text names them, years, and
// the author's own papers.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "experiments/experiment.hpp"
#include "reference/data_folder.hpp"
#include "reference/toml_table.hpp"

namespace phytobench::experiments::alsweis {

namespace {

void record_entries(ExperimentContext& context, const TomlTable& list) {
  const std::vector<double> years = list.numbers("years");
  const TomlTable named_in = list.table("named-in");
  std::set<double> named;
  for (const std::string& part : named_in.keys())
    for (const double number : named_in.numbers(part)) named.insert(number);
  const auto has_entry = [&](double number) {
    return number == std::floor(number) && number >= 1.0 &&
           number <= static_cast<double>(years.size());
  };
  const auto named_entries = std::count_if(named.begin(), named.end(), has_entry);
  context.record("entries/count", whole(years.size()), "entries");
  context.record("entries/named", static_cast<std::int64_t>(named_entries), "entries");
  context.record("entries/named-but-missing",
                 static_cast<std::int64_t>(named.size()) - named_entries, "entries");
  context.record("entries/latest-year", *std::max_element(years.begin(), years.end()), "year");
}

/// Letters and digits alone, small, with one spelling of -ise and -ize.
std::string plain(const std::string& title) {
  std::string text;
  for (const char c : title) {
    const auto code = static_cast<unsigned char>(c);
    if (std::isalnum(code)) text += c == 'z' ? 's' : static_cast<char>(std::tolower(code));
  }
  return text;
}

/// Papers of the author that stand twice, and pages that two of them are said to have.
void record_own_papers(ExperimentContext& context, const TomlTable& own) {
  std::set<std::string> papers, listed;
  std::map<std::string, std::set<std::string>> with_pages;
  const std::vector<double> wanted = own.numbers("listed");
  const std::vector<TomlTable> entries = own.tables("entry");
  for (const TomlTable& entry : entries) {
    const std::string paper = plain(entry.text("title"));
    papers.insert(paper);
    if (std::find(wanted.begin(), wanted.end(), entry.number("number")) != wanted.end())
      listed.insert(paper);
    if (const std::string pages = entry.text("pages"); !pages.empty())
      with_pages[pages].insert(paper);
  }
  const auto shared = std::count_if(with_pages.begin(), with_pages.end(),
                                    [](const auto& pages) { return pages.second.size() > 1; });
  context.record("own/entries", whole(entries.size()), "entries");
  context.record("own/papers", whole(papers.size()), "papers");
  context.record("own/listed", whole(listed.size()), "papers");
  context.record("own/pages-of-two-papers", static_cast<std::int64_t>(shared));
}

/// A paper cannot be older than what it names.
void record_wrong_year(ExperimentContext& context, const TomlTable& list) {
  const TomlTable wrong = list.table("dated-too-early");
  const double printed =
      list.numbers("years").at(static_cast<std::size_t>(wrong.number("number")) - 1);
  const double latest = wrong.number("latest_year_it_names");
  context.record("wrong-year/as-printed", printed - latest, "year");
  context.record("wrong-year/corrected", wrong.number("corrected_year") - latest, "year");
}

void run(ExperimentContext& context) {
  const TomlTable list = TomlTable::read(paper_folder("alsweis") / "references.toml");
  record_entries(context, list);
  record_own_papers(context, list.table("own"));
  record_wrong_year(context, list);
}

}  // namespace

extern const ExperimentDescriptor reference_list;
constinit const ExperimentDescriptor reference_list{
    .id = "alsweis/reference-list",
    .question = "Is the list of references complete, and does it contradict itself?",
    .source = "[Alsweis] section 1.2, list of references",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
