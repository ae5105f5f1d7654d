// SPDX-License-Identifier: BSD-3-Clause
#include "host/file/mesh_reader.h"

#include <array>
#include <string>

#include "host/file/file_bytes.h"
#include "host/file/file_error.h"

namespace cagewright::host {
namespace {

using Reader = MeshFile (*)(const std::filesystem::path&, std::string_view, MeshRole);

template <MeshFile (*read)(const std::filesystem::path&, std::string_view)>
MeshFile for_any_role(const std::filesystem::path& path, std::string_view bytes, MeshRole) {
  return read(path, bytes);
}

struct Format {
  std::string_view ending;
  Reader read;
};
constexpr std::array<Format, 6> formats = {{{".obj", for_any_role<read_obj>},
                                            {".off", for_any_role<read_off>},
                                            {".ply", for_any_role<read_ply>},
                                            {".stl", for_any_role<read_stl>},
                                            {".glb", read_gltf},
                                            {".gltf", read_gltf}}};

Reader reader_for(const std::filesystem::path& path) {
  const std::string ending = lower_ending(path);
  for (const Format& format : formats) {
    if (format.ending == ending) return format.read;
  }
  return nullptr;
}

}  // namespace

bool is_mesh_file_name(const std::filesystem::path& path) { return reader_for(path) != nullptr; }

MeshFile read_mesh(const std::filesystem::path& path, MeshRole role) {
  const Reader read = reader_for(path);
  if (read == nullptr) {
    const std::string ending = lower_ending(path);
    throw FileError(
        path, {},
        (ending.empty() ? std::string("it has no ending") : "the ending " + in_quotes(ending) + " is unknown") +
            "; a mesh file ends in .obj, .off, .ply, .stl, .glb or .gltf");
  }
  const std::string bytes = read_bytes(path);
  if (bytes.empty()) throw FileError(path, {}, "is not a mesh: the file is empty");
  return read(path, bytes, role);
}

}  // namespace cagewright::host
