// SPDX-License-Identifier: MIT
#include "reports/report_files.hpp"

#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"
#include "reference/data_folder.hpp"
#include "reports/csv.hpp"
#include "reports/document.hpp"
#include "reports/document_comparison.hpp"
#include "reports/document_validation.hpp"
#include "reports/errata_letter.hpp"
#include "reports/junit_xml.hpp"
#include "reports/latex_files.hpp"
#include "reports/render_template.hpp"
#include "reports/scaling_plots.hpp"
#include "reports/verdicts_json.hpp"

namespace phytobench {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

/// Path of a file from a folder that it lies below; empty for any other file.
std::string path_below(const fs::path& folder, const fs::path& file) {
  const fs::path path = fs::weakly_canonical(file).lexically_relative(fs::weakly_canonical(folder));
  return path.empty() || *path.begin() == ".." ? "" : path.generic_string();
}

/// Replaces the value of every key "file" that is one of `links`.
void link_files(ordered_json& document, const std::map<std::string, std::string>& links) {
  if (document.is_object() && document.contains("file") && document["file"].is_string())
    if (const auto link = links.find(document["file"].get<std::string>()); link != links.end())
      document["file"] = link->second;
  if (document.is_structured())
    for (ordered_json& part : document) link_files(part, links);
}

class FilesBuilder {
 public:
  FilesBuilder(const ReportInput& input, const ReportFilesOptions& options)
      : input_(input), options_(options) {}

  ReportFiles build() {
    if (options_.formats.has_pictures()) add_pages();
    if (options_.formats.latex) files_.merge(latex_files(input_.judged, options_.without_varying));
    if (options_.formats.csv) add_csv();
    if (options_.formats.junit)
      files_["junit.xml"] = junit_xml(input_.judged, options_.without_varying, comparison());
    files_["verdicts.json"] = verdicts_json(input_.judged, comparison(), options_.without_varying);
    return std::move(files_);
  }

 private:
  const RunComparison* comparison() const {
    return input_.comparison ? &*input_.comparison : nullptr;
  }

  void add_pages() {
    plots_ = scaling_plots(input_.judged.scaling, options_.without_varying);
    for (const auto& [name, svg] : plots_) files_["figures/" + name + ".svg"] = svg;
    for (auto& [name, csv] : scaling_plot_data(input_.judged.scaling, options_.without_varying))
      files_["figures/" + name + ".csv"] = csv;
    add_pictures(input_.drawings);
    add_pictures(input_.photographs);
    add_pictures(input_.plot_data);
    const ordered_json document = page_document();
    const fs::path templates = data_folder() / "templates";
    if (options_.formats.html)
      files_["index.html"] = render_report(templates, document, EscapeFor::html);
    if (!options_.formats.markdown) return;
    files_["report.md"] = render_report(templates, document, EscapeFor::markdown);
    for (const JudgedPaper& paper : input_.judged.papers)
      files_["errata-" + paper.paper.key + ".md"] = errata_letter(paper, options_.without_varying);
  }

  void add_pictures(const std::map<std::string, Picture>& pictures) {
    for (const auto& [name, picture] : pictures) {
      const std::string link = path_below(options_.folder, picture.file);
      if (link.empty())
        files_[figure_file(name)] = picture.bytes;
      else
        links_[figure_file(name)] = link;
    }
  }

  static std::map<std::string, std::string> bytes_of(
      const std::map<std::string, Picture>& pictures) {
    std::map<std::string, std::string> bytes;
    for (const auto& [name, picture] : pictures) bytes[name] = picture.bytes;
    return bytes;
  }

  static void add(ordered_json& document, const std::string& slot, ordered_json part) {
    document["has_" + slot] = true;
    document[slot] = std::move(part);
  }

  ordered_json page_document() const {
    ordered_json document =
        make_document(input_.judged, {.environment_json = input_.environments.front(),
                                      .run_folder = input_.run_folders.front().string(),
                                      .pictures = bytes_of(input_.drawings),
                                      .photographs = bytes_of(input_.photographs),
                                      .plots = plots_,
                                      .without_varying = options_.without_varying,
                                      .plot_data = bytes_of(input_.plot_data),
                                      .experiments = options_.experiments,
                                      .comparison = comparison(),
                                      .captions = input_.captions});
    link_files(document, links_);
    if (comparison())
      add(document, "comparison",
          comparison_document(input_.judged, *comparison(), input_.environments,
                              options_.without_varying));
    if (const Validation validation = validation_of(input_.judged.run); validation.any())
      add(document, "validation", validation_document(validation, options_.without_varying));
    return document;
  }

  void add_csv() {
    files_["claims.csv"] = claims_csv(input_.judged, options_.without_varying);
    if (!comparison()) {
      files_["records.csv"] = records_csv(input_.judged.run, options_.without_varying);
      return;
    }
    files_["records.csv"] = records_csv(comparison()->runs, options_.without_varying);
    files_["claims-by-run.csv"] = claims_by_run_csv(*comparison(), options_.without_varying);
    files_["records-that-differ.csv"] = differing_records_csv(*comparison());
  }

  const ReportInput& input_;
  const ReportFilesOptions& options_;
  std::map<std::string, std::string> plots_;
  std::map<std::string, std::string> links_;
  ReportFiles files_;
};

}  // namespace

ReportFormats report_formats_named(const std::vector<std::string>& names) {
  ReportFormats formats;
  const std::map<std::string, bool*> known = {{"html", &formats.html},
                                              {"md", &formats.markdown},
                                              {"latex", &formats.latex},
                                              {"csv", &formats.csv},
                                              {"junit", &formats.junit}};
  for (const std::string& name : names) {
    const auto format = known.find(name);
    if (format == known.end())
      throw InputError("unknown report format '" + name + "'; use html, md, latex, csv or junit");
    *format->second = true;
  }
  return formats;
}

ReportFiles report_files(const ReportInput& input, const ReportFilesOptions& options) {
  return FilesBuilder(input, options).build();
}

}  // namespace phytobench
