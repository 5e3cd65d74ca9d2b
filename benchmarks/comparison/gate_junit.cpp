// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/gate_junit.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "benchmarks/comparison/plain_text.hpp"
#include "core/picture/svg_text.hpp"

namespace phytobench {

namespace {

/// XML has no way to write most control characters.
std::string escaped(const std::string& text) {
  return escaped_for_svg(one_line(text, 2000));
}

/// Test runners group by classes, whose names they split at dots.
std::string class_of(std::string_view gate, const std::string& name) {
  std::string family = name.substr(0, name.find('/'));
  std::replace(family.begin(), family.end(), '.', '_');
  return fmt::format("{}.{}", gate, family);
}

std::string ending_of(const GateCase& one) {
  const std::string message = escaped(one.message);
  switch (one.outcome) {
    case GateOutcome::failed:
      return fmt::format("      <failure message=\"{0}\">{0}</failure>\n", message);
    case GateOutcome::skipped:
      return fmt::format("      <skipped message=\"{}\"/>\n", message);
    case GateOutcome::passed:
      break;
  }
  return message.empty() ? "" : fmt::format("      <system-out>{}</system-out>\n", message);
}

}  // namespace

std::string gate_junit(std::string_view command, const std::vector<GateCase>& cases) {
  const std::string_view gate = command.substr(command.rfind(' ') + 1);  // npos + 1 is 0
  const auto count_of = [&](GateOutcome outcome) {
    return std::count_if(cases.begin(), cases.end(),
                         [&](const GateCase& one) { return one.outcome == outcome; });
  };
  std::string body;
  for (const GateCase& one : cases)
    body += fmt::format("    <testcase classname=\"{}\" name=\"{}\">\n{}    </testcase>\n",
                        escaped(class_of(gate, one.name)), escaped(one.name), ending_of(one));
  const std::string totals =
      fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\"", cases.size(),
                  count_of(GateOutcome::failed), count_of(GateOutcome::skipped));
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites name=\"phytobench\" {0}>\n"
      "  <testsuite name=\"phytobench {1}\" {0}>\n{2}  </testsuite>\n</testsuites>\n",
      totals, command, body);
}

}  // namespace phytobench
