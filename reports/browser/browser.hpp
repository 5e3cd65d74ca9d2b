// SPDX-License-Identifier: MIT
// For tests: a browser that is told what to do, and what it says.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "reports/browser/browser_process.hpp"

namespace phytobench {

inline constexpr double most_seconds = 60.0;  ///< for any answer; a busy machine is slow

/// Calls of the DevTools protocol and the events between their answers.
class Browser {
 public:
  explicit Browser(const std::filesystem::path& program) : process_(program) {}

  /// The result of a call, in a session of a page or, without one, of the browser itself. Throws
  /// EnvironmentError if the browser refuses, ends or does not answer in time.
  nlohmann::json call(const std::string& method,
                      const nlohmann::json& parameters = nlohmann::json::object(),
                      const std::string& session = "");

  /// Takes in events until the condition holds. Throws EnvironmentError if it does not in time.
  void wait_until(const std::function<bool()>& condition, const std::string& what);

  /// What has happened in a session so far: {"method": ..., "params": ...}.
  std::vector<nlohmann::json>& events(const std::string& session) { return events_[session]; }

 private:
  nlohmann::json next_message(Deadline deadline, const std::string& what);
  void keep_event(nlohmann::json message);

  BrowserProcess process_;
  std::int64_t last_call_ = 0;
  std::map<std::string, std::vector<nlohmann::json>> events_;
};

}  // namespace phytobench
