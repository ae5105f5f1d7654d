// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_MESH_PICKER_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_MESH_PICKER_H

#include <Eigen/Core>
#include <memory>
#include <optional>

#include "host/file/triangle_mesh.h"

namespace cagewright::host {

// Where a line meets a mesh first.
struct MeshHit {
  Eigen::Vector3d point, normal;  // unit, counter-clockwise; both in the mesh's space
  double distance = 0;            // from the line's origin, of the line's space
};

// Finds where lines meet a mesh. Builds its search structure at the first question. Keeps the mesh.
class MeshPicker {
 public:
  explicit MeshPicker(std::shared_ptr<const TriangleMesh> mesh);
  ~MeshPicker();
  MeshPicker(MeshPicker&&) noexcept;
  MeshPicker& operator=(MeshPicker&&) noexcept;

  // Origin and unit direction in the mesh's space. O(log n).
  std::optional<MeshHit> first_hit(const Eigen::Vector3d& origin, const Eigen::Vector3d& direction) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace cagewright::host

#endif
