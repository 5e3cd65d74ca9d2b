// SPDX-License-Identifier: MIT
#include "reports/claim_list.hpp"

#include "reference/claims.hpp"
#include "reference/papers.hpp"

namespace phytobench {

std::vector<ListedClaim> listed_claims() {
  std::vector<ListedClaim> listed;
  for (const std::string& key : paper_keys())
    for (const Claim& claim : load_claims(key).claims)
      listed.push_back(
          {claim.id, claim.kind, claim.locator, claim.text, std::string(name_of(claim.tier))});
  return listed;
}

}  // namespace phytobench
