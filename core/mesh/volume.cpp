// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/volume.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace cagewright {
namespace {

// Neumaier's summation: a thin model's volume is a small difference of large terms.
class Sum {
 public:
  void add(double term) {
    const double next = sum_ + term;
    lost_ += std::abs(sum_) >= std::abs(term) ? (sum_ - next) + term : (term - next) + sum_;
    sum_ = next;
  }
  double value() const { return sum_ + lost_; }

 private:
  double sum_ = 0, lost_ = 0;
};

}  // namespace

Volumes find_volumes(const IndexedMesh& mesh, const Labels& components) {
  // Halved before they are subtracted: the box of a model may be longer than the greatest double.
  const Vector3 half_min = 0.5 * mesh.points.colwise().minCoeff().transpose();
  const Vector3 half_max = 0.5 * mesh.points.colwise().maxCoeff().transpose();
  const Vector3 center = half_min + half_max;
  Volumes volumes;
  volumes.unit = (half_max - half_min).maxCoeff();
  volumes.of.assign(static_cast<std::size_t>(components.count), 0);
  if (volumes.unit == 0) return volumes;

  const auto corner = [&](Eigen::Index t, int i) -> Vector3 {
    return (mesh.points.row(mesh.triangles(t, i)).transpose() - center) / volumes.unit;
  };
  std::vector<Sum> sums(volumes.of.size());
  Sum total;
  double magnitude = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const Vector3 a = corner(t, 0), b = corner(t, 1), c = corner(t, 2);
    const Vector3 ab = b - a, ac = c - a;
    const double term = a.dot(ab.cross(ac)) / 6;
    sums[components.of[static_cast<std::size_t>(t)]].add(term);
    total.add(term);
    magnitude += a.norm() * ab.norm() * ac.norm();
  }
  for (std::size_t k = 0; k < sums.size(); ++k) volumes.of[k] = sums[k].value();
  volumes.total = total.value();
  volumes.rounding = 16 * std::numeric_limits<double>::epsilon() * magnitude;
  return volumes;
}

}  // namespace cagewright
