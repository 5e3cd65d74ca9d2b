// SPDX-License-Identifier: MIT
// The ways a command can end without a result. The command line turns each into its exit code.
#pragma once

#include <stdexcept>
#include <string>

namespace phytobench {

/// Something the user gave is wrong (exit code 2). The message is one line: what, where, what to
/// do.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The machine refused: full disk, unwritable path, missing data folder (exit code 3).
class EnvironmentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A glob or tier that selects nothing (exit code 4).
class NothingSelected : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The user pressed Ctrl-C; everything finished so far is kept (exit code 130).
class Interrupted : public std::runtime_error {
 public:
  explicit Interrupted(const std::string& rest = "finished results are kept")
      : std::runtime_error("interrupted; " + rest) {}
};

/// A broken promise between two parts of phytobench itself: always a bug (exit code 3).
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

}  // namespace phytobench
