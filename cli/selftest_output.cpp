// SPDX-License-Identifier: MIT
#include "cli/selftest_output.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/option_values.hpp"
#include "core/record/environment.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

ordered_json tally_json(const VerdictTally& tally, int wanted) {
  return {{"wanted", wanted},       {"compared", tally.all()}, {"slower", tally.slower},
          {"faster", tally.faster}, {"same", tally.same},      {"inconclusive", tally.inconclusive},
          {"other", tally.other}};
}

ordered_json share_json(const Estimate& share) {
  return {{"share", share.value}, {"low", share.low}, {"high", share.high}};
}

std::string share_text(const Estimate& share) {
  return fmt::format("{:.0f} % (95 %: {:.0f} to {:.0f} %)", 100.0 * share.value, 100.0 * share.low,
                     100.0 * share.high);
}

std::string counts_text(const VerdictTally& tally) {
  return fmt::format("{} comparisons: {} same, {} inconclusive, {} slower, {} faster\n",
                     tally.all(), tally.same, tally.inconclusive, tally.slower, tally.faster);
}

std::string equal_sides_text(const InstrumentCheck& check) {
  if (check.alike.all() + check.usual.all() == 0)
    return "This build against itself: no comparison was made\n";
  std::string text = "This build against itself, " + counts_text(check.alike);
  if (check.wanted_usual > 0)
    text += fmt::format("The same as compare does it, with {} benchmarks in each, {}",
                        check.usual_names.size(), counts_text(check.usual));
  return text + fmt::format("  false alarms: {}, at most {:.0f} % are allowed\n",
                            share_text(false_alarms(check)), 100.0 * most_false_alarms);
}

std::string handicapped_text(const InstrumentCheck& check) {
  const std::string loss = fmt::format("{:.0f} %", 100.0 * check.handicap);
  if (check.handicapped.all() == 0)
    return "This build against itself slowed down by " + loss + ": no comparison was made\n";
  return fmt::format(
      "This build against itself slowed down by {}, {} comparisons: {} slower, {} inconclusive, {} "
      "same, {} faster\n  found: {}, at least {:.0f} % are demanded; median of what was found: "
      "{:+.1f} %\n",
      loss, check.handicapped.all(), check.handicapped.slower, check.handicapped.inconclusive,
      check.handicapped.same, check.handicapped.faster, share_text(found_handicaps(check)),
      100.0 * least_found, 100.0 * check.found_handicap);
}

}  // namespace

std::string selftest_json(const InstrumentCheck& check, const InstrumentVerdict& verdict,
                          const SelftestOptions& options) {
  ordered_json json{{"schema", "phytobench/selftest-1"},
                    {"state", name_of(verdict.state)},
                    {"reasons", verdict.reasons}};
  json["alike"] = tally_json(check.alike, check.wanted_alike);
  json["usual"] = tally_json(check.usual, check.wanted_usual);
  json["usual"]["benchmarks"] = check.usual_names;
  json["handicapped"] = tally_json(check.handicapped, check.wanted_handicapped);
  json["false_alarms"] = nullptr;
  if (check.alike.all() + check.usual.all() > 0)
    json["false_alarms"] = share_json(false_alarms(check));
  json["found_handicaps"] = nullptr;
  if (check.handicapped.all() > 0) json["found_handicaps"] = share_json(found_handicaps(check));
  json["handicap"] = check.handicap;
  json["found_handicap"] = check.found_handicap;
  json["noise_floor"] = check.noise_floor;
  json["refusals"] = ordered_json::array();
  for (const RefusalCheck& refusal : check.refusals)
    json["refusals"].push_back({{"benchmark", refusal.benchmark},
                                {"demanded", refusal.demanded},
                                {"found", refusal.found},
                                {"refused", refusal.is_refused}});
  json["seed"] = options.seed;
  json["seconds"] = check.seconds;
  json["environment"] =
      ordered_json::parse(environment_json(options.command_line, options.seed, 1));
  return json_text(json) + "\n";
}

std::string selftest_text(const InstrumentCheck& check, const InstrumentVerdict& verdict) {
  std::string text;
  for (const RefusalCheck& refusal : check.refusals)
    text += fmt::format("{:<26} {}: {}\n", refusal.benchmark,
                        refusal.is_refused ? "as demanded" : "NOT AS DEMANDED", refusal.found);
  text += equal_sides_text(check) + handicapped_text(check);
  text += fmt::format(
      "Equal things differ by up to {:.1f} % on this machine (median over the comparisons of fixed "
      "work)\n"
      "{:.0f} s\n\nThe instrument is {}.\n",
      100.0 * check.noise_floor, check.seconds, name_of(verdict.state));
  for (const std::string& reason : verdict.reasons) text += "  " + reason + "\n";
  return text;
}

}  // namespace phytobench::cli
