// SPDX-License-Identifier: BSD-3-Clause
#include "host/scene/slide_transform.h"

#include <Eigen/SVD>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "host/file/gltf_nodes.h"

namespace cagewright::host {
namespace {

constexpr double perpendicular = 1e-9;  // cosine

Eigen::Affine3d from_columns(const Eigen::Vector3d& x, const Eigen::Vector3d& y, const Eigen::Vector3d& z,
                             const Eigen::Vector3d& center) {
  Eigen::Affine3d transform = Eigen::Affine3d::Identity();
  transform.linear() << x, y, z;
  transform.translation() = center;
  return transform;
}

// Decimal, so that a radius of 0.35 stays 0.35.
double rounded_to(int digits, double value) {
  std::array<char, 40> text{};
  const auto end =
      std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::scientific, digits - 1);
  std::from_chars(text.data(), end.ptr, value);
  return value;
}

// Coarser than what is lost by turning and measuring, so that rounding again changes nothing, or only once more:
// numbers of a rotation are read as if they were of length 1.
std::optional<StoredEllipse> rounded(const Slide::Ellipse& ellipse) {
  constexpr int digits = 14;
  constexpr double turn = 1e14;  // of one part in it
  auto numbers = decompose(slide_transform(ellipse));
  if (!numbers) return {};
  for (std::size_t i = 3; i < 7; ++i) (*numbers)[i] = std::round((*numbers)[i] * turn) / turn;
  for (std::size_t i = 7; i < 10; ++i) (*numbers)[i] = rounded_to(digits, (*numbers)[i]);
  return StoredEllipse{*numbers, transformed_circle(compose(*numbers))};
}

}  // namespace

Eigen::Affine3d slide_transform(const Slide::Ellipse& ellipse) {
  const Eigen::Vector3d center = Eigen::Vector3d::Map(ellipse.center.data());
  Eigen::Vector3d u = Eigen::Vector3d::Map(ellipse.u.data()), v = Eigen::Vector3d::Map(ellipse.v.data());
  const Eigen::Vector3d normal = u.cross(v).stableNormalized();
  if (std::abs(u.dot(v)) > perpendicular * u.norm() * v.norm()) {
    Eigen::Matrix<double, 3, 2> radii;
    radii << u, v;
    const Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>> svd(radii, Eigen::ComputeFullU);
    const Eigen::Vector3d axis = svd.matrixU().col(0);
    v = svd.singularValues()(1) * normal.cross(axis) * (axis.dot(u) < 0 ? -1 : 1);
    u = svd.singularValues()(0) * axis * (axis.dot(u) < 0 ? -1 : 1);
  }
  return from_columns(u, v, (u.norm() + v.norm()) / 2 * normal, center);
}

Slide::Ellipse transformed_circle(const Eigen::Affine3d& transform) {
  const auto column = [&](const Eigen::Vector3d& values) -> Point3 { return {values.x(), values.y(), values.z()}; };
  return {column(transform.translation()), column(transform.linear().col(0)), column(transform.linear().col(1))};
}

std::optional<TranslationRotationScale> decompose(const Eigen::Affine3d& transform) {
  const Eigen::Matrix3d m = transform.linear();
  const Eigen::Vector3d lengths(m.col(0).stableNorm(), m.col(1).stableNorm(), m.col(2).stableNorm());
  if (!(lengths.minCoeff() > 0) || !lengths.allFinite()) return {};
  Eigen::Matrix3d axes;
  for (int i = 0; i < 3; ++i) axes.col(i) = m.col(i) / lengths(i);
  const double worst = std::max({std::abs(axes.col(0).dot(axes.col(1))), std::abs(axes.col(1).dot(axes.col(2))),
                                 std::abs(axes.col(2).dot(axes.col(0)))});
  if (worst > perpendicular) return {};
  const double mirrored = axes.determinant() < 0 ? -1 : 1;
  axes.col(2) *= mirrored;
  const Eigen::Quaterniond rotation = Eigen::Quaterniond(axes).normalized();
  const Eigen::Vector3d center = transform.translation();
  return TranslationRotationScale{center.x(),   center.y(),   center.z(), rotation.x(), rotation.y(),
                                  rotation.z(), rotation.w(), lengths(0), lengths(1),   mirrored * lengths(2)};
}

Eigen::Affine3d compose(const TranslationRotationScale& numbers) {
  const auto from = numbers.begin();
  return gltf_transform({from, from + 3}, {from + 3, from + 7}, {from + 7, from + 10});
}

std::optional<StoredEllipse> as_stored(const Slide::Ellipse& ellipse) {
  constexpr int enough = 8;  // times; twice has been all
  std::optional<StoredEllipse> stored = rounded(ellipse);
  for (int i = 0; stored && i < enough; ++i) {
    const std::optional<StoredEllipse> again = rounded(stored->ellipse);
    if (!again || again->ellipse == stored->ellipse) break;
    stored = again;
  }
  return stored;
}

}  // namespace cagewright::host
