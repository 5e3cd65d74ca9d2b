// SPDX-License-Identifier: MIT
#include "reports/write_report.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "reference/data_folder.hpp"
#include "reports/csv.hpp"
#include "reports/document.hpp"
#include "reports/render_template.hpp"
#include "reports/scaling_plots.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

void check_formats(const std::vector<std::string>& formats) {
  for (const std::string& format : formats)
    if (format != "html" && format != "md" && format != "csv")
      throw InputError("unknown report format '" + format + "'; use html, md or csv");
}

/// Artifacts of the run with that extension, by their path below artifacts/.
std::map<std::string, std::string> artifacts_of(const fs::path& run_folder,
                                                std::string_view extension) {
  std::map<std::string, std::string> pictures;
  const fs::path artifacts = run_folder / "artifacts";
  if (!fs::is_directory(artifacts)) return pictures;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(artifacts))
    if (entry.path().extension() == extension)
      pictures[fs::relative(entry.path(), artifacts).string()] = read_text_file(entry.path());
  return pictures;
}

std::string verdicts_json(const JudgedRun& judged, bool without_varying) {
  ordered_json json;
  json["schema"] = "phytobench/verdicts-1";
  json["tier"] = name_of(judged.run.header.tier);
  json["seed"] = judged.run.header.seed;
  json["claims"] = ordered_json::array();
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements) {
      const Claim& claim = *judgement.claim;
      if (without_varying && judgement.varies) continue;
      ordered_json row{{"id", claim.id},
                       {"verdict", name_of(judgement.verdict)},
                       {"basis", claim.basis},
                       {"published", claim.published},
                       {"measured", judgement.measured},
                       {"expected", name_of(claim.expected_verdict)}};
      row["digits"] = claim.digits ? ordered_json(*claim.digits) : ordered_json(nullptr);
      row["reason"] = judgement.reason;
      json["claims"].push_back(row);
    }
  return json.dump(2) + "\n";
}

ReportSummary summary_of(const JudgedRun& judged) {
  ReportSummary summary;
  std::map<Verdict, std::size_t> counts;
  std::size_t fitted = 0;
  std::string unexpected;
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements) {
      if (is_fitted(judgement))
        ++fitted;
      else
        ++counts[judgement.verdict];
      summary.inconclusive += judgement.verdict == Verdict::inconclusive;
      if (!judgement.is_unexpected()) continue;
      ++summary.unexpected;
      unexpected += fmt::format("unexpected: {} is '{}', expected '{}' ({})\n", judgement.claim->id,
                                name_of(judgement.verdict),
                                name_of(judgement.claim->expected_verdict), judgement.measured);
    }
  const auto add_line = [&](std::size_t count, std::string_view name) {
    if (count > 0) summary.text += fmt::format("{:4}  {}\n", count, name);
  };
  for (const Verdict verdict : all_verdicts) {
    add_line(counts[verdict], name_of(verdict));
    if (verdict == Verdict::reproduced) add_line(fitted, fitted_row);
  }
  summary.text += unexpected;
  return summary;
}

std::string load_template(const std::string& name) {
  return read_text_file(data_folder() / "templates" / name);
}

}  // namespace

ReportSummary write_report(const ReportRequest& request) {
  check_formats(request.formats);
  const JudgedRun judged = judge_run(read_run(request.run_folder));
  const auto plots = scaling_plots(judged.scaling, request.without_varying);
  const auto photographs = artifacts_of(request.run_folder, ".jpg");
  const ordered_json document =
      make_document(judged, {.environment_json = read_environment(request.run_folder),
                             .run_folder = request.run_folder.string(),
                             .pictures = artifacts_of(request.run_folder, ".svg"),
                             .photographs = photographs,
                             .plots = plots,
                             .without_varying = request.without_varying});
  const auto wanted = [&](const char* format) {
    return std::find(request.formats.begin(), request.formats.end(), format) !=
           request.formats.end();
  };
  for (const auto& [name, svg] : plots)
    write_file_atomically(request.out_folder / "figures" / (name + ".svg"), svg);
  for (const auto& [name, bytes] : photographs)
    write_file_atomically(request.out_folder / figure_file(name), bytes);
  if (wanted("html"))
    write_file_atomically(
        request.out_folder / "index.html",
        render_template(load_template("report.html.mustache"), document, EscapeFor::html));
  if (wanted("md"))
    write_file_atomically(
        request.out_folder / "report.md",
        render_template(load_template("report.md.mustache"), document, EscapeFor::markdown));
  if (wanted("csv")) {
    write_file_atomically(request.out_folder / "claims.csv",
                          claims_csv(judged, request.without_varying));
    write_file_atomically(request.out_folder / "records.csv", records_csv(judged.run));
  }
  write_file_atomically(request.out_folder / "verdicts.json",
                        verdicts_json(judged, request.without_varying));
  return summary_of(judged);
}

}  // namespace phytobench
