// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_TESTS_WORKSPACE_ELLIPSOID_H
#define CAGEWRIGHT_HOST_TESTS_WORKSPACE_ELLIPSOID_H

#include <cstdint>

#include "host/file/triangle_mesh.h"

namespace cagewright::host::test {

// Closed; half axes 0.5, 2 and 0.4 along x, y and z; 2 columns (rows - 1) triangles.
TriangleMesh ellipsoid(std::uint32_t rows, std::uint32_t columns);

}  // namespace cagewright::host::test

#endif
