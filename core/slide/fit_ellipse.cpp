// SPDX-License-Identifier: BSD-3-Clause
#include "core/slide/fit_ellipse.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/error/error.h"
#include "core/mesh/tolerance.h"
#include "core/slide/plane_frame.h"

namespace cagewright {
namespace {

[[noreturn]] void fail(ErrorCode code, const std::string& name, const std::string& what,
                       std::optional<std::size_t> element = {}) {
  ErrorPlace place;
  place.element = element;
  throw Error(code, slide_text(name) + ": " + what, place);
}

// Turns an ellipse given in plane coordinates into space, |u| >= |v|, normal along u x v.
Ellipse to_space(const PlaneFrame& frame, const Vector2& center, const Vector2& major, double long_radius,
                 double short_radius) {
  Ellipse ellipse;
  ellipse.center = frame.to_space(center);
  ellipse.normal = frame.normal;
  ellipse.u = long_radius * (major.x() * frame.e1 + major.y() * frame.e2).normalized();
  ellipse.v = frame.normal.cross(ellipse.u).normalized() * short_radius;
  return ellipse;
}

void turn_half(Ellipse& ellipse) {
  ellipse.u = -ellipse.u;
  ellipse.v = -ellipse.v;
}

std::size_t distinct_points(const Points& points) {
  std::set<std::array<double, 3>> seen;
  for (Eigen::Index i = 0; i < points.rows(); ++i) seen.insert({points(i, 0), points(i, 1), points(i, 2)});
  return seen.size();
}

// Direct least-squares fit of a x^2 + b xy + c y^2 + d x + e y + f = 0 under 4ac - b^2 = 1 [Fitzgibbon et al. 1999].
// Eliminating d, e, f first leaves a well-conditioned 3 x 3 eigenproblem [Halir & Flusser 1998].
std::optional<Eigen::Matrix<double, 6, 1>> fit_conic(const std::vector<Vector2>& points) {
  Eigen::Matrix3d s1 = Eigen::Matrix3d::Zero(), s2 = s1, s3 = s1;
  for (const Vector2& p : points) {
    const Vector3 quadratic(p.x() * p.x(), p.x() * p.y(), p.y() * p.y()), linear(p.x(), p.y(), 1);
    s1 += quadratic * quadratic.transpose();
    s2 += quadratic * linear.transpose();
    s3 += linear * linear.transpose();
  }
  const Eigen::Matrix3d t = -s3.ldlt().solve(s2.transpose());
  const Eigen::Matrix3d reduced = s1 + s2 * t;
  Eigen::Matrix3d m;
  m << reduced.row(2) / 2, -reduced.row(1), reduced.row(0) / 2;
  const Eigen::EigenSolver<Eigen::Matrix3d> solver(m);
  if (solver.info() != Eigen::Success) return {};
  double best_residual = std::numeric_limits<double>::infinity();
  std::optional<Eigen::Matrix<double, 6, 1>> best;
  for (int i = 0; i < 3; ++i) {
    const Vector3 v = solver.eigenvectors().col(i).real();
    const double discriminant = 4 * v(0) * v(2) - v(1) * v(1);
    if (!(discriminant > 0)) continue;
    const double residual = v.dot(reduced * v) / discriminant;
    if (residual >= best_residual) continue;
    best_residual = residual;
    Eigen::Matrix<double, 6, 1> conic;
    conic << v, t * v;
    best = conic;
  }
  return best;
}

// Centre and radii of a conic that is an ellipse; empty where it is not, or is imaginary.
struct FlatEllipse {
  Vector2 center, major;
  double long_radius, short_radius;
};
std::optional<FlatEllipse> ellipse_of(const Eigen::Matrix<double, 6, 1>& conic) {
  Eigen::Matrix2d q;
  q << conic(0), conic(1) / 2, conic(1) / 2, conic(2);
  const Vector2 linear(conic(3), conic(4));
  const Vector2 center = -q.inverse() * linear / 2;
  const double level = -(conic(5) + linear.dot(center) / 2);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(q / level);
  const Vector2 inverse_squares = solver.eigenvalues();  // ascending: the long radius first
  if (!(inverse_squares(0) > 0) || !inverse_squares.allFinite() || !center.allFinite()) return {};
  return FlatEllipse{center, solver.eigenvectors().col(0), 1 / std::sqrt(inverse_squares(0)),
                     1 / std::sqrt(inverse_squares(1))};
}

struct Moments {
  double area = 0;    // over extent squared
  double extent = 0;  // of the polygon from its mean
  Vector2 centroid = Vector2::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // over extent squared
};

// Of the region inside a polygon, by Green's theorem, relative to the polygon's mean and extent for accuracy.
Moments moments_of(const std::vector<Vector2>& polygon) {
  Vector2 origin = Vector2::Zero();
  for (const Vector2& p : polygon) origin += p / static_cast<double>(polygon.size());
  double extent = 0;
  for (const Vector2& p : polygon) extent = std::max(extent, (p - origin).stableNorm());
  Moments m;
  if (!(extent > 0)) return m;
  Vector2 first = Vector2::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 a = (polygon[i] - origin) / extent, b = (polygon[(i + 1) % polygon.size()] - origin) / extent;
    const double cross = a.x() * b.y() - a.y() * b.x();
    m.area += cross / 2;
    first += cross / 6 * (a + b);
    second += cross / 24 * (2 * a * a.transpose() + a * b.transpose() + b * a.transpose() + 2 * b * b.transpose());
  }
  if (m.area == 0) return m;
  const Vector2 mean = first / m.area;
  m.centroid = origin + extent * mean;
  m.covariance = second / m.area - mean * mean.transpose();
  m.extent = extent;
  return m;
}

// The principal directions of a circle are rounding; a point of the curve has to give u instead.
bool is_round(double long_radius, double short_radius) {
  return long_radius - short_radius <= tolerance::round_loop * long_radius;
}

// The point farthest from `center`; of equally far ones the first.
Vector2 farthest_point(const std::vector<Vector2>& polygon, const Vector2& center) {
  Vector2 best = polygon.front();
  for (const Vector2& p : polygon)
    if ((p - center).norm() > (1 + tolerance::tie) * (best - center).norm()) best = p;
  return best;
}

Vector3 stroke_normal(const Points& stroke, const Vector3& mean, const std::string& name) {
  const Points centered = stroke.rowwise() - mean.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(centered.transpose() * centered);
  const Vector3 extents = solver.eigenvalues().cwiseMax(0).cwiseSqrt();  // ascending
  if (!(extents(1) > tolerance::collinear_stroke * extents(2)))
    fail(ErrorCode::stroke_collinear, name, "the stroke is a straight line: draw it so that it bends round the limb");
  Vector3 normal = solver.eigenvectors().col(0).normalized();
  Vector3 turn = Vector3::Zero();
  for (Eigen::Index i = 0; i + 1 < centered.rows(); ++i)
    turn += Vector3(centered.row(i)).cross(Vector3(centered.row(i + 1)));
  return normal.dot(turn) < 0 ? Vector3(-normal) : normal;
}

void check_finite(const Vector3& value, const char* what, const std::string& name) {
  if (!value.allFinite())
    fail(ErrorCode::slide_not_finite, name, std::string("its ") + what + " is not a finite number: give finite ones");
}

}  // namespace

Ellipse fit_stroke(const Points& stroke, const std::string& name) {
  for (Eigen::Index i = 0; i < stroke.rows(); ++i)
    if (!stroke.row(i).allFinite())
      fail(ErrorCode::slide_not_finite, name,
           "stroke point " + std::to_string(i) + " is not a finite number: give finite ones",
           static_cast<std::size_t>(i));
  if (const std::size_t count = distinct_points(stroke); count < 5)
    fail(ErrorCode::stroke_too_short, name,
         "the stroke has " + std::to_string(count) + " distinct points and an ellipse needs 5: draw a longer stroke");
  const Vector3 mean = stroke.colwise().mean();
  const PlaneFrame frame(mean, stroke_normal(stroke, mean, name));
  std::vector<Vector2> flat = frame.to_plane(stroke);
  double extent = 0;
  for (const Vector2& p : flat) extent = std::max(extent, p.norm());
  for (Vector2& p : flat) p /= extent;

  const auto conic = fit_conic(flat);
  const auto fitted = conic ? ellipse_of(*conic) : std::nullopt;
  if (!fitted || fitted->long_radius > tolerance::largest_ellipse ||
      fitted->short_radius < tolerance::degenerate_radius * fitted->long_radius)
    fail(ErrorCode::stroke_no_ellipse, name,
         "no ellipse fits the stroke: draw it farther round the limb, without a zigzag");
  Vector2 major = fitted->major;
  if (is_round(fitted->long_radius, fitted->short_radius))
    major = farthest_point(flat, fitted->center) - fitted->center;
  Ellipse ellipse =
      to_space(frame, extent * fitted->center, major, extent * fitted->long_radius, extent * fitted->short_radius);
  if (ellipse.u.dot(Vector3(stroke.row(0)) - ellipse.center) < 0) turn_half(ellipse);
  return ellipse;
}

Ellipse fit_loop(const Points& loop, const Vector3& on_plane, const Vector3& normal, const std::string& name) {
  const PlaneFrame frame(on_plane, normal);
  const std::vector<Vector2> polygon = frame.to_plane(loop);
  const Moments moments = moments_of(polygon);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(moments.covariance);
  // Along a radius r of a solid ellipse the variance is r^2 / 4.
  const Vector2 radii = 2 * moments.extent * solver.eigenvalues().cwiseMax(0).cwiseSqrt();
  if (!(radii(0) > tolerance::degenerate_radius * radii(1)))
    fail(ErrorCode::slide_degenerate, name, "the model's cross section there has no area: move the slide");
  Vector2 major = solver.eigenvectors().col(1);
  if (is_round(radii(1), radii(0))) major = farthest_point(polygon, moments.centroid) - moments.centroid;
  Ellipse ellipse = to_space(frame, moments.centroid, major, radii(1), radii(0));
  double farthest = 0;  // along u, with its sign; of equally far ones the first
  for (Eigen::Index i = 0; i < loop.rows(); ++i) {
    const double along = ellipse.u.dot(Vector3(loop.row(i)) - ellipse.center);
    if (std::abs(along) > (1 + tolerance::tie) * std::abs(farthest)) farthest = along;
  }
  if (farthest < 0) turn_half(ellipse);
  return ellipse;
}

Ellipse from_radii(const EllipseDefinition& definition, const std::string& name) {
  check_finite(definition.center, "center", name);
  check_finite(definition.u, "u", name);
  check_finite(definition.v, "v", name);
  Eigen::Matrix<double, 3, 2> radii;
  radii << definition.u, definition.v;
  const Eigen::JacobiSVD<Eigen::Matrix<double, 3, 2>> svd(radii, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Vector2 lengths = svd.singularValues();
  if (!(lengths(1) > tolerance::degenerate_radius * lengths(0)))
    fail(ErrorCode::slide_degenerate, name,
         "its radii u and v are zero or parallel, so they span no plane: give two radii at an angle");
  Ellipse ellipse;
  ellipse.center = definition.center;
  ellipse.normal = definition.u.cross(definition.v).normalized();
  ellipse.u = svd.matrixU().col(0) * lengths(0);
  if (ellipse.u.dot(definition.u) < 0) ellipse.u = -ellipse.u;
  ellipse.v = ellipse.normal.cross(ellipse.u).normalized() * lengths(1);
  return ellipse;
}

void check_definition(const Slide& slide) {
  if (const auto* stroke = std::get_if<StrokeDefinition>(&slide.definition)) {
    fit_stroke(stroke->points, slide.name);
  } else if (const auto* plane = std::get_if<PointNormalDefinition>(&slide.definition)) {
    check_finite(plane->point, "point", slide.name);
    check_finite(plane->normal, "normal", slide.name);
    if (!(plane->normal.stableNorm() > 0))
      fail(ErrorCode::slide_degenerate, slide.name, "its normal is zero: give the direction that the plane faces");
  } else if (const auto* click = std::get_if<PointDefinition>(&slide.definition)) {
    check_finite(click->point, "point", slide.name);
  } else {
    from_radii(std::get<EllipseDefinition>(slide.definition), slide.name);
  }
}

}  // namespace cagewright
