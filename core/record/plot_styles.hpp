// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "core/record/plot_data.hpp"

namespace phytobench {

/// The words for styles in plot files.
inline constexpr std::array<std::pair<std::string_view, PlotStyle>, 6> plot_styles{
    {{"solid", PlotStyle::solid},
     {"dashed", PlotStyle::dashed},
     {"dotted", PlotStyle::dotted},
     {"points", PlotStyle::points},
     {"steps", PlotStyle::steps},
     {"marked", PlotStyle::marked}}};

}  // namespace phytobench
