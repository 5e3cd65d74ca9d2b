// SPDX-License-Identifier: MIT
#include "core/record/folder_lock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/record/run_folder_fixture.hpp"

namespace phytobench {
namespace {

class FolderLocks : public RunFolder {};

TEST_F(FolderLocks, KeepOthersOutAsLongAsTheyLive) {
  make_folder(folder_);
  {
    const FolderLock first(folder_);
    EXPECT_THAT(input_error([this] { FolderLock second(folder_); }),
                testing::StartsWith(folder_.string() + ": another run is writing there"));
  }
  EXPECT_NO_THROW(FolderLock again(folder_));
}

TEST_F(FolderLocks, GoWithWhoeverTheyAreMovedTo) {
  make_folder(folder_);
  FolderLock kept;
  {
    FolderLock first(folder_);
    FolderLock second(std::move(first));
    kept = std::move(second);
  }
  EXPECT_THROW(FolderLock another(folder_), InputError);
  kept = FolderLock();
  EXPECT_NO_THROW(FolderLock another(folder_));
}

TEST_F(FolderLocks, HoldNothingWhereThereIsNoFolder) {
  EXPECT_NO_THROW(FolderLock lock(folder_));
  make_folder(base_);
  EXPECT_NO_THROW(FolderLock lock(folder_));
}

TEST_F(FolderLocks, LeaveNothingInTheFolder) {
  make_folder(folder_);
  const FolderLock lock(folder_);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

}  // namespace
}  // namespace phytobench
