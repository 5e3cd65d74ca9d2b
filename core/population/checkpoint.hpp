// SPDX-License-Identifier: MIT
// A population on disk, so that a run that ended early goes on where it was.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/population/population_settings.hpp"
#include "core/population/stand.hpp"

namespace phytobench {

struct Checkpoint {
  std::vector<Setting> settings;     ///< of the run that wrote it
  std::vector<std::uint64_t> tally;  ///< what its writer counts besides
  PopulationState state;
};

/// Layout, all numbers little-endian: "phytopop", format version (4 bytes), length of what follows
/// the checksum (8), FNV-1a of that (8); then settings, tally and the state, lists with their
/// length (8) before them. The same state gives the same bytes.
std::string checkpoint_bytes(std::span<const Setting> settings,
                             std::span<const std::uint64_t> tally, const PopulationState& state);

/// The same state bit for bit. Throws InputError that begins with `name` for bytes that are no
/// checkpoint, of another version, cut off, or altered.
Checkpoint parse_checkpoint(std::string_view bytes, const std::string& name);
Checkpoint read_checkpoint(const std::filesystem::path& file);

/// Throws InputError that begins with `name` and says which setting differs, and how, unless the
/// run that wrote the checkpoint had the same ones.
void refuse_other_settings(const Checkpoint& checkpoint, std::span<const Setting> settings,
                           const std::string& name);

}  // namespace phytobench
