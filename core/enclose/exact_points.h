// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <unordered_map>
#include <vector>

#include "core/mesh/types.h"

// g++ 12 takes the unused half of a union in there for uninitialised input.
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/multiprecision/cpp_int.hpp>
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic pop
#endif

namespace cagewright {

// 512 bits without an allocation, which most numbers here do with.
using ExactInteger = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
    512, 0, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked,
    std::allocator<boost::multiprecision::limb_type>>>;
using Homogeneous = std::array<ExactInteger, 4>;  // x, y, z, w > 0; the point is (x, y, z) / w, in a common unit

// The two axes that are left of a plane's points, in the order in which its triangles run counter-clockwise.
struct Projection {
  int u = 0, v = 1;
};

// Points with rational coordinates, one number for each place. All answers are exact: what floating point with error
// bounds cannot decide is decided by integers.
class ExactPoints {
 public:
  // Rows of `given` are finite; equal ones get one number.
  explicit ExactPoints(const Points& given);

  int of_row(Eigen::Index row) const { return of_row_[static_cast<std::size_t>(row)]; }
  int count() const { return static_cast<int>(exact_.size()); }
  const Homogeneous& exact(int point) const { return exact_[static_cast<std::size_t>(point)]; }
  // The given coordinates, or the nearest doubles but for an ulp or two.
  const Vector3& rounded(int point) const { return rounded_[static_cast<std::size_t>(point)]; }

  // Where the segment pq meets the plane of three given points that do not lie on a line. Precondition: p and q are on
  // different sides of it.
  int meet_plane(int p, int q, const std::array<int, 3>& plane);
  // Where the lines ab and cd of one plane cross.
  int meet_line(int a, int b, int c, int d, Projection plane);
  // weights . corners over the sum of the (positive) weights; not to be counted among the points.
  Homogeneous mean(const std::array<int, 3>& corners, const std::array<int, 3>& weights) const;

  // 1 where abc runs counter-clockwise in the projection.
  int orientation(int a, int b, int c, Projection plane) const;
  int orientation(int a, int b, const Homogeneous& c, Projection plane) const;
  // Sign of a - b along an axis.
  int compare(int a, int b, int axis) const;
  // Whether p, on the line ab, lies between a and b and is neither.
  bool is_between(int p, int a, int b) const;

 private:
  int add(Homogeneous point);
  int number_of(const Homogeneous& point, const Vector3& rounded);

  std::vector<Homogeneous> exact_;
  std::vector<Vector3> rounded_;
  std::vector<int> of_row_;
  std::unordered_multimap<std::size_t, int> by_place_;
  int given_count_ = 0;
  int unit_ = 0;  // a power of two
};

// Of homogeneous points; rows u, v, w.
ExactInteger determinant(const Homogeneous& a, const Homogeneous& b, const Homogeneous& c, Projection plane);

}  // namespace cagewright
