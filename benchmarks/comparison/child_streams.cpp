// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/child_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

void Descriptor::close() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

/// Other programs that are started do not get it.
ChildStreams::File ChildStreams::temporary_file(const std::string& content) {
  File file(std::tmpfile(), std::fclose);
  if (!file || std::fwrite(content.data(), 1, content.size(), file.get()) != content.size() ||
      std::fflush(file.get()) != 0)
    throw EnvironmentError(fmt::format("no temporary file for a program's input and output: {}",
                                       std::strerror(errno)));
  std::rewind(file.get());
  ::fcntl(::fileno(file.get()), F_SETFD, FD_CLOEXEC);
  return file;
}

std::string ChildStreams::content_of(std::FILE* file) {
  std::string content;
  std::array<char, 1 << 14> block;
  std::rewind(file);
  for (std::size_t size; (size = std::fread(block.data(), 1, block.size(), file)) > 0;)
    content.append(block.data(), size);
  return content;
}

ChildStreams::ChildStreams(const std::string& input, const std::filesystem::path& log)
    : in_(temporary_file(input)),
      out_(temporary_file("")),
      err_(temporary_file("")),
      log_(log.empty() ? -1
                       : ::open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  if (!log.empty() && log_.number() < 0)
    throw EnvironmentError(fmt::format("cannot write {}: {}", log.string(), std::strerror(errno)));
}

int ChildStreams::number(int target) const {
  if (target > 0 && log_.number() >= 0) return log_.number();
  return ::fileno((target == 0 ? in_ : target == 1 ? out_ : err_).get());
}

std::string ChildStreams::out() const {
  return content_of(out_.get());
}

std::string ChildStreams::err() const {
  return content_of(err_.get());
}

}  // namespace phytobench
