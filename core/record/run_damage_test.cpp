// SPDX-License-Identifier: MIT
// Every way to damage the files of a small run: reading must refuse it, naming file and line. Only
// a cut in the last experiment of the records may pass, because a run that was killed looks so;
// that experiment then does not count and is named.
#include <regex>

#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

std::string shown(const RunContents& run) {
  std::string text = std::string(name_of(run.header.tier)) + std::to_string(run.header.seed) + "\n";
  for (const Record& record : run.records) text += to_json_line(record) + "\n";
  for (const TimingSample& sample : run.timings) text += to_json_line(sample) + "\n";
  for (const std::string& experiment : run.complete_experiments) text += experiment + "\n";
  for (const std::string& artifact : run.artifacts) text += artifact + "\n";
  if (run.unfinished) text += "without " + *run.unfinished + "\n";
  return text;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size() - 1) + 1;
    lines.push_back(text.substr(start, end - start));
    start = end;
  }
  return lines;
}

std::string joined(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line;
  return text;
}

/// Runs of lines up to and with a sealed one.
std::vector<std::string> sections_of(const std::string& text) {
  std::vector<std::string> sections{""};
  for (const std::string& line : lines_of(text)) {
    sections.back() += line;
    if (line.find("\"sha256\"") != std::string::npos) sections.emplace_back();
  }
  sections.pop_back();
  return sections;
}

enum class Reading { as_before, without_the_last, refused };

class RunDamage : public RunFolder {
 protected:
  void SetUp() override {
    RunFolder::SetUp();
    write_three_experiments(folder_, quick_seven, 0.0);
    whole_ = shown(read_run(folder_));
    const std::string records = read_text_file(records_file());
    std::vector<std::string> sections = sections_of(records);
    start_of_last_ = records.size() - sections.back().size();
    sections.pop_back();
    overwrite(records_file(), joined(sections));
    without_last_ = shown(read_run(folder_));
    overwrite(records_file(), records);
    ASSERT_NE(whole_, without_last_);
    ASSERT_TRUE(without_last_.ends_with("without p/three\n"));
  }

  static void write_three_experiments(const fs::path& folder, const RunHeader& header,
                                      double shift) {
    RunWriter writer(folder, header, RunMode::fresh);
    writer.write_environment("{\"shift\":" + std::to_string(shift) + "}\n");
    for (const char* name : {"p/one", "p/two", "p/three"}) {
      writer.write_artifact(name, "tree.svg", "<svg>" + std::to_string(shift) + "</svg>");
      const std::vector<Record> records{record_of(name, "share", 0.1 + shift),
                                        record_of(name, "hash", std::string("00ff"))};
      const std::vector<TimingSample> timings{timing_of(name, 0.5 + shift),
                                              timing_of(name, 0.25 + shift)};
      writer.append(name, records, timings);
    }
  }

  std::vector<fs::path> line_files() const { return {records_file(), timings_file()}; }

  std::vector<fs::path> files() const {
    return {records_file(), timings_file(), environment_file(),
            folder_ / "artifacts" / "p" / "two" / "tree.svg"};
  }

  /// Reads the run with a file replaced, and puts that back.
  Reading reading_with(const fs::path& file, const std::string& text) const {
    const std::string before = read_text_file(file);
    overwrite(file, text);
    Reading reading = Reading::refused;
    try {
      const std::string found = shown(read_run(folder_));
      reading = found == whole_ ? Reading::as_before : Reading::without_the_last;
      EXPECT_TRUE(found == whole_ || found == without_last_) << "read as\n" << found;
    } catch (const InputError& error) {
      expect_place(error.what());
    }
    overwrite(file, before);
    return reading;
  }

  void expect_refused(const fs::path& file, const std::string& text, const std::string& damage) {
    EXPECT_EQ(reading_with(file, text), Reading::refused) << file << ": " << damage;
  }

  std::string whole_;              ///< what the run holds
  std::string without_last_;       ///< the same without its last experiment
  std::size_t start_of_last_ = 0;  ///< byte of the records

 private:
  void expect_place(const std::string& message) const {
    static const std::regex place(R"(.*/((records|timings)\.jsonl:[1-9][0-9]*|environment\.json)"
                                  R"(|artifacts/p/[a-z]+/tree\.svg): [^\n]*; [^\n]*)");
    EXPECT_TRUE(message.starts_with(folder_.string())) << message;
    EXPECT_TRUE(std::regex_match(message, place)) << message;
  }
};

TEST_F(RunDamage, FlippedBitIsRefusedAtEveryByte) {
  for (const fs::path& file : files()) {
    const std::string text = read_text_file(file);
    for (std::size_t byte = 0; byte < text.size(); ++byte) {
      std::string damaged = text;
      damaged[byte] = static_cast<char>(damaged[byte] ^ (1 << (byte * 5 % 8)));
      expect_refused(file, damaged, "byte " + std::to_string(byte));
    }
  }
}

TEST_F(RunDamage, CutIsRefusedAtEveryLengthButInTheLastExperiment) {
  for (const fs::path& file : files()) {
    const std::string text = read_text_file(file);
    for (std::size_t length = 0; length < text.size(); ++length) {
      const bool looks_killed = file == records_file() && length >= start_of_last_;
      EXPECT_EQ(reading_with(file, text.substr(0, length)),
                looks_killed ? Reading::without_the_last : Reading::refused)
          << file << " of length " << length;
    }
  }
}

TEST_F(RunDamage, LineLostRepeatedOrSwappedIsRefused) {
  for (const fs::path& file : line_files()) {
    const std::vector<std::string> lines = lines_of(read_text_file(file));
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const auto place = static_cast<std::ptrdiff_t>(i);
      std::vector<std::string> repeated = lines, swapped = lines, fewer = lines;
      repeated.insert(repeated.begin() + place, lines[i]);
      expect_refused(file, joined(repeated), "repeated " + lines[i]);
      std::swap(swapped[i], swapped[(i + 1) % lines.size()]);
      if (swapped != lines) expect_refused(file, joined(swapped), "swapped " + lines[i]);
      fewer.erase(fewer.begin() + place);
      if (file == records_file() && i + 1 == lines.size())
        EXPECT_EQ(reading_with(file, joined(fewer)), Reading::without_the_last);
      else
        expect_refused(file, joined(fewer), "lost " + lines[i]);
    }
  }
}

TEST_F(RunDamage, ExperimentLostRepeatedOrSwappedIsRefused) {
  for (const fs::path& file : line_files()) {
    const std::vector<std::string> sections = sections_of(read_text_file(file));
    for (std::size_t i = 0; i < sections.size(); ++i) {
      const auto place = static_cast<std::ptrdiff_t>(i);
      for (std::size_t other = 0; other < sections.size(); ++other) {
        std::vector<std::string> swapped = sections, repeated = sections;
        std::swap(swapped[i], swapped[other]);
        if (other != i) expect_refused(file, joined(swapped), "swapped " + sections[i]);
        repeated.insert(repeated.begin() + static_cast<std::ptrdiff_t>(other), sections[i]);
        expect_refused(file, joined(repeated), "repeated " + sections[i]);
      }
      std::vector<std::string> fewer = sections;
      fewer.erase(fewer.begin() + place);
      if (file == timings_file() || i + 1 < sections.size())
        expect_refused(file, joined(fewer), "lost " + sections[i]);
    }
  }
}

TEST_F(RunDamage, WhatIsOfAnotherRunIsRefused) {
  const fs::path other_folder = base_ / "other";
  write_three_experiments(other_folder, {Tier::quick, 8}, 0.01);
  for (const fs::path& file : files()) {
    const std::string text = read_text_file(file);
    const std::string foreign = read_text_file(other_folder / fs::relative(file, folder_));
    expect_refused(file, foreign, "as a whole");
    const auto expect_each_refused = [&](const std::vector<std::string>& own,
                                         const std::vector<std::string>& others) {
      ASSERT_EQ(own.size(), others.size());
      for (std::size_t i = 0; i < own.size(); ++i) {
        std::vector<std::string> mixed = own;
        mixed[i] = others[i];
        if (mixed != own) expect_refused(file, joined(mixed), "of another run: " + others[i]);
      }
    };
    expect_each_refused(lines_of(text), lines_of(foreign));
    if (file == records_file() || file == timings_file())
      expect_each_refused(sections_of(text), sections_of(foreign));
  }
}

}  // namespace
}  // namespace phytobench
