// SPDX-License-Identifier: MIT
#include "reports/errata_letter_strongest.hpp"

#include <algorithm>
#include <tuple>

namespace phytobench {

namespace {

constexpr std::size_t most_errata = 5;

int weight_of_kind(const Erratum& erratum) {
  if (!erratum.kind) return 2;
  switch (*erratum.kind) {
    case ErratumKind::formula:
    case ErratumKind::number:
      return 0;
    case ErratumKind::missing_case:
      return 1;
    default:
      return 2;
  }
}

/// Smaller ones come first.
std::tuple<bool, bool, int, std::ptrdiff_t> rank_of(const Erratum& erratum) {
  return {erratum.confidence != "certain", !erratum.counter_example, weight_of_kind(erratum),
          -std::ssize(erratum.claims)};
}

}  // namespace

std::vector<const Erratum*> strongest_errata(const JudgedPaper& judged) {
  std::vector<const Erratum*> errata;
  for (const Erratum& erratum : judged.errata)
    if (erratum.kind != ErratumKind::program) errata.push_back(&erratum);
  std::stable_sort(errata.begin(), errata.end(), [](const Erratum* a, const Erratum* b) {
    if (rank_of(*a) != rank_of(*b)) return rank_of(*a) < rank_of(*b);
    return section_is_before(a->section, b->section);
  });
  errata.resize(std::min(errata.size(), most_errata));
  return errata;
}

}  // namespace phytobench
