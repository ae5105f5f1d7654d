// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "core/enclose/box_tree.h"
#include "core/enclose/triangle_intersection.h"
#include "core/meshing/meshing.h"

namespace cagewright {

// A cage whose vertices move, and what its triangles run into: the model's triangles and each other. The tests are
// those of the certificate; with a clearance, being nearer than that counts too (in floating point). A triangle's own
// model is that of its part, and near a slide also that of the part beyond: it has to bound those, and only to keep
// clear of the rest. Borrows all that it is made of but the points. Questions about different triangles may be asked by
// several threads at once, moves not: of each triangle the model near it is remembered.
class MovableCage {
 public:
  // The model is segmentation.cut, the cut model. O(n log n).
  MovableCage(const Segmentation& segmentation, const Cage& cage, double diagonal);

  const IndexedMesh& mesh() const { return mesh_; }
  const IndexedMesh& model() const { return segmentation_.cut; }
  const BoxTree& model_tree() const { return tree_; }
  const Cage& cage() const { return cage_; }
  const Segmentation& segmentation() const { return segmentation_; }

  const Points& points() const { return mesh_.points; }
  Vector3 point(int vertex) const { return mesh_.points.row(vertex); }
  int vertex_count() const { return static_cast<int>(mesh_.points.rows()); }
  int vertex_of(int t, int corner) const { return mesh_.triangles(t, corner); }
  const std::vector<int>& triangles_at(int vertex) const { return incident_[static_cast<std::size_t>(vertex)]; }
  int triangle_count() const { return static_cast<int>(mesh_.triangles.rows()); }
  Triangle3 triangle(int t) const { return triangle_of(mesh_, t); }
  const Box3& box(int t) const { return boxes_[static_cast<std::size_t>(t)]; }
  Vector3 normal(int t) const;  // unit, outward
  double volume() const;
  // Of the volume by a vertex's position. O(triangles at it).
  Vector3 volume_gradient(int vertex) const;

  void place(int vertex, const Vector3& point);
  void place_all(const Points& points);

  // Calls `visit` with all model triangles (rows of the cut model) within `distance` (>= 0) of triangle t, and few
  // others, until it returns true.
  void visit_near(int t, double distance, const std::function<bool(int model_triangle)>& visit) const;
  // The same with the model triangles that triangle t meets or is nearer to than
  // `clearance` (>= 0, model units), until it returns true.
  enum class Whose { own, others, any, nobody };
  void visit_hits(int t, Whose whose, double clearance, const std::function<bool(int model_triangle)>& visit) const;
  // One of them, or -1.
  int hit_of_model(int t, Whose whose, double clearance) const;
  bool hits_model(int t, Whose whose, double clearance) const { return hit_of_model(t, whose, clearance) >= 0; }
  bool is_own(int t, int model_triangle) const;
  // The same without what is beyond slides.
  bool is_of_part(int t, int model_triangle) const {
    return segmentation_.triangle_part[static_cast<std::size_t>(model_triangle)] ==
           cage_.triangle_part[static_cast<std::size_t>(t)];
  }
  // The parts on the other sides of the slides that a model triangle is near.
  std::span<const int> parts_beyond(int model_triangle) const;

  // Calls `visit` with the other cage triangles that triangle t meets, or, where they share no vertex, is nearer to
  // than `gap` (> 0: their rounding to floats does not matter), until it returns true.
  void visit_cage_hits(int t, double gap, const std::function<bool(int other)>& visit) const;
  int hit_of_cage(int t, double gap) const;
  bool hits_cage(int t, double gap) const { return hit_of_cage(t, gap) >= 0; }

 private:
  // Round a model triangle, in single precision, rounded up.
  struct Ball {
    Eigen::Vector3f center;
    float radius;
    int triangle;
    float height = 0;  // in a neighbourhood: over the plane of the cage triangle as it was
  };
  struct Neighbourhood {
    Triangle3 at;       // where the cage triangle was
    double reach = -1;  // how far it was looked round
    double moved = 0;   // since then, at most, by any of its points
    bool has_plane = false;
    std::vector<Ball> balls;  // where there is a plane, by their highest points, falling
  };
  void find_balls();
  const Neighbourhood& neighbourhood(int t, double distance) const;
  void look_round(int t, double reach) const;
  void find_parts_beyond();
  bool is_asked(int t, int model_triangle, Whose whose) const;
  bool are_in_the_way(int t, int other, double gap) const;

  const Segmentation& segmentation_;
  const Cage& cage_;
  BoxTree tree_;
  IndexedMesh mesh_;
  std::vector<Box3> boxes_;                            // of the cage's triangles
  std::vector<std::vector<int>> incident_;             // triangles at each vertex
  double looked_beyond_;                               // how much farther than asked a neighbourhood is looked round
  std::vector<Ball> balls_;                            // round each model triangle
  mutable std::vector<Neighbourhood> neighbourhoods_;  // of each cage triangle
  std::vector<int> parts_beyond_, first_beyond_;       // model triangle k: parts_beyond_[first_beyond_[k]] and on
  mutable std::vector<int> last_hit_;                  // of each cage triangle: most often the next one too, or -1
};

}  // namespace cagewright
