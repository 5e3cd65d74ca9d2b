// SPDX-License-Identifier: MIT
#include "reports/browser/browser.hpp"

#include <utility>

#include "core/contract/errors.hpp"

namespace phytobench {

using nlohmann::json;

json Browser::call(const std::string& method, const json& parameters, const std::string& session) {
  const std::int64_t id = ++last_call_;
  json message{{"id", id}, {"method", method}, {"params", parameters}};
  if (!session.empty()) message["sessionId"] = session;
  const Deadline deadline = deadline_in(most_seconds);
  process_.send(message.dump(), deadline);
  while (true) {
    json answer = next_message(deadline, method);
    if (!answer.contains("id")) {
      keep_event(std::move(answer));
    } else if (answer["id"] == id) {
      if (answer.contains("error"))
        throw EnvironmentError("browser: " + method + ": " + answer["error"].dump());
      return std::move(answer["result"]);
    }
  }
}

void Browser::wait_until(const std::function<bool()>& condition, const std::string& what) {
  const Deadline deadline = deadline_in(most_seconds);
  while (!condition()) {
    json message = next_message(deadline, what);
    if (!message.contains("id")) keep_event(std::move(message));
  }
}

json Browser::next_message(Deadline deadline, const std::string& what) {
  const auto message = process_.receive(deadline);
  if (!message) throw EnvironmentError("browser: no answer in time: " + what);
  return json::parse(*message);
}

void Browser::keep_event(json message) {
  events_[message.value("sessionId", "")].push_back(std::move(message));
}

}  // namespace phytobench
