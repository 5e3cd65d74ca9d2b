// SPDX-License-Identifier: MIT
// For tests that put a data folder of their own in place of the suite's.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace phytobench {

inline constexpr const char* data_folder_variable = "PHYTOBENCH_DATA";

/// Puts the variable back at its end.
class KeptDataFolderVariable {
 public:
  KeptDataFolderVariable() {
    if (const char* old_value = std::getenv(data_folder_variable)) old_value_ = old_value;
  }
  ~KeptDataFolderVariable() {
    if (old_value_)
      ::setenv(data_folder_variable, old_value_->c_str(), 1);
    else
      ::unsetenv(data_folder_variable);
  }
  KeptDataFolderVariable(const KeptDataFolderVariable&) = delete;
  KeptDataFolderVariable& operator=(const KeptDataFolderVariable&) = delete;

 private:
  std::optional<std::string> old_value_;
};

}  // namespace phytobench
