// SPDX-License-Identifier: MIT
#include "core/contract/sha256.hpp"

#include <set>
#include <string>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

// Known answers: the NIST examples for SHA-256 (FIPS 180-4).
TEST(Sha256, GivesTheKnownAnswers) {
  EXPECT_EQ(sha256_hex(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256_hex("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256_hex("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256_hex(std::string(1'000'000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST(Sha256, TakesEveryByteIntoAccount) {
  const std::string zeros(3, '\0');
  EXPECT_NE(sha256_hex(zeros), sha256_hex(zeros.substr(1))) << "a zero does not end the bytes";
  std::set<std::string> digests = {sha256_hex(zeros)};
  for (std::size_t place = 0; place < zeros.size(); ++place) {
    std::string changed = zeros;
    changed[place] = '\x01';
    digests.insert(sha256_hex(changed));
  }
  EXPECT_EQ(digests.size(), 4u);
}

}  // namespace
}  // namespace phytobench
