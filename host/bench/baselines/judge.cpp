// SPDX-License-Identifier: BSD-3-Clause
#include "host/bench/baselines/judge.h"

#include <CGAL/Polygon_mesh_processing/connected_components.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>

#include <algorithm>
#include <cmath>

namespace cagewright::bench {
namespace {

namespace processing = CGAL::Polygon_mesh_processing;

// Of the triangles as they are, closed or not.
double signed_volume(const Surface& surface) {
  double six_volumes = 0;
  for (const auto face : surface.faces()) {
    const auto h = surface.halfedge(face);
    const auto a = surface.point(surface.source(h)) - CGAL::ORIGIN;
    const auto b = surface.point(surface.target(h)) - CGAL::ORIGIN;
    const auto c = surface.point(surface.target(surface.next(h))) - CGAL::ORIGIN;
    six_volumes += a * CGAL::cross_product(b, c);
  }
  return six_volumes / 6;
}

bool is_solid(const Surface& cage) {
  return !cage.is_empty() && CGAL::is_closed(cage) && !processing::does_self_intersect(cage) &&
         processing::does_bound_a_volume(cage);
}

}  // namespace

Judge::Judge(const Surface& model)
    : model_(model),
      tree_(faces(model).first, faces(model).second, model),
      diagonal_(diagonal_of(model)),
      volume_(std::abs(signed_volume(model))) {
  tree_.build();
}

bool Judge::encloses(const Surface& cage) const {
  const auto meets_model = [&](const auto face) {
    const auto h = cage.halfedge(face);
    return tree_.do_intersect(Kernel::Triangle_3(cage.point(cage.source(h)), cage.point(cage.target(h)),
                                                 cage.point(cage.target(cage.next(h)))));
  };
  if (std::any_of(cage.faces().begin(), cage.faces().end(), meets_model) || !is_solid(cage)) return false;
  // Where no triangles meet, one vertex of a piece tells for all of it; that every vertex is asked costs little.
  const CGAL::Side_of_triangle_mesh<Surface, Kernel> side(cage);
  return std::all_of(model_.vertices().begin(), model_.vertices().end(),
                     [&](const auto v) { return side(model_.point(v)) == CGAL::ON_BOUNDED_SIDE; });
}

double Judge::volume_ratio(const Surface& cage) const { return signed_volume(cage) / volume_; }

}  // namespace cagewright::bench
