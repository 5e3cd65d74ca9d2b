// SPDX-License-Identifier: MIT
#include "core/contract/temporary_file.hpp"

#include <fcntl.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "core/contract/errors.hpp"

namespace phytobench {

TemporaryFile temporary_file(std::string_view text, std::string_view failure) {
  TemporaryFile file(std::tmpfile(), std::fclose);
  if (!file || std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0)
    throw EnvironmentError(std::string(failure) + ": " + std::strerror(errno));
  std::rewind(file.get());
  ::fcntl(::fileno(file.get()), F_SETFD, FD_CLOEXEC);
  return file;
}

std::string content_of(const TemporaryFile& file) {
  std::string content;
  std::array<char, 1 << 14> block;
  std::rewind(file.get());
  for (std::size_t size; (size = std::fread(block.data(), 1, block.size(), file.get())) > 0;)
    content.append(block.data(), size);
  return content;
}

}  // namespace phytobench
