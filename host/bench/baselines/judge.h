// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>

#include "host/bench/baselines/surface.h"

namespace cagewright::bench {

// Tells of cages whether they enclose a model, with CGAL's exact predicates: for the searches of the baselines, which
// try many. The figures of the table come from `cagewright check`.
class Judge {
 public:
  // Keeps the model by reference. Its triangles should be closed; where they are not, its volume is that of what they
  // are.
  explicit Judge(const Surface& model);

  // Whether the cage is closed, bounds a volume, does not meet itself, and has all of the model strictly inside.
  bool encloses(const Surface& cage) const;

  // The cage's volume over the model's.
  double volume_ratio(const Surface& cage) const;

  const Surface& model() const { return model_; }
  double diagonal() const { return diagonal_; }

  // Whether the box meets the model's surface.
  bool meets_surface(const Kernel::Iso_cuboid_3& box) const { return tree_.do_intersect(box); }

 private:
  using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Surface>>>;

  const Surface& model_;
  Tree tree_;
  double diagonal_;
  double volume_;
};

}  // namespace cagewright::bench
