// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_MESH_WRITER_H
#define CAGEWRIGHT_HOST_FILE_MESH_WRITER_H

#include <filesystem>
#include <string>

#include "host/file/triangle_mesh.h"

namespace cagewright::host {

// Whether `path` ends in one of .obj .off .ply .stl .glb, in any case: what mesh_bytes can make.
bool is_writable_mesh_name(const std::filesystem::path& path);

// The mesh as a file of the format that the ending of `path` names. Nothing is written. OBJ, OFF, PLY and STL are text,
// with the shortest numbers that read back as the same doubles, in any locale; .glb holds floats, as glTF has no
// doubles. Precondition: positions finite, indices in range. Throws FileError where the mesh has no triangles, the
// ending is another one, or a position is beyond a float for .glb. O(n).
std::string mesh_bytes(const TriangleMesh& mesh, const std::filesystem::path& path);

// The same for .glb alone: one scene, one node and one mesh, all named `name`.
std::string glb_bytes(const TriangleMesh& mesh, const std::string& name, const std::filesystem::path& path);

}  // namespace cagewright::host

#endif
