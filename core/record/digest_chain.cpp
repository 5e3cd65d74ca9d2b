// SPDX-License-Identifier: MIT
#include "core/record/digest_chain.hpp"

#include "core/contract/check.hpp"
#include "core/contract/sha256.hpp"

namespace phytobench {

namespace {

constexpr std::string_view seal_key = ",\"sha256\":\"";
constexpr std::string_view seal_end = "\"}";
constexpr std::size_t digits = 64;
constexpr std::size_t tail = seal_key.size() + digits + seal_end.size();

}  // namespace

std::string DigestChain::sealed(std::string_view lines, std::string_view object) {
  PHYTOBENCH_EXPECT(object.size() > 2 && object.front() == '{' && object.back() == '}');
  const std::string_view open = object.substr(0, object.size() - 1);
  seal_ = sha256_hex(seal_ + std::string(lines) + std::string(open));
  return std::string(open) + std::string(seal_key) + seal_ + std::string(seal_end);
}

bool DigestChain::accept(std::string_view section) {
  if (section.size() < tail || !section.ends_with(seal_end)) return false;
  const std::string_view covered = section.substr(0, section.size() - tail);
  const std::string_view rest = section.substr(covered.size());
  if (!rest.starts_with(seal_key)) return false;
  std::string expected = sha256_hex(seal_ + std::string(covered));
  if (rest.substr(seal_key.size(), digits) != expected) return false;
  seal_ = std::move(expected);
  return true;
}

}  // namespace phytobench
