// SPDX-License-Identifier: MIT
// Pages that the thesis cites of the article on space colonization, its source [25], against the
// pages that its list of references gives that article.
#include <fmt/format.h>

#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

struct Pages {
  int first;
  int last;

  bool contain(int page) const { return first <= page && page <= last; }
};

/// Source [25]: proceedings of a workshop, pages 63 to 70.
constexpr Pages article{63, 70};

struct Citation {
  const char* place;
  int page;
};

constexpr Citation citations[] = {
    {"section-3.4.4-border", 1},
    {"section-3.4.4-footnote", 66},
    {"section-3.4.4-weeping", 69},
    {"equation-11", 65},
    {"equation-12", 65},
    {"section-4.1-radii", 26},
    {"section-5.2.2", 68},
    {"figure-17", 64},
    {"figure-18", 65},
    {"figure-19", 66},
    {"figure-21", 67},
};

void run(ExperimentContext& context) {
  std::int64_t outside = 0;
  for (const Citation& citation : citations) {
    const bool inside = article.contain(citation.page);
    context.record(fmt::format("{}/page", citation.place), std::int64_t{citation.page});
    context.record(fmt::format("{}/inside", citation.place), std::int64_t{inside});
    outside += !inside;
  }
  context.record("citations", static_cast<std::int64_t>(std::size(citations)), "citations");
  context.record("outside", outside, "citations");
}

}  // namespace

extern const ExperimentDescriptor cited_pages;
constinit const ExperimentDescriptor cited_pages{
    .id = "brzoska2019/cited-pages",
    .question = "Do the pages cited of the article on space colonization exist in it?",
    .source = "[Brzoska2019] sec. 3.4.4, 4.1, 5.2.2, source 25",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
