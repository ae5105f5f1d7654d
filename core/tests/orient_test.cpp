// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <chrono>
#include <cmath>
#include <complex>

#include "core/orient/orient.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

Ellipse ellipse(const Vector3& center, const Vector3& normal, const Vector3& along, double long_radius,
                double short_radius) {
  Ellipse e;
  e.center = center;
  e.normal = normal.normalized();
  e.u = long_radius * (along - along.dot(e.normal) * e.normal).normalized();
  e.v = short_radius * e.normal.cross(e.u).normalized();
  return e;
}

Ellipse random_ellipse(Random& random, const Vector3& near_normal, double wobble) {
  const double short_radius = random.uniform(0.3, 1);
  return ellipse(3 * random.direction(), near_normal + wobble * random.direction(), random.direction(),
                 short_radius * random.uniform(1, 2), short_radius);
}

// Equation (1) once more, straight from the paper: complex numbers, the SVD, and the minimum by its zero gradient,
// which is found by differences (exact for a quadratic).
class PaperEnergy {
 public:
  PaperEnergy(const std::vector<Ellipse>& slides, const NeighbourPairs& pairs, double lambda)
      : slides_(slides), pairs_(pairs), lambda_(lambda) {}

  double operator()(const Eigen::VectorXd& x) const {
    double energy = 0;
    for (const auto& [k, h] : pairs_) energy += smoothness(k, h, x);
    for (int k = 0; k < static_cast<int>(slides_.size()); ++k) {
      const double u = at(k).u.norm(), v = at(k).v.norm();
      energy += lambda_ * (u - v) * (u - v) / (u * u + v * v) * (x.segment<2>(2 * k) - Vector2(1, 0)).squaredNorm();
    }
    return energy;
  }

  Eigen::VectorXd minimiser() const {
    const auto n = static_cast<Eigen::Index>(2 * slides_.size());
    Eigen::MatrixXd hessian(n, n);
    Eigen::VectorXd gradient(n);
    const Eigen::VectorXd zero = Eigen::VectorXd::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::VectorXd a = Eigen::VectorXd::Unit(n, i);
      gradient(i) = ((*this)(a) - (*this)(-a)) / 2;
      for (Eigen::Index j = 0; j < n; ++j) {
        const Eigen::VectorXd b = Eigen::VectorXd::Unit(n, j);
        hessian(i, j) = (*this)(a + b) - (*this)(a) - (*this)(b) + (*this)(zero);
      }
    }
    return hessian.colPivHouseholderQr().solve(-gradient);
  }

 private:
  const Ellipse& at(int k) const { return slides_[static_cast<std::size_t>(k)]; }
  Vector2 flat(int k, const Vector3& d) const { return {at(k).u.normalized().dot(d), at(k).v.normalized().dot(d)}; }
  static Vector2 pow4(const Vector2& v) {
    const double angle = 4 * std::atan2(v.y(), v.x());
    return {std::cos(angle), std::sin(angle)};
  }
  double smoothness(int k, int h, const Eigen::VectorXd& x) const {
    const double s_k = at(k).u.squaredNorm() + at(k).v.squaredNorm();
    const double s_h = at(h).u.squaredNorm() + at(h).v.squaredNorm();
    const double w = (s_k + s_h - std::abs(s_k - s_h)) / (at(k).center - at(h).center).squaredNorm();
    const double angle = std::acos(std::clamp(at(k).normal.dot(at(h).normal), -1.0, 1.0));
    if (angle >= M_PI / 4 && angle <= 3 * M_PI / 4)  // both ways: the first case of (2) is not symmetric
      return w * (x.segment<2>(2 * k) - pow4(flat(k, at(h).normal))).squaredNorm() +
             w * (x.segment<2>(2 * h) - pow4(flat(h, at(k).normal))).squaredNorm();
    Eigen::Matrix2d f = Eigen::Matrix2d::Identity();
    if (at(k).normal.dot(at(h).normal) <= 0) f(1, 1) = -1;
    // R F takes the axes of h, projected to the plane of k and written in k, to (1, 0) and (0, 1).
    Eigen::Matrix2d projected;
    projected << flat(k, at(h).u.normalized()), flat(k, at(h).v.normalized());
    const Eigen::JacobiSVD<Eigen::Matrix2d> svd(f * projected, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const Eigen::Matrix2d r = svd.matrixV() * svd.matrixU().transpose();
    EXPECT_GT(r.determinant(), 0);
    return w * (r * r * r * r * f * x.segment<2>(2 * k) - x.segment<2>(2 * h)).squaredNorm();
  }

  const std::vector<Ellipse>& slides_;
  const NeighbourPairs& pairs_;
  double lambda_;
};

void expect_minimises(const std::vector<Ellipse>& slides, const NeighbourPairs& pairs, double lambda) {
  const PaperEnergy energy(slides, pairs, lambda);
  const Eigen::VectorXd x = energy.minimiser();
  const std::vector<SectionFrame> sections = orient(slides, pairs, lambda, OrientMinimum::angles);
  const std::vector<SectionFrame> as_linear = orient(slides, pairs, lambda);
  std::vector<double> angles;
  Eigen::VectorXd unit(x.size()), turned(x.size()), straight(x.size());
  for (std::size_t k = 0; k < slides.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(2 * k);
    EXPECT_LT((sections[k].linear - x.segment<2>(row)).norm(), 1e-5 * (1 + x.norm())) << "slide " << k;
    EXPECT_EQ(as_linear[k].x, sections[k].linear);
    EXPECT_NEAR(sections[k].x.norm(), 1, 1e-12);
    turned.segment<2>(row) = sections[k].x;
    straight.segment<2>(row) = x.segment<2>(row).normalized();
    angles.push_back(0.3 + static_cast<double>(k));
    unit.segment<2>(row) << std::cos(4 * angles[k]), std::sin(4 * angles[k]);
    const Vector3 p = sections[k].p.normalized();
    const double root = 4 * std::atan2(slides[k].v.normalized().dot(p), slides[k].u.normalized().dot(p));
    EXPECT_NEAR(std::remainder(root - std::atan2(turned(row + 1), turned(row)), 2 * M_PI), 0, 1e-9);
    EXPECT_LE(std::abs(root), M_PI + 1e-9) << "of the four roots the one nearest to u";
  }
  EXPECT_NEAR(orientation_energy(slides, pairs, lambda, angles), energy(unit), 1e-10 * (1 + energy(unit)));
  EXPECT_LE(energy(turned), energy(straight) * (1 + 1e-9));
  for (std::size_t k = 0; k < slides.size(); ++k) {  // a small turn of any slide lowers it no further
    for (const double turn : {-1e-3, 1e-3}) {
      Eigen::VectorXd other = turned;
      other.segment<2>(static_cast<Eigen::Index>(2 * k)) = Eigen::Rotation2Dd(turn) * sections[k].x;
      EXPECT_GE(energy(other), energy(turned) * (1 - 1e-9)) << "slide " << k;
    }
  }
}

// Where neighbours and radii disagree, the linear solution is short, and no minimum once it is taken to length 1.
TEST(Orient, IsBetterThanTheLinearSolutionTakenToLength1) {
  Random random(10);
  double most = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Ellipse> slides;
    for (int i = 0; i < 4; ++i)
      slides.push_back(random_ellipse(random, i % 2 ? Vector3::UnitX() : Vector3::UnitZ(), 0.3));
    const NeighbourPairs pairs = {{0, 1}, {0, 2}, {1, 2}, {2, 3}, {1, 3}};
    std::vector<double> linear, turned;
    for (const SectionFrame& s : orient(slides, pairs, 4, OrientMinimum::angles)) {
      linear.push_back(std::atan2(s.linear.y(), s.linear.x()) / 4);
      turned.push_back(std::atan2(s.x.y(), s.x.x()) / 4);
    }
    const double before = orientation_energy(slides, pairs, 4, linear);
    const double after = orientation_energy(slides, pairs, 4, turned);
    EXPECT_LE(after, before * (1 + 1e-9));
    most = std::max(most, before / after - 1);
  }
  EXPECT_GT(most, 0.01) << "a test that tells something";
}

TEST(Orient, MinimisesEquation1ForParallelSlides) {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Ellipse> slides;
    for (int i = 0; i < 3; ++i) slides.push_back(random_ellipse(random, Vector3::UnitZ(), 0.3));
    expect_minimises(slides, {{0, 1}, {1, 2}}, random.uniform(0.1, 10));
  }
}

TEST(Orient, MinimisesEquation1WhereNormalsAreOpposite) {
  Random random(2);
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<Ellipse> slides = {random_ellipse(random, Vector3::UnitZ(), 0.3),
                                         random_ellipse(random, -Vector3::UnitZ(), 0.3),
                                         random_ellipse(random, Vector3::UnitZ(), 0.3)};
    expect_minimises(slides, {{0, 1}, {0, 2}, {1, 2}}, random.uniform(0.1, 10));
  }
}

TEST(Orient, MinimisesEquation1ForPerpendicularSlides) {
  Random random(3);
  for (int trial = 0; trial < 200; ++trial) {
    const std::vector<Ellipse> slides = {random_ellipse(random, Vector3::UnitZ(), 0.3),
                                         random_ellipse(random, Vector3::UnitX(), 0.3),
                                         random_ellipse(random, -Vector3::UnitX(), 0.3)};
    expect_minimises(slides, {{0, 1}, {0, 2}, {1, 2}}, random.uniform(0.1, 10));
  }
}

TEST(Orient, FollowsTheRadiiWhereLambdaIsLarge) {
  const std::vector<Ellipse> slides = {ellipse({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 2, 1),
                                       ellipse({0, 0, 1}, {0, 0, 1}, {1, 1, 0}, 2, 1)};
  const auto sections = orient(slides, {{0, 1}}, 1e9);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_LT((sections[k].p - slides[k].u).norm(), 1e-7);
    EXPECT_LT((sections[k].q - slides[k].v).norm(), 1e-7);
  }
}

TEST(Orient, MakesParallelSectionsAgreeWithoutAlignment) {
  std::vector<Ellipse> slides;
  for (int k = 0; k < 5; ++k)
    slides.push_back(ellipse({0, 0, double(k)}, {0, 0, k % 2 ? 1.0 : -1.0}, {1, 0.15 * k, 0}, 2 - 0.1 * k, 1));
  const std::vector<SectionFrame> sections = orient(slides, {{0, 1}, {1, 2}, {2, 3}, {3, 4}}, 0);
  for (std::size_t k = 1; k < sections.size(); ++k) {
    const Vector3 p = sections[k].p.normalized(), first = sections[0].p.normalized();
    EXPECT_LT(std::min(std::abs(p.dot(first)), p.cross(first).norm()), 1e-6)
        << "parallel or perpendicular to the first";
  }
}

TEST(Orient, TakesSlidesInOnePlaceForVeryNearAndNotForADefect) {
  const std::vector<Ellipse> slides = {ellipse({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 2, 1),
                                       ellipse({0, 0, 0}, {0, 0.1, 1}, {1, 0.2, 0}, 2, 1),
                                       ellipse({0, 0, 1}, {0, 0, 1}, {1, 0, 0}, 2, 1)};
  for (const double lambda : {0.0, 4.0, 1e6})
    for (const SectionFrame& section : orient(slides, {{0, 1}, {1, 2}}, lambda)) EXPECT_TRUE(section.p.allFinite());
}

TEST(Orient, DecidesTheSameWayForSlidesAt45DegreesHoweverTheyAreTurned) {
  const double r = std::sqrt(0.5);
  const std::vector<Ellipse> slides = {ellipse({0, 0, 0}, {0, 0, 1}, {1, 0.4, 0}, 2, 1),
                                       ellipse({0, 1, 2}, {0, r, r}, {1, -0.7, 0.7}, 1.5, 1)};
  const Vector2 x = orient(slides, {{0, 1}}, 0.5)[1].x;
  for (unsigned trial = 0; trial < 100; ++trial) {
    const Eigen::Matrix3d turn = shapes::random_motion(trial, 1, 0).rotation;
    std::vector<Ellipse> turned = slides;
    for (Ellipse& slide : turned) {
      for (Vector3* direction : {&slide.center, &slide.normal, &slide.u, &slide.v}) *direction = turn * *direction;
    }
    EXPECT_LT((orient(turned, {{0, 1}}, 0.5)[1].x - x).norm(), 1e-9);
  }
}

TEST(Orient, KeepsTheRadiiOfASlideWithoutNeighbours) {
  Random random(5);
  for (const double lambda : {0.0, 4.0}) {
    const std::vector<Ellipse> slides = {random_ellipse(random, Vector3::UnitX(), 1),
                                         ellipse({0, 0, 0}, {0, 1, 1}, {1, 0, 0}, 1, 1)};
    const auto sections = orient(slides, {}, lambda);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_LT((sections[k].p - slides[k].u).norm(), 1e-12);
  }
  EXPECT_TRUE(orient({}, {}, 4).empty());
}

// Which way a stroke was drawn does not matter: the corners are the same set.
TEST(Orient, GivesTheSameRectanglesWhereANormalIsTurnedRound) {
  Random random(6);
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Ellipse> slides = {random_ellipse(random, Vector3::UnitZ(), 0.25),
                                   random_ellipse(random, Vector3::UnitZ(), 0.25),
                                   random_ellipse(random, Vector3::UnitX(), 0.25)};
    const NeighbourPairs pairs = {{0, 1}, {0, 2}, {1, 2}};
    const auto before = orient(slides, pairs, 4);
    const std::size_t turned = static_cast<std::size_t>(random.below(3));
    slides[turned].normal = -slides[turned].normal;
    slides[turned].v = -slides[turned].v;
    const auto after = orient(slides, pairs, 4);
    for (std::size_t k = 0; k < 3; ++k)
      for (const Vector3& corner : before[k].corners()) {
        double nearest = 1e9;
        for (const Vector3& other : after[k].corners()) nearest = std::min(nearest, (corner - other).norm());
        EXPECT_LT(nearest, 1e-7) << "trial " << trial << " slide " << k;
      }
  }
}

TEST(Orient, MovesWithTheSlides) {
  Random random(7);
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const shapes::Motion motion = shapes::random_motion(seed, random.uniform(0.1, 10), 10);
    std::vector<Ellipse> slides, moved;
    for (int k = 0; k < 4; ++k) {
      slides.push_back(random_ellipse(random, k % 2 ? Vector3(Vector3::UnitX()) : Vector3(Vector3::UnitZ()), 0.3));
      moved.push_back({motion(slides.back().center), motion.turn(slides.back().normal),
                       motion.scale * motion.turn(slides.back().u), motion.scale * motion.turn(slides.back().v)});
    }
    const NeighbourPairs pairs = {{0, 1}, {0, 2}, {1, 3}, {2, 3}};
    const auto here = orient(slides, pairs, 4), there = orient(moved, pairs, 4);
    for (std::size_t k = 0; k < slides.size(); ++k)
      for (std::size_t i = 0; i < 4; ++i)
        EXPECT_LT((motion(here[k].corners()[i]) - there[k].corners()[i]).norm(), 1e-9 * motion.scale);
  }
}

TEST(Orient, CircumscribesTheEllipse) {
  Random random(8);
  for (int trial = 0; trial < 100; ++trial) {
    const std::vector<Ellipse> slides = {random_ellipse(random, Vector3::UnitZ(), 0.5),
                                         random_ellipse(random, Vector3::UnitZ(), 0.5)};
    const auto sections = orient(slides, {{0, 1}}, 0.2);
    for (std::size_t k = 0; k < 2; ++k) {
      const SectionFrame& s = sections[k];
      EXPECT_NEAR(s.p.dot(s.q), 0, 1e-12);
      EXPECT_LT((s.p.cross(s.q).normalized() - slides[k].normal).norm(), 1e-12);
      double along_p = 0, along_q = 0;
      for (int i = 0; i < 3600; ++i) {
        const Vector3 r = std::cos(i * M_PI / 1800) * slides[k].u + std::sin(i * M_PI / 1800) * slides[k].v;
        along_p = std::max(along_p, r.dot(s.p) / s.p.squaredNorm());
        along_q = std::max(along_q, r.dot(s.q) / s.q.squaredNorm());
      }
      EXPECT_NEAR(along_p, 1, 1e-5);
      EXPECT_NEAR(along_q, 1, 1e-5);
    }
  }
}

TEST(Orient, OrientsAChainOfTenThousandSlidesInTimeThatGrowsLinearly) {
  Random random(9);
  const auto seconds = [&](int count) {
    std::vector<Ellipse> slides;
    NeighbourPairs pairs;
    for (int k = 0; k < count; ++k) {
      slides.push_back(random_ellipse(random, Vector3::UnitZ(), 0.3));
      slides.back().center = {0, 0, double(k)};
      if (k > 0) pairs.emplace_back(k - 1, k);
    }
    const auto start = std::chrono::steady_clock::now();
    const auto sections = orient(slides, pairs, 4);
    EXPECT_EQ(sections.size(), slides.size());
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  EXPECT_LT(seconds(10000), 5);  // 0.05 s in a release build; a dense solve takes minutes
}

}  // namespace
}  // namespace cagewright
