// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/child_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

void Descriptor::close() {
  if (number_ >= 0) ::close(number_);
  number_ = -1;
}

namespace {

constexpr const char* no_file = "no temporary file for a program's input and output";

}  // namespace

ChildStreams::ChildStreams(const std::string& input, const std::filesystem::path& log)
    : in_(temporary_file(input, no_file)),
      out_(temporary_file("", no_file)),
      err_(temporary_file("", no_file)),
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
  return content_of(out_);
}

std::string ChildStreams::err() const {
  return content_of(err_);
}

}  // namespace phytobench
