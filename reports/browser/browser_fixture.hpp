// SPDX-License-Identifier: MIT
#pragma once

#include <unistd.h>

#include <filesystem>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "reports/browser/page.hpp"

namespace phytobench {

/// One browser and one folder for all tests of a suite; skipped where no browser is installed.
class BrowserSlow : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    const auto program = installed_browser();
    if (!program) return;
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("phytobench-pages-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
    browser_ = std::make_unique<Browser>(*program);
  }

  static void TearDownTestSuite() {
    if (!browser_) return;
    browser_.reset();
    std::filesystem::remove_all(folder_);
  }

  void SetUp() override {
    if (!browser_)
      GTEST_SKIP() << "no browser: install chromium, or name one in PHYTOBENCH_BROWSER";
  }

  static inline std::unique_ptr<Browser> browser_;
  static inline std::filesystem::path folder_;
};

}  // namespace phytobench
