// SPDX-License-Identifier: BSD-3-Clause
#include "core/orient/orient.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "core/error/error.h"
#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

using Matrix2 = Eigen::Matrix2d;

Vector2 pow4(const Vector2& v) {
  const std::complex<double> unit = std::complex<double>(v.x(), v.y()) / v.norm();
  const std::complex<double> fourth = unit * unit * unit * unit;
  return {fourth.real(), fourth.imag()};
}

double size(const Ellipse& slide) { return slide.u.squaredNorm() + slide.v.squaredNorm(); }  // (4b), (4c)

double smoothness_weight(const Ellipse& k, const Ellipse& h) {  // (4a)
  const double s_k = size(k), s_h = size(h);
  // Slides in one place, as two strokes over each other may be, would weigh infinitely much.
  const double nearest = tolerance::nearest_centers * tolerance::nearest_centers * (s_k + s_h);
  return (s_k + s_h - std::abs(s_k - s_h)) / std::max((k.center - h.center).squaredNorm(), nearest);
}

double alignment_weight(const Ellipse& k, double lambda) {  // (5b)
  const double difference = k.u.norm() - k.v.norm();
  return lambda * difference * difference / size(k);
}

bool perpendicular(const Ellipse& k, const Ellipse& h) {  // the angle between the normals is in [pi/4, 3 pi/4]
  return std::abs(k.normal.dot(h.normal)) <= std::numbers::sqrt2 / 2 + tolerance::tie;
}

Vector2 in_frame_of(const Ellipse& k, const Vector3& direction) {
  return {k.u.normalized().dot(direction), k.v.normalized().dot(direction)};
}

// R_kh^4 F_kh of (2), where R_kh F_kh carries coordinates of k to those of h. The axes of h seen from k form a matrix
// that is near a rotation once F is taken out; its nearest rotation is the SVD's, here in closed form.
Matrix2 transport(const Ellipse& k, const Ellipse& h) {
  Matrix2 m;
  m.row(0) << h.u.normalized().dot(k.u.normalized()), h.u.normalized().dot(k.v.normalized());
  m.row(1) << h.v.normalized().dot(k.u.normalized()), h.v.normalized().dot(k.v.normalized());
  Matrix2 flip = Matrix2::Identity();
  flip(1, 1) = k.normal.dot(h.normal) > 0 ? 1 : -1;  // (3)
  const Matrix2 r = m * flip;
  const double angle = std::atan2(r(1, 0) - r(0, 1), r(0, 0) + r(1, 1));
  return Eigen::Rotation2Dd(4 * angle).toRotationMatrix() * flip;
}

// (1) as |x|^2_A - 2 b.x + constant, built term by term.
class Energy {
 public:
  explicit Energy(std::size_t slides) : b_(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(2 * slides))) {}

  // weight |x_k - target|^2
  void pull(int k, const Vector2& target, double weight) {
    heaviest_ = std::max(heaviest_, weight);
    add(k, k, weight * Matrix2::Identity());
    b_.segment<2>(2 * k) += weight * target;
    constant_ += weight * target.squaredNorm();
  }
  // weight |T x_k - x_h|^2
  void tie(int k, int h, const Matrix2& t, double weight) {
    heaviest_ = std::max(heaviest_, weight);
    add(k, k, weight * t.transpose() * t);
    add(h, h, weight * Matrix2::Identity());
    add(h, k, -weight * t);
    add(k, h, -weight * t.transpose());
  }
  // The heaviest weight so far; 1 where there is none.
  double heaviest() const { return heaviest_ > 0 ? heaviest_ : 1; }
  Eigen::VectorXd minimiser() const {
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix());
    const Eigen::VectorXd x = solver.solve(b_);
    if (solver.info() != Eigen::Success || !x.allFinite())
      throw Error(ErrorCode::internal, "orient: equation (1) has no unique minimum");
    return x;
  }
  double at(const Eigen::VectorXd& x) const { return x.dot(matrix() * x) - 2 * b_.dot(x) + constant_; }
  const Eigen::VectorXd& linear_term() const { return b_; }
  Eigen::SparseMatrix<double> matrix() const {
    Eigen::SparseMatrix<double> a(b_.size(), b_.size());
    a.setFromTriplets(entries_.begin(), entries_.end());
    return a;
  }

 private:
  void add(int row, int column, const Matrix2& block) {
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j) entries_.emplace_back(2 * row + i, 2 * column + j, block(i, j));
  }
  std::vector<Eigen::Triplet<double>> entries_;
  Eigen::VectorXd b_;
  double constant_ = 0, heaviest_ = 0;
};

Energy equation_1(const std::vector<Ellipse>& slides, const NeighbourPairs& neighbours, double lambda) {
  Energy energy(slides.size());
  for (const auto& [first, second] : neighbours) {
    const Ellipse& k = slides[static_cast<std::size_t>(first)];
    const Ellipse& h = slides[static_cast<std::size_t>(second)];
    const double w = smoothness_weight(k, h);
    if (perpendicular(k, h)) {
      energy.pull(first, pow4(in_frame_of(k, h.normal)), w);
      energy.pull(second, pow4(in_frame_of(h, k.normal)), w);
    } else {
      energy.tie(first, second, transport(k, h), w);
    }
  }
  for (std::size_t k = 0; k < slides.size(); ++k)
    energy.pull(static_cast<int>(k), Vector2::UnitX(), alignment_weight(slides[k], lambda));  // (5a)
  return energy;
}

// (1) over directions of length 1: x_k = (cos f_k, sin f_k), f_k four times the angle of p_k.
class UnitEnergy {
 public:
  UnitEnergy(const Energy& energy, Eigen::VectorXd angles)
      : a_(energy.matrix()), b_(energy.linear_term()), angles_(std::move(angles)) {}

  // To the minimum next to where it is. Newton's method with halved steps; where a step is so small that the energy
  // cannot tell any more, the gradient decides alone.
  Eigen::VectorXd minimise() {
    double energy = at(angles_);
    for (int k = 0; k < most_steps; ++k) {
      const Eigen::VectorXd step = newton_step();
      const double length = step.size() > 0 ? step.cwiseAbs().maxCoeff() : 0;
      if (!std::isfinite(length) || length < least_step) break;
      if (length < sure_step) {
        angles_ += step;
        continue;
      }
      double share = std::min(1.0, longest_step / length);
      while (share > least_share && !(at(angles_ + share * step) < energy)) share /= 2;
      if (share <= least_share) break;
      angles_ += share * step;
      energy = at(angles_);
    }
    return directions(angles_);
  }

  static Eigen::VectorXd directions(const Eigen::VectorXd& angles) {
    Eigen::VectorXd x(2 * angles.size());
    for (Eigen::Index k = 0; k < angles.size(); ++k) x.segment<2>(2 * k) << std::cos(angles(k)), std::sin(angles(k));
    return x;
  }

 private:
  static constexpr int most_steps = 50;
  static constexpr double longest_step = 1, sure_step = 1e-6, least_step = 1e-13, least_share = 1e-6;

  double at(const Eigen::VectorXd& angles) const {
    const Eigen::VectorXd x = directions(angles);
    return x.dot(a_ * x) - 2 * b_.dot(x);
  }

  // Where the second derivatives are not positive definite, without those terms of theirs that may be negative.
  Eigen::VectorXd newton_step() const {
    const Eigen::VectorXd x = directions(angles_), pull = a_ * x - b_;
    Eigen::SparseMatrix<double> tangents(x.size(), angles_.size());
    tangents.reserve(Eigen::VectorXi::Constant(angles_.size(), 2));
    Eigen::VectorXd bend(angles_.size());  // of the circle: what the pull along x adds
    for (Eigen::Index k = 0; k < angles_.size(); ++k) {
      tangents.insert(2 * k, k) = -x(2 * k + 1);
      tangents.insert(2 * k + 1, k) = x(2 * k);
      bend(k) = -x.segment<2>(2 * k).dot(pull.segment<2>(2 * k));
    }
    const Eigen::VectorXd gradient = tangents.transpose() * pull;
    Eigen::SparseMatrix<double> flat = tangents.transpose() * a_ * tangents, curved = flat;
    curved.diagonal() += bend;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(curved);
    if (solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > 0)) {
      flat.diagonal() += bend.cwiseMax(0);
      solver.compute(flat);
    }
    return solver.solve(-gradient);
  }

  Eigen::SparseMatrix<double> a_;
  Eigen::VectorXd b_, angles_;
};

Eigen::VectorXd angles_of(const Eigen::VectorXd& x) {
  Eigen::VectorXd angles(x.size() / 2);
  for (Eigen::Index k = 0; k < angles.size(); ++k) angles(k) = std::atan2(x(2 * k + 1), x(2 * k));
  return angles;
}

// Half the extent of the ellipse along a unit direction in its plane.
double reach(const Ellipse& slide, const Vector3& direction) {
  return std::hypot(slide.u.dot(direction), slide.v.dot(direction));
}

SectionFrame section_of(const Ellipse& slide, const Vector2& x, const Vector2& linear) {
  // The fourth root nearest to u; of the two half way between u and v, always the same.
  const double y = std::abs(x.y()) <= tolerance::tie * x.norm() ? std::abs(x.y()) : x.y();
  const double angle = std::atan2(y, x.x()) / 4;
  const Vector3 u = slide.u.normalized(), v = slide.v.normalized();
  const Vector3 p = std::cos(angle) * u + std::sin(angle) * v;
  const Vector3 q = slide.normal.cross(p);
  return {slide.center, slide.normal, reach(slide, p) * p, reach(slide, q) * q, x, linear};
}

}  // namespace

std::array<Vector3, 4> SectionFrame::corners() const {
  return {center + p + q, center - p + q, center - p - q, center + p - q};
}

std::vector<SectionFrame> orient(const std::vector<Ellipse>& slides, const NeighbourPairs& neighbours, double lambda,
                                 OrientMinimum minimum) {
  std::vector<SectionFrame> sections;
  if (slides.empty()) return sections;
  Energy energy = equation_1(slides, neighbours, lambda);
  // Pulls a slide that nothing else orients to its own u.
  const double weight = tolerance::tie_break_weight * energy.heaviest();
  for (std::size_t k = 0; k < slides.size(); ++k) energy.pull(static_cast<int>(k), Vector2::UnitX(), weight);
  const Eigen::VectorXd linear = energy.minimiser();
  const Eigen::VectorXd x =
      minimum == OrientMinimum::linear ? linear : UnitEnergy(energy, angles_of(linear)).minimise();
  for (std::size_t k = 0; k < slides.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(2 * k);
    sections.push_back(section_of(slides[k], x.segment<2>(row), linear.segment<2>(row)));
  }
  return sections;
}

double orientation_energy(const std::vector<Ellipse>& slides, const NeighbourPairs& neighbours, double lambda,
                          const std::vector<double>& angles) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(2 * slides.size()));
  for (std::size_t k = 0; k < slides.size(); ++k)
    x.segment<2>(static_cast<Eigen::Index>(2 * k)) = pow4({std::cos(angles[k]), std::sin(angles[k])});
  return equation_1(slides, neighbours, lambda).at(x);
}

}  // namespace cagewright
