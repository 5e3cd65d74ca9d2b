// SPDX-License-Identifier: MIT
// The README's commands work as they stand, one after the other in one folder.
#include <sstream>

#include "cli/command_line_fixture.hpp"
#include "core/picture/render.hpp"

namespace phytobench {
namespace {

/// A command as a shell splits it; a file it is redirected to.
struct ReadmeCommand {
  Words words;
  std::string redirected_to;
};

/// Indented lines of the README that call the program; what stands behind two spaces explains them.
std::vector<ReadmeCommand> readme_commands() {
  const std::string call = "    build/release/phytobench ";
  std::istringstream readme(content_of(std::filesystem::path(PHYTOBENCH_SOURCE) / "README.md"));
  std::vector<ReadmeCommand> commands;
  for (std::string line; std::getline(readme, line);) {
    if (!line.starts_with(call)) continue;
    line = line.substr(call.size());
    line = line.substr(0, line.find("  "));
    ReadmeCommand command;
    std::istringstream words(line);
    for (std::string word; words >> word;) {
      if (word == ">")
        words >> command.redirected_to;
      else
        command.words.push_back(word);
    }
    commands.push_back(command);
  }
  return commands;
}

bool is_quick(const ReadmeCommand& command) {
  const std::string& what = command.words.front();
  return what == "grow" || what == "list" || what == "build" || what == "derive" ||
         what == "compete" || what == "terrain" || what == "doctor";
}

bool needs_rendering(const ReadmeCommand& command) {
  return std::any_of(command.words.begin(), command.words.end(),
                     [](const std::string& word) { return word.ends_with(".png"); });
}

class Readme : public CommandLine {};

TEST_F(Readme, CommandsThatTakeNoLongWorkAsTheyStand) {
  std::size_t ran = 0;
  for (const ReadmeCommand& command : readme_commands()) {
    if (!is_quick(command) || (needs_rendering(command) && !can_render())) continue;
    std::string line;
    for (const std::string& word : command.words) line += word + " ";
    SCOPED_TRACE(line);
    const Outcome outcome = run(command.words);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    if (!command.redirected_to.empty()) write(command.redirected_to, outcome.out);
    for (const std::string& word : command.words) {
      if (word.ends_with(".png") || word.ends_with(".svg")) EXPECT_TRUE(exists(word)) << word;
    }
    ++ran;
  }
  EXPECT_GE(ran, 30u);
  for (const char* file :
       {"birch.obj", "birch.glb", "tree.obj", "tree.glb", "willow.glb", "bush.svg", "koch.csv",
        "my-tree.glb", "meadow/stand.svg", "stand/frames/00010.png", "stand/checkpoint.bin"})
    EXPECT_TRUE(exists(file)) << file;
}

TEST_F(Readme, CommandsNameSubcommandsThatExist) {
  for (const ReadmeCommand& command : readme_commands())
    EXPECT_THAT(output_of({command.words.front(), "--help"}), testing::HasSubstr("Usage"));
}

}  // namespace
}  // namespace phytobench
