// SPDX-License-Identifier: MIT
#include "reports/document_scaling.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_intervals.hpp"
#include "reports/document_numbers.hpp"
#include "reports/document_tables.hpp"
#include "reports/repeat_commands.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

/// Rounded to two significant digits.
double two_digits(double value) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - 1.0);
  return std::round(value / unit) * unit;
}

ordered_json no_cell() {
  return table_cell("-");
}

/// "open: 3 rounds, 6 needed".
std::string lacking_rounds(std::size_t rounds) {
  return fmt::format("open: {}, {} needed", counted(rounds, "round"), fewest_rounds);
}

std::string state_of(const JudgedAim& aim) {
  switch (aim.state) {
    case JudgedAim::State::reached:
      return "aim reached";
    case JudgedAim::State::must_reached:
      return "least reached, aim missed";
    case JudgedAim::State::must_reached_aim_open:
      return "least reached, aim open";
    case JudgedAim::State::missed:
      return "missed";
    case JudgedAim::State::open:
      return aim.measured.is_only_range() ? lacking_rounds(aim.measured.rounds)
                                          : "open: the interval holds the bound";
    case JudgedAim::State::not_measured:
      return "not measured";
  }
  return "";
}

class ScalingDocument {
 public:
  ScalingDocument(const JudgedScaling& scaling, bool without_varying)
      : scaling_(scaling), hide_varying_(without_varying) {}

  ordered_json build(const std::map<std::string, std::string>& pictures) {
    document_["id"] = scaling_.study.id;
    document_["title"] = scaling_.study.title;
    document_["intro"] = scaling_.study.intro;
    document_["repeat"] = repeat_experiments({scaling_.study.experiment}, Tier::full);
    document_["pictures"] = ordered_json::array();
    for (const auto& [name, svg] : pictures)
      document_["pictures"].push_back(
          {{"name", name},
           {"svg", svg},
           {"varies", name.ends_with("-time")},
           {"caption", name.ends_with("-time")
                           ? fmt::format("Time of one growth: median and its {}.", ends_of_medians)
                           : "Distance evaluations of one growth."}});
    document_["grids"] = ordered_json::array();
    add_laws();
    add_sizes();
    add_phases();
    document_["crossovers"] = hide_varying_ ? ordered_json::array() : crossovers();
    document_["has_crossovers"] = !document_["crossovers"].empty();
    document_["aims"] = aims();
    document_["ends"] = ends_of_medians;
    document_["has_aims"] = !document_["aims"].empty();
    return document_;
  }

 private:
  void add_laws() {
    const auto law_cell = [](const std::optional<PowerLaw>& law) {
      if (!law) return no_cell();
      return table_cell(fmt::format("{:.2f}", law->exponent.value),
                        fmt::format("{:.2f} to {:.2f}", law->exponent.low, law->exponent.high));
    };
    ordered_json laws = grid("Exponents",
                             "as which power of the number of points it grows, fitted over all "
                             "sizes, with its 95 % interval",
                             !hide_varying_);
    laws["columns"].push_back("distance evaluations");
    if (!hide_varying_) laws["columns"].push_back("time");
    for (const ScaledEntry& entry : scaling_.entries) {
      if (!entry.work_law) continue;
      ordered_json cells{law_cell(entry.work_law)};
      if (!hide_varying_) cells.push_back(law_cell(entry.time_law));
      add_row(laws, entry.name, std::move(cells));
    }
    if (!laws["rows"].empty()) add(std::move(laws));
  }

  void add_sizes() {
    add_floor();
    add_by_size("Evaluations over the floor", "1: nothing is looked at that need not be", false,
                [](const ScaledEntry::AtSize& at) {
                  if (!at.exact) return table_cell("inexact");
                  return at.over_floor ? table_cell(fmt::format("{:.3g}", *at.over_floor))
                                       : no_cell();
                });
    if (hide_varying_) return;
    add_by_size("Time of one growth", fmt::format("median and its {}", ends_of_medians), true,
                [](const ScaledEntry::AtSize& at) {
                  if (!at.seconds) return no_cell();
                  return table_cell(shown_seconds(at.seconds->value),
                                    shown_ends(*at.seconds, shown_seconds(at.seconds->low),
                                               shown_seconds(at.seconds->high)));
                });
    add_by_size("Memory", "bytes per attraction point that the engine holds", true,
                [](const ScaledEntry::AtSize& at) {
                  return at.bytes_per_point ? table_cell(fmt::format("{:.1f}", *at.bytes_per_point))
                                            : no_cell();
                });
  }

  void add_floor() {
    ordered_json floor =
        grid("The floor",
             "pairs that any exact method must look at: a new node and a live point "
             "within the influence distance; a removed point and its first killer",
             false);
    floor["columns"] = {"nodes", "iterations", "pairs to associate", "pairs to remove",
                        "pairs per node"};
    for (const auto& [size, at] : scaling_.sizes)
      add_row(floor, with_thousands(at.points) + " points",
              {table_cell(with_thousands(at.nodes)), table_cell(with_thousands(at.iterations)),
               table_cell(with_thousands(at.association_pairs)),
               table_cell(with_thousands(at.removal_pairs)),
               table_cell(fmt::format("{:.2f}", (at.association_pairs + at.removal_pairs) /
                                                    std::max(at.nodes, 1.0)))});
    add(std::move(floor));
  }

  template <class Cell>
  void add_by_size(const std::string& title, const std::string& note, bool varies,
                   const Cell& make_cell) {
    ordered_json by_size = grid(title, note, varies);
    for (const auto& [size, at] : scaling_.sizes)
      by_size["columns"].push_back(with_thousands(at.points));
    bool is_empty = true;
    for (const ScaledEntry& entry : scaling_.entries) {
      ordered_json cells = ordered_json::array();
      for (const auto& [size, ignored] : scaling_.sizes) {
        cells.push_back(entry.at.contains(size) ? make_cell(entry.at.at(size)) : no_cell());
        is_empty &= cells.back() == no_cell();
      }
      add_row(by_size, entry.name, std::move(cells));
    }
    if (!is_empty) add(std::move(by_size));
  }

  /// Where the time of the engine that goes farthest is spent.
  void add_phases() {
    if (hide_varying_ || scaling_.entries.empty()) return;
    const ScaledEntry& entry = scaling_.entries.front();
    ordered_json phases = grid("Where " + entry.name + " spends its time",
                               "nanoseconds per attraction point; medians", true);
    phases["columns"] = {"build", "association", "removal", "growth", "points per cell visited"};
    for (const auto& [size, at] : entry.at) {
      if (at.phase_seconds.empty()) continue;
      const double points = scaling_.sizes.at(size).points;
      ordered_json cells = ordered_json::array();
      for (const char* phase : {"build", "association", "kill", "growth"}) {
        const auto found = at.phase_seconds.find(phase);
        cells.push_back(found == at.phase_seconds.end()
                            ? no_cell()
                            : table_cell(fmt::format("{:.1f}", 1e9 * found->second / points)));
      }
      cells.push_back(at.evaluations && at.cells_visited && *at.cells_visited > 0.0
                          ? table_cell(fmt::format("{:.2f}", *at.evaluations / *at.cells_visited))
                          : no_cell());
      add_row(phases, with_thousands(points) + " points", std::move(cells));
    }
    if (!phases["rows"].empty()) add(std::move(phases));
  }

  ordered_json crossovers() const {
    ordered_json lines = ordered_json::array();
    for (const Crossover& crossover : scaling_.crossovers)
      lines.push_back(
          fmt::format("{} overtakes {} between {} and {} points (about {}){}", crossover.overtaking,
                      crossover.overtaken, with_thousands(crossover.low),
                      with_thousands(crossover.high), with_thousands(two_digits(crossover.about)),
                      crossover.is_open() ? "; " + lacking_rounds(crossover.rounds) : ""));
    return lines;
  }

  ordered_json aims() const {
    ordered_json rows = ordered_json::array();
    for (const JudgedAim& aim : scaling_.aims) {
      if (hide_varying_ && aim.varies) continue;
      rows.push_back(aim_row(aim));
    }
    return rows;
  }

  static ordered_json aim_row(const JudgedAim& judged) {
    const Aim& aim = judged.aim;
    const MedianOfRounds& found = judged.measured;
    const bool measured = judged.state != JudgedAim::State::not_measured;
    const bool has_interval = measured && found.rounds > 0;
    // What keeps it from an aim is of no interest before it is known to miss it.
    const bool missed = measured && judged.surely_misses_its_aim();
    const int digits = digits_to_tell_apart(std::array{found.value, found.low, found.high},
                                            std::array{aim.must, aim.aim}, 3);
    const auto shown_with = [&](double value) { return shown(value, digits); };
    const auto shown_bound = [&](double v) { return shown(v, std::max(digits, shown_digits)); };
    return {{"text", aim.text},
            {"must", (aim.more_is_better() ? "at least " : "at most ") + shown_bound(aim.must)},
            {"aim", shown_bound(aim.aim)},
            {"measured", measured ? shown_with(found.value) : "-"},
            {"interval",
             has_interval ? shown_ends(found, shown_with(found.low), shown_with(found.high)) : ""},
            {"has_interval", has_interval},
            {"state", state_of(judged)},
            {"varies", judged.varies},
            {"limits", missed ? aim.limits : ""},
            {"has_limits", missed && !aim.limits.empty()}};
  }

  static ordered_json grid(const std::string& title, const std::string& note, bool varies) {
    return {{"title", title},
            {"note", note},
            {"has_note", !note.empty()},
            {"varies", varies},
            {"columns", ordered_json::array()},
            {"rows", ordered_json::array()}};
  }
  static void add_row(ordered_json& grid, const std::string& label, ordered_json cells) {
    grid["rows"].push_back({{"label", label}, {"cells", std::move(cells)}});
  }
  void add(ordered_json grid) { document_["grids"].push_back(std::move(grid)); }

  const JudgedScaling& scaling_;
  bool hide_varying_;
  ordered_json document_;
};

}  // namespace

ordered_json scaling_document(const JudgedScaling& scaling,
                              const std::map<std::string, std::string>& pictures,
                              bool without_varying) {
  return ScalingDocument(scaling, without_varying).build(pictures);
}

}  // namespace phytobench
