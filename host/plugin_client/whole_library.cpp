// SPDX-License-Identifier: BSD-3-Clause
#include "host/plugin_client/whole_library.h"

#include <elf.h>

#include <algorithm>
#include <cstring>
#include <fstream>

namespace cagewright::host {
namespace {

template <class Part>
bool read_part(std::ifstream& file, std::uint64_t offset, Part& part) {
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char*>(&part), sizeof(part));
  return file.good();
}

}  // namespace

std::optional<std::uint64_t> bytes_of_whole_library(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  Elf64_Ehdr header{};
  if (!read_part(file, 0, header) || std::memcmp(header.e_ident, ELFMAG, SELFMAG) != 0 ||
      header.e_ident[EI_CLASS] != ELFCLASS64 || header.e_phentsize != sizeof(Elf64_Phdr))
    return {};
  std::uint64_t bytes = header.e_phoff + std::uint64_t{header.e_phnum} * sizeof(Elf64_Phdr);
  for (unsigned i = 0; i < header.e_phnum; ++i) {
    Elf64_Phdr segment{};
    if (!read_part(file, header.e_phoff + i * sizeof(segment), segment)) return bytes;
    if (segment.p_type == PT_LOAD) bytes = std::max(bytes, segment.p_offset + segment.p_filesz);
  }
  return bytes;
}

}  // namespace cagewright::host
