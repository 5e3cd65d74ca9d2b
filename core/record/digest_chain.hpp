// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace phytobench {

/// Finds damage in a file of sections that is only ever appended to. The last line of each section
/// is a JSON object whose last key, "sha256", seals it: the SHA-256 of the seal before (nothing for
/// the first), the section's other lines and this line up to that key. A section that was changed,
/// lost, repeated or moved therefore shows in its own seal or in the next. This finds accidents,
/// not forgers, who can compute seals too.
class DigestChain {
 public:
  /// A chain that goes on after this seal.
  explicit DigestChain(std::string seal = {}) : seal_(std::move(seal)) {}

  /// The line, without line end, that ends a section: `object`, a JSON object with at least one
  /// key, and its seal. `lines` are the section's others, with their line ends.
  std::string sealed(std::string_view lines, std::string_view object);

  /// Whether a section, without its last line end, is what was sealed. The chain goes on from it if
  /// so and stays as it is if not.
  bool accept(std::string_view section);

  /// The last seal: 64 hexadecimal digits.
  const std::string& seal() const { return seal_; }

 private:
  std::string seal_;
};

}  // namespace phytobench
