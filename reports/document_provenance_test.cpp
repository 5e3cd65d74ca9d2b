// SPDX-License-Identifier: MIT
#include "reports/document_provenance.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

using nlohmann::ordered_json;

const ordered_json environment = ordered_json::parse(R"({
  "schema": "x", "compiler": "GNU 12", "threads": 2, "source_changed": false,
  "machine": {"processor": "P", "caches": ["a", "b"], "logical_processors": 4,
              "memory_gib": 23.456, "virtual_machine": true}})");

TEST(Environment, IsRowsOfNameAndValue) {
  const ordered_json rows = environment_rows(environment);
  ASSERT_EQ(rows.size(), 8u);
  EXPECT_EQ(rows[2]["name"], "source changed");
  EXPECT_EQ(rows[2]["value"], "no");
  EXPECT_EQ(rows[4]["name"], "machine: caches");
  EXPECT_EQ(rows[4]["value"], "a, b");
  EXPECT_EQ(rows[6]["value"], "23.46");
}

TEST(MachineLine, NamesMachineThreadsAndCompiler) {
  EXPECT_EQ(machine_line(environment),
            "P, 4 logical processors, in a virtual machine; 2 threads; GNU 12.");
  EXPECT_EQ(machine_line(ordered_json::object()), "");
}

}  // namespace
}  // namespace phytobench
