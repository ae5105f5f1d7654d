// SPDX-License-Identifier: BSD-3-Clause
// The predicates against rationals, on input that floating point gets wrong.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include "core/mesh/predicates.h"

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#endif
#include <boost/multiprecision/cpp_int.hpp>

namespace cagewright {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Tetrahedron = std::array<Vector3, 4>;

int rational_sign(const Tetrahedron& p) {
  std::array<std::array<Rational, 3>, 3> m;
  for (int row = 0; row < 3; ++row) {
    for (int k = 0; k < 3; ++k) m[row][k] = Rational(p[row + 1][k]) - Rational(p[0][k]);
  }
  const Rational det = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
                       m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
                       m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  return det.sign();
}

int rational_sign(const Vector2& a, const Vector2& b, const Vector2& c) {
  const Rational left = (Rational(b.x()) - Rational(a.x())) * (Rational(c.y()) - Rational(a.y()));
  const Rational right = (Rational(b.y()) - Rational(a.y())) * (Rational(c.x()) - Rational(a.x()));
  return Rational(left - right).sign();
}

int sign_of(const Tetrahedron& p) { return orient3d(p[0], p[1], p[2], p[3]); }

class Random {
 public:
  double unit() { return std::uniform_real_distribution<double>(-1, 1)(engine_); }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(engine_); }
  Vector3 point() { return {unit(), unit(), unit()}; }
  // Any finite double at all, every exponent as likely as the other.
  double any_finite() {
    for (;;) {
      const double value = std::bit_cast<double>(engine_());
      if (std::isfinite(value)) return value;
    }
  }
  double nudged(double value) {
    for (int ulps = below(4); ulps > 0; --ulps) value = std::nextafter(value, 1e308 * (below(2) * 2 - 1));
    return value;
  }
  // The last point in the plane of the others, but for rounding and a few ulps.
  Tetrahedron nearly_flat(double scale, const Vector3& offset) {
    Tetrahedron p = {point() * scale + offset, point() * scale + offset, point() * scale + offset, Vector3::Zero()};
    const double s = unit(), t = unit();
    p[3] = p[0] + s * (p[1] - p[0]) + t * (p[2] - p[0]);
    for (double& x : p[3]) x = nudged(x);
    std::swap(p[3], p[below(4)]);
    return p;
  }

 private:
  std::mt19937_64 engine_{12345};
};

TEST(Orient3d, IsPositiveOnTheSideOfTheNormal) {
  const Vector3 o = Vector3::Zero(), x = Vector3::UnitX(), y = Vector3::UnitY(), z = Vector3::UnitZ();
  EXPECT_EQ(orient3d(o, x, y, z), 1);
  EXPECT_EQ(orient3d(o, x, y, -z), -1);
  EXPECT_EQ(orient3d(o, x, y, x + y), 0);
}

TEST(Orient3d, AgreesWithRationalsOnNearlyFlatInput) {
  Random random;
  int zero = 0, positive = 0;
  for (int round = 0; round < 3000; ++round) {
    const double scale = std::ldexp(1.0, random.below(40) - 20);
    const Vector3 offset = round % 2 == 0 ? Vector3::Zero() : Vector3(random.point() * 1000);
    const Tetrahedron p = random.nearly_flat(scale, offset);
    const int expected = rational_sign(p);
    ASSERT_EQ(sign_of(p), expected) << round;
    zero += expected == 0;
    positive += expected > 0;
  }
  EXPECT_GT(positive, 500);
  EXPECT_LT(positive + zero, 2500);
}

TEST(Orient3d, AgreesWithRationalsOnALatticeOfUlps) {
  // The classic picture of a failing predicate: one point moves over a grid of neighbouring doubles.
  const double ulp = std::numeric_limits<double>::epsilon();
  for (int i = 0; i < 32; ++i) {
    for (int j = 0; j < 32; ++j) {
      const Tetrahedron p = {Vector3(0.5 + i * ulp, 0.5 + j * ulp, 0.5), Vector3(12, 12, 12),
                             Vector3(24, 24, 24 + j % 2), Vector3(1, 1, 0)};
      ASSERT_EQ(sign_of(p), rational_sign(p)) << i << " " << j;
    }
  }
}

TEST(Orient3d, AgreesWithRationalsOnAnyFiniteDoubles) {
  Random random;
  for (int round = 0; round < 300; ++round) {
    Tetrahedron p;
    for (Vector3& point : p) {
      for (double& x : point) x = random.any_finite();
    }
    ASSERT_EQ(sign_of(p), rational_sign(p)) << round;
  }
}

TEST(Orient3d, AgreesWithRationalsOnHugeAndSubnormalInput) {
  Random random;
  for (const double scale : {1e-322, 1e-310, 1e-160, 1e-105, 1e101, 1e160, 1e306, 1.7e308}) {
    for (int round = 0; round < 60; ++round) {
      const Tetrahedron p = random.nearly_flat(scale, Vector3::Zero());
      if (!(p[0].allFinite() && p[1].allFinite() && p[2].allFinite() && p[3].allFinite())) continue;
      ASSERT_EQ(sign_of(p), rational_sign(p)) << scale << " " << round;
    }
    const double s = scale;
    EXPECT_EQ(orient3d({0, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, s}), 1) << scale;
    EXPECT_EQ(orient3d({-s, 0, 0}, {s, 0, 0}, {0, s, 0}, {0, 0, -s}), -1) << scale;
  }
}

TEST(Orient3d, AgreesWithRationalsWhereMagnitudesMix) {
  Random random;
  for (int round = 0; round < 500; ++round) {
    Tetrahedron p;
    for (Vector3& point : p) {
      for (double& x : point) x = random.below(4) == 0 ? 0 : std::ldexp(random.unit(), random.below(360) - 180);
    }
    ASSERT_EQ(sign_of(p), rational_sign(p)) << round;
  }
}

TEST(Orient3d, ChangesItsSignWithEverySwap) {
  Random random;
  for (int round = 0; round < 100; ++round) {
    const Tetrahedron p = random.nearly_flat(1, Vector3(3, 5, 7));
    const int sign = sign_of(p);
    std::array<int, 4> order = {0, 1, 2, 3};
    do {
      int swaps = 0;
      for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < i; ++j) swaps += order[j] > order[i];
      }
      ASSERT_EQ(sign_of({p[order[0]], p[order[1]], p[order[2]], p[order[3]]}), swaps % 2 == 0 ? sign : -sign);
    } while (std::ranges::next_permutation(order).found);
  }
}

TEST(Orient3d, IsZeroWherePointsCoincideOrLieInAnAxisPlane) {
  Random random;
  for (int round = 0; round < 50; ++round) {
    const Vector3 a = random.point(), b = random.point(), c = random.point();
    EXPECT_EQ(orient3d(a, b, c, a), 0);
    EXPECT_EQ(orient3d(a, b, b, c), 0);
    Tetrahedron flat = {a, b, c, random.point()};
    for (Vector3& point : flat) point[round % 3] = 0.1;
    EXPECT_EQ(sign_of(flat), 0);
  }
}

TEST(Orient2d, IsPositiveForCounterClockwise) {
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
  EXPECT_EQ(orient2d({0, 0}, {1, 1}, {3, 3}), 0);
}

TEST(Orient2d, AgreesWithRationalsOnALatticeOfUlps) {
  const double ulp = std::numeric_limits<double>::epsilon();
  int zero = 0;
  for (int i = 0; i < 64; ++i) {
    for (int j = 0; j < 64; ++j) {
      const Vector2 a(0.5 + i * ulp, 0.5 + j * ulp), b(12, 12), c(24, 24);
      const int expected = rational_sign(a, b, c);
      ASSERT_EQ(orient2d(a, b, c), expected) << i << " " << j;
      zero += expected == 0;
    }
  }
  EXPECT_EQ(zero, 64);
}

TEST(Orient2d, AgreesWithRationalsOnAnyFiniteDoubles) {
  Random random;
  for (int round = 0; round < 1000; ++round) {
    const Vector2 a(random.any_finite(), random.any_finite()), b(random.any_finite(), random.any_finite()),
        c(random.any_finite(), random.any_finite());
    ASSERT_EQ(orient2d(a, b, c), rational_sign(a, b, c)) << round;
  }
}

TEST(Orient2d, AgreesWithRationalsOnNearlyCollinearInputAtAnyScale) {
  Random random;
  for (const double scale : {1e-322, 1e-310, 1e-160, 1e-110, 1.0, 1e101, 1e160, 1e306}) {
    for (int round = 0; round < 200; ++round) {
      const Vector2 a = random.point().head<2>() * scale, b = random.point().head<2>() * scale;
      Vector2 c = a + random.unit() * (b - a);
      for (double& x : c) x = random.nudged(x);
      const int expected = rational_sign(a, b, c);
      ASSERT_EQ(orient2d(a, b, c), expected) << scale << " " << round;
      ASSERT_EQ(orient2d(b, c, a), expected) << scale << " " << round;
      ASSERT_EQ(orient2d(b, a, c), -expected) << scale << " " << round;
    }
  }
}

}  // namespace
}  // namespace cagewright
