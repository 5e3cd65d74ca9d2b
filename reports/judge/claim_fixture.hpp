// SPDX-License-Identifier: MIT
// Claims and evidence made up for tests of judgement.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "reference/claims.hpp"
#include "reports/judge/evidence.hpp"

namespace phytobench {

using Terms = std::vector<std::vector<std::string>>;

/// Of all its terms.
inline ClaimCheck check_of(CheckSubject subject, Terms terms) {
  ClaimCheck check{.subject = subject, .terms = std::move(terms)};
  check.required = check.terms.size();
  return check;
}

inline ClaimCheck at_least(double low, ClaimCheck check) {
  check.low = low;
  return check;
}

inline Claim claim_of(std::vector<ClaimCheck> checks) {
  Claim claim;
  claim.checks = std::move(checks);
  return claim;
}

inline Evidence evidence_of(std::vector<Record> records, std::vector<TimingSample> timings = {}) {
  RunContents run;
  run.records = std::move(records);
  run.timings = std::move(timings);
  return Evidence(run);
}

}  // namespace phytobench
