// SPDX-License-Identifier: MIT
#include "benchmarks/regression/worker_options.hpp"

#include <algorithm>
#include <charconv>

#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"

namespace phytobench {

namespace {

double number_in(const std::string& text, double low, double high, const std::string& option) {
  double number = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end || !(number >= low && number <= high))
    throw InputError("'" + text + "' is no value of " + option);
  return number;
}

void check_command(const std::string& command) {
  const std::vector<std::string> known = {"list",      "verify", "counters",
                                          "calibrate", "sample", "once"};
  if (std::find(known.begin(), known.end(), command) == known.end())
    throw InputError("unknown command '" + command + "'" + did_you_mean(command, known) +
                     "; give list, verify, counters, calibrate, sample or once");
}

}  // namespace

WorkerOptions worker_options(const std::vector<std::string>& arguments) {
  WorkerOptions options;
  for (auto argument = arguments.begin(); argument != arguments.end(); ++argument) {
    const auto value = [&]() -> const std::string& {
      if (std::next(argument) == arguments.end()) throw InputError(*argument + " needs a value");
      return *++argument;
    };
    if (*argument == "--plugin")
      options.plugins.push_back(value());
    else if (*argument == "--handicap")
      options.handicap = number_in(value(), 0.0, 1.0, "--handicap");
    else if (*argument == "--sample-ms")
      options.sample_ms = number_in(value(), 0.1, 10000.0, "--sample-ms");
    else if (*argument == "--selftest")
      options.with_selftest = true;
    else if (argument->starts_with("-"))
      throw InputError("unknown option '" + *argument + "'");
    else if (options.command.empty())
      options.command = *argument;
    else
      options.names.push_back(*argument);
  }
  check_command(options.command);
  return options;
}

}  // namespace phytobench
