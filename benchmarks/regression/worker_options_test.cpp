// SPDX-License-Identifier: MIT
#include "benchmarks/regression/worker_options.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

TEST(WorkerOptions, AreRead) {
  const WorkerOptions options =
      worker_options({"--handicap", "0.1", "verify", "a/b", "--plugin", "x.so", "c", "--selftest"});
  EXPECT_EQ(options.command, "verify");
  EXPECT_EQ(options.names, (std::vector<std::string>{"a/b", "c"}));
  EXPECT_EQ(options.plugins, (std::vector<std::string>{"x.so"}));
  EXPECT_EQ(options.handicap, 0.1);
  EXPECT_TRUE(options.with_selftest);
}

TEST(WorkerOptions, WhatTheyDoNotKnowIsRefused) {
  const std::vector<std::vector<std::string>> wrong = {{},
                                                       {"verfy"},
                                                       {"list", "--fast"},
                                                       {"sample", "--handicap"},
                                                       {"sample", "--handicap", "2"},
                                                       {"sample", "--handicap", "nan"},
                                                       {"calibrate", "--sample-ms", "10ms"},
                                                       {"calibrate", "--sample-ms", "0"}};
  for (const auto& arguments : wrong) EXPECT_THROW(worker_options(arguments), InputError);
}

}  // namespace
}  // namespace phytobench
