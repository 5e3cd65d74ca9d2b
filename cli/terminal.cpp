// SPDX-License-Identifier: MIT
#include "cli/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>

#include "core/contract/errors.hpp"

namespace phytobench::cli {

namespace {

volatile std::sig_atomic_t interrupted = 0;
bool line_shown = false;

void on_interrupt(int signal) {
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}

std::size_t terminal_width() {
  winsize size{};
  return ::ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 1 ? size.ws_col - 1u : 79u;
}

}  // namespace

void show_progress(const std::string& line) {
  using Clock = std::chrono::steady_clock;
  static Clock::time_point last;
  if (::isatty(STDERR_FILENO) == 0) return;
  if (line_shown && Clock::now() - last < std::chrono::milliseconds(100)) return;
  last = Clock::now();
  line_shown = true;
  std::fprintf(stderr, "\r\x1b[K%s", line.substr(0, terminal_width()).c_str());
}

void clear_progress() {
  if (line_shown) std::fprintf(stderr, "\r\x1b[K");
  line_shown = false;
}

void tell(const std::string& line) {
  clear_progress();
  std::fprintf(stderr, "phytobench: %s\n", line.c_str());
}

void catch_interrupts() {
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

bool is_interrupted() {
  return interrupted != 0;
}

void print(const std::string& text) {
  clear_progress();
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0)
    throw EnvironmentError("cannot write to standard output; free the disk or check the pipe");
}

}  // namespace phytobench::cli
