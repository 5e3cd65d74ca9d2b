// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/record/digest_chain.hpp"

namespace phytobench {

/// The end of a section.
struct Seal {
  int line = 0;            ///< of the file, from 1
  std::uintmax_t end = 0;  ///< bytes of the file up to and with its line end
  std::string digest;      ///< 64 hexadecimal digits
};

/// A file of JSON lines that grows by sections and that a DigestChain protects, as its only writer
/// sees it.
class SealedFile {
 public:
  SealedFile() = default;

  /// A new file of one section without other lines, in the place of what is there. Throws
  /// EnvironmentError.
  SealedFile(std::filesystem::path file, std::string_view first_object);

  /// Goes on after a section; what follows it is cut off. Throws EnvironmentError.
  SealedFile(std::filesystem::path file, const Seal& last);

  /// Appends a section and has it written to the disk. Throws EnvironmentError; the file then is as
  /// it was.
  void append(std::string_view lines, std::string_view object);

  /// Takes the file back to where this is, after a copy of this has appended to it. Fails silently:
  /// a reader knows what is too much.
  void cut() const noexcept;

  /// The seal of a section, were it appended.
  std::string digest_after(std::string_view lines, std::string_view object) const;

 private:
  std::filesystem::path file_;
  std::uintmax_t bytes_ = 0;
  DigestChain chain_;
};

}  // namespace phytobench
