// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/program_digest.hpp"

#include <elf.h>

#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include "benchmarks/comparison/side_fixture.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

struct Section {
  std::string name;
  std::string content;
  std::uint64_t flags = SHF_ALLOC;
  std::uint32_t type = SHT_PROGBITS;
  std::uint64_t size = 0;  ///< of SHT_NOBITS
};

template <class Part>
std::string bytes_of(const Part& part) {
  return std::string(reinterpret_cast<const char*>(&part), sizeof part);
}

/// A file with these sections, after the empty one and that of names; the table comes last.
std::string elf(const std::vector<Section>& sections, std::size_t gap = 0) {
  std::string names("\0.shstrtab\0", 11), body(gap, 'g');
  std::vector<Elf64_Shdr> table(1);
  for (const Section& section : sections) {
    const bool is_empty = section.type == SHT_NOBITS;
    table.push_back({.sh_name = static_cast<Elf64_Word>(names.size()),
                     .sh_type = section.type,
                     .sh_flags = section.flags,
                     .sh_offset = sizeof(Elf64_Ehdr) + body.size(),
                     .sh_size = is_empty ? section.size : section.content.size()});
    names += section.name + '\0';
    body += section.content;
  }
  table.push_back({.sh_name = 1,
                   .sh_type = SHT_STRTAB,
                   .sh_offset = sizeof(Elf64_Ehdr) + body.size(),
                   .sh_size = names.size()});
  body += names;
  Elf64_Ehdr header{.e_type = ET_DYN,
                    .e_machine = EM_X86_64,
                    .e_version = EV_CURRENT,
                    .e_shoff = sizeof(Elf64_Ehdr) + body.size(),
                    .e_ehsize = sizeof(Elf64_Ehdr),
                    .e_shentsize = sizeof(Elf64_Shdr),
                    .e_shnum = static_cast<Elf64_Half>(table.size()),
                    .e_shstrndx = static_cast<Elf64_Half>(table.size() - 1)};
  std::memcpy(header.e_ident, ELFMAG, SELFMAG);
  header.e_ident[EI_CLASS] = ELFCLASS64;
  header.e_ident[EI_DATA] = ELFDATA2LSB;
  std::string file = bytes_of(header) + body;
  for (const Elf64_Shdr& section : table) file += bytes_of(section);
  return file;
}

const Section code{.name = ".text", .content = "code", .flags = SHF_ALLOC | SHF_EXECINSTR};
const Section zeros{.name = ".bss", .type = SHT_NOBITS, .size = 1ull << 40};
const Section build_id{.name = ".note.gnu.build-id", .content = "1234"};
const Section symbols{.name = ".symtab", .content = "/a/path", .flags = 0};

std::string digest(const std::string& file) {
  return program_digest(file, "file");
}

std::string problem(const std::string& file) {
  return message_of<InputError>([&] { digest(file); });
}

TEST(ProgramDigest, IsThatOfWhatIsLoaded) {
  const std::string expected = digest(elf({code, zeros, build_id, symbols}));
  EXPECT_EQ(expected.size(), 64u);
  EXPECT_EQ(digest(elf({code, zeros})), expected);
  EXPECT_EQ(digest(elf({symbols, code, build_id, zeros}, 13)), expected);
  Section other_build = build_id, other_symbols = symbols;
  other_build.content = "5678";
  other_symbols.content = "/another/path";
  EXPECT_EQ(digest(elf({code, zeros, other_build, other_symbols})), expected);
}

TEST(ProgramDigest, ChangesWithEverythingThatIsLoaded) {
  const std::string expected = digest(elf({code, zeros}));
  Section content = code, name = code, flags = code, size = zeros;
  content.content = "cod_";
  name.name = ".init";
  flags.flags |= SHF_WRITE;
  size.size += 1;
  for (const std::vector<Section>& changed : std::vector<std::vector<Section>>{
           {content, zeros}, {name, zeros}, {flags, zeros}, {code, size}, {code}, {zeros, code}})
    EXPECT_NE(digest(elf(changed)), expected);
}

TEST(ProgramDigest, NeedsAnElfFileOfThisMachine) {
  EXPECT_THAT(problem(""), HasSubstr("file: is no ELF file"));
  EXPECT_THAT(problem("#!/bin/sh\n"), HasSubstr("is no ELF file"));
  std::string file = elf({code});
  file[EI_CLASS] = ELFCLASS32;
  EXPECT_THAT(problem(file), HasSubstr("no 64-bit ELF file"));
  file = elf({code});
  file[EI_DATA] = ELFDATA2MSB;
  EXPECT_THAT(problem(file), HasSubstr("another byte order"));
  EXPECT_THAT(problem(elf({symbols, build_id})), HasSubstr("nothing of it would be loaded"));
  file = elf({code});
  std::memset(file.data() + offsetof(Elf64_Ehdr, e_shoff), 0, 8);
  EXPECT_THAT(problem(file), HasSubstr("has no section table"));
}

TEST(ProgramDigest, RefusesSectionsThatShareTheirBytesWithoutEnd) {
  std::string file = elf({code, code, code});
  const std::size_t table = file.size() - 5 * sizeof(Elf64_Shdr);
  for (std::size_t i = 1; i <= 3; ++i) {
    const std::uint64_t from = 0, all = file.size();
    char* section = file.data() + table + i * sizeof(Elf64_Shdr);
    std::memcpy(section + offsetof(Elf64_Shdr, sh_offset), &from, sizeof from);
    std::memcpy(section + offsetof(Elf64_Shdr, sh_size), &all, sizeof all);
  }
  EXPECT_THAT(problem(file), HasSubstr("its sections overlap"));
}

TEST(ProgramDigest, CountsMoreSectionsThanTheHeaderCanHold) {
  const std::string usual = elf({code, zeros});
  std::string large = usual;
  const std::size_t table = large.size() - 4 * sizeof(Elf64_Shdr);
  const std::uint64_t count = 4;
  const std::uint32_t names = 3;
  const Elf64_Half none = 0, elsewhere = SHN_XINDEX;
  std::memcpy(large.data() + table + offsetof(Elf64_Shdr, sh_size), &count, sizeof count);
  std::memcpy(large.data() + table + offsetof(Elf64_Shdr, sh_link), &names, sizeof names);
  std::memcpy(large.data() + offsetof(Elf64_Ehdr, e_shnum), &none, sizeof none);
  std::memcpy(large.data() + offsetof(Elf64_Ehdr, e_shstrndx), &elsewhere, sizeof elsewhere);
  EXPECT_EQ(digest(large), digest(usual));
}

TEST(ProgramDigest, OfAFileThatEndsEarlyIsRefused) {
  const std::string file = elf({code, zeros, build_id, symbols});
  for (std::size_t size = 0; size < file.size(); ++size)
    EXPECT_NE(problem(file.substr(0, size)), "no error") << size;
}

TEST(ProgramDigest, OfADamagedFileIsAnotherOrRefusedButNeverACrash) {
  const std::string file = elf({code, zeros, build_id, symbols});
  for (std::size_t at = 0; at < file.size(); ++at)
    for (const int mask : {0x01, 0x80, 0xff}) {
      std::string damaged = file;
      damaged[at] = static_cast<char>(damaged[at] ^ mask);
      try {
        EXPECT_EQ(digest(damaged).size(), 64u);
      } catch (const InputError&) {
      }
    }
}

class ProgramFiles : public SideFolder {};

TEST_F(ProgramFiles, HaveTheDigestOfTheirCopies) {
  const std::string copy = program_digest(write_program("copy")), own = program_digest("/bin/sh");
  EXPECT_EQ(copy, own);
  EXPECT_NE(program_digest("/proc/self/exe"), own);
  EXPECT_THAT(message_of<InputError>([&] { program_digest(folder_ / "none"); }),
              HasSubstr("no such file"));
}

}  // namespace
}  // namespace phytobench
