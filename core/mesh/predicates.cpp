// SPDX-License-Identifier: BSD-3-Clause
// The filter is the first stage of Shewchuk, Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric
// Predicates, 1997 (error bounds A: 3 eps + 16 eps^2 and 7 eps + 56 eps^2, eps = 2^-53). What it cannot decide goes
// straight to integers: every double is an integer times a power of two, and the signs are homogeneous.
#include "core/mesh/predicates.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

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
namespace {

namespace mp = boost::multiprecision;
using WideInteger = mp::number<mp::cpp_int_backend<512, 512, mp::signed_magnitude, mp::unchecked, void>>;

constexpr double eps = std::numeric_limits<double>::epsilon() / 2;
constexpr double bound2 = 4 * eps, bound3 = 8 * eps;  // Shewchuk's, with an eps to spare

// Shewchuk's bounds hold where nothing under- or overflows. With differences up to `most` no product overflows and
// underflow loses less than 1e-220; with a permanent of at least `least` that is less than the eps to spare above.
constexpr double most = 1e100, least = 1e-200;

int sign_of(double value) { return (value > 0) - (value < 0); }

// The coordinates as integers, all times the same power of two.
template <int count>
struct Scaled {
  std::array<std::int64_t, count> mantissa{};
  std::array<int, count> shift{};
  int widest_shift = 0;

  explicit Scaled(const std::array<double, count>& values) {
    int lowest = std::numeric_limits<int>::max();
    for (int i = 0; i < count; ++i) {
      if (values[i] == 0) continue;
      mantissa[i] = static_cast<std::int64_t>(std::ldexp(std::frexp(values[i], &shift[i]), 53));
      lowest = std::min(lowest, shift[i]);
    }
    for (int i = 0; i < count; ++i) {
      shift[i] = mantissa[i] == 0 ? 0 : shift[i] - lowest;
      widest_shift = std::max(widest_shift, shift[i]);
    }
  }

  template <class Integer>
  Integer get(int i) const {
    return Integer(mantissa[i]) << shift[i];
  }
};

template <class Integer>
int exact_orient2d(const Scaled<6>& s) {
  const auto difference = [&](int point, int axis) {
    return Integer(s.get<Integer>(2 * point + axis) - s.get<Integer>(axis));
  };
  const Integer left = difference(1, 0) * difference(2, 1);
  const Integer right = difference(1, 1) * difference(2, 0);
  return left.compare(right) > 0 ? 1 : left.compare(right) < 0 ? -1 : 0;
}

template <class Integer>
int exact_orient3d(const Scaled<12>& s) {
  std::array<Integer, 3> b, c, d;
  for (int axis = 0; axis < 3; ++axis) {
    const Integer a = s.get<Integer>(axis);
    b[axis] = s.get<Integer>(3 + axis) - a;
    c[axis] = s.get<Integer>(6 + axis) - a;
    d[axis] = s.get<Integer>(9 + axis) - a;
  }
  const Integer x = b[1] * c[2] - b[2] * c[1];
  const Integer y = b[2] * c[0] - b[0] * c[2];
  const Integer z = b[0] * c[1] - b[1] * c[0];
  const Integer determinant = x * d[0] + y * d[1] + z * d[2];
  return determinant.sign();
}

// A coordinate has at most 53 + shift bits, a difference one more; six products of three of them take 3 more.
constexpr int widest_shift3 = (511 - 3) / 3 - 54;
constexpr int widest_shift2 = (511 - 1) / 2 - 54;

}  // namespace

int orient2d(const Vector2& a, const Vector2& b, const Vector2& c) {
  const Vector2 ab = b - a, ac = c - a;
  const double left = ab.x() * ac.y(), right = ab.y() * ac.x();
  const double determinant = left - right;
  const double permanent = std::abs(left) + std::abs(right);
  const double reach = std::max(ab.cwiseAbs().maxCoeff(), ac.cwiseAbs().maxCoeff());
  if (reach <= most && permanent >= least && std::abs(determinant) > bound2 * permanent) return sign_of(determinant);

  // Differences of doubles are zero only where they are equal; axis-parallel input is common enough to be quick.
  if (ab.isZero(0) || ac.isZero(0) || (ab.x() == 0 && ac.x() == 0) || (ab.y() == 0 && ac.y() == 0)) return 0;
  const Scaled<6> scaled({a.x(), a.y(), b.x(), b.y(), c.x(), c.y()});
  return scaled.widest_shift <= widest_shift2 ? exact_orient2d<WideInteger>(scaled)
                                              : exact_orient2d<mp::cpp_int>(scaled);
}

int orient3d(const Vector3& a, const Vector3& b, const Vector3& c, const Vector3& d) {
  const Vector3 ab = b - a, ac = c - a, ad = d - a;
  const double x1 = ab.y() * ac.z(), x2 = ab.z() * ac.y();
  const double y1 = ab.z() * ac.x(), y2 = ab.x() * ac.z();
  const double z1 = ab.x() * ac.y(), z2 = ab.y() * ac.x();
  const double determinant = (x1 - x2) * ad.x() + (y1 - y2) * ad.y() + (z1 - z2) * ad.z();
  const double permanent = (std::abs(x1) + std::abs(x2)) * std::abs(ad.x()) +
                           (std::abs(y1) + std::abs(y2)) * std::abs(ad.y()) +
                           (std::abs(z1) + std::abs(z2)) * std::abs(ad.z());
  const double reach = std::max({ab.cwiseAbs().maxCoeff(), ac.cwiseAbs().maxCoeff(), ad.cwiseAbs().maxCoeff()});
  if (reach <= most && permanent >= least && std::abs(determinant) > bound3 * permanent) return sign_of(determinant);

  // Differences of doubles are zero only where they are equal; axis-parallel input is common enough to be quick.
  if (ab.isZero(0) || ac.isZero(0) || ad.isZero(0)) return 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (ab[axis] == 0 && ac[axis] == 0 && ad[axis] == 0) return 0;
  }
  const Scaled<12> scaled({a.x(), a.y(), a.z(), b.x(), b.y(), b.z(), c.x(), c.y(), c.z(), d.x(), d.y(), d.z()});
  return scaled.widest_shift <= widest_shift3 ? exact_orient3d<WideInteger>(scaled)
                                              : exact_orient3d<mp::cpp_int>(scaled);
}

}  // namespace cagewright
