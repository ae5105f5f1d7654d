// SPDX-License-Identifier: BSD-3-Clause
#include "core/tests/slide_sets.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>

#include "core/error/error.h"
#include "core/segment/segment.h"

namespace cagewright {

SlideSets::SlideSets(const Model& model)
    : model_(model),
      mesh_(to_indexed_mesh(model.mesh)),
      normals_(mesh_.triangles.rows(), 3),
      centers_(mesh_.triangles.rows(), 3) {
  double area = 0;
  for (Eigen::Index t = 0; t < mesh_.triangles.rows(); ++t) {
    const Eigen::Matrix3d corners = mesh_.points(Eigen::Vector3i(mesh_.triangles.row(t)), Eigen::all);
    const Vector3 across = Vector3(corners.row(1) - corners.row(0)).cross(Vector3(corners.row(2) - corners.row(0)));
    normals_.row(t) = across.normalized().transpose();
    centers_.row(t) = corners.colwise().mean();
    areas_up_to_.push_back(area += across.norm() / 2);
  }
}

Vector3 SlideSets::point_on_surface(Random& random) const {
  const double at = random.uniform(0, areas_up_to_.back());
  const auto found = std::lower_bound(areas_up_to_.begin(), areas_up_to_.end() - 1, at);
  const Eigen::Vector3i corners = mesh_.triangles.row(found - areas_up_to_.begin());
  double u = random.uniform(0, 1), v = random.uniform(0, 1);
  if (u + v > 1) {
    u = 1 - u;
    v = 1 - v;
  }
  return mesh_.points(corners, Eigen::all).transpose() * Vector3(1 - u - v, u, v);
}

// The normals round a limb are across it.
Vector3 SlideSets::limb_direction(const Vector3& point, double radius) const {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (Eigen::Index t = 0; t < centers_.rows(); ++t) {
    if ((Vector3(centers_.row(t)) - point).squaredNorm() > radius * radius) continue;
    const auto i = static_cast<std::size_t>(t);
    const double area = areas_up_to_[i] - (i > 0 ? areas_up_to_[i - 1] : 0);
    spread += area * normals_.row(t).transpose() * normals_.row(t);
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(0);
}

Slide SlideSets::make_slide(const std::string& name, Random& random) const {
  const Vector3 point = point_on_surface(random);
  if (random.below(2) == 0) return {name, PointNormalDefinition{point, random.direction()}};
  const double sign = random.below(2) == 0 ? 1 : -1;
  return {name,
          PointNormalDefinition{point, sign * limb_direction(point, random.uniform(0.05, 0.12) * model_.diagonal)}};
}

std::vector<Slide> SlideSets::make_set(Random& random) const {
  const std::size_t wanted = 2 + static_cast<std::size_t>(random.below(14));
  std::vector<Slide> slides;
  for (std::size_t tries = 0; slides.size() < wanted && tries < 4 * wanted + 20; ++tries) {
    slides.push_back(make_slide(std::string("s").append(std::to_string(slides.size() + 1)), random));
    try {
      segment(model_, slides);
    } catch (const Error&) {
      slides.pop_back();
    }
  }
  return slides;
}

}  // namespace cagewright
