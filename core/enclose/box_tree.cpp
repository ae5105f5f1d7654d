// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/box_tree.h"

#include <cmath>
#include <numeric>
#include <unsupported/Eigen/BVH>

#include "core/enclose/triangle_distance.h"
#include "core/mesh/tolerance.h"

namespace cagewright {

struct BoxTree::Tree {
  Eigen::KdBVH<double, 3, int> boxes;
  std::vector<Box3> own;  // of each triangle: the tree's leaves hold two triangles in one box
  double size = 0;        // largest coordinate
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

// Boxes that the slab round the triangle's plane cuts. Rounding only ever lets too many through: `slack` is far above
// it, relative to the coordinates.
struct SlabQuery {
  const Box3& box;
  const Vector3& normal;
  double offset, half_width;
  const std::vector<Box3>& boxes;
  const std::function<bool(int)>& visit;
  bool meets(const Box3& other) const {
    if (!other.intersects(box)) return false;
    const Vector3 center = other.center(), half = other.sizes() / 2;
    return std::abs(normal.dot(center) - offset) <= half.dot(normal.cwiseAbs()) + half_width;
  }
  bool intersectVolume(const Box3& volume) const { return meets(volume); }
  bool intersectObject(int triangle) const {
    return meets(boxes[static_cast<std::size_t>(triangle)]) && visit(triangle);
  }
};

// Boxes that come near a thin triangle.
struct CapsuleQuery {
  const Box3& box;
  Capsule capsule;
  double distance;
  const std::vector<Box3>& boxes;
  const std::function<bool(int)>& visit;
  bool meets(const Box3& other) const {
    return other.intersects(box) && !capsule.parts_ball(other.center(), other.sizes().norm() / 2, distance);
  }
  bool intersectVolume(const Box3& volume) const { return meets(volume); }
  bool intersectObject(int triangle) const {
    return meets(boxes[static_cast<std::size_t>(triangle)]) && visit(triangle);
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
  if (mesh.points.rows() > 0) tree_->size = mesh.points.cwiseAbs().maxCoeff();
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

void BoxTree::visit_near(const Triangle3& t, double distance, const std::function<bool(int triangle)>& visit) const {
  if (tree_->own.empty()) return;
  const Vector3 normal = unit_normal(t);
  Box3 box(t[0]);
  box.extend(t[1]).extend(t[2]);
  const double size = std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff()) + distance;
  box.min().array() -= distance;
  box.max().array() += distance;
  if (is_thin(t, box)) {
    CapsuleQuery query{box, Capsule(t), distance, tree_->own, visit};
    Eigen::BVIntersect(tree_->boxes, query);
    return;
  }
  const double half_width = distance + tolerance::rounding * (size + tree_->size);
  SlabQuery query{box, normal, normal.dot(t[0]), half_width, tree_->own, visit};
  Eigen::BVIntersect(tree_->boxes, query);
}

}  // namespace cagewright
