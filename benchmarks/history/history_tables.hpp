// SPDX-License-Identifier: MIT
// The format of a history's file. Another format gets another number, and the old one is read on.
#pragma once

#include "benchmarks/history/history_file.hpp"

namespace phytobench {

inline constexpr int history_version = 1;

/// Makes the tables where the file is empty and may be filled; whoever else is making them is
/// waited for. Throws InputError where it holds anything but a history of this format.
void begin_history(const SqliteDatabase& database, HistoryAccess access);

}  // namespace phytobench
