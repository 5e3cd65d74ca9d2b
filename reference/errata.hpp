// SPDX-License-Identifier: MIT
// Misprints and missing cases of a paper (reference/papers/<key>/errata.toml, or errata/*.toml).
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace phytobench {

/// A number that shows an erratum: an oracle evaluated as printed and as corrected.
struct CounterExample {
  std::string oracle;  ///< "equation-22": as in reference/errata_test.cpp
  std::vector<double> arguments;
  std::optional<double> printed;  ///< absent where the printed form is undefined
  double corrected = 0.0;
  double tolerance = 0.0;
  std::string why;  ///< reason of the tolerance
};

struct Erratum {
  std::string id;
  std::string paper;
  std::string locator;
  std::string printed;
  std::string corrected;
  std::string consequence;
  std::string confidence;  ///< "certain" or "probable"
  std::vector<std::string> claims;
  std::optional<CounterExample> counter_example;
};

std::vector<Erratum> load_errata(const std::string& paper);

}  // namespace phytobench
