// SPDX-License-Identifier: MIT
#include "reports/plot/run_gnuplot.hpp"

#include <spawn.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/contract/errors.hpp"
#include "reports/plot/plot_text.hpp"

namespace phytobench {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// With the content to read. Files instead of pipes: nobody waits for a reader.
File temporary_file(const std::string& content = "") {
  File file(std::tmpfile(), std::fclose);
  if (!file || std::fputs(content.c_str(), file.get()) < 0 || std::fflush(file.get()) != 0)
    throw EnvironmentError(std::string("no file for gnuplot's script: ") + std::strerror(errno));
  std::rewind(file.get());
  return file;
}

std::string content_of(const File& file) {
  std::string content;
  std::rewind(file.get());
  for (int c; (c = std::fgetc(file.get())) != EOF;) content += static_cast<char>(c);
  return content;
}

}  // namespace

std::optional<std::string> run_gnuplot(std::string program, const std::string& script) {
  const File in = temporary_file(script), out = temporary_file(), err = temporary_file();
  posix_spawn_file_actions_t actions;
  ::posix_spawn_file_actions_init(&actions);
  int target = 0, status = -1;
  for (const File* file : {&in, &out, &err})
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
