// SPDX-License-Identifier: MIT
#include "reports/errata_list.hpp"

#include "reference/errata.hpp"
#include "reference/papers.hpp"

namespace phytobench {

std::vector<ListedErratum> listed_errata() {
  std::vector<ListedErratum> listed;
  for (const std::string& key : paper_keys())
    for (const Erratum& erratum : load_errata(key))
      listed.push_back({key, erratum.id, erratum.locator, erratum.printed, erratum.corrected,
                        erratum.consequence, erratum.kind == ErratumKind::program});
  return listed;
}

}  // namespace phytobench
