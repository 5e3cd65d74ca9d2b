// SPDX-License-Identifier: MIT
#include "reports/judge/run_comparison.hpp"

#include <algorithm>
#include <iterator>

#include "core/contract/check.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

/// How much an undecided verdict says: noise was at least measured, and a fixed verdict has its
/// reason in the text of the work.
int telling(Verdict verdict) {
  if (verdict == Verdict::inconclusive) return 2;
  return verdict == Verdict::not_measured ? 0 : 1;
}

const Judgement& judgement_of(const LabelledRun& run, std::size_t paper, std::size_t claim) {
  return run.judged.papers[paper].judgements[claim];
}

/// The same claim in each run.
ComparedClaim compared_claim(std::span<const LabelledRun> runs, std::size_t paper,
                             std::size_t claim) {
  ComparedClaim compared;
  compared.id = judgement_of(runs.front(), paper, claim).claim->id;
  for (const LabelledRun& run : runs) {
    const Judgement& judgement = judgement_of(run, paper, claim);
    PHYTOBENCH_EXPECT(judgement.claim->id == compared.id);
    compared.verdicts.push_back(judgement.verdict);
    compared.measured.push_back(judgement.measured);
    compared.varies |= judgement.varies;
  }
  const MergedVerdict merged = merged_verdict(compared.verdicts);
  compared.merged = merged.verdict;
  compared.contradicted = merged.contradicted;
  return compared;
}

/// Inconclusive, with what each run found. A reason is for readers: it calls a verdict as they see
/// it everywhere else.
Judgement contradicted_judgement(std::span<const LabelledRun> runs, const ComparedClaim& compared,
                                 std::size_t paper, std::size_t claim) {
  Judgement merged{.verdict = Verdict::inconclusive};
  merged.contradicted = true;
  merged.reason = "The runs disagree: ";
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const Judgement& own = judgement_of(runs[run], paper, claim);
    const std::string separator = run > 0 ? "; " : "";
    const std::string letter = run_letter(run);
    merged.reason += separator + letter + ": " + std::string(label_of(compared.verdicts[run]));
    merged.measured += separator + letter + ": " + own.measured;
    for (JudgedCheck check : own.checks) {
      for (JudgedTerm& term : check.terms) term.expression += " (" + letter + ")";
      merged.checks.push_back(std::move(check));
    }
  }
  merged.reason += ". " + judgement_of(runs.front(), paper, claim).claim->reason;
  return merged;
}

Judgement merged_judgement(std::span<const LabelledRun> runs, const ComparedClaim& compared,
                           std::size_t paper, std::size_t claim) {
  Judgement merged = compared.contradicted
                         ? contradicted_judgement(runs, compared, paper, claim)
                         : judgement_of(runs[merged_verdict(compared.verdicts).run], paper, claim);
  merged.varies = compared.varies;
  return merged;
}

/// Each experiment with its records and samples from the first run that completed it.
RunContents merged_contents(std::span<const LabelledRun> runs) {
  RunContents merged;
  merged.header = runs.front().judged.run.header;
  for (const LabelledRun& run : runs) {
    const RunContents& own = run.judged.run;
    const auto is_new = [&](const auto& measured) {
      return !merged.complete_experiments.contains(measured.experiment);
    };
    std::copy_if(own.records.begin(), own.records.end(), std::back_inserter(merged.records),
                 is_new);
    std::copy_if(own.timings.begin(), own.timings.end(), std::back_inserter(merged.timings),
                 is_new);
    merged.complete_experiments.insert(own.complete_experiments.begin(),
                                       own.complete_experiments.end());
  }
  return merged;
}

/// Of the same table in each run the first that was measured.
JudgedTable merged_table(std::span<const LabelledRun> runs, std::size_t paper, std::size_t table) {
  for (const LabelledRun& run : runs)
    if (run.judged.papers[paper].tables[table].measured)
      return run.judged.papers[paper].tables[table];
  return runs.front().judged.papers[paper].tables[table];
}

/// What the merged run shows of one paper; all points to the claims and tables of the first run.
struct MergedPaper {
  std::vector<Judgement> judgements;
  std::vector<JudgedTable> tables;
};

MergedPaper merged_paper(std::span<const LabelledRun> runs, std::size_t paper,
                         std::vector<ComparedClaim>& claims) {
  MergedPaper merged;
  const JudgedPaper& first = runs.front().judged.papers[paper];
  for (std::size_t claim = 0; claim < first.judgements.size(); ++claim) {
    claims.push_back(compared_claim(runs, paper, claim));
    merged.judgements.push_back(merged_judgement(runs, claims.back(), paper, claim));
    merged.judgements.back().claim = first.judgements[claim].claim;
  }
  for (std::size_t table = 0; table < first.tables.size(); ++table) {
    merged.tables.push_back(merged_table(runs, paper, table));
    merged.tables.back().table = first.tables[table].table;
  }
  return merged;
}

JudgedScaling merged_scaling(std::span<const LabelledRun> runs) {
  for (const LabelledRun& run : runs)
    if (run.judged.scaling.measured()) return run.judged.scaling;
  return runs.front().judged.scaling;
}

}  // namespace

std::string run_letter(std::size_t place) {
  constexpr std::size_t letters = 26;
  const std::string last(1, static_cast<char>('A' + place % letters));
  return place < letters ? last : run_letter(place / letters - 1) + last;
}

bool is_decided(Verdict verdict) {
  return verdict == Verdict::reproduced || verdict == Verdict::reproduced_with_erratum ||
         verdict == Verdict::not_reproduced;
}

MergedVerdict merged_verdict(std::span<const Verdict> verdicts) {
  PHYTOBENCH_EXPECT(!verdicts.empty());
  const auto decided = std::find_if(verdicts.begin(), verdicts.end(), is_decided);
  if (decided == verdicts.end()) {
    const auto best = std::max_element(verdicts.begin(), verdicts.end(), [](Verdict a, Verdict b) {
      return telling(a) < telling(b);
    });
    return {*best, static_cast<std::size_t>(best - verdicts.begin()), false};
  }
  const auto run = static_cast<std::size_t>(decided - verdicts.begin());
  const bool contradicted = std::any_of(verdicts.begin(), verdicts.end(), [&](Verdict verdict) {
    return is_decided(verdict) && verdict != *decided;
  });
  return {contradicted ? Verdict::inconclusive : *decided, run, contradicted};
}

MergedRuns merge_runs(std::vector<LabelledRun> runs) {
  PHYTOBENCH_EXPECT(runs.size() >= 2);
  MergedRuns merged;
  std::vector<MergedPaper> papers;
  for (std::size_t paper = 0; paper < runs.front().judged.papers.size(); ++paper)
    papers.push_back(merged_paper(runs, paper, merged.comparison.claims));
  JudgedScaling scaling = merged_scaling(runs);
  RunContents contents = merged_contents(runs);
  std::vector<const RunContents*> all;
  for (const LabelledRun& run : runs) all.push_back(&run.judged.run);
  merged.comparison.records = compare_records(all);
  // From here on the first run's papers, to whose claims all judgements point, are the merged ones.
  for (LabelledRun& run : runs)
    merged.comparison.runs.push_back(
        {std::move(run.label), std::move(run.judged.run), std::move(run.folder)});
  merged.judged = std::move(runs.front().judged);
  merged.judged.run = std::move(contents);
  merged.judged.scaling = std::move(scaling);
  for (std::size_t paper = 0; paper < papers.size(); ++paper) {
    merged.judged.papers[paper].judgements = std::move(papers[paper].judgements);
    merged.judged.papers[paper].tables = std::move(papers[paper].tables);
  }
  return merged;
}

}  // namespace phytobench
