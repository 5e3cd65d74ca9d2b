// SPDX-License-Identifier: MIT
#include "reports/repeat_commands.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace phytobench {

std::string repeat_run(const std::vector<std::string>& experiments, const RunHeader& header,
                       const std::string& folder) {
  std::string command = "phytobench run";
  for (const std::string& experiment : experiments) command += " " + experiment;
  return command +
         fmt::format(" --tier {} --seed {} --out {}", name_of(header.tier), header.seed, folder);
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
