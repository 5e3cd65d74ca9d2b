// SPDX-License-Identifier: MIT
#include "reports/browser/browser_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <vector>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what) {
  throw EnvironmentError("browser: " + what);
}

fs::path new_folder() {
  std::string name = (fs::temp_directory_path() / "phytobench-browser-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) fail(std::string("no folder: ") + std::strerror(errno));
  return name;
}

/// Nothing but the page under test may cause work, messages or requests.
std::vector<std::string> arguments(const fs::path& program, const fs::path& folder) {
  return {program.string(),
          "--headless=new",
          "--remote-debugging-pipe",
          "--user-data-dir=" + folder.string(),
          "--no-sandbox",  // test machines run as root in containers
          "--no-zygote",
          "--disable-gpu",
          "--disable-dev-shm-usage",
          "--disable-breakpad",
          "--disable-crash-reporter",
          "--disable-extensions",
          "--disable-background-networking",
          "--disable-component-update",
          "--disable-default-apps",
          "--disable-sync",
          "--no-first-run",
          "--no-default-browser-check",
          "--force-color-profile=srgb",
          "about:blank"};
}

/// The user's settings stay out of it, and its files in its folder.
std::vector<std::string> environment(const fs::path& folder) {
  const char* path = std::getenv("PATH");
  return {std::string("PATH=") + (path ? path : "/usr/bin:/bin"), "HOME=" + folder.string(),
          "TMPDIR=" + folder.string(), "LANG=C.UTF-8"};
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Waits until the socket is ready for `events`; false at the deadline.
bool wait_for(int socket, short events, Deadline deadline) {
  using std::chrono::milliseconds;
  while (true) {
    const auto left = std::chrono::ceil<milliseconds>(deadline - std::chrono::steady_clock::now());
    pollfd ready{.fd = socket, .events = events, .revents = 0};
    const int count = ::poll(&ready, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
    if (count >= 0) return count > 0;
    if (errno != EINTR) fail(std::strerror(errno));
  }
}

}  // namespace

Deadline deadline_in(double seconds) {
  return std::chrono::steady_clock::now() +
         std::chrono::duration_cast<std::chrono::steady_clock::duration>(
             std::chrono::duration<double>(seconds));
}

std::optional<fs::path> installed_browser() {
  if (const char* given = std::getenv("PHYTOBENCH_BROWSER")) return fs::path(given);
  const char* path = std::getenv("PATH");
  for (const char* name : {"chromium", "chromium-browser", "google-chrome"}) {
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');)
      if (::access((fs::path(folder) / name).c_str(), X_OK) == 0) return fs::path(folder) / name;
  }
  return std::nullopt;
}

BrowserProcess::BrowserProcess(const fs::path& program) : folder_(new_folder()) {
  // One socket serves as both pipes. Unlike a pipe it can be written to without a signal when the
  // other side is gone. Its ends are moved away from 3 and 4, where the browser expects them.
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    fail(std::strerror(errno));
  socket_ = ::fcntl(ends[0], F_DUPFD_CLOEXEC, 10);
  const int its_end = ::fcntl(ends[1], F_DUPFD_CLOEXEC, 10);
  for (const int end : ends) ::close(end);
  start(program, its_end);
  ::close(its_end);
}

void BrowserProcess::start(const fs::path& program, int its_end) {
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  ::posix_spawn_file_actions_init(&actions);
  ::posix_spawnattr_init(&attributes);
  ::posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  for (const int output : {1, 2})
    ::posix_spawn_file_actions_addopen(&actions, output, "/dev/null", O_WRONLY, 0);
  for (const int pipe : {3, 4}) ::posix_spawn_file_actions_adddup2(&actions, its_end, pipe);
  ::posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
  ::posix_spawnattr_setpgroup(&attributes, 0);
  std::vector<std::string> words = arguments(program, folder_), variables = environment(folder_);
  const int error = ::posix_spawn(&process_, program.c_str(), &actions, &attributes,
                                  pointers(words).data(), pointers(variables).data());
  ::posix_spawnattr_destroy(&attributes);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error == 0) return;
  ::close(its_end);
  ::close(socket_);
  fs::remove_all(folder_);
  fail("cannot start " + program.string() + ": " + std::strerror(error));
}

BrowserProcess::~BrowserProcess() {
  ::kill(-process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
  ::close(socket_);
  // Those that it had started may need a moment to die; until then they write to the folder.
  std::error_code error;
  for (int attempt = 0; attempt < 50; ++attempt) {
    fs::remove_all(folder_, error);
    if (!fs::exists(folder_, error)) return;
    ::usleep(20'000);
  }
}

void BrowserProcess::send(const std::string& message, Deadline deadline) {
  const char* rest = message.c_str();
  std::size_t left = message.size() + 1;  // its zero is the end of the message
  while (left > 0) {
    if (!wait_for(socket_, POLLOUT, deadline)) fail("takes no message");
    const ssize_t sent = ::send(socket_, rest, left, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (sent < 0 && errno != EINTR && errno != EAGAIN) fail("has ended");
    if (sent <= 0) continue;
    rest += sent;
    left -= static_cast<std::size_t>(sent);
  }
}

std::optional<std::string> BrowserProcess::receive(Deadline deadline) {
  std::size_t end = received_.find('\0', searched_);
  std::vector<char> buffer(1 << 16);
  while (end == std::string::npos) {
    searched_ = received_.size();
    if (!wait_for(socket_, POLLIN, deadline)) return std::nullopt;
    const ssize_t count = ::recv(socket_, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
    if (count <= 0) fail("has ended");
    received_.append(buffer.data(), static_cast<std::size_t>(count));
    end = received_.find('\0', searched_);
  }
  std::string message = received_.substr(0, end);
  received_.erase(0, end + 1);
  searched_ = 0;
  return message;
}

}  // namespace phytobench
