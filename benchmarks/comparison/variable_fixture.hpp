// SPDX-License-Identifier: MIT
// For tests: a variable of the environment that is what it was afterwards.
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace phytobench {

class Variable {
 public:
  explicit Variable(const char* name) : name_(name) {
    if (const char* value = std::getenv(name)) before_ = value;
  }
  ~Variable() {
    if (before_)
      set(*before_);
    else
      ::unsetenv(name_);
  }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

  void set(const std::string& value) { ::setenv(name_, value.c_str(), 1); }

 private:
  const char* name_;
  std::optional<std::string> before_;
};

}  // namespace phytobench
