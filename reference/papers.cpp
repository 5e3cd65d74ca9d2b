// SPDX-License-Identifier: MIT
#include "reference/papers.hpp"

#include "reference/data_folder.hpp"
#include "reference/toml_table.hpp"

namespace phytobench {

std::vector<std::string> paper_keys() {
  return {
#define PAPER(key, dependency) #key,
#include "reference/papers.def"
#undef PAPER
  };
}

Paper load_paper(const std::string& key) {
  const TomlTable table = TomlTable::read(paper_folder(key) / "paper.toml");
  return {.key = key,
          .title = table.text("title"),
          .author = table.text("author"),
          .year = table.text("year"),
          .kind = table.text("kind"),
          .summary = table.text("summary"),
          .pictures = table.has("pictures") ? table.text("pictures") : ""};
}

}  // namespace phytobench
