// SPDX-License-Identifier: MIT
#pragma once

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// Calls `use(paper, judgement)` for each claim, paper by paper, in the order of its file.
template <class Use>
void for_each_judgement(const JudgedRun& judged, const Use& use) {
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements) use(paper, judgement);
}

}  // namespace phytobench
