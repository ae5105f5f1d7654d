// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <vector>

#include "core/meshing/meshing.h"

namespace cagewright {

// The local scope of refinement at one position of the cage: through which cage triangle a part's vertex is seen from
// the part's projection centre. Immutable once made, so safe to share between threads.
class Cones {
 public:
  static constexpr int inside = -1;  // seen through a section and in front of it: no wall bounds the vertex

  // `points` are the cage's vertices where they are now, n x 3; `on_plane` (model units): a vertex that near to a
  // section lies on it. Keeps nothing of what is passed in. O(cage triangles).
  Cones(const Segmentation& segmentation, const Cage& topology, const Points& points, double on_plane);

  // Whether the ray from the part's centre to v passes through cage triangle t. O(1).
  bool sees(int part, int t, const Vector3& v) const;

  // The cage triangle through which `part` sees v, or `inside`. A vertex behind a section (which has moved in, or whose
  // plane goes on beyond it) is handed to the part on the section's other side; where that one does not bound it, or
  // the cage folds and no cone holds v, the nearest cone of `part` does. O(triangles of a part).
  int triangle_of(int part, const Vector3& v) const;

 private:
  struct Wall {
    int triangle;
    std::array<Vector3, 3> planes;  // through the centre and an edge; positive inside the cone
  };
  struct Opening {  // a section, as the part sees it
    int behind;     // the part on its other side
    std::array<Vector3, 4> planes;
    std::array<Vector3, 2> normals;  // of its two triangles, out of the part
    std::array<Vector3, 4> corners;  // counter-clockwise as seen from outside the part
  };
  struct Part {
    Vector3 center;
    std::vector<Wall> walls;
    std::vector<Opening> openings;
  };

  Opening opening_of(const PartSection& side, const std::array<int, 2>& slide_parts, const Vector3& center,
                     const Points& points) const;
  const Opening* opening_of(const Part& part, const Vector3& v) const;
  bool in_front(const Opening& opening, const Vector3& v) const;
  int wall_of(const Part& part, const Vector3& v) const;

  double on_plane_;
  std::vector<Part> parts_;
  std::vector<int> slot_;  // of each cage triangle: which wall of its part it is
};

}  // namespace cagewright
