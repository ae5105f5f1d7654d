// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/enclose/surface_tree.h"

namespace cagewright {

// A model made ready to measure cages against: made once, it serves any number of them. Lengths are in units of the
// diagonal of the model's bounding box. Immutable, so safe to share between threads; keeps nothing of the mesh given.
class MeasuredModel {
 public:
  // Precondition: finite points, indices in range, every vertex used, a volume (to_indexed_mesh of a Model). Threads: 0
  // for all; same bits for any number. O(n log n).
  explicit MeasuredModel(const IndexedMesh& model, unsigned threads = 0);

  const IndexedMesh& mesh() const { return mesh_; }  // moved and scaled: its box has the centre 0 and the diagonal 1
  const SurfaceTree& surface() const { return surface_; }
  double volume() const { return volume_; }  // enclosed by its triangles; > 0, whichever way they face
  double vertex_share(int vertex) const { return vertex_shares_[static_cast<std::size_t>(vertex)]; }  // of the area;
  // a third of the triangles round it: the sum over all vertices is 1
  const Vector3& centroid() const { return centroid_; }              // of the area
  const Eigen::Matrix3d& covariance() const { return covariance_; }  // of the area, round the centroid
  IndexedMesh to_units(const IndexedMesh& mesh) const;               // moves and scales as the model was
  Vector3 to_model(const Vector3& point) const { return diagonal_ * point + center_; }  // back to model units

 private:
  Vector3 center_;
  double diagonal_;
  IndexedMesh mesh_;
  SurfaceTree surface_;
  double volume_;
  std::vector<double> vertex_shares_;
  Vector3 centroid_;
  Eigen::Matrix3d covariance_;
};

// Signed volume of the triangles as they are: how often they wind round space, all in all. Closed or it means nothing.
double signed_volume(const IndexedMesh& mesh);

}  // namespace cagewright
