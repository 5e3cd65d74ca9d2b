// SPDX-License-Identifier: MIT
// The bush of [Lintermann1997] sec. 2.1 and [Brzoska2019] eq. 7: its grammar with the numbers of
// slashes and primes that the prints differ in, and the closed forms of its counts. Shares no code
// with core/, so that agreement means something.
#pragma once

#include <string>

#include "reference/oracles/liebemann2017_lsystems.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench::oracles::lintermann1997 {

// 5, 7 and 5 slashes in The Algorithmic Beauty of Plants; 8, 8 and 8 in the text of the paper.
struct BushPrint {
  int slashes_first = 5;   // in p1, behind the first group
  int slashes_second = 7;  // in p1, behind the second group
  int slashes_stem = 5;    // in p2
  int leaf_primes = 3;     // in p4; [Brzoska2019] eq. 7 has 2
};

inline liebemann2017::D0LSystem bush(const BushPrint& print) {
  using liebemann2017::one_by_one;
  const auto slashes = [](int n) { return std::string(static_cast<std::size_t>(n), '/'); };
  const std::string primes(static_cast<std::size_t>(print.leaf_primes), '\'');
  return {{"A"},
          {{"A", one_by_one("[&FL!A]" + slashes(print.slashes_first) + "'[&FL!A]" +
                            slashes(print.slashes_second) + "'[&FL!A]")},
           {"F", one_by_one("S" + slashes(print.slashes_stem) + "F")},
           {"S", one_by_one("FL")},
           {"L", one_by_one("[" + primes + "^^{-f+f+f-|-f+f+f}]")}}};
}

// F' = F + S + 3 A, S' = F and A' = 3 A give F(n+1) = F(n) + F(n-1) + 3^(n+1), whose solution with
// F(0) = 0 and F(1) = 3 has 9/5 3^n and Fibonacci's numbers.
inline Count bush_F(int n) {
  if (n == 0) return 0;
  return (9 * whole_power(3, n) - 9 * fibonacci(n - 1) - 12 * fibonacci(n)) / 5;
}
// F(0) + ... + F(n-1): how often an F was replaced.
inline Count bush_F_replaced(int n) {
  if (n == 0) return 0;
  return (9 * replacements(3, n) - 9 * fibonacci(n) - 12 * (fibonacci(n + 1) - 1)) / 5;
}
inline Count bush_A(int n) {
  return whole_power(3, n);
}
inline Count bush_S(int n) {
  return n == 0 ? 0 : bush_F(n - 1);
}
inline Count bush_L(int n) {
  return n == 0 ? 0 : bush_S(n - 1) + whole_power(3, n);
}
// Every L that was replaced; as many as S.
inline Count bush_polygons(int n) {
  return bush_S(n);
}
inline Count bush_groups(int n) {  // [&FL!A]; also the number of & and of !
  return 3 * replacements(3, n);
}
inline Count bush_pairs(int n) {
  return bush_groups(n) + bush_polygons(n);
}
inline Count bush_primes(int n, const BushPrint& print) {
  return 2 * replacements(3, n) + static_cast<Count>(print.leaf_primes) * bush_polygons(n);
}
inline Count bush_slashes(int n, const BushPrint& print) {
  return static_cast<Count>(print.slashes_first + print.slashes_second) * replacements(3, n) +
         static_cast<Count>(print.slashes_stem) * bush_F_replaced(n);
}
// Of a polygon: two braces, 6 f, 2 ^, 4 +, 3 -, one |.
inline Count bush_letters(int n, const BushPrint& print) {
  return bush_A(n) + bush_F(n) + bush_S(n) + bush_L(n) + 18 * bush_polygons(n) + 2 * bush_pairs(n) +
         2 * bush_groups(n) + bush_primes(n, print) + bush_slashes(n, print);
}

}  // namespace phytobench::oracles::lintermann1997
