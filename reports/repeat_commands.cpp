// SPDX-License-Identifier: MIT
#include "reports/repeat_commands.hpp"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include <fmt/format.h>

namespace phytobench {

namespace {

constexpr std::array<std::string_view, 4> options_with_a_value = {"--tier", "--seed", "--threads",
                                                                  "--out"};

/// Every id has a slash, and without one only a glob can name experiments: what else stands in the
/// command line belongs to a path with spaces.
bool can_select(const std::string& word) {
  return word.find_first_of("/*?[") != std::string::npos;
}

std::string quoted_for_shell(const std::string& word) {
  return word.find_first_of("*?[]") == std::string::npos ? word : "'" + word + "'";
}

}  // namespace

std::vector<std::string> selection_of(const std::string& command_line) {
  std::istringstream words(command_line);
  std::string word;
  std::vector<std::string> selection;
  if (!(words >> word >> word) || word != "run") return selection;
  while (words >> word) {
    const bool has_value = std::find(options_with_a_value.begin(), options_with_a_value.end(),
                                     word) != options_with_a_value.end();
    if (has_value)
      words >> word;
    else if (!word.starts_with("-") && can_select(word))
      selection.push_back(quoted_for_shell(word));
  }
  return selection;
}

std::string repeat_run(const std::vector<std::string>& selection, Tier tier, std::uint64_t seed) {
  std::string command = "phytobench run";
  for (const std::string& word : selection) command += " " + word;
  return command + fmt::format(" --tier {} --seed {} --out results/again", name_of(tier), seed);
}

std::vector<std::string> experiments_of(const Claim& claim) {
  std::vector<std::string> experiments;
  for (const ClaimCheck& check : claim.checks)
    for (const auto& term : check.terms)
      for (const std::string& part : term) {
        const std::size_t start = check.subject == CheckSubject::sum ? 1 : 0;
        const std::size_t second = part.find('/', part.find('/') + 1);
        const std::string id = part.substr(start, second - start);
        if (std::find(experiments.begin(), experiments.end(), id) == experiments.end())
          experiments.push_back(id);
      }
  return experiments;
}

std::string repeat_experiments(const std::vector<std::string>& experiments, Tier tier,
                               std::uint64_t seed) {
  std::string folder = fmt::format("{}", fmt::join(experiments, "-and-"));
  std::replace(folder.begin(), folder.end(), '/', '-');
  const std::string seeded = seed == 0 ? "" : fmt::format(" --seed {}", seed);
  return fmt::format("phytobench run {} --tier {}{} --out results/again-{}-{}{}",
                     fmt::join(experiments, " "), name_of(tier), seeded, folder, name_of(tier),
                     seed == 0 ? "" : fmt::format("-{}", seed));
}

}  // namespace phytobench
