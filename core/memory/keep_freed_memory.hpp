// SPDX-License-Identifier: MIT
#pragma once

namespace phytobench {

/// From now on the program keeps memory that it frees instead of giving it back to the system. For
/// programs that time the same work again and again: otherwise every repetition waits anew for the
/// system to clear its pages, which at ten million points costs as much as the search. Call it
/// once, early. Does nothing where the C library cannot.
void keep_freed_memory();

}  // namespace phytobench
