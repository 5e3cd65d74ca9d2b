// SPDX-License-Identifier: MIT
#include "core/record/digest_chain.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/sha256.hpp"

namespace phytobench {
namespace {

TEST(DigestChain, SealsWithTheSumOfTheSealBeforeTheLinesAndTheObject) {
  DigestChain chain;
  const std::string first = sha256_hex(R"({"a":1)");
  EXPECT_EQ(chain.sealed("", R"({"a":1})"), R"({"a":1,"sha256":")" + first + "\"}");
  EXPECT_EQ(chain.seal(), first);
  const std::string second = sha256_hex(first + "[1]\n[2]\n" + R"({"b":2)");
  EXPECT_EQ(chain.sealed("[1]\n[2]\n", R"({"b":2})"), R"({"b":2,"sha256":")" + second + "\"}");
}

TEST(DigestChain, AcceptsWhatItSealedAndNothingElse) {
  DigestChain writer, reader;
  const std::string first = writer.sealed("", R"({"a":1})");
  const std::string second = "[1]\n" + writer.sealed("[1]\n", R"({"b":2})");
  EXPECT_FALSE(reader.accept(second)) << "the first is lost";
  EXPECT_TRUE(reader.accept(first));
  EXPECT_FALSE(reader.accept(first)) << "it stands here twice";
  for (std::size_t i = 0; i < second.size(); ++i) {
    std::string damaged = second;
    damaged[i] = static_cast<char>(damaged[i] ^ 1);
    EXPECT_FALSE(reader.accept(damaged)) << "byte " << i;
    EXPECT_FALSE(reader.accept(second.substr(0, i))) << "cut to " << i;
  }
  EXPECT_FALSE(reader.accept(second + "\n"));
  EXPECT_TRUE(reader.accept(second)) << "a refusal changes nothing";
  EXPECT_EQ(reader.seal(), writer.seal());
}

TEST(DigestChain, GoesOnAfterASeal) {
  DigestChain whole;
  whole.sealed("", R"({"a":1})");
  DigestChain resumed(whole.seal());
  EXPECT_EQ(resumed.sealed("", R"({"b":2})"), whole.sealed("", R"({"b":2})"));
}

TEST(DigestChain, RefusesWhatIsNoObjectWithAKey) {
  DigestChain chain;
  for (const char* object : {"", "{}", "[1]", "{\"a\":1"})
    EXPECT_THROW(chain.sealed("", object), ContractViolation) << object;
}

}  // namespace
}  // namespace phytobench
