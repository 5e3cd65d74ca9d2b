// SPDX-License-Identifier: MIT
#include "core/contract/text_file.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <memory>
#include <utility>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail_writing(const fs::path& file, int error) {
  throw EnvironmentError("cannot write " + file.string() + ": " + std::strerror(error) +
                         "; nothing was changed there, free the disk or choose another folder");
}

[[noreturn]] void fail_too_large(const fs::path& file, std::uintmax_t most_bytes) {
  throw InputError(file.string() + ": is larger than " + std::to_string(most_bytes) +
                   " bytes; this cannot be the right file");
}

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

std::string read_text_file(const fs::path& file, std::uintmax_t most_bytes) {
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) throw InputError(file.string() + ": no such file");
  if (fs::is_directory(status)) throw InputError(file.string() + ": is a folder, a file is needed");
  if (fs::is_regular_file(status) && fs::file_size(file, error) > most_bytes)
    fail_too_large(file, most_bytes);
  std::ifstream stream(file, std::ios::binary);
  std::string text;
  std::array<char, 1 << 16> block;
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    text.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > most_bytes) fail_too_large(file, most_bytes);  // a device has no size to ask
  }
  if (!stream.eof()) throw InputError(file.string() + ": cannot be read; check its permissions");
  return text;
}

void make_folder(const fs::path& folder) {
  if (folder.empty()) return;
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    throw EnvironmentError("cannot make the folder " + folder.string() + ": " +
                           (error ? error.message() : "a file of that name exists"));
}

namespace {

/// A file under a temporary name beside its own, which goes away unless it is renamed.
class FileToRename {
 public:
  FileToRename(const fs::path& file, std::string_view content) : file_(file), temporary_(file) {
    make_folder(file.parent_path());
    temporary_ += ".part" + std::to_string(::getpid());
    const std::unique_ptr<std::FILE, CloseFile> stream(std::fopen(temporary_.c_str(), "wb"));
    if (!stream) fail_writing(file, errno);
    const bool written =
        std::fwrite(content.data(), 1, content.size(), stream.get()) == content.size() &&
        std::fflush(stream.get()) == 0 && ::fsync(::fileno(stream.get())) == 0;
    if (written) return;
    const int reason = errno;
    discard();
    fail_writing(file, reason);
  }
  FileToRename(const FileToRename&) = delete;
  FileToRename& operator=(const FileToRename&) = delete;
  FileToRename(FileToRename&& other) noexcept { *this = std::move(other); }
  FileToRename& operator=(FileToRename&& other) noexcept {
    std::swap(file_, other.file_);
    std::swap(temporary_, other.temporary_);
    return *this;
  }
  ~FileToRename() { discard(); }

  void rename() {
    std::error_code error;
    if (fs::is_directory(file_, error)) fail_writing(file_, EISDIR);
    fs::rename(temporary_, file_, error);
    if (error) fail_writing(file_, error.value());
    temporary_.clear();
  }

 private:
  void discard() noexcept {
    std::error_code ignored;
    if (!temporary_.empty()) fs::remove(temporary_, ignored);
  }

  fs::path file_;
  fs::path temporary_;
};

}  // namespace

void write_file_atomically(const fs::path& file, std::string_view content) {
  FileToRename(file, content).rename();
}

void write_files_atomically(const std::vector<FileContent>& files) {
  std::vector<FileToRename> written;
  for (const FileContent& file : files) written.emplace_back(file.file, file.content);
  for (FileToRename& file : written) file.rename();
}

}  // namespace phytobench
