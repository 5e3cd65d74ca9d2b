// SPDX-License-Identifier: MIT
#include "reports/plot/run_gnuplot.hpp"

#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstring>

#include "core/contract/errors.hpp"
#include "core/contract/temporary_file.hpp"
#include "reports/plot/plot_text.hpp"

namespace phytobench {

std::optional<std::string> run_gnuplot(std::string program, const std::string& script) {
  // Files instead of pipes: nobody waits for a reader.
  constexpr const char* no_file = "no file for gnuplot's script";
  const TemporaryFile in = temporary_file(script, no_file), out = temporary_file("", no_file),
                      err = temporary_file("", no_file);
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  int target = 0, status = -1;
  for (const TemporaryFile* file : {&in, &out, &err})
    ::posix_spawn_file_actions_adddup2(&actions, ::fileno(file->get()), target++);
  std::string no_user_settings = "-d", locale = "LC_ALL=C";
  char* const argv[] = {program.data(), no_user_settings.data(), nullptr};
  char* const envp[] = {locale.data(), nullptr};
  pid_t child = 0;
  const int error = ::posix_spawnp(&child, program.c_str(), &actions, nullptr, argv, envp);
  ::posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT || error == ENOTDIR || error == EACCES) return std::nullopt;
  while (error == 0 && ::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
  std::string svg = content_of(out);
  if (status == 0 && svg.find("</svg>") != std::string::npos) return svg;
  throw EnvironmentError(program + " drew nothing: " +
                         (error == 0 ? printable(content_of(err)) : std::strerror(error)));
}

}  // namespace phytobench
