// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

namespace phytobench {

using Deadline = std::chrono::steady_clock::time_point;

/// A moment that many seconds from now.
Deadline deadline_in(double seconds);

/// A Chromium on this machine: $PHYTOBENCH_BROWSER, or the first of the usual names in $PATH.
/// Nothing if there is none.
std::optional<std::filesystem::path> installed_browser();

/// A Chromium without a window, as a process that speaks the DevTools protocol: messages in JSON,
/// each ended by a zero byte, over its file descriptors 3 and 4. It has its own folder for all that
/// it writes. The destructor kills it with everything it has started, and removes that folder.
class BrowserProcess {
 public:
  /// Throws EnvironmentError if the program cannot be started.
  explicit BrowserProcess(const std::filesystem::path& program);
  ~BrowserProcess();
  BrowserProcess(const BrowserProcess&) = delete;
  BrowserProcess& operator=(const BrowserProcess&) = delete;

  /// Throws EnvironmentError if the browser has ended or takes nothing until the deadline.
  void send(const std::string& message, Deadline deadline);

  /// The next message; nothing if none has come by the deadline. Throws EnvironmentError if the
  /// browser has ended.
  std::optional<std::string> receive(Deadline deadline);

 private:
  void start(const std::filesystem::path& program, int its_end);

  std::filesystem::path folder_;
  pid_t process_ = -1;  ///< also the number of its process group
  int socket_ = -1;
  std::string received_;
  std::size_t searched_ = 0;  ///< of received_, where no end of a message is
};

}  // namespace phytobench
