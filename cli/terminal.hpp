// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace phytobench::cli {

/// Shows one line that replaces itself on standard error; nothing unless that is a terminal.
void show_progress(const std::string& line);

/// Takes the progress line away, before other output.
void clear_progress();

/// Shows one line that stays, on standard error.
void tell(const std::string& line);

/// Makes Ctrl-C set a flag instead of killing the program. A second Ctrl-C kills.
void catch_interrupts();
bool is_interrupted();

/// Writes to standard output and throws EnvironmentError if that fails (a full disk, a closed
/// pipe).
void print(const std::string& text);

}  // namespace phytobench::cli
