// SPDX-License-Identifier: MIT
#include "core/contract/name_selection.hpp"

#include <fnmatch.h>

#include <algorithm>

#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"

namespace phytobench {

namespace {

bool matches(const std::string& pattern, const std::string& name) {
  return ::fnmatch(pattern.c_str(), name.c_str(), 0) == 0;
}

[[noreturn]] void fail_to_match(const std::string& pattern, std::span<const std::string> names,
                                const SelectionWords& words) {
  const std::string kind(words.kind), listing(words.listing);
  if (pattern.find_first_of("*?[") != std::string::npos)
    throw NothingSelected("no " + kind + " matches '" + pattern + "'; see " + listing);
  throw InputError("unknown " + kind + " '" + pattern + "'" + did_you_mean(pattern, names) + " (" +
                   listing + ")");
}

}  // namespace

std::vector<std::size_t> selected_names(std::span<const std::string> names,
                                        std::span<const std::string> patterns,
                                        const SelectionWords& words) {
  for (const std::string& pattern : patterns)
    if (std::none_of(names.begin(), names.end(),
                     [&](const std::string& name) { return matches(pattern, name); }))
      fail_to_match(pattern, names, words);
  std::vector<std::size_t> selected;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (patterns.empty() ||
        std::any_of(patterns.begin(), patterns.end(),
                    [&](const std::string& pattern) { return matches(pattern, names[i]); }))
      selected.push_back(i);
  return selected;
}

}  // namespace phytobench
