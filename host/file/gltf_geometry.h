// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_GLTF_GEOMETRY_H
#define CAGEWRIGHT_HOST_FILE_GLTF_GEOMETRY_H

#include <filesystem>

#include "host/file/triangle_mesh.h"

namespace tinygltf {
class Model;
}

namespace cagewright::host {

// The triangles of mesh `mesh` of `model`, all primitives as one, in the mesh's own space: lists, strips and fans, with
// or without indices. Points and lines are skipped with a note, morph targets and skins are not applied. May hold no
// triangles. Throws FileError, which names mesh, primitive and accessor. Precondition: the mesh is there. O(size).
MeshFile read_gltf_mesh(const std::filesystem::path& path, const tinygltf::Model& model, int mesh);

}  // namespace cagewright::host

#endif
