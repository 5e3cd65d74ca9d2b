// SPDX-License-Identifier: MIT
#include "core/record/whole_run.hpp"

#include <algorithm>
#include <optional>

#include "core/contract/errors.hpp"
#include "core/contract/sha256.hpp"
#include "core/contract/text_file.hpp"
#include "core/record/records_file.hpp"
#include "core/record/timings_file.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t most_bytes = std::uintmax_t{4} << 30;
constexpr const char* what_to_do =
    "; put an intact copy in the place of this folder, or run the experiments again";

std::string at_line(const fs::path& file, int line) {
  return file.string() + ":" + std::to_string(line) + ": ";
}

struct RunTexts {
  std::string records;
  std::optional<std::string> timings;
  std::optional<std::string> environment;
};

std::optional<std::string> text_if_there(const fs::path& file) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::nullopt;
  return read_text_file(file, most_bytes);
}

/// The files of one moment: a run that goes on appends to the timings before it touches another
/// file, so the others stood still while they were read if the timings have not grown.
RunTexts read_texts(const fs::path& folder) {
  RunTexts texts;
  for (int attempt = 0; attempt < 10; ++attempt) {
    texts.timings = text_if_there(folder / timings_name);
    texts.records = read_text_file(folder / records_name, most_bytes);
    texts.environment = text_if_there(folder / environment_name);
    std::error_code ignored;
    if (!texts.timings || fs::file_size(folder / timings_name, ignored) == texts.timings->size())
      break;
  }
  return texts;
}

/// What to do about a file in the place of a run's folder; it may be one of the run's.
std::string folder_instead_of(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  std::error_code ignored;
  return fs::exists(folder / records_name, ignored)
             ? "give the folder of its run, " + folder.string()
             : "give a folder that phytobench run --out has made";
}

void refuse_what_is_no_run(const fs::path& folder) {
  std::error_code ignored;
  if (fs::exists(folder, ignored) && !fs::is_directory(folder, ignored))
    throw InputError(folder.string() + ": is a file; " + folder_instead_of(folder));
  if (!fs::is_directory(folder, ignored))
    throw InputError(folder.string() + ": no such folder; make one with phytobench run --out");
  if (!fs::exists(folder / records_name, ignored))
    throw InputError(folder.string() + ": holds no " + records_name +
                     "; make one with phytobench run --out");
}

/// Each experiment of the records must have its timings, in the same order. An experiment whose
/// timings alone are there was being written when the program died; there can be one, the last.
void refuse_lost_experiments(const fs::path& folder, const RecordsFile& records,
                             const TimingsFile& timings) {
  const std::size_t both = std::min(records.experiments.size(), timings.experiments.size());
  for (std::size_t i = 0; i < both; ++i) {
    const TimingsFile::Experiment& timed = timings.experiments[i];
    if (timed.name != records.experiments[i].name ||
        timed.records_digest != records.experiments[i].digest)
      throw InputError(at_line(folder / timings_name, timed.line) + "the timings of '" +
                       timed.name + "' belong to other records than those in " + records_name +
                       what_to_do);
  }
  if (records.experiments.size() > both)
    throw InputError(at_line(folder / timings_name, timings.last.line) + "the timings of '" +
                     records.experiments[both].name + "' are lost, which should follow" +
                     what_to_do);
  if (timings.experiments.size() > both + 1)
    throw InputError(at_line(folder / records_name, records.last.line) + "the records of '" +
                     timings.experiments[both].name + "' are lost, which should follow" +
                     what_to_do);
}

/// Takes out the experiment of which there are only timings.
void drop_unfinished(TimingsFile& timings, std::size_t complete) {
  if (timings.experiments.size() == complete) return;
  const TimingsFile::Experiment unfinished = timings.experiments.back();
  timings.timings.resize(timings.timings.size() - unfinished.timings);
  timings.last = unfinished.before;
  timings.experiments.pop_back();
  std::erase_if(timings.sessions,
                [&](const auto& session) { return session.experiments > complete; });
}

/// The experiment that was left out because its lines break off.
std::optional<std::string> unfinished_of(const RecordsFile& records, const TimingsFile& timings) {
  if (timings.experiments.size() > records.experiments.size())
    return timings.experiments.back().name;
  return records.unfinished ? records.unfinished : timings.unfinished;
}

/// environment.json must be that of the start of the run in which the last experiment was measured,
/// or of a later start, which has measured nothing yet.
void refuse_other_environment(const fs::path& folder, const std::optional<std::string>& environment,
                              const TimingsFile& timings) {
  if (timings.experiments.empty() || (!environment && timings.sessions.empty())) return;
  const std::string file = (folder / environment_name).string();
  if (!environment) throw InputError(file + ": is lost" + what_to_do);
  const std::string digest = sha256_hex(*environment);
  bool is_known = false;
  for (const TimingsFile::Session& session : timings.sessions) {
    if (session.experiments < timings.experiments.size()) is_known = false;
    is_known = is_known || session.environment_digest == digest;
  }
  if (!is_known)
    throw InputError(file +
                     ": was changed since the run wrote it, or is of another run (its SHA-256 is "
                     "not in " +
                     timings_name + ")" + what_to_do);
}

void refuse_other_artifacts(const fs::path& folder, const TimingsFile& timings) {
  for (const TimingsFile::Experiment& experiment : timings.experiments)
    for (const auto& [name, digest] : experiment.artifacts) {
      const fs::path file = folder / artifacts_name / experiment.name / name;
      std::error_code ignored;
      const bool exists = fs::exists(file, ignored);
      if (!exists && is_full_size(name)) continue;
      if (exists && sha256_hex(read_text_file(file, most_bytes)) == digest) continue;
      throw InputError(file.string() + (exists ? ": was changed" : ": is lost") + " since '" +
                       experiment.name + "' wrote it" + what_to_do);
    }
}

/// By their path below artifacts/.
std::set<std::string> artifacts_of(const fs::path& folder, const TimingsFile& timings) {
  std::set<std::string> artifacts;
  for (const TimingsFile::Experiment& experiment : timings.experiments)
    for (const auto& [name, digest] : experiment.artifacts)
      if (fs::exists(folder / artifacts_name / experiment.name / name))
        artifacts.insert(experiment.name + "/" + name);
  return artifacts;
}

}  // namespace

bool is_full_size(const fs::path& artifact) {
  return artifact.stem().extension() == ".full";
}

WholeRun read_whole_run(const fs::path& folder) {
  refuse_what_is_no_run(folder);
  const RunTexts texts = read_texts(folder);
  RecordsFile records = parse_records(folder / records_name, texts.records);
  if (!texts.timings) throw InputError((folder / timings_name).string() + ": is lost" + what_to_do);
  TimingsFile timings = parse_timings(folder / timings_name, *texts.timings);
  refuse_lost_experiments(folder, records, timings);
  std::optional<std::string> unfinished = unfinished_of(records, timings);
  drop_unfinished(timings, records.experiments.size());
  refuse_other_environment(folder, texts.environment, timings);
  refuse_other_artifacts(folder, timings);
  WholeRun run{.contents = {.header = records.header,
                            .records = std::move(records.records),
                            .timings = std::move(timings.timings),
                            .complete_experiments = {},
                            .artifacts = artifacts_of(folder, timings),
                            .unfinished = std::move(unfinished)},
               .last_of_records = records.last,
               .last_of_timings = timings.last};
  for (const RecordsFile::Experiment& experiment : records.experiments)
    run.contents.complete_experiments.insert(experiment.name);
  return run;
}

}  // namespace phytobench
