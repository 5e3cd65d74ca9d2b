// SPDX-License-Identifier: MIT
// Names that the thesis gives: labels of its requirements, counted with the answers it gives to
// them, and the alphabets of its L-systems against the letters that these use.
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "reference/data_folder.hpp"
#include "reference/oracles/brzoska2019_l_systems.hpp"
#include "reference/toml_table.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// Of all groups, in order.
struct Requirements {
  std::vector<std::string> set, answered, corrected, answers;
};

void append(std::vector<std::string>& all, const std::vector<std::string>& some) {
  all.insert(all.end(), some.begin(), some.end());
}

Requirements record_groups(ExperimentContext& context) {
  Requirements all;
  const TomlTable file = TomlTable::read(paper_folder("brzoska2019") / "requirements.toml");
  for (const TomlTable& group : file.tables("group")) {
    context.record(fmt::format("requirements/{}", group.text("name")),
                   whole(group.texts("set").size()));
    append(all.set, group.texts("set"));
    append(all.answered, group.texts("answered"));
    append(all.corrected, group.texts("corrected"));
    append(all.answers, group.texts("answers"));
  }
  return all;
}

std::int64_t different(const std::vector<std::string>& labels) {
  return whole(std::set<std::string>(labels.begin(), labels.end()).size());
}

void record_requirements(ExperimentContext& context) {
  const Requirements all = record_groups(context);
  context.record("requirements/set", whole(all.set.size()));
  context.record("requirements/answered", whole(all.answered.size()));
  context.record("requirements/different-labels/set", different(all.set));
  context.record("requirements/different-labels/answered", different(all.answered));
  context.record("requirements/different-labels/corrected", different(all.corrected));
  for (const char* answer : {"yes", "in part", "not judged", "no"}) {
    std::string name = answer;
    std::replace(name.begin(), name.end(), ' ', '-');
    context.record("answers/" + name, whole(static_cast<std::size_t>(std::count(
                                          all.answers.begin(), all.answers.end(), answer))));
  }
}

void record_alphabets(ExperimentContext& context) {
  namespace literal = oracles::brzoska2019;
  const auto record = [&](const std::string& name, const literal::LSystem& system) {
    context.record(fmt::format("alphabet/{}/letters", name), whole(system.V.size()), "letters");
    context.record(fmt::format("alphabet/{}/outside", name),
                   std::int64_t{literal::letters_outside_alphabet(system)}, "letters");
  };
  record("equation-4", literal::equation_4());
  record("equation-5", literal::equation_5());
  record("equation-6-as-printed", literal::equation_6_as_printed());
  record("equation-6-corrected", literal::equation_6_corrected());
  record("equation-7", literal::equation_7());
}

void run(ExperimentContext& context) {
  record_requirements(context);
  record_alphabets(context);
}

}  // namespace

extern const ExperimentDescriptor printed_names;
constinit const ExperimentDescriptor printed_names{
    .id = "brzoska2019/printed-names",
    .question = "Do the thesis' labels and alphabets agree with what they are used for?",
    .source = "[Brzoska2019] sec. 3.3, 6.1, eq. 4-7",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
