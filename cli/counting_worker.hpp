// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "benchmarks/comparison/side.hpp"

namespace phytobench::cli {

/// The worker that counts: the program or the build folder that the user has named, or, without a
/// name, that of this build or of the preset 'counters'. One that was not named must be of the
/// program's own commit, see refuse_stale_worker(). Its origin says what it was built from, as far
/// as it is known. Throws InputError where there is none, or where it does not count.
Side counting_worker(const std::string& given);

}  // namespace phytobench::cli
