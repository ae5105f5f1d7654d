// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/enclose/box_tree.h"
#include "core/enclose/triangle_intersection.h"
#include "core/meshing/meshing.h"

namespace cagewright {

// A cage whose vertices are moved one at a time, and what its triangles run into: the model's triangles and each other.
// The tests are those of the certificate; with a clearance, being nearer than that counts too (in floating point).
// A triangle's own model is that of its part, and near a slide also that of the part beyond: it has to bound those, and
// only to keep clear of the rest. Borrows all that it is made of but the points. One thread at a time.
class MovableCage {
 public:
  // `clearance` >= 0, model units. The model is segmentation.cut, the cut model. O(n log n).
  MovableCage(const Segmentation& segmentation, const Cage& cage, double clearance);

  const Points& points() const { return mesh_.points; }
  Vector3 point(int vertex) const { return mesh_.points.row(vertex); }
  const std::vector<int>& triangles_at(int vertex) const { return incident_[static_cast<std::size_t>(vertex)]; }
  int triangle_count() const { return static_cast<int>(mesh_.triangles.rows()); }
  Triangle3 triangle(int t) const;
  Vector3 normal(int t) const;  // unit, outward
  double volume() const;
  // Of the volume by a vertex's position. O(triangles at it).
  Vector3 volume_gradient(int vertex) const;

  void place(int vertex, const Vector3& point);
  void place_all(const Points& points);

  // Calls `visit` with the model triangles (rows of the cut model) that triangle t runs into, until it returns true.
  enum class Whose { own, others, any };
  void visit_hits(int t, Whose whose, const std::function<bool(const Triangle3& hit)>& visit) const;
  bool hits_model(int t, Whose whose) const;
  long count_model_hits(int t, Whose whose) const;
  long count_cage_hits(int t) const;  // other cage triangles
  bool hits_cage(int t) const;

 private:
  void find_parts_beyond();
  bool runs_into(const Triangle3& model_triangle, const Triangle3& cage_triangle) const;
  bool is_asked(int t, int model_triangle, Whose whose) const;

  const Segmentation& segmentation_;
  const Cage& cage_;
  double clearance_;
  BoxTree tree_;
  IndexedMesh mesh_;
  std::vector<Box3> boxes_;                 // of the cage's triangles
  std::vector<std::vector<int>> incident_;  // triangles at each vertex
  std::vector<int> part_beyond_;            // of each model triangle near a slide: the part on its other side, else -1
  mutable std::vector<int> last_hit_;       // of each cage triangle: most often the next one too, or -1
};

}  // namespace cagewright
