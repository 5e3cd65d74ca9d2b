// SPDX-License-Identifier: MIT
#include "reports/document_run_origins.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "build_information.hpp"
#include "reports/document_numbers.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

constexpr const char* unknown = "not recorded";

std::string text_at(const ordered_json& environment, const char* key) {
  const auto found = environment.find(key);
  if (found == environment.end()) return unknown;
  return found->is_string() ? found->get<std::string>() : found->dump();
}

std::string processor_of(const ordered_json& environment) {
  const auto machine = environment.find("machine");
  return machine != environment.end() && machine->is_object() ? text_at(*machine, "processor")
                                                              : unknown;
}

bool is_of_changed_source(const ordered_json& environment) {
  return environment.value("source_changed", ordered_json(false)) == true;
}

/// Nothing where there is none, or where the program was built without Git and says "unknown".
std::optional<std::string> recorded_commit(const ordered_json& environment) {
  const auto found = environment.find("commit");
  if (found == environment.end() || !found->is_string()) return std::nullopt;
  const auto commit = found->get<std::string>();
  if (commit.empty() || commit == "unknown") return std::nullopt;
  return commit;
}

std::string commit_of(const ordered_json& environment) {
  return recorded_commit(environment).value_or(unknown) +
         (is_of_changed_source(environment) ? " with changes" : "");
}

/// The runs with their environments read.
class Origins {
 public:
  explicit Origins(const RunOrigins& origins)
      : runs_(origins.runs), without_varying_(origins.without_varying) {
    for (const std::string& text : origins.environments)
      environments_.push_back(ordered_json::parse(text));
  }

  ordered_json facts() {
    add_fact("name in the other files", false,
             [](const auto& run, const auto&) { return run.label; });
    add_fact("tier", false, [](const auto& run, const auto&) {
      return std::string(name_of(run.contents.header.tier));
    });
    add_fact("seed", false,
             [](const auto& run, const auto&) { return std::to_string(run.contents.header.seed); });
    add_fact("experiments", false, [](const auto& run, const auto&) {
      return std::to_string(run.contents.complete_experiments.size());
    });
    add_fact("measurements", false, [](const auto& run, const auto&) {
      return std::to_string(run.contents.records.size());
    });
    if (!without_varying_) add_varying_facts();
    return rows_;
  }

  ordered_json warnings() {
    if (!without_varying_) warn_of_sources();
    warn_of_headers();
    warn_of_experiments();
    return rows_;
  }

 private:
  /// What to say of each run.
  template <class Text>
  std::vector<std::string> texts_of(const Text& text) const {
    std::vector<std::string> texts;
    for (std::size_t run = 0; run < runs_.size(); ++run)
      texts.push_back(text(runs_[run], environments_[run]));
    return texts;
  }

  static bool are_equal(const std::vector<std::string>& texts) {
    return std::set<std::string>(texts.begin(), texts.end()).size() == 1;
  }

  template <class Text>
  void add_fact(const char* name, bool varies, const Text& text) {
    const std::vector<std::string> cells = texts_of(text);
    const bool differs = !are_equal(cells);
    rows_.push_back({{"name", name},
                     {"varies", varies},
                     {"differs", differs},
                     {"cells", cells},
                     {"shared", differs ? "" : cells.front()},
                     {"span", cells.size()}});
  }

  void add_varying_facts() {
    add_fact("compiler", true,
             [](const auto&, const auto& origin) { return text_at(origin, "compiler"); });
    add_fact("processor", true,
             [](const auto&, const auto& origin) { return processor_of(origin); });
    add_fact("commit", true, [](const auto&, const auto& origin) { return commit_of(origin); });
    add_fact("date", true,
             [](const auto&, const auto& origin) { return text_at(origin, "date_utc"); });
    if (std::any_of(runs_.begin(), runs_.end(),
                    [](const auto& run) { return !run.folder.empty(); }))
      add_fact("folder", true, [](const auto& run, const auto&) { return run.folder; });
    add_fact("raw samples of times and memory", true, [](const auto& run, const auto&) {
      return std::to_string(run.contents.timings.size());
    });
    add_fact("flags", true,
             [](const auto&, const auto& origin) { return text_at(origin, "flags"); });
  }

  void warn(std::string text, bool varies) {
    rows_.push_back({{"text", std::move(text)}, {"varies", varies}});
  }

  /// A run that names no commit is like and unlike any other: only the others are compared.
  void warn_of_sources() {
    std::set<std::string> commits;
    std::vector<std::string> named, unnamed, changed;
    for (std::size_t run = 0; run < runs_.size(); ++run) {
      const ordered_json& origin = environments_[run];
      const std::string letter = run_letter(run);
      if (is_of_changed_source(origin)) changed.push_back(letter);
      if (const auto commit = recorded_commit(origin)) {
        commits.insert(*commit);
        named.push_back(letter + ": " + commit_of(origin));
      } else {
        unnamed.push_back(letter);
      }
    }
    if (commits.size() > 1)
      warn_of_commits(named);
    else if (!changed.empty())
      warn(fmt::format("Changes that no commit holds were in the source of {}: the runs may come "
                       "from different code{}.",
                       fmt::join(changed, " and "),
                       unnamed.empty() ? " although they name the same commit" : ""),
           true);
    if (!unnamed.empty())
      warn(fmt::format("No commit is recorded for {}: whether the runs come from the same code "
                       "cannot be told.",
                       fmt::join(unnamed, " and ")),
           true);
  }

  void warn_of_commits(const std::vector<std::string>& named) {
    warn(fmt::format("The runs come from different commits ({}): where they differ, the suite "
                     "itself may have changed between them. All of them are judged by the claims "
                     "of the version that wrote this report ({}, commit {}), and what one of "
                     "those rests on may be absent from a run of another version.",
                     fmt::join(named, ", "), build_information::version, build_information::commit),
         true);
  }

  template <class Value>
  bool differ_in(const Value& value) const {
    return std::any_of(runs_.begin(), runs_.end(), [&](const ComparedRun& run) {
      return value(run.contents.header) != value(runs_.front().contents.header);
    });
  }

  void warn_of_headers() {
    if (differ_in([](const RunHeader& header) { return header.tier; }))
      warn(
          "The runs are of different tiers: a claim of a higher tier is decided by the others "
          "alone, and measurements that depend on the tier differ.",
          false);
    if (differ_in([](const RunHeader& header) { return header.seed; }))
      warn("The runs have different seeds: measurements that rest on random numbers differ.",
           false);
  }

  void warn_of_experiments() {
    std::set<std::string> all;
    for (const ComparedRun& run : runs_)
      all.insert(run.contents.complete_experiments.begin(),
                 run.contents.complete_experiments.end());
    std::vector<std::string> lacking;
    for (std::size_t run = 0; run < runs_.size(); ++run)
      if (const auto own = runs_[run].contents.complete_experiments.size(); own < all.size())
        lacking.push_back(
            fmt::format("{} lacks {}", run_letter(run), counted(all.size() - own, "experiment")));
    if (!lacking.empty())
      warn(fmt::format("The runs did not run the same: of {} that any of them ran, {}. Claims on "
                       "those are decided by the other runs alone.",
                       counted(all.size(), "experiment"), fmt::join(lacking, ", ")),
           false);
  }

  std::span<const ComparedRun> runs_;
  bool without_varying_;
  std::vector<ordered_json> environments_;
  ordered_json rows_ = ordered_json::array();
};

}  // namespace

ordered_json run_facts(const RunOrigins& origins) {
  return Origins(origins).facts();
}

ordered_json run_warnings(const RunOrigins& origins) {
  return Origins(origins).warnings();
}

}  // namespace phytobench
