// SPDX-License-Identifier: BSD-3-Clause
#include "host/bench/baselines/simplify.h"

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/GarlandHeckbert_plane_policies.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

namespace cagewright::bench {

namespace simplification = CGAL::Surface_mesh_simplification;

Surface simplified(Surface surface, std::size_t triangles, Collapse collapse) {
  // A closed triangle mesh has three edges to two triangles; the predicate stops below its number.
  const simplification::Count_stop_predicate<Surface> stop(triangles / 2 * 3 + 1);
  if (collapse == Collapse::lindstrom_turk) {
    simplification::edge_collapse(surface, stop,
                                  CGAL::parameters::get_cost(simplification::LindstromTurk_cost<Surface>())
                                      .get_placement(simplification::LindstromTurk_placement<Surface>()));
  } else {
    const simplification::GarlandHeckbert_plane_policies<Surface, Kernel> quadrics(surface);
    simplification::edge_collapse(
        surface, stop, CGAL::parameters::get_cost(quadrics.get_cost()).get_placement(quadrics.get_placement()));
  }
  surface.collect_garbage();
  return surface;
}

}  // namespace cagewright::bench
