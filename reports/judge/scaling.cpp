// SPDX-License-Identifier: MIT
#include "reports/judge/scaling.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <fmt/format.h>

namespace phytobench {

namespace {

/// Turned so that more is better, whatever the aim.
struct Ends {
  double worse;
  double better;
};

double sign_of(const Aim& aim) {
  return aim.more_is_better() ? 1.0 : -1.0;
}

Ends ends_of(const Aim& aim, const MedianOfRounds& measured) {
  return aim.more_is_better() ? Ends{measured.low, measured.high}
                              : Ends{-measured.high, -measured.low};
}

/// "25298/voxel_grid.dn/exact" -> 25298 and "voxel_grid.dn"; nothing for other measurements.
struct ScaledPlace {
  double size;
  std::string entry;
};

std::optional<ScaledPlace> place_of(const std::string& measurement, const std::string& experiment) {
  static const std::string end = "/exact";
  if (!measurement.starts_with(experiment + "/") || !measurement.ends_with(end))
    return std::nullopt;
  const std::string path = measurement.substr(
      experiment.size() + 1, measurement.size() - experiment.size() - 1 - end.size());
  const std::size_t slash = path.find('/');
  if (slash == std::string::npos) return std::nullopt;
  return ScaledPlace{std::stod(path.substr(0, slash)), path.substr(slash + 1)};
}

class ScalingJudge {
 public:
  ScalingJudge(ScalingStudy study, const RunContents& run, const Evidence& evidence)
      : evidence_(evidence) {
    judged_.study = std::move(study);
    for (const Record& record : run.records)
      if (const auto place = place_of(record.measurement, judged_.study.experiment)) add(*place);
  }

  JudgedScaling judge() {
    for (ScaledEntry& entry : judged_.entries) fit(entry);
    rank();
    find_crossovers();
    for (const Aim& aim : judged_.study.aims) judged_.aims.push_back(judge_aim(aim));
    return std::move(judged_);
  }

 private:
  std::string id(double size, const std::string& rest) const {
    return fmt::format("{}/{:.0f}/{}", judged_.study.experiment, size, rest);
  }

  std::optional<double> number(double size, const std::string& rest) const {
    const std::vector<double> samples = evidence_.samples(id(size, rest));
    return samples.empty() ? std::nullopt : std::optional(samples.front());
  }

  void add(const ScaledPlace& place) {
    ScaledSize& size = judged_.sizes[place.size];
    size = {.points = number(place.size, "points").value_or(0.0),
            .nodes = number(place.size, "nodes").value_or(0.0),
            .iterations = number(place.size, "iterations").value_or(0.0),
            .association_pairs = number(place.size, "floor/association_pairs").value_or(0.0),
            .removal_pairs = number(place.size, "floor/removal_pairs").value_or(0.0)};
    auto entry = std::find_if(judged_.entries.begin(), judged_.entries.end(),
                              [&](const ScaledEntry& e) { return e.name == place.entry; });
    if (entry == judged_.entries.end())
      entry = judged_.entries.insert(entry, {.name = place.entry, .at = {}});
    entry->at[place.size] = at_size(place, size);
  }

  ScaledEntry::AtSize at_size(const ScaledPlace& place, const ScaledSize& size) const {
    const auto of = [&](const std::string& quantity) { return place.entry + "/" + quantity; };
    ScaledEntry::AtSize at;
    at.exact = number(place.size, of("exact")) == 1.0;
    at.evaluations = number(place.size, of("evaluations"));
    at.cells_visited = number(place.size, of("cells_visited"));
    const double floor = size.association_pairs + size.removal_pairs;
    if (at.evaluations && floor > 0.0) at.over_floor = *at.evaluations / floor;
    if (const auto bytes = number(place.size, of("bytes")); bytes && size.points > 0.0)
      at.bytes_per_point = *bytes / size.points;
    at.seconds = evidence_.median_of(seconds_of(place));
    for (const char* phase : {"build", "association", "kill", "growth"})
      if (const auto seconds =
              evidence_.median_of(id(place.size, of(phase + std::string("_seconds")))))
        at.phase_seconds[phase] = seconds->value;
    return at;
  }

  std::string seconds_of(const ScaledPlace& place) const {
    return id(place.size, place.entry + "/seconds");
  }

  void fit(ScaledEntry& entry) const {
    std::vector<double> timed, seconds, counted, evaluations;
    for (const auto& [size, at] : entry.at) {
      const double points = judged_.sizes.at(size).points;
      if (at.seconds) timed.push_back(points), seconds.push_back(at.seconds->value);
      if (at.evaluations && *at.evaluations > 0.0)
        counted.push_back(points), evaluations.push_back(*at.evaluations);
    }
    entry.time_law = fit_power_law(timed, seconds);
    entry.work_law = fit_power_law(counted, evaluations);
  }

  /// Larger sizes first, then less time: an engine that was grown where others were not comes
  /// first.
  void rank() {
    const auto key = [](const ScaledEntry& entry) {
      const auto& [size, at] = *entry.at.rbegin();
      const double seconds =
          at.seconds ? at.seconds->value : std::numeric_limits<double>::infinity();
      return std::tuple(-size, seconds, entry.name);
    };
    std::sort(judged_.entries.begin(), judged_.entries.end(),
              [&](const ScaledEntry& a, const ScaledEntry& b) { return key(a) < key(b); });
  }

  /// Time of a over time of b, paired by round.
  std::optional<MedianOfRounds> time_ratio(const std::string& a, const std::string& b,
                                           double size) const {
    return evidence_.ratio_of(seconds_of({size, a}), seconds_of({size, b}));
  }

  void find_crossovers() {
    for (const ScaledEntry& a : judged_.entries)
      for (const ScaledEntry& b : judged_.entries)
        if (&a != &b && medians_cross(a, b)) find_crossover(a, b);
  }

  /// Whether it is worth asking for intervals.
  static bool medians_cross(const ScaledEntry& a, const ScaledEntry& b) {
    bool a_was_faster = false;
    for (const auto& [size, at] : a.at) {
      const auto other = b.at.find(size);
      if (other == b.at.end() || !at.seconds || !other->second.seconds) continue;
      if (a_was_faster && at.seconds->value > other->second.seconds->value) return true;
      a_was_faster |= at.seconds->value < other->second.seconds->value;
    }
    return false;
  }

  /// From the last size where `a` is certainly faster to the first beyond where `b` certainly is.
  /// With too few rounds for certainty all of them must agree, and it stays open.
  void find_crossover(const ScaledEntry& a, const ScaledEntry& b) {
    double last = 0.0, last_ratio = 0.0;
    std::size_t last_rounds = 0;
    for (const auto& [size, at] : a.at) {
      if (!b.at.contains(size)) continue;
      const auto ratio = time_ratio(a.name, b.name, size);
      if (!ratio) continue;
      if (ratio->high < 1.0) {
        last = size;
        last_ratio = ratio->value;
        last_rounds = ratio->rounds;
      } else if (ratio->low > 1.0 && last > 0.0) {
        const double from = std::log(last), to = std::log(size);
        const double share =
            -std::log(last_ratio) / (std::log(ratio->value) - std::log(last_ratio));
        judged_.crossovers.push_back({a.name, b.name, last, size,
                                      std::exp(from + share * (to - from)),
                                      std::min(last_rounds, ratio->rounds)});
        last = 0.0;
      }
    }
  }

  JudgedAim judge_aim(const Aim& aim) const {
    JudgedAim judged{.aim = aim, .measured = {}};
    const auto measured = measure(aim);
    if (!measured) return judged;
    judged.measured = *measured;
    judged.varies = aim.kind != Aim::Kind::over_floor;
    judged.state = state_of(judged);
    return judged;
  }

  static JudgedAim::State state_of(const JudgedAim& judged) {
    using State = JudgedAim::State;
    if (judged.measured.is_only_range()) return State::open;
    const Ends ends = ends_of(judged.aim, judged.measured);
    const double must = sign_of(judged.aim) * judged.aim.must;
    if (ends.worse >= sign_of(judged.aim) * judged.aim.aim) return State::reached;
    if (ends.worse >= must)
      return judged.surely_misses_its_aim() ? State::must_reached : State::must_reached_aim_open;
    return ends.better >= must ? State::open : State::missed;
  }

  std::optional<MedianOfRounds> measure(const Aim& aim) const {
    switch (aim.kind) {
      case Aim::Kind::ratio:
        return time_ratio(aim.entries.at(0), aim.entries.at(1), aim.sizes.at(0));
      case Aim::Kind::per_point:
        return per_point(aim);
      case Aim::Kind::over_floor:
        return largest(aim, &ScaledEntry::AtSize::over_floor);
      case Aim::Kind::bytes_per_point:
        return largest(aim, &ScaledEntry::AtSize::bytes_per_point);
    }
    return std::nullopt;
  }

  /// Sizes are timed one after the other: pairing their rounds removes nothing that they share, and
  /// as they are independent, the interval of their ratios is as exact as any.
  std::optional<MedianOfRounds> per_point(const Aim& aim) const {
    const std::string& entry = aim.entries.at(0);
    const double large = aim.sizes.at(0), small = aim.sizes.at(1);
    auto ratio = evidence_.ratio_of(seconds_of({large, entry}), seconds_of({small, entry}));
    if (!ratio || !judged_.sizes.contains(large) || !judged_.sizes.contains(small))
      return std::nullopt;
    const double points = judged_.sizes.at(large).points / judged_.sizes.at(small).points;
    for (double* end : {&ratio->value, &ratio->low, &ratio->high}) *end /= points;
    return ratio;
  }

  std::optional<MedianOfRounds> largest(
      const Aim& aim, std::optional<double> ScaledEntry::AtSize::*quantity) const {
    std::optional<MedianOfRounds> most;
    for (const std::string& name : aim.entries) {
      const ScaledEntry* entry = find(name);
      if (entry == nullptr) continue;
      for (const auto& [size, at] : entry->at)
        if (const auto& value = at.*quantity; value && (!most || *value > most->value))
          most = MedianOfRounds{{*value, *value, *value}};
    }
    return most;
  }

  const ScaledEntry* find(const std::string& name) const {
    for (const ScaledEntry& entry : judged_.entries)
      if (entry.name == name) return &entry;
    return nullptr;
  }

  const Evidence& evidence_;
  JudgedScaling judged_;
};

}  // namespace

bool JudgedAim::surely_misses_its_aim() const {
  return !measured.is_only_range() && ends_of(aim, measured).better < sign_of(aim) * aim.aim;
}

JudgedScaling judge_scaling(ScalingStudy study, const RunContents& run, const Evidence& evidence) {
  return ScalingJudge(std::move(study), run, evidence).judge();
}

}  // namespace phytobench
