// SPDX-License-Identifier: MIT
// L-System1 and L-System2 of [Alsweis] sec. 3.2 and 3.4: all outcomes of the stochastic one with
// exact probabilities, and the queries of the other one. Shares no code with core/.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace phytobench::oracles::alsweis {

// 2/5 and 3/5 multiply to whole numbers over powers of five. Lowest terms.
struct FifthsProbability {
  std::uint64_t numerator = 0;
  std::uint64_t denominator = 1;
  friend bool operator==(const FifthsProbability&, const FifthsProbability&) = default;
};
FifthsProbability sum(FifthsProbability a, FifthsProbability b);
FifthsProbability product(FifthsProbability a, FifthsProbability b);

// "B(0)B(6)[A(3)]B(4)" -> 9/25, after so many steps.
std::map<std::string, FifthsProbability> outcomes_of_lsystem_1(int steps);

// L-System2 does not say its angle and its first heading; by the paper that it comes from they are
// 90 degrees and upwards. "F(2)?P(0,2)-F(1)?P(1,2)-A", with the answers of the queries.
std::string word_of_lsystem_2(int steps);

// The answers alone, from left to right.
std::vector<std::pair<int, int>> queries_of_lsystem_2(int steps);

}  // namespace phytobench::oracles::alsweis
