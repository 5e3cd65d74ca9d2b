// SPDX-License-Identifier: MIT
#include "core/record/append_to_file.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

void append_or_restore(const fs::path& file, std::string_view text, std::uintmax_t size) {
  std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(file.c_str(), "ab"));
  const bool is_open = stream != nullptr;
  const bool written = is_open &&
                       std::fwrite(text.data(), 1, text.size(), stream.get()) == text.size() &&
                       std::fflush(stream.get()) == 0 && ::fsync(::fileno(stream.get())) == 0;
  if (written) return;
  const int reason = errno;
  stream.reset();  // it writes what it still holds, if it can: cut afterwards
  std::error_code ignored;
  if (is_open) fs::resize_file(file, size, ignored);
  throw EnvironmentError("cannot write " + file.string() + ": " + std::strerror(reason) +
                         "; what was written before is kept, make room and go on with --resume");
}

}  // namespace phytobench
