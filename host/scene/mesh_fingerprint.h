// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_SCENE_MESH_FINGERPRINT_H
#define CAGEWRIGHT_HOST_SCENE_MESH_FINGERPRINT_H

#include <string>

#include "host/file/triangle_mesh.h"

namespace cagewright::host {

// 16 hexadecimal digits that meshes of other positions (as the floats that a scene holds) or triangles do not have, but
// by a chance of 2^-64: FNV-1a. O(n).
std::string mesh_fingerprint(const TriangleMesh& mesh);

}  // namespace cagewright::host

#endif
