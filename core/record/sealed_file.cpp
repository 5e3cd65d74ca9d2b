// SPDX-License-Identifier: MIT
#include "core/record/sealed_file.hpp"

#include <utility>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/record/append_to_file.hpp"

namespace phytobench {

namespace fs = std::filesystem;

SealedFile::SealedFile(fs::path file, std::string_view first_object) : file_(std::move(file)) {
  const std::string text = chain_.sealed("", first_object) + "\n";
  write_file_atomically(file_, text);
  bytes_ = text.size();
}

SealedFile::SealedFile(fs::path file, const Seal& last)
    : file_(std::move(file)), bytes_(last.end), chain_(last.digest) {
  std::error_code error;
  if (fs::file_size(file_, error) == bytes_) return;
  fs::resize_file(file_, bytes_, error);
  if (error)
    throw EnvironmentError("cannot write " + file_.string() + ": " + error.message() +
                           "; check its permissions");
}

void SealedFile::append(std::string_view lines, std::string_view object) {
  DigestChain chain = chain_;
  const std::string text = std::string(lines) + chain.sealed(lines, object) + "\n";
  append_or_restore(file_, text, bytes_);
  bytes_ += text.size();
  chain_ = std::move(chain);
}

std::string SealedFile::digest_after(std::string_view lines, std::string_view object) const {
  DigestChain chain = chain_;
  chain.sealed(lines, object);
  return chain.seal();
}

void SealedFile::cut() const noexcept {
  std::error_code ignored;
  fs::resize_file(file_, bytes_, ignored);
}

}  // namespace phytobench
