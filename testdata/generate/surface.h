// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "testdata/generate/field.h"
#include "testdata/generate/triangle_mesh.h"

namespace cagewright::testdata {

// Meshes the zero surface of the field: flying edges on a regular grid of `resolution` cells along the longest side of
// the field's bounds, the largest component of that, then even triangles with vertices on the surface to 1e-9. The
// number of triangles grows with the square of the resolution. Triangles face outward. Deterministic.
// Needs 4 bytes of memory for each grid point. Throws std::invalid_argument where resolution < 8.
TriangleMesh mesh_surface(const Field& field, int resolution);

}  // namespace cagewright::testdata
