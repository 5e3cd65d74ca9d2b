// SPDX-License-Identifier: MIT
// Where engines that are not exact find other shadows than the exact one, in numbers and in
// pictures.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "core/picture/image.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/site_scenes.hpp"

namespace phytobench::experiments::lesser2019 {

inline constexpr std::string_view engines_that_approximate[] = {"printed_march", "line_sweep",
                                                                "sheared_sweep"};

/// What is wrong among the pixel-hours that one pixel of a picture stands for, as shares of them.
struct WrongShares {
  double dark = 0.0;  ///< dark and should be lit, by the hours of a vertex
  double lit = 0.0;
};

inline WrongShares wrong_shares(const HeightField& field, const std::vector<std::uint16_t>& right,
                                const std::vector<std::uint16_t>& found, std::size_t hours, int x,
                                int y, int every) {
  WrongShares wrong;
  int vertices = 0;
  for (int row = y * every; row < std::min((y + 1) * every, field.rows()); ++row)
    for (int column = x * every; column < std::min((x + 1) * every, field.columns()); ++column) {
      const std::size_t i = field.index(column, row);
      const int more = int{found[i]} - int{right[i]};
      (more > 0 ? wrong.lit : wrong.dark) += std::abs(more);
      ++vertices;
    }
  const double all = static_cast<double>(vertices) * static_cast<double>(hours);
  return {wrong.dark / all, wrong.lit / all};
}

/// Grey by height; red where vertices are dark in more hours than they should be, blue where in
/// fewer: full colour for one hour in thirteen and more, fainter with the root of the share. At
/// most `most` pixels wide.
inline Image picture_of_differences(const HeightField& field, const LitMaps& exact,
                                    const LitMaps& other, int most) {
  const int every = (std::max(field.columns(), field.rows()) + most - 1) / most;
  const HeightRange range = height_range(field);
  const std::vector<std::uint16_t> right = lit_positions(exact), found = lit_positions(other);
  Image image((field.columns() + every - 1) / every, (field.rows() + every - 1) / every);
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const double grey = 0.55 + 0.4 * (field.at(x * every, y * every) - range.lowest) /
                                     (range.highest - range.lowest);
      const WrongShares wrong = wrong_shares(field, right, found, exact.positions(), x, y, every);
      const double red = std::min(1.0, std::sqrt(13.0 * wrong.dark));
      const double blue = std::min(1.0, std::sqrt(13.0 * wrong.lit));
      const double rest = 1.0 - std::max(red, blue);
      image.at(x, y) = to_pixel({rest * grey + 0.85 * red, rest * grey + 0.1 * std::max(red, blue),
                                 rest * grey + 0.85 * blue});
    }
  return image;
}

/// Records how many pixel-hours are otherwise, as a share of all, wrongly lit, and hour by hour;
/// leaves a picture.
inline void record_differences(ExperimentContext& context, const std::string& name,
                               const HeightField& field, const std::vector<SunDirection>& suns,
                               int threads) {
  const LitMaps exact = cast_by("max_pyramid", field, suns, threads).lit;
  const double pixel_hours = static_cast<double>(field.size() * suns.size());
  context.record(name + "/pixel-hours", whole(field.size() * suns.size()), "pixel-hours");
  context.record(name + "/lit", whole(exact.lit()), "pixel-hours");
  for (const std::string_view engine : engines_that_approximate) {
    context.progress(fmt::format("{}, {}", name, engine));
    const Cast cast = cast_by(engine, field, suns, threads);
    const LitMaps& found = cast.lit;
    const std::string start = fmt::format("{}/{}/", name, engine);
    const std::uint64_t wrong = differing_bits(exact, found);
    context.record(start + "wrong", whole(wrong), "pixel-hours");
    context.record(start + "rays-given-up", whole(cast.work.stuck), "rays");
    context.record(start + "wrong-share", static_cast<double>(wrong) / pixel_hours);
    // Wrongly lit less wrongly dark is what is lit more.
    const auto more = static_cast<double>(found.lit()) - static_cast<double>(exact.lit());
    context.record(start + "more-lit-share", more / pixel_hours);
    context.record(start + "wrongly-lit-share",
                   (static_cast<double>(wrong) + more) / 2.0 / pixel_hours);
    for (std::size_t hour = 0; hour < suns.size(); ++hour)
      context.record(fmt::format("{}hour-{}/wrong-share", start, hour + 1),
                     static_cast<double>(differing_bits(exact, found, hour)) /
                         static_cast<double>(field.size()));
    context.artifact(fmt::format("{}-{}.png", name, engine),
                     to_png(picture_of_differences(field, exact, found, 512)));
    if (engine == "printed_march" && field.columns() >= 200)  // the one that a report shows
      context.artifact(fmt::format("printed-march-{}.jpg", name),
                       to_jpeg(picture_of_differences(field, exact, found, 200)));
  }
}

}  // namespace phytobench::experiments::lesser2019
