// SPDX-License-Identifier: MIT
#include "core/record/plot_points.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Reads the points of a plot line by line.
class PointReader {
 public:
  PointReader(PlotData& plot, std::string name) : plot_(plot), name_(std::move(name)) {}

  void read(std::string_view csv) {
    while (!csv.empty()) {
      const std::size_t end = std::min(csv.find('\n'), csv.size());
      std::string_view row = csv.substr(0, end);
      if (row.ends_with('\r')) row.remove_suffix(1);
      ++line_;
      if (line_ == 1)
        read_header(row);
      else
        read_point(csv_fields(row));
      csv.remove_prefix(std::min(end + 1, csv.size()));
    }
    if (line_ == 0) refuse("is empty");
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}; {}", name_, std::max(line_, 1), what, plot_remedy));
  }

  void read_header(std::string_view row) {
    numbered_ = row.starts_with("panel,");
    const std::string_view rest = row.substr(numbered_ ? 6 : 0);
    bars_ = rest == "series,x,y,low,high";
    if ((!bars_ && rest != "series,x,y") || numbered_ != (plot_.panels.size() > 1))
      refuse(fmt::format("the header is not {0}series,x,y or {0}series,x,y,low,high",
                         plot_.panels.size() > 1 ? "panel," : ""));
  }

  double number(const std::string& field, bool may_be_empty, bool is_log) const {
    if (field.empty() && may_be_empty) return no_value;
    double value = 0.0;
    const char* const end = field.data() + field.size();
    const auto [stop, error] = std::from_chars(field.data(), end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value))
      refuse(fmt::format("'{}' is no finite number", field));
    if (is_log && !(value > 0.0)) refuse(fmt::format("{} on a logarithmic axis", field));
    return value;
  }

  PlotCurve& curve_of(const std::string& name, std::size_t panel) const {
    for (PlotCurve& curve : plot_.panels[panel].curves)
      if (curve.name == name) return curve;
    refuse(fmt::format("no series '{}' in panel {}", name, panel + 1));
  }

  void read_point(const std::vector<std::string>& fields) const {
    const std::size_t first = numbered_ ? 1 : 0;
    if (fields.size() != first + (bars_ ? 5 : 3))
      refuse(fmt::format("{} fields instead of {}", fields.size(), first + (bars_ ? 5 : 3)));
    const double panel = numbered_ ? number(fields[0], false, true) - 1.0 : 0.0;
    if (panel != std::floor(panel) || panel >= static_cast<double>(plot_.panels.size()))
      refuse(fmt::format("no panel {}", fields[0]));
    const PlotPanel& axes = plot_.panels[static_cast<std::size_t>(panel)];
    PlotCurve& curve = curve_of(fields[first], static_cast<std::size_t>(panel));
    curve.x.push_back(number(fields[first + 1], false, axes.log_x));
    curve.y.push_back(number(fields[first + 2], true, axes.log_y));
    if (!bars_ || (fields[first + 3].empty() && fields[first + 4].empty())) return;
    curve.low.push_back(number(fields[first + 3], false, axes.log_y));
    curve.high.push_back(number(fields[first + 4], false, axes.log_y));
  }

  PlotData& plot_;
  std::string name_;
  int line_ = 0;
  bool numbered_ = false, bars_ = false;
};

}  // namespace

void read_plot_points(PlotData& plot, std::string_view csv, const std::string& name) {
  PointReader(plot, name).read(csv);
}

std::vector<std::string> csv_fields(std::string_view row) {
  std::vector<std::string> fields(1);
  bool is_quoted = false;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const bool doubled = is_quoted && row[i] == '"' && row.substr(i + 1).starts_with('"');
    if (doubled)
      fields.back() += row[i++];
    else if (row[i] == '"')
      is_quoted = !is_quoted;
    else if (row[i] == ',' && !is_quoted)
      fields.emplace_back();
    else
      fields.back() += row[i];
  }
  return fields;
}

}  // namespace phytobench
