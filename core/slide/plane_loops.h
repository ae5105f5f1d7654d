// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "core/mesh/edge_blocks.h"
#include "core/mesh/half_edge_mesh.h"
#include "core/slide/slide.h"

namespace cagewright {

// A closed curve in which a plane meets a closed mesh. Vertices on the plane count as being ahead of it, so that every
// crossed edge has one end strictly behind and the curves never branch.
struct PlaneLoop {
  std::vector<OpenMesh::HalfedgeHandle> crossed;  // from behind to ahead, in order round the loop
  Points points;                                  // n x 3: where they cross, row = crossed edge
};

// All loops of the plane through `point` with normal `normal` (any length > 0), in an order that only the mesh's edges
// fix. `blocks` are those of the mesh. O(n / 16), and what is near the plane.
std::vector<PlaneLoop> plane_loops(const HalfEdgeMesh& mesh, const EdgeBlocks& blocks, const Vector3& point,
                                   const Vector3& normal);

// How often the loop goes round `center` in the plane with `normal`: 0 where it does not enclose it. Exact on the
// projected coordinates. O(n).
int winding_number(const Points& loop, const Vector3& center, const Vector3& normal);

// Finds the ellipse of `slide` on the model and the loop that it cuts: the innermost one round the centre.
// A point-and-normal slide takes the loop round its point, else the nearest one; a point alone that of with_plane.
// Throws Error: those of fit_ellipse.h and across_limb.h, slide_misses_model, slide_not_enclosed. `index` is the
// slide's, for the error. `blocks` and the cost: as for plane_loops; of a point alone O(n).
struct SlideOnModel {
  Ellipse ellipse;
  PlaneLoop loop;
  bool hollow = false;  // within the loop the model has an inside wall round the centre, as a pipe has
};
SlideOnModel place_slide(const HalfEdgeMesh& mesh, const EdgeBlocks& blocks, const Slide& slide, std::size_t index);

// A slide that is a point alone with the plane that across_limb.h finds for it; any other slide as it is. Where `mesh`
// is to be cut, this comes first: the plane must not depend on the cuts of other slides. Throws as place_slide. O(n).
Slide with_plane(const HalfEdgeMesh& mesh, const Slide& slide, std::size_t index);

}  // namespace cagewright
