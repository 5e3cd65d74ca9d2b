// SPDX-License-Identifier: MIT
#include "core/contract/sha256.hpp"

#include <array>

#include <openssl/evp.h>

#include "core/contract/errors.hpp"

namespace phytobench {

std::string sha256_hex(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw EnvironmentError("OpenSSL refuses to compute SHA-256; check its configuration");
  constexpr std::string_view digits = "0123456789abcdef";
  std::string hex;
  for (unsigned int i = 0; i < length; ++i) {
    hex += digits[digest[i] >> 4];
    hex += digits[digest[i] & 15];
  }
  return hex;
}

}  // namespace phytobench
