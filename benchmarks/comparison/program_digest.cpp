// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/program_digest.hpp"

#include <elf.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/contract/sha256.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {

namespace {

/// Larger programs are not compared; a debug build of everything has some 100 MB.
constexpr std::uintmax_t most_program_bytes = std::uintmax_t{2} << 30;

/// Reads a file that may be damaged: nothing in it is believed unchecked.
class ElfFile {
 public:
  ElfFile(std::string_view content, std::string_view name) : content_(content), name_(name) {
    check_kind();
    header_ = at<Elf64_Ehdr>(0);
    read_sections();
  }

  /// What counts of it, ready to be hashed.
  std::string loaded() const {
    std::string text;
    std::uint64_t bytes = 0;
    for (const Elf64_Shdr& section : sections_) {
      const std::string_view name = name_of(section);
      if ((section.sh_flags & SHF_ALLOC) == 0 || name.starts_with(".note.")) continue;
      text += fmt::format("{}\n{:x} {:x}\n", name, section.sh_flags, section.sh_size);
      if (section.sh_type == SHT_NOBITS) continue;
      const std::string_view part = slice(section.sh_offset, section.sh_size);
      bytes += part.size();
      if (bytes > content_.size()) fail("is damaged: its sections overlap");
      text += part;
    }
    if (text.empty()) fail("nothing of it would be loaded into memory");
    return text;
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw InputError(fmt::format("{}: {}; a program or shared library for this machine is needed",
                                 name_, problem));
  }

  std::string_view slice(std::uint64_t offset, std::uint64_t size) const {
    if (offset > content_.size() || size > content_.size() - offset)
      fail("is damaged: something lies behind its end");
    return content_.substr(offset, size);
  }

  /// A copy, because the file need not be aligned.
  template <class Part>
  Part at(std::uint64_t offset) const {
    static_assert(std::is_trivially_copyable_v<Part>);
    Part part{};
    std::memcpy(&part, slice(offset, sizeof part).data(), sizeof part);
    return part;
  }

  void check_kind() const {
    constexpr int order = std::endian::native == std::endian::little ? ELFDATA2LSB : ELFDATA2MSB;
    if (!content_.starts_with(ELFMAG)) fail("is no ELF file");
    if (content_.size() < sizeof(Elf64_Ehdr)) fail("is damaged: it ends in its header");
    if (content_[EI_CLASS] != ELFCLASS64) fail("is no 64-bit ELF file");
    if (content_[EI_DATA] != order) fail("has another byte order");
  }

  void read_sections() {
    if (header_.e_shoff == 0) fail("has no section table");
    if (header_.e_shentsize != sizeof(Elf64_Shdr))
      fail("is damaged: its sections have no known form");
    // Numbers too large for the header stand in the first section.
    const Elf64_Shdr first = at<Elf64_Shdr>(header_.e_shoff);
    const std::uint64_t count =
        header_.e_shnum == 0 ? first.sh_size : std::uint64_t{header_.e_shnum};
    const std::uint64_t names =
        header_.e_shstrndx == SHN_XINDEX ? first.sh_link : std::uint32_t{header_.e_shstrndx};
    if (count > content_.size() / sizeof(Elf64_Shdr)) fail("is damaged: too many sections");
    if (names >= count) fail("is damaged: its sections have no names");
    slice(header_.e_shoff, count * sizeof(Elf64_Shdr));
    for (std::uint64_t i = 0; i < count; ++i)
      sections_.push_back(at<Elf64_Shdr>(header_.e_shoff + i * sizeof(Elf64_Shdr)));
    names_ = slice(sections_[names].sh_offset, sections_[names].sh_size);
  }

  std::string_view name_of(const Elf64_Shdr& section) const {
    if (section.sh_name >= names_.size()) fail("is damaged: a section has no name");
    const std::string_view rest = names_.substr(section.sh_name);
    const std::size_t end = rest.find('\0');
    if (end == std::string_view::npos) fail("is damaged: a section's name has no end");
    return rest.substr(0, end);
  }

  std::string_view content_;
  std::string_view name_;
  Elf64_Ehdr header_{};
  std::vector<Elf64_Shdr> sections_;
  std::string_view names_;  ///< of sections
};

}  // namespace

std::string program_digest(std::string_view content, std::string_view name) {
  return sha256_hex(ElfFile(content, name).loaded());
}

std::string program_digest(const std::filesystem::path& file) {
  return program_digest(read_text_file(file, most_program_bytes), file.string());
}

}  // namespace phytobench
