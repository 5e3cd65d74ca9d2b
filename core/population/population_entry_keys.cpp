// SPDX-License-Identifier: MIT
// Keys of [[influence]] and [[event]] in a population file.
#include "core/population/population_keys.hpp"

namespace phytobench {

namespace {

using population_key::choice;
using population_key::number;
using Keys = std::vector<PopulationKey>;
using Values = PopulationFileValues;

Keys influence_keys() {
  const std::string_view signs = "[Alsweis] (5.6), table 5.1, for each pair of species";
  const auto word = [](auto place) { return choice({"helps", "none", "harms"}, place, -1); };
  return {{"influence.of", "-", "", "the species that acts; later entries override earlier ones",
           signs,
           PopulationText{"a species' name, \"*\" for all",
                          [](Values & v) -> auto& {return v.influence.of;
}
}  // namespace
, true, true, false, "\"*\""
}  // namespace phytobench
, {"influence.on", "-", "", "the species that it acts on", signs,
   PopulationText{"a species' name, \"*\" for all", [](Values& v) -> auto& {return v.influence.on;
}
}
, true, true, false, "\"oak\""
}
,
    {"influence.above",
     "-",
     "\"harms\"",
     "what its crown does; for rules influence_signs, nurse and combined",
     signs,
     word([](auto& v) -> auto& { return v.influence.above; }),
     false,
     true},
    {"influence.below",
     "-",
     "\"harms\"",
     "what its roots do; without any [[influence]] all harm, and under rule nurse all roots help",
     signs,
     word([](auto& v) -> auto& { return v.influence.below; }),
     false,
     true},
}
;
}

Keys event_keys() {
  return {
      {"event.kind", "-", "", "whether plants fall ill or are taken out", "[Alsweis] sec. 4.7, 7.5",
       choice(
           {"disease", "removal"}, [](auto& v) -> auto& { return v.event.kind; }),
       true, true, false, "\"removal\""},
      {"event.step", "steps", "", "steps that are done before it", "phytobench",
       number(
           {.high = 1e6}, [](auto& v) -> auto& { return v.event.step; }),
       true, true, false, "30"},
      {"event.species", "-", "\"\"", "the species whose plants it strikes", "phytobench",
       PopulationText{"a species' name, \"\" for all",
                      [](Values & v) -> auto& {return v.event_species;
}
}
, false, true
}
,
    {"event.largest",
     "plants",
     "",
     "how many it strikes, the largest first",
     "[Alsweis] fig. 4.11",
     number(
         {.low = 1, .high = 1e9}, [](auto& v) -> auto& { return v.event.largest; }),
     false,
     true,
     true,
     "2"},
    {"event.share",
     "share",
     "",
     "or the share that it strikes at random",
     "phytobench",
     number(
         {.high = 1, .low_is_allowed = false}, [](auto& v) -> auto& { return v.event.share; }),
     false,
     true,
     true,
     "0.1"},
    {"event.plants", "-", "",
     "or the ids of those that it strikes: plants of the file first, from 0, then those sown",
     "[Alsweis] fig. 7.10", PopulationIds{[](Values & v) -> auto& {return v.event.plants;
}
}
, false, true, true, "[0, 7]"
}
,
}
;
}

}  // namespace

std::vector<PopulationKey> influence_and_event_keys() {
  Keys all = influence_keys();
  const Keys events = event_keys();
  all.insert(all.end(), events.begin(), events.end());
  return all;
}

}  // namespace phytobench
