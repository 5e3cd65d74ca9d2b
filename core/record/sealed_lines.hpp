// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <functional>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "core/record/sealed_file.hpp"

namespace phytobench {

/// What becomes of the lines of a file, in their order.
struct SealedLineUse {
  /// A line within a section, which may turn out to be unfinished.
  std::function<void(const nlohmann::ordered_json&)> line;
  /// The last line of a section, which is whole.
  std::function<void(const nlohmann::ordered_json&, const Seal&)> seal;
};

/// Reads the content of a SealedFile. A last line that breaks off was being written when the
/// program died, and is left out. Throws InputError with file and line for a broken line, for a
/// section that is not as it was sealed, and for what `use` complains about.
void read_sealed_lines(const std::filesystem::path& file, std::string_view text,
                       const SealedLineUse& use);

}  // namespace phytobench
