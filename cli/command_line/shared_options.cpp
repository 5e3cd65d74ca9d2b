// SPDX-License-Identifier: MIT
// What the options of several commands have in common. Only files of this folder and main.cpp
// include the command-line library.
#include <utility>

#include <CLI/CLI.hpp>

#include "cli/command_line/command_line.hpp"
#include "core/contract/errors.hpp"

namespace phytobench::cli {

namespace {

void append_names(std::vector<std::string>& files, const std::string& text) {
  for (std::size_t begin = 0, end = 0; end != std::string::npos; begin = end + 1) {
    end = text.find(',', begin);
    const std::string name = text.substr(begin, end - begin);  // to the end where there is none
    if (name.empty())
      throw InputError(
          "--out '" + text +
          "': a name is missing; give names with one comma between two, like a.obj,b.glb");
    files.push_back(name);
  }
}

}  // namespace

void add_files(CLI::App& sub, std::vector<std::string>& files, const std::string& meaning) {
  const auto read = [&files](const std::vector<std::string>& given) {
    for (const std::string& text : given) append_names(files, text);
  };
  sub.add_option_function<std::vector<std::string>>("--out", read, meaning)
      ->allow_extra_args(false);
}

std::function<int()> unless_example_has_company(const CLI::App& sub, std::function<int()> chosen) {
  if (sub.count("--example") == 0) return chosen;
  for (const CLI::Option* option : sub.get_options())
    if (option->count() > 0 && option->get_name() != "--example")
      throw InputError("--example prints a file to start from and nothing else; leave out " +
                       (option->get_positional() ? option->results().front() : option->get_name()));
  return chosen;
}

}  // namespace phytobench::cli
