// SPDX-License-Identifier: MIT
#include "core/population/checkpoint.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/population/little_endian.hpp"

namespace phytobench {

namespace {

constexpr std::string_view magic = "phytopop";
constexpr std::uint32_t version = 1;
constexpr std::size_t header_size = magic.size() + 4 + 8 + 8;

/// Bytes of one plant beside those of its recent growth.
constexpr std::size_t plant_bytes = 3 * 8 + 8 + 2 * 4 + 2;

void write_state(const PopulationState& state, ByteWriter& out) {
  const Stand& stand = state.stand;
  out.number(state.step);
  out.number(state.next_id);
  out.list<std::uint64_t>(state.born);
  out.list<std::uint64_t>(state.died);
  out.count(state.recent_growth.size());
  out.count(stand.size());
  for (const auto* values : {&stand.x, &stand.y, &stand.stem_radius}) out.numbers<double>(*values);
  out.numbers<PlantId>(stand.id);
  out.numbers<std::int32_t>(stand.age);
  out.numbers<std::int32_t>(stand.ill_since);
  out.numbers<SpeciesIndex>(stand.species);
  for (const std::vector<float>& growth : state.recent_growth) out.numbers<float>(growth);
  out.count(state.seeds.size());
  for (const DormantSeed& seed : state.seeds) {
    out.number(seed.place.x);
    out.number(seed.place.y);
    out.number(seed.species);
  }
}

PopulationState read_state(ByteReader& in) {
  PopulationState state;
  Stand& stand = state.stand;
  state.step = in.number<std::int32_t>();
  state.next_id = in.number<PlantId>();
  state.born = in.list<std::uint64_t>();
  state.died = in.list<std::uint64_t>();
  state.recent_growth.resize(in.count(1));
  const std::size_t plants = in.count(plant_bytes + state.recent_growth.size() * sizeof(float));
  for (auto* values : {&stand.x, &stand.y, &stand.stem_radius})
    *values = in.numbers<double>(plants);
  stand.id = in.numbers<PlantId>(plants);
  stand.age = in.numbers<std::int32_t>(plants);
  stand.ill_since = in.numbers<std::int32_t>(plants);
  stand.species = in.numbers<SpeciesIndex>(plants);
  for (std::vector<float>& growth : state.recent_growth) growth = in.numbers<float>(plants);
  state.seeds.resize(in.count(2 * 8 + 2));
  for (DormantSeed& seed : state.seeds) {
    seed.place.x = in.number<double>();
    seed.place.y = in.number<double>();
    seed.species = in.number<SpeciesIndex>();
  }
  return state;
}

/// What the steps rely on, in case someone made the bytes.
void check_state(const PopulationState& state, const ByteReader& in) {
  const Stand& stand = state.stand;
  const std::size_t species = state.born.size();
  in.expect(state.step >= 0 && state.died.size() == species && !state.recent_growth.empty());
  for (std::size_t i = 0; i < stand.size(); ++i)
    in.expect(
        std::isfinite(stand.x[i]) && std::isfinite(stand.y[i]) && stand.stem_radius[i] > 0.0 &&
        std::isfinite(stand.stem_radius[i]) && stand.id[i] < state.next_id && stand.age[i] >= 0 &&
        stand.age[i] < std::numeric_limits<std::int32_t>::max() && stand.ill_since[i] >= healthy &&
        stand.ill_since[i] <= state.step && stand.species[i] < species);
  for (const DormantSeed& seed : state.seeds)
    in.expect(std::isfinite(seed.place.x) && std::isfinite(seed.place.y) && seed.species < species);
}

/// The bytes behind the header, which must be those that were written.
std::string_view checked_body(std::string_view bytes, const std::string& name) {
  if (!bytes.starts_with(magic))
    throw InputError(name +
                     ": is no checkpoint of a population; give the folder of phytobench "
                     "compete --out");
  ByteReader header(bytes.substr(magic.size()), name);
  const auto its_version = header.number<std::uint32_t>();
  if (its_version != version)
    throw InputError(fmt::format(
        "{}: has format {}, this program reads {}; go on with the program that wrote it, or start "
        "the run again",
        name, its_version, version));
  const auto length = header.number<std::uint64_t>(), checksum = header.number<std::uint64_t>();
  const std::string_view body = bytes.substr(header_size);
  header.expect(body.size() == length && digest(body) == checksum);
  return body;
}

}  // namespace

std::string checkpoint_bytes(std::span<const Setting> settings,
                             std::span<const std::uint64_t> tally, const PopulationState& state) {
  ByteWriter out;
  out.text.reserve(4096 +
                   state.stand.size() * (plant_bytes + sizeof(float) * state.recent_growth.size()));
  out.text.resize(header_size);  // what it says is known at the end
  out.count(settings.size());
  for (const Setting& setting : settings) {
    out.word(setting.key);
    out.word(setting.value);
  }
  out.list(tally);
  write_state(state, out);
  const std::string_view body = std::string_view(out.text).substr(header_size);
  ByteWriter header;
  header.text = magic;
  header.number(version);
  header.count(body.size());
  header.number(digest(body));
  std::copy(header.text.begin(), header.text.end(), out.text.begin());
  return std::move(out.text);
}

Checkpoint parse_checkpoint(std::string_view bytes, const std::string& name) {
  ByteReader in(checked_body(bytes, name), name);
  Checkpoint checkpoint;
  checkpoint.settings.resize(in.count(2 * 8));
  for (Setting& setting : checkpoint.settings) {
    setting.key = in.word();
    setting.value = in.word();
  }
  checkpoint.tally = in.list<std::uint64_t>();
  checkpoint.state = read_state(in);
  in.expect(in.is_at_end());
  check_state(checkpoint.state, in);
  return checkpoint;
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
  return parse_checkpoint(read_text_file(file, std::numeric_limits<std::uintmax_t>::max()),
                          file.string());
}

void refuse_other_settings(const Checkpoint& checkpoint, std::span<const Setting> settings,
                           const std::string& name) {
  constexpr const char* what_to_do = "go on with the same, or start again with another --out";
  const std::vector<Setting>& old = checkpoint.settings;
  for (const Setting& setting : settings) {
    const auto same_key = [&](const Setting& other) { return other.key == setting.key; };
    const auto found = std::find_if(old.begin(), old.end(), same_key);
    if (found == old.end())
      throw InputError(fmt::format("{}: was written without {} ({} now); {}", name, setting.key,
                                   setting.value, what_to_do));
    if (found->value != setting.value)
      throw InputError(fmt::format("{}: was written with {} = {}, not {}; {}", name, setting.key,
                                   found->value, setting.value, what_to_do));
  }
  for (const Setting& setting : old)
    if (std::none_of(settings.begin(), settings.end(),
                     [&](const Setting& other) { return other.key == setting.key; }))
      throw InputError(fmt::format("{}: was written with {} = {}, which is missing now; {}", name,
                                   setting.key, setting.value, what_to_do));
}

}  // namespace phytobench
