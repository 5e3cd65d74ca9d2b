// SPDX-License-Identifier: MIT
#include "core/population/checkpoint.hpp"

#include <functional>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/little_endian.hpp"
#include "core/population/test_populations.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using namespace testing_populations;

constexpr std::size_t header_size = 28;
const std::vector<std::uint64_t> tally = {3, 0, 1ull << 63};

/// Plants of all ages, seeds at rest, ill ones.
PopulationState lively_state() {
  return after(lively(), 14).state();
}

std::string bytes_of(const PopulationState& state) {
  return checkpoint_bytes(settings_of(lively()), tally, state);
}

std::string refusal_of(const std::string& bytes) {
  try {
    parse_checkpoint(bytes, "a.bin");
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

/// With length and checksum that fit the body again.
std::string sealed(std::string bytes) {
  ByteWriter header;
  header.count(bytes.size() - header_size);
  header.number(digest(std::string_view(bytes).substr(header_size)));
  return bytes.replace(12, 16, header.text);
}

TEST(Checkpoint, KeepsEveryBitOfTheState) {
  const PopulationState state = lively_state();
  ASSERT_GT(state.seeds.size(), 0u);
  ASSERT_GT(state.stand.size(), 20u);
  const Checkpoint back = parse_checkpoint(bytes_of(state), "a.bin");
  EXPECT_TRUE(same(back.state, state));
  EXPECT_EQ(back.tally, tally);
  EXPECT_EQ(back.settings, settings_of(lively()));
  EXPECT_EQ(checkpoint_bytes(back.settings, back.tally, back.state), bytes_of(state));
}

TEST(Checkpoint, APopulationTakenUpAgainDoesTheSame) {
  const Checkpoint back = parse_checkpoint(bytes_of(lively_state()), "a.bin");
  Population population(lively(), back.state, overlap_engine_named("layered_grid"));
  for (int i = 0; i < 11; ++i) population.step();
  EXPECT_TRUE(same(population.state(), after(lively(), 25).state()));
}

TEST(Checkpoint, KeepsAStandWithoutPlants) {
  PopulationState empty = sow(one_species(0));
  EXPECT_TRUE(same(parse_checkpoint(bytes_of(empty), "a.bin").state, empty));
}

TEST(Checkpoint, HasTheLayoutItsHeaderSays) {
  const std::string bytes = bytes_of(lively_state());
  EXPECT_EQ(bytes.substr(0, 12), std::string("phytopop\x01\0\0\0", 12));
  const auto low_byte = static_cast<unsigned char>(bytes[12]);
  EXPECT_EQ(low_byte, (bytes.size() - header_size) % 256);
}

TEST(Checkpoint, NoticesEveryByteThatIsAltered) {
  const std::string bytes = bytes_of(after(one_species(4), 2).state());
  for (std::size_t at = 0; at < bytes.size(); ++at) {
    std::string altered = bytes;
    altered[at] = static_cast<char>(altered[at] ^ (1 << at % 8));
    EXPECT_THAT(refusal_of(altered), testing::StartsWith("a.bin: ")) << at;
  }
}

TEST(Checkpoint, NoticesEveryByteThatIsMissingOrTooMuch) {
  const std::string bytes = bytes_of(after(one_species(4), 2).state());
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_THAT(refusal_of(bytes.substr(0, size)), testing::StartsWith("a.bin: ")) << size;
  EXPECT_THAT(refusal_of(bytes + '\0'), HasSubstr("damaged"));
}

TEST(Checkpoint, SaysWhatElseAFileIs) {
  EXPECT_THAT(refusal_of("x,y,r\n1,2,3\n"), HasSubstr("no checkpoint of a population"));
  std::string newer = bytes_of(lively_state());
  newer[8] = 2;
  EXPECT_THAT(refusal_of(newer), HasSubstr("format 2, this program reads 1"));
  EXPECT_THROW(read_checkpoint("no/such/file.bin"), InputError);
}

TEST(Checkpoint, TrustsNoLengthInABodyThatSomeoneMade) {
  const std::string bytes = bytes_of(lively_state());
  for (std::size_t at = header_size; at + 8 <= bytes.size(); ++at) {
    std::string made = bytes;
    made.replace(at, 8, 8, '\xff');
    const std::string refusal = refusal_of(sealed(made));
    EXPECT_TRUE(refusal == "accepted" || refusal.starts_with("a.bin: is damaged")) << refusal;
  }
  EXPECT_THAT(refusal_of(sealed(bytes + "more")), HasSubstr("damaged"));
  EXPECT_THAT(refusal_of(sealed(bytes.substr(0, bytes.size() - 1))), HasSubstr("damaged"));
}

TEST(Checkpoint, RefusesAStateThatStepsCannotGoOnFrom) {
  const auto refusal = [](const std::function<void(PopulationState&)>& spoil) {
    PopulationState state = lively_state();
    spoil(state);
    return refusal_of(bytes_of(state));
  };
  EXPECT_EQ(refusal([](PopulationState&) {}), "accepted");
  for (const auto& spoil : std::vector<std::function<void(PopulationState&)>>{
           [](PopulationState& s) { s.stand.species[3] = 2; },
           [](PopulationState& s) { s.stand.x[3] = NAN; },
           [](PopulationState& s) { s.stand.stem_radius[0] = 0.0; },
           [](PopulationState& s) { s.stand.id[1] = s.next_id; },
           [](PopulationState& s) { s.stand.ill_since[1] = s.step + 1; },
           [](PopulationState& s) { s.seeds[0].species = 7; },
           [](PopulationState& s) { s.recent_growth.clear(); },
           [](PopulationState& s) { s.died.push_back(0); },
           [](PopulationState& s) { s.step = -1; }})
    EXPECT_THAT(refusal(spoil), HasSubstr("damaged"));
}

TEST(Checkpoint, OfOtherSettingsIsRefusedByTheirName) {
  const Checkpoint checkpoint = parse_checkpoint(bytes_of(lively_state()), "a.bin");
  refuse_other_settings(checkpoint, settings_of(lively()), "a.bin");
  const auto refusal = [&](const std::vector<Setting>& settings) -> std::string {
    try {
      refuse_other_settings(checkpoint, settings, "a.bin");
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_THAT(refusal(settings_of(lively(2))),
              HasSubstr("a.bin: was written with seed = 1, not 2"));
  PopulationParameters other = lively();
  other.rule = "none";
  EXPECT_THAT(refusal(settings_of(other)), HasSubstr("competition.rule = combined, not none"));
  std::vector<Setting> settings = settings_of(lively());
  settings.push_back({"--every", "3"});
  EXPECT_THAT(refusal(settings), HasSubstr("without --every"));
  settings.pop_back();
  settings.erase(settings.begin());
  EXPECT_THAT(refusal(settings), HasSubstr("seed = 1, which is missing now"));
}

}  // namespace
}  // namespace phytobench
