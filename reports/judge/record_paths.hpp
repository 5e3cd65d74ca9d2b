// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/record/record.hpp"

namespace phytobench {

/// Parts of a name between slashes: "a/b/c" -> a, b, c.
std::vector<std::string> path_parts(std::string_view name);

/// Records of a run below one name, by what follows it.
class RecordsBelow {
 public:
  /// `prefix` ends in a slash.
  RecordsBelow(const std::vector<Record>& records, const std::string& prefix);

  const std::map<std::string, const Record*>& by_name() const { return by_name_; }

  const Record* find(const std::string& name) const;
  std::optional<double> number(const std::string& name) const;
  std::optional<std::int64_t> count(const std::string& name) const;
  std::string text(const std::string& name) const;  ///< empty where there is none

 private:
  std::map<std::string, const Record*> by_name_;
};

/// The number that a value, or a record's value, is; nothing for text.
std::optional<double> number_of(const RecordValue& value);
std::optional<double> number_of(const Record& record);

}  // namespace phytobench
