// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "core/enclose/exact_points.h"
#include "core/enclose/face_triangulation.h"

namespace cagewright {

// The triangles of a mesh, cut wherever they meet each other, exactly. Two faces then meet in common points and edges
// only, or, where triangles overlap in a plane, in regions that are bounded by the same edges.
struct Arrangement {
  struct Face {
    std::array<int, 3> points = {};           // numbers in `points`, counter-clockwise as the source runs
    std::array<int, 3> neighbours = {};       // the source's face across edge i (point i to the next), or -1
    std::array<bool, 3> is_constrained = {};  // something else meets the source in edge i, or it is the source's border
    int source = 0;                           // triangle of the mesh
  };

  explicit Arrangement(const IndexedMesh& mesh) : points(mesh.points) {}

  ExactPoints points;
  std::vector<std::array<int, 3>> corners;  // of each source, as points; three equal ones: a triangle without area
  std::vector<Projection> planes;           // of each source
  std::vector<Face> faces;                  // by source
  std::vector<int> first_face;              // source s has faces first_face[s] up to first_face[s + 1]
};

// Precondition: finite points, indices in range. Triangles without area are left out. Throws Error(internal).
// O(pairs that meet + sum over triangles of (what meets it)^2).
Arrangement arrange(const IndexedMesh& mesh);

}  // namespace cagewright
