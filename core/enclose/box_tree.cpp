// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/box_tree.h"

#include <numeric>
#include <unsupported/Eigen/BVH>

namespace cagewright {

struct BoxTree::Tree {
  Eigen::KdBVH<double, 3, int> boxes;
  std::vector<Box3> own;  // of each triangle: the tree's leaves hold two triangles in one box
};

namespace {

struct Query {
  const Box3& box;
  const std::vector<Box3>& boxes;
  const std::function<bool(int)>& visit;
  bool intersectVolume(const Box3& volume) const { return volume.intersects(box); }
  bool intersectObject(int triangle) const {
    return boxes[static_cast<std::size_t>(triangle)].intersects(box) && visit(triangle);
  }
};

}  // namespace

Box3 box_of_triangle(const IndexedMesh& mesh, Eigen::Index triangle) {
  Box3 box;
  for (int i = 0; i < 3; ++i) box.extend(Vector3(mesh.points.row(mesh.triangles(triangle, i))));
  return box;
}

BoxTree::BoxTree(const IndexedMesh& mesh) : tree_(std::make_unique<Tree>()) {
  std::vector<int> triangles(static_cast<std::size_t>(mesh.triangles.rows()));
  std::iota(triangles.begin(), triangles.end(), 0);
  tree_->own.reserve(triangles.size());
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) tree_->own.push_back(box_of_triangle(mesh, t));
  tree_->boxes.init(triangles.begin(), triangles.end(), tree_->own.begin(), tree_->own.end());
}

BoxTree::~BoxTree() = default;
BoxTree::BoxTree(BoxTree&&) noexcept = default;
BoxTree& BoxTree::operator=(BoxTree&&) noexcept = default;

void BoxTree::visit(const Box3& box, const std::function<bool(int triangle)>& visit) const {
  if (tree_->own.empty()) return;
  Query query{box, tree_->own, visit};
  Eigen::BVIntersect(tree_->boxes, query);
}

}  // namespace cagewright
