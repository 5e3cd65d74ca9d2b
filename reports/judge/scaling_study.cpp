// SPDX-License-Identifier: MIT
#include "reference/data_folder.hpp"
#include "reference/toml_table.hpp"
#include "reports/judge/scaling.hpp"

namespace phytobench {

namespace {

Aim::Kind kind_of(const TomlTable& table) {
  const std::string kind = table.text("kind");
  if (kind == "ratio") return Aim::Kind::ratio;
  if (kind == "per_point") return Aim::Kind::per_point;
  if (kind == "over_floor") return Aim::Kind::over_floor;
  if (kind == "bytes_per_point") return Aim::Kind::bytes_per_point;
  table.fail("unknown kind '" + kind + "'; use ratio, per_point, over_floor or bytes_per_point");
}

Aim read_aim(const TomlTable& table) {
  table.allow_only({"kind", "text", "entries", "sizes", "must", "aim", "limits"});
  Aim aim{.kind = kind_of(table),
          .text = table.text("text"),
          .entries = table.texts("entries"),
          .sizes = {},
          .must = table.number("must"),
          .aim = table.number("aim"),
          .limits = table.text_or("limits", "")};
  if (table.has("sizes")) aim.sizes = table.numbers("sizes");
  const bool ratio = aim.kind == Aim::Kind::ratio, per_point = aim.kind == Aim::Kind::per_point;
  if (aim.entries.size() < (ratio ? 2u : 1u)) table.fail("'entries' names too few");
  if (aim.sizes.size() != (ratio ? 1u : per_point ? 2u : 0u))
    table.fail("'sizes' holds one size for a ratio, two for per_point, none otherwise");
  return aim;
}

}  // namespace

ScalingStudy load_scaling_study(const std::string& id) {
  const TomlTable file = TomlTable::read(data_folder() / "studies" / (id + ".toml"));
  file.allow_only({"experiment", "title", "intro", "aim"});
  ScalingStudy study{.id = id,
                     .experiment = file.text("experiment"),
                     .title = file.text("title"),
                     .intro = file.text("intro"),
                     .aims = {}};
  for (const TomlTable& table : file.tables("aim")) study.aims.push_back(read_aim(table));
  return study;
}

}  // namespace phytobench
