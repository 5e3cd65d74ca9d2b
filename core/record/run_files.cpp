// SPDX-License-Identifier: MIT
#include "core/record/run_files.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <functional>
#include <map>
#include <memory>

#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

constexpr const char* schema = "phytobench/records-1";
constexpr const char* records_name = "records.jsonl";
constexpr const char* timings_name = "timings.jsonl";

std::string header_line(const RunHeader& header) {
  ordered_json line;
  line["schema"] = schema;
  line["tier"] = name_of(header.tier);
  line["seed"] = header.seed;
  return line.dump() + "\n";
}

std::string completion_line(const std::string& experiment, std::size_t records) {
  ordered_json line;
  line["experiment"] = experiment;
  line["complete"] = true;
  line["records"] = records;
  return line.dump() + "\n";
}

/// Calls use(object, line number) for each line. A last line without line end was being written
/// when the run died and is left out; anything else that is no JSON object is an error.
void for_each_line(const fs::path& file, const std::function<void(const ordered_json&, int)>& use) {
  const std::string text = read_text_file(file, std::uintmax_t{4} << 30);
  int number = 0;
  for (std::size_t start = 0; start < text.size();) {
    ++number;
    const std::size_t end = text.find('\n', start);
    if (end == std::string::npos) return;
    const auto where = [&] { return file.string() + ":" + std::to_string(number) + ": "; };
    try {
      const ordered_json line =
          ordered_json::parse(text.begin() + static_cast<std::ptrdiff_t>(start),
                              text.begin() + static_cast<std::ptrdiff_t>(end));
      use(line, number);
    } catch (const nlohmann::json::exception& error) {
      throw InputError(where() + "damaged record (" + error.what() +
                       "); run the experiments again");
    } catch (const InputError& error) {
      throw InputError(where() + error.what());
    }
    start = end + 1;
  }
}

Record record_from(const ordered_json& line) {
  Record record{
      .experiment = line.at("experiment"), .measurement = line.at("measurement"), .value = {}};
  const ordered_json& value = line.at("value");
  if (value.is_number_integer())
    record.value = value.get<std::int64_t>();
  else if (value.is_number())
    record.value = value.get<double>();
  else if (value.is_string())
    record.value = value.get<std::string>();
  else
    throw InputError("measurement '" + record.measurement + "' holds neither number nor text");
  record.unit = line.at("unit");
  record.sample_size = line.at("n");
  if (line.contains("spread")) record.spread = line.at("spread").get<double>();
  if (line.contains("seed")) record.seed = line.at("seed").get<std::uint64_t>();
  return record;
}

TimingSample timing_from(const ordered_json& line) {
  TimingSample sample{.experiment = line.at("experiment"),
                      .measurement = line.at("measurement"),
                      .round = line.at("round"),
                      .position = line.at("position"),
                      .threads = line.at("threads")};
  if (line.contains("seconds")) {
    sample.value = line.at("seconds");
  } else {
    sample.value = line.at("value");
    sample.unit = line.at("unit");
  }
  if (!(sample.value > 0.0)) throw InputError("a timing must be positive seconds");
  return sample;
}

RunHeader header_from(const ordered_json& line) {
  if (!line.contains("schema") || line.at("schema") != schema)
    throw InputError(std::string("not a run of this suite: the first line must name the schema ") +
                     schema);
  return {tier_named(line.at("tier").get<std::string>()), line.at("seed").get<std::uint64_t>()};
}

/// Collects records per experiment until its completion line says how many there must be.
class RecordCollector {
 public:
  void add(const ordered_json& line) {
    if (!line.contains("complete")) {
      Record record = record_from(line);
      pending_[record.experiment].push_back(std::move(record));
      return;
    }
    const std::string experiment = line.at("experiment");
    std::vector<Record>& own = pending_[experiment];
    if (own.size() != line.at("records").get<std::size_t>())
      throw InputError("experiment '" + experiment + "' lost or gained records");
    if (!contents.complete_experiments.insert(experiment).second)
      throw InputError("experiment '" + experiment + "' stands here twice");
    for (Record& record : own) {
      if (!seen_.insert(record.measurement).second)
        throw InputError("measurement '" + record.measurement + "' stands here twice");
      contents.records.push_back(std::move(record));
    }
    own.clear();
  }

  RunContents contents;

 private:
  std::map<std::string, std::vector<Record>> pending_;
  std::set<std::string> seen_;
};

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

/// Appends, or leaves the file as long as it was.
void append_or_restore(const fs::path& file, const std::string& text) {
  std::error_code error;
  const std::uintmax_t old_size = fs::exists(file) ? fs::file_size(file, error) : 0;
  const std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(file.c_str(), "ab"));
  const bool written = stream != nullptr &&
                       std::fwrite(text.data(), 1, text.size(), stream.get()) == text.size() &&
                       std::fflush(stream.get()) == 0 && ::fsync(::fileno(stream.get())) == 0;
  if (written) return;
  const int reason = errno;
  fs::resize_file(file, old_size, error);
  throw EnvironmentError("cannot write " + file.string() + ": " + std::strerror(reason) +
                         "; finished experiments are kept, make room and use --resume");
}

template <class Line>
std::string joined_lines(std::span<const Line> lines) {
  std::string text;
  for (const Line& line : lines) text += to_json_line(line) + "\n";
  return text;
}

}  // namespace

RunContents read_run(const fs::path& folder) {
  const fs::path records = folder / records_name;
  if (!fs::is_directory(folder))
    throw InputError(folder.string() + ": no such folder; make one with phytobench run --out");
  if (!fs::exists(records))
    throw InputError(folder.string() + ": holds no " + records_name +
                     "; make one with phytobench run --out");
  RecordCollector collector;
  bool has_header = false;
  for_each_line(records, [&](const ordered_json& line, int number) {
    if (number > 1) return collector.add(line);
    collector.contents.header = header_from(line);
    has_header = true;
  });
  if (!has_header) throw InputError(records.string() + ": is empty; run the experiments again");
  RunContents contents = std::move(collector.contents);
  if (fs::exists(folder / timings_name))
    for_each_line(folder / timings_name, [&](const ordered_json& line, int) {
      TimingSample sample = timing_from(line);
      if (contents.complete_experiments.contains(sample.experiment))
        contents.timings.push_back(std::move(sample));
    });
  return contents;
}

std::string read_environment(const fs::path& folder) {
  const fs::path file = folder / "environment.json";
  return fs::exists(file) ? read_text_file(file) : "{}";
}

RunWriter::RunWriter(fs::path folder, const RunHeader& header, RunMode mode)
    : folder_(std::move(folder)) {
  const fs::path records = folder_ / records_name;
  if (!fs::exists(records)) {
    make_folder(folder_);
    write_file_atomically(folder_ / timings_name, "");
    write_file_atomically(records, header_line(header));
    return;
  }
  if (mode == RunMode::fresh)
    throw InputError(folder_.string() +
                     ": already holds records; use --resume to go on with them, or "
                     "another --out");
  const RunContents old = read_run(folder_);
  if (old.header != header)
    throw InputError(folder_.string() + ": was begun with --tier " +
                     std::string(name_of(old.header.tier)) + " --seed " +
                     std::to_string(old.header.seed) +
                     "; resume with the same or use another --out");
  // Write back what is whole, so that nothing half-written stays in between.
  complete_ = old.complete_experiments;
  std::string text = header_line(header);
  std::map<std::string, std::vector<Record>> by_experiment;
  std::vector<std::string> order;
  for (const Record& record : old.records) {
    if (!by_experiment.contains(record.experiment)) order.push_back(record.experiment);
    by_experiment[record.experiment].push_back(record);
  }
  for (const std::string& experiment : complete_)
    if (!by_experiment.contains(experiment))
      order.push_back(experiment);  // it had nothing to record
  for (const std::string& experiment : order) {
    const std::vector<Record>& own = by_experiment[experiment];
    text += joined_lines<Record>(own) + completion_line(experiment, own.size());
  }
  write_file_atomically(folder_ / timings_name, joined_lines<TimingSample>(old.timings));
  write_file_atomically(records, text);
}

void RunWriter::append(const std::string& experiment, std::span<const Record> records,
                       std::span<const TimingSample> timings) {
  // Timings first: they count only once the records say the experiment is complete.
  append_or_restore(folder_ / timings_name, joined_lines(timings));
  append_or_restore(folder_ / records_name,
                    joined_lines(records) + completion_line(experiment, records.size()));
  complete_.insert(experiment);
}

void RunWriter::write_environment(const std::string& json) {
  write_file_atomically(folder_ / "environment.json", json);
}

void RunWriter::write_artifact(const std::string& experiment, const std::string& name,
                               const std::string& content) {
  write_file_atomically(folder_ / "artifacts" / experiment / name, content);
}

}  // namespace phytobench
