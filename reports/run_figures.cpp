// SPDX-License-Identifier: MIT
#include "reports/run_figures.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/picture/base64.hpp"
#include "reports/characters.hpp"
#include "reports/document_anchors.hpp"
#include "reports/natural_order.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

constexpr double lettered_scale = 0.75;  ///< at which letters of 12 pixels can still be read
constexpr std::size_t most_bytes_in_page = 60 * 1024;  ///< a larger picture is a link

/// "alsweis/x/figures-7.6-7.7.svg" -> "7.6-7.7"; nothing without a number of a figure.
std::optional<std::string> figure_number(const std::string& artifact) {
  const std::string stem = std::filesystem::path(artifact).stem().string();
  for (const std::string_view opening : {"figure-", "figures-"})
    if (stem.starts_with(opening) && stem.size() > opening.size() && is_digit(stem[opening.size()]))
      return stem.substr(opening.size());
  return std::nullopt;
}

/// Every number of figures that an artifact's name holds: "7.6-7.7" are two.
std::vector<Place> figure_places(const std::string& artifact) {
  const auto number = figure_number(artifact);
  return number ? places_of("figures " + number->substr(0, number->find("-step")))
                : std::vector<Place>{};
}

ordered_json claims_on(const std::string& artifact, const ClaimIndex& claims) {
  ordered_json links = ordered_json::array();
  for (const Place& place : figure_places(artifact))
    if (place.kind == PlaceKind::figure)
      for (const ClaimLink& link : claims.at(place)) links.push_back(link_document(link));
  return links;
}

/// "figure-40-left" -> "Figure 40 left".
std::string artifact_label_of(const std::string& artifact) {
  std::string label = std::filesystem::path(artifact).stem().string();
  std::replace(label.begin(), label.end(), '-', ' ');
  label[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(label[0])));
  return label;
}

/// A plot and its data have one name, but for the ending.
std::string data_name(const std::string& picture) {
  return std::filesystem::path(picture).replace_extension(".csv").generic_string();
}
std::string picture_name(const std::string& data) {
  return std::filesystem::path(data).replace_extension(".svg").generic_string();
}

ordered_json picture_part(const std::string& svg, const std::string& prefix) {
  const double width = svg_width(svg);
  const bool lettered = svg.find("<text") != std::string::npos;
  const bool fits = svg.size() <= most_bytes_in_page;
  return {{"in_page", fits && !svg.empty()},
          {"has_picture", !svg.empty()},
          {"svg", fits ? with_own_ids(svg, prefix) : ""},
          {"kibibytes", fmt::format("{:.0f}", static_cast<double>(svg.size()) / 1024.0)},
          {"width", fmt::format("{:.0f}", width > 0.0 ? width : plain_picture_width)},
          {"least_width", fmt::format("{:.0f}", lettered ? lettered_scale * width : 0)}};
}

/// The numbers behind a plot.
ordered_json data_part(const std::string& name, const std::string& csv) {
  const DataTable table = data_table(csv);
  ordered_json part{{"file", figure_file(name)},
                    {"name", name},
                    {"header", table.header},
                    {"has_rows", !table.rows.empty()},
                    {"rows", ordered_json::array()}};
  for (const auto& row : table.rows) part["rows"].push_back({{"cells", row}});
  return part;
}

ordered_json figure_document(const std::string& name, const FigureSources& sources,
                             const ClaimIndex& claims) {
  const auto picture = sources.pictures.find(name);
  const std::string svg = picture == sources.pictures.end() ? "" : picture->second;
  const auto own = sources.captions.find(name);
  const auto& [caption, description] = own == sources.captions.end()
                                           ? PlotCaption{svg_caption(svg), svg_description(svg)}
                                           : own->second;
  ordered_json figure = picture_part(svg, slug(name));
  figure["name"] = name;
  figure["anchor"] = "figure-" + slug(name);
  figure["file"] = figure_file(name);
  figure["caption"] = caption.empty() ? artifact_label_of(name) : caption;
  figure["description"] = description;
  figure["has_description"] = !description.empty() && description != caption;
  figure["claims"] = claims_on(name, claims);
  figure["has_claims"] = !figure["claims"].empty();
  const auto data = sources.plot_data.find(data_name(name));
  figure["has_data"] = data != sources.plot_data.end();
  figure["data"] =
      figure["has_data"] == true ? data_part(data->first, data->second) : ordered_json::object();
  return figure;
}

}  // namespace

bool is_figure_before(const std::string& a, const std::string& b) {
  const auto first = figure_number(a), second = figure_number(b);
  if (first.has_value() != second.has_value()) return first.has_value();
  if (first && *first != *second) return is_naturally_before(*first, *second);
  return is_naturally_before(a, b);
}

std::string figure_file(const std::string& artifact) {
  std::string file = artifact;
  std::replace(file.begin(), file.end(), '/', '-');
  return "figures/" + file;
}

ordered_json figures_of(const std::string& paper, const FigureSources& sources,
                        const ClaimIndex& claims) {
  std::set<std::string> own;
  for (const auto& [name, svg] : sources.pictures)
    if (name.starts_with(paper + "/")) own.insert(name);
  for (const auto& [name, csv] : sources.plot_data)
    if (name.starts_with(paper + "/")) own.insert(picture_name(name));
  std::vector<std::string> names(own.begin(), own.end());
  std::sort(names.begin(), names.end(), is_figure_before);
  ordered_json figures = ordered_json::array();
  for (const std::string& name : names) figures.push_back(figure_document(name, sources, claims));
  return figures;
}

ordered_json photographs_of(const std::string& paper,
                            const std::map<std::string, std::string>& photographs,
                            const ClaimIndex& claims) {
  ordered_json gallery = ordered_json::array();
  for (const auto& [name, bytes] : photographs) {
    if (!name.starts_with(paper + "/")) continue;
    const bool fits = bytes.size() <= most_bytes_in_page;
    gallery.push_back({{"label", artifact_label_of(name)},
                       {"file", figure_file(name)},
                       {"in_page", fits},
                       {"source", fits ? "data:image/jpeg;base64," + to_base64(bytes) : ""},
                       {"claims", claims_on(name, claims)}});
    gallery.back()["has_claims"] = !gallery.back()["claims"].empty();
  }
  return gallery;
}

}  // namespace phytobench
