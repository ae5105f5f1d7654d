// SPDX-License-Identifier: BSD-3-Clause
// Points are homogeneous integers without a common divisor, so that equal points are equal numbers.
#include "core/enclose/exact_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/mesh/predicates.h"

namespace cagewright {
namespace {

namespace mp = boost::multiprecision;

constexpr double rounding = 1.0 / (1LL << 50);  // of a rounded coordinate, relative

// value = mantissa * 2^exponent.
struct Binary {
  std::int64_t mantissa = 0;
  int exponent = 0;
  explicit Binary(double value) {
    if (value == 0) return;
    mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    exponent -= 53;
    while (mantissa % 2 == 0) {
      mantissa /= 2;
      ++exponent;
    }
  }
};

int bits(const ExactInteger& value) { return value == 0 ? 0 : static_cast<int>(mp::msb(mp::abs(value))) + 1; }

double quotient(const ExactInteger& over, const ExactInteger& under, int unit) {
  if (over == 0) return 0;
  const int shift = std::max(0, 64 + bits(under) - bits(over));
  const ExactInteger whole = (mp::abs(over) << shift) / under;
  const double size = std::ldexp(whole.convert_to<double>(), unit - shift);
  return over < 0 ? -size : size;
}

std::size_t hash_of(const Vector3& place) {
  std::size_t hash = 0;
  for (const double x : place) hash = hash * 1000003 + std::hash<double>()(x == 0 ? 0.0 : x);
  return hash;
}

int sign_of(const ExactInteger& value) { return value.sign(); }

// Sign of det[b - a, c - a] of rounded coordinates where their error cannot change it, else 0.
int surely(const Vector3& a, const Vector3& b, const Vector3& c, Projection p) {
  const double bu = b[p.u] - a[p.u], bv = b[p.v] - a[p.v], cu = c[p.u] - a[p.u], cv = c[p.v] - a[p.v];
  const double left = bu * cv, right = bv * cu, determinant = left - right;
  const double error = rounding * std::max({a.cwiseAbs().maxCoeff(), b.cwiseAbs().maxCoeff(), c.cwiseAbs().maxCoeff()});
  const double sum = std::abs(bu) + std::abs(bv) + std::abs(cu) + std::abs(cv);
  const double bound = 4 * error * sum + 16 * error * error + rounding * (std::abs(left) + std::abs(right));
  constexpr double least = 1e-250;  // nothing has underflown
  if (!(std::abs(determinant) > bound) || std::abs(determinant) < least) return 0;
  return determinant > 0 ? 1 : -1;
}

}  // namespace

ExactInteger determinant(const Homogeneous& a, const Homogeneous& b, const Homogeneous& c, Projection p) {
  const auto u = static_cast<std::size_t>(p.u), v = static_cast<std::size_t>(p.v);
  return a[u] * (b[v] * c[3] - b[3] * c[v]) - a[v] * (b[u] * c[3] - b[3] * c[u]) + a[3] * (b[u] * c[v] - b[v] * c[u]);
}

ExactPoints::ExactPoints(const Points& given) {
  unit_ = std::numeric_limits<int>::max();
  for (const double x : given.reshaped())
    if (x != 0) unit_ = std::min(unit_, Binary(x).exponent);
  if (unit_ == std::numeric_limits<int>::max()) unit_ = 0;
  for (Eigen::Index row = 0; row < given.rows(); ++row) {
    Homogeneous point;
    for (int axis = 0; axis < 3; ++axis) {
      const Binary x(given(row, axis));
      point[static_cast<std::size_t>(axis)] = x.mantissa;
      if (x.mantissa != 0) point[static_cast<std::size_t>(axis)] <<= x.exponent - unit_;
    }
    point[3] = 1;
    of_row_.push_back(number_of(point, given.row(row)));
  }
  given_count_ = count();
}

int ExactPoints::number_of(const Homogeneous& point, const Vector3& rounded) {
  const std::size_t hash = hash_of(rounded);
  const auto [begin, end] = by_place_.equal_range(hash);
  for (auto it = begin; it != end; ++it)
    if (exact(it->second) == point) return it->second;
  by_place_.emplace(hash, count());
  exact_.push_back(point);
  rounded_.push_back(rounded);
  return count() - 1;
}

int ExactPoints::add(Homogeneous point) {
  ExactInteger divisor = mp::gcd(point[3], point[0]);
  for (const std::size_t axis : {1, 2}) divisor = mp::gcd(divisor, point[axis]);
  if (point[3] < 0) divisor = -divisor;
  if (divisor != 1)
    for (ExactInteger& x : point) x /= divisor;
  Vector3 rounded;
  for (std::size_t axis = 0; axis < 3; ++axis)
    rounded[static_cast<Eigen::Index>(axis)] = quotient(point[axis], point[3], unit_);
  return number_of(point, rounded);
}

int ExactPoints::meet_plane(int p, int q, const std::array<int, 3>& plane) {
  const Homogeneous &a = exact(plane[0]), &b = exact(plane[1]), &c = exact(plane[2]);  // given: w = 1
  const std::array<ExactInteger, 3> ab = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
  const std::array<ExactInteger, 3> ac = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
  const std::array<ExactInteger, 3> n = {ab[1] * ac[2] - ab[2] * ac[1], ab[2] * ac[0] - ab[0] * ac[2],
                                         ab[0] * ac[1] - ab[1] * ac[0]};
  const auto height = [&](const Homogeneous& x) -> ExactInteger {
    return n[0] * (x[0] - a[0] * x[3]) + n[1] * (x[1] - a[1] * x[3]) + n[2] * (x[2] - a[2] * x[3]);
  };
  const ExactInteger of_p = height(exact(p)), of_q = height(exact(q));
  Homogeneous point;
  for (std::size_t i = 0; i < 4; ++i) point[i] = of_p * exact(q)[i] - of_q * exact(p)[i];
  return add(std::move(point));
}

int ExactPoints::meet_line(int a, int b, int c, int d, Projection plane) {
  const ExactInteger of_a = determinant(exact(c), exact(d), exact(a), plane);
  const ExactInteger of_b = determinant(exact(c), exact(d), exact(b), plane);
  Homogeneous point;
  for (std::size_t i = 0; i < 4; ++i) point[i] = of_a * exact(b)[i] - of_b * exact(a)[i];
  return add(std::move(point));
}

Homogeneous ExactPoints::mean(const std::array<int, 3>& corners, const std::array<int, 3>& weights) const {
  Homogeneous point = {0, 0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) point[axis] += weights[i] * exact(corners[i])[axis];
    point[3] += weights[i] * exact(corners[i])[3];
  }
  return point;
}

int ExactPoints::orientation(int a, int b, int c, Projection p) const {
  if (a == b || b == c || a == c) return 0;
  const Vector3 &ra = rounded(a), &rb = rounded(b), &rc = rounded(c);
  if (std::max({a, b, c}) < given_count_) return orient2d({ra[p.u], ra[p.v]}, {rb[p.u], rb[p.v]}, {rc[p.u], rc[p.v]});
  if (const int sign = surely(ra, rb, rc, p); sign != 0) return sign;
  return sign_of(determinant(exact(a), exact(b), exact(c), p));
}

int ExactPoints::orientation(int a, int b, const Homogeneous& c, Projection p) const {
  return sign_of(determinant(exact(a), exact(b), c, p));
}

int ExactPoints::compare(int a, int b, int axis) const {
  const double x = rounded(a)[axis], y = rounded(b)[axis];
  if (std::max(a, b) < given_count_) return (x > y) - (x < y);
  if (std::abs(x - y) > 4 * rounding * (std::abs(x) + std::abs(y))) return x > y ? 1 : -1;
  const auto i = static_cast<std::size_t>(axis);
  return sign_of(exact(a)[i] * exact(b)[3] - exact(b)[i] * exact(a)[3]);
}

bool ExactPoints::is_between(int p, int a, int b) const {
  for (int axis = 0; axis < 3; ++axis) {
    const int side = compare(a, b, axis);
    if (side == 0) continue;
    return compare(a, p, axis) == side && compare(p, b, axis) == side;
  }
  return false;
}

}  // namespace cagewright
