// SPDX-License-Identifier: MIT
// What a program reads and writes while it runs: files, so that nobody has to wait for its output.
#pragma once

#include <filesystem>
#include <string>

#include "core/contract/temporary_file.hpp"

namespace phytobench {

/// An open file of the system, closed with it; negative: none.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  void close();

 private:
  int number_;
};

/// Standard input, output and error of a program.
class ChildStreams {
 public:
  /// With the text to read. Output goes to temporary files, or to the end of `log` unless that is
  /// empty. Throws EnvironmentError.
  ChildStreams(const std::string& input, const std::filesystem::path& log);

  /// The descriptor that becomes 0, 1 or 2 of the program.
  int number(int target) const;

  /// What was written since; nothing of it if it went to a log.
  std::string out() const;
  std::string err() const;

 private:
  TemporaryFile in_, out_, err_;
  Descriptor log_;
};

}  // namespace phytobench
