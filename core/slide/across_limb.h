// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "core/mesh/half_edge_mesh.h"
#include "core/slide/slide.h"

namespace cagewright {

// The plane across the limb at a point of the surface, for a slide that a click makes (not in the paper).
//
// Planes through the point start, round the surface's (smoothed) normal and leaning to and from it, whose loops through
// the point are short. Each is turned about the point until the surface's normals round its loop lean along the plane's
// normal by as equal amounts as they can: on a cylinder or a cone, until it is perpendicular to the axis [the
// rotational symmetry axis of Tagliasacchi, Zhang & Cohen-Or 2009]. Of what they end as, the one with the shortest loop
// is taken; loops that are short since their plane comes near the tangent plane count as longer.
//
// The plane's point is the surface's nearest to the given one, moved a little into the model, so that the loop that a
// point-and-normal slide has there is that one. The unit normal points away from the middle of the model's surface.
// Turns, moves and scales with the model but for rounding. Where the model is as good as round about the point (a
// sphere), any plane through the point and the surface's normal may come.
// Precondition: the point is finite. Throws Error: slide_misses_model where the point is farther from the surface than
// tolerance::off_surface; slide_not_enclosed where no loop there runs round solid material: on an inside wall. `name`
// is for the sentences. O(n) once, then O(edges in a loop) for each of about 100 planes. Thread-safe.
PointNormalDefinition plane_across_limb(const HalfEdgeMesh& mesh, const PointDefinition& click,
                                        const std::string& name);

}  // namespace cagewright
