// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_FILE_MESH_READER_H
#define CAGEWRIGHT_HOST_FILE_MESH_READER_H

#include <filesystem>
#include <string_view>

#include "host/file/triangle_mesh.h"

namespace cagewright::host {

// Whether `path` ends in one of .obj .off .ply .stl .glb .gltf, in any case.
bool is_mesh_file_name(const std::filesystem::path& path);

// What a scene is read for: a cage of ours in it is not part of its model, but is what a cage is read from.
enum class MeshRole { model, cage };

// Reads the mesh of a file, format by its ending. Faces that are not manifold, degenerate faces and unused vertices are
// kept; polygons become triangles. Throws FileError: missing, unreadable, unknown ending, cut short, not a mesh, NaN or
// infinite positions, indices out of range, no triangles. O(file size).
MeshFile read_mesh(const std::filesystem::path& path, MeshRole role = MeshRole::model);

// The readers of single formats, from the file's bytes; `path` is for sentences (and for the files that a .gltf names).
// OBJ: v (with w or colours), f (negative indices too) and line continuations; every other statement is skipped, free
// curves and surfaces with a note. A statement that OBJ does not have is an error.
MeshFile read_obj(const std::filesystem::path& path, std::string_view bytes);
// OFF, COFF, NOFF, STOFF and their combinations; colours, normals and texture coordinates are skipped.
MeshFile read_off(const std::filesystem::path& path, std::string_view bytes);
// PLY 1.0 ascii, binary_little_endian and binary_big_endian: element vertex, face and tristrips; others are skipped.
MeshFile read_ply(const std::filesystem::path& path, std::string_view bytes);
// STL ascii and binary. Corners at exactly the same position become one vertex, as STL has no other way to say so.
MeshFile read_stl(const std::filesystem::path& path, std::string_view bytes);
// glTF 2.0, text or binary (told apart by the first bytes): the triangles of the default scene. One mesh node: its own
// local space, untouched by its transform. Several: merged in the scene's space, with a note. Points and lines are
// skipped with a note, morph targets and skins are not applied.
MeshFile read_gltf(const std::filesystem::path& path, std::string_view bytes, MeshRole role = MeshRole::model);

}  // namespace cagewright::host

#endif
