// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/pipeline/pipeline.h"
#include "core/tests/cage_checks.h"
#include "core/tests/expect_error.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

using shapes::SlidBody;

// A meshed cage and what refine needs of it.
struct Meshed {
  SlidBody body;
  Model model;
  PipelineResult result;
  std::vector<std::string> names;

  explicit Meshed(SlidBody slid) : body(std::move(slid)), model(prepare_model(body.mesh)) {
    PipelineOptions options;
    options.last_stage = Stage::meshing;
    result = make_cage(model, body.slides, options);
    names = checks::names_of(body.slides);
  }
  Refinement refined(const RefineOptions& options, const Progress& progress = {}) const {
    return refine(result.segmentation, result.sections, *result.cage, model.diagonal, names, options, progress);
  }
  Vector3 vertex(long v) const { return result.segmentation.cut.points.row(v); }
};

Vector3 corner(const Cage& cage, const Points& points, Eigen::Index t, int i) {
  return points.row(cage.triangles(t, i));
}
Vector3 center_of(const Cage& cage, Eigen::Index t) {
  return cage.part_center[static_cast<std::size_t>(cage.triangle_part[static_cast<std::size_t>(t)])];
}
// The sine under which a part's centre sees a triangle: positive from inside.
double facing(const Cage& cage, const Points& points, Eigen::Index t) {
  const Vector3 c = center_of(cage, t);
  const Vector3 x = corner(cage, points, t, 0) - c, y = corner(cage, points, t, 1) - c,
                z = corner(cage, points, t, 2) - c;
  return (y - x).cross(z - x).normalized().dot(x) / std::max({x.norm(), y.norm(), z.norm()});
}
// Least signed distance of v from the planes of the cone from `center` over the polygon.
double margin(const std::vector<Vector3>& polygon, const Vector3& center, const Vector3& v) {
  double least = 1e300;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector3 a = polygon[i] - center, b = polygon[(i + 1) % polygon.size()] - center;
    least = std::min(least, a.cross(b).normalized().dot(v - center));
  }
  return least;
}
double winding(const Cage& cage, const Points& points, const Vector3& q) {
  double angle = 0;
  for (Eigen::Index t = 0; t < cage.triangles.rows(); ++t) {
    const Vector3 a = corner(cage, points, t, 0) - q, b = corner(cage, points, t, 1) - q,
                  c = corner(cage, points, t, 2) - q;
    angle += 2 * std::atan2(a.dot(b.cross(c)), a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                                   b.dot(c) * a.norm() + c.dot(a) * b.norm());
  }
  return angle / (4 * M_PI);
}

TEST(Refine, MeetsEquation9OnEveryBodyAtEveryDistance) {
  for (const SlidBody& body : shapes::slid_bodies())
    for (const double delta : {0.0, 0.01, 0.05}) {
      if (delta > 0.01 && body.name == "figure") continue;  // too much for its armpits: see the next test
      const Meshed m(body);
      SCOPED_TRACE(body.name + ", delta " + std::to_string(delta));
      RefineOptions options;
      options.delta = delta;
      const Refinement r = m.refined(options);
      EXPECT_TRUE(r.converged);
      EXPECT_LE(std::abs(-r.max_signed_distance - delta * m.model.diagonal), 1e-3 * m.model.diagonal);
      ASSERT_FALSE(r.records.empty());
      EXPECT_LT(r.max_signed_distance, r.records.front().max_signed_distance);
      EXPECT_EQ(r.cage.points, r.records.back().after);
      EXPECT_EQ(r.cage.triangles, m.result.cage->triangles);
      checks::expect_closed_manifold(r.cage.points, r.cage.triangles, body.cage_genus);
    }
}

TEST(Refine, BoundsAConvexLimb) {
  const Meshed m(shapes::limb(3));
  RefineOptions options;
  options.delta = 0.005;  // more than what (9) tolerates
  const Refinement r = m.refined(options);
  const Refinement tight = m.refined({});
  for (Eigen::Index v = 0; v < m.result.segmentation.cut.points.rows(); v += 7) {
    const Vector3 p = m.vertex(v);
    EXPECT_GT(winding(r.cage, r.cage.points, p), 0.5) << "vertex " << v;
    const Vector3 axis = Vector3(std::clamp(p.x(), -1.0, 1.0), 0, 0);
    const Vector3 less = p - 4e-3 * m.model.diagonal * (p - axis).normalized();
    EXPECT_GT(winding(tight.cage, tight.cage.points, less), 0.5) << "vertex " << v;
  }
}

// Of every record: normals, (6) and (7) from their definitions.
void expect_anchors_of_record(const Meshed& m, const RefineRecord& record, double delta) {
  const Cage& cage = *m.result.cage;
  double largest = -1e300;
  for (Eigen::Index t = 0; t < cage.triangles.rows(); ++t) {
    const auto i = static_cast<std::size_t>(t);
    const Vector3 a = corner(cage, record.before, t, 0), b = corner(cage, record.before, t, 1),
                  c = corner(cage, record.before, t, 2), n = record.normals.row(t), g = (a + b + c) / 3;
    EXPECT_LT((n - (b - a).cross(c - a).normalized()).norm(), 1e-12);
    if (record.outermost[i] < 0) {
      EXPECT_EQ(record.signed_distance[i], -std::numeric_limits<double>::infinity());
      EXPECT_LT((Vector3(record.anchors.row(t)) - g).norm(), 1e-12);
      continue;
    }
    const Vector3 v = m.vertex(record.outermost[i]);
    EXPECT_NEAR(record.signed_distance[i], (v - g).dot(n), 1e-12);
    largest = std::max(largest, record.signed_distance[i]);
    if (std::abs(record.signed_distance[i] + delta) < 1e-8 * m.model.diagonal) continue;  // either case of (7)
    const Vector3 anchor = record.signed_distance[i] > -delta ? Vector3(v + delta * n) : g;
    EXPECT_LT((Vector3(record.anchors.row(t)) - anchor).norm(), 1e-12);
  }
  EXPECT_EQ(record.max_signed_distance, largest);
}

TEST(Refine, RecordsAnchorsAsEquations6And7SayThem) {
  for (const SlidBody& body : {shapes::figure(), shapes::handle_body()}) {
    const Meshed m(body);
    for (const double delta : {0.0, 0.02}) {
      RefineOptions options;
      options.delta = delta;
      for (const RefineRecord& record : m.refined(options).records)
        expect_anchors_of_record(m, record, delta * m.model.diagonal);
    }
  }
}

TEST(Refine, TakesTheOutermostVertexOfThePartWhereTheScopeIsThePart) {
  const Meshed m(shapes::figure());
  RefineOptions options;
  options.scope = RefineScope::part;
  options.iterations = 3;
  const Cage& cage = *m.result.cage;
  for (const RefineRecord& record : m.refined(options).records) {
    expect_anchors_of_record(m, record, 0);
    for (Eigen::Index t = 0; t < cage.triangles.rows(); ++t) {
      const auto part = static_cast<std::size_t>(cage.triangle_part[static_cast<std::size_t>(t)]);
      const Vector3 g =
          (corner(cage, record.before, t, 0) + corner(cage, record.before, t, 1) + corner(cage, record.before, t, 2)) /
          3;
      double best = -1e300;
      for (int v : m.result.segmentation.parts[part].vertices)
        best = std::max(best, (m.vertex(v) - g).dot(Vector3(record.normals.row(t))));
      EXPECT_NEAR(record.signed_distance[static_cast<std::size_t>(t)], best, 1e-13);
    }
  }
}

// The cones over a part's triangles and sections partition space; (6) takes what each triangle's cone holds.
TEST(Refine, TakesTheOutermostVertexOfTheConeWhereTheScopeIsLocal) {
  for (const SlidBody& body : {shapes::figure(), shapes::fork(2), shapes::ring(5)}) {
    SCOPED_TRACE(body.name);
    const Meshed m(body);
    const Segmentation& s = m.result.segmentation;
    const Cage& cage = *m.result.cage;
    RefineOptions options;
    options.iterations = 1;
    const RefineRecord record = m.refined(options).records.at(0);
    const double eps = 1e-9 * m.model.diagonal;
    std::vector<double> best(static_cast<std::size_t>(cage.triangles.rows()), -1e300);
    for (std::size_t p = 0; p < s.parts.size(); ++p)
      for (int v : s.parts[p].vertices) {
        const Vector3 c = cage.part_center[p];
        int seen = 0, on_border = 0;
        for (Eigen::Index t = 0; t < cage.triangles.rows(); ++t) {
          if (cage.triangle_part[static_cast<std::size_t>(t)] != static_cast<int>(p)) continue;
          const double inside = margin(
              {corner(cage, cage.points, t, 0), corner(cage, cage.points, t, 1), corner(cage, cage.points, t, 2)}, c,
              m.vertex(v));
          on_border += std::abs(inside) <= eps;
          if (inside <= eps) continue;
          ++seen;
          const Vector3 n = record.normals.row(t), a = corner(cage, cage.points, t, 0);
          double& b = best[static_cast<std::size_t>(t)];
          b = std::max(b, (m.vertex(v) - a).dot(n));
        }
        for (const PartSection& side : s.parts[p].sections) {
          const SectionFrame& f = m.result.sections[static_cast<std::size_t>(side.slide)];
          const auto q = f.corners();
          std::vector<Vector3> quad(q.begin(), q.end());
          if (!side.outward) std::reverse(quad.begin(), quad.end());
          const double inside = margin(quad, c, m.vertex(v));
          seen += inside > eps;
          on_border += std::abs(inside) <= eps;
        }
        if (!on_border) {
          EXPECT_EQ(seen, 1) << "vertex " << v << " of part " << p;
        }
      }
    for (std::size_t t = 0; t < best.size(); ++t) {
      if (best[t] < -1e299) continue;
      EXPECT_GE(record.signed_distance[t], best[t] - 1e-12) << "triangle " << t;
    }
  }
}

// Equation (8) as a dense least-squares problem: one row for each triangle at the vertex, three for the damping.
Vector3 dense_step(const Cage& cage, const RefineRecord& record, int j, double& trace) {
  std::vector<Eigen::RowVector4d> rows;
  trace = 0;
  for (Eigen::Index t = 0; t < cage.triangles.rows(); ++t)
    for (int i = 0; i < 3; ++i) {
      if (cage.triangles(t, i) != j) continue;
      const double w = record.weights(t, i);
      const Vector3 n = record.normals.row(t), a = record.anchors.row(t), u = record.before.row(j);
      trace += w * (1 - std::pow(n.dot(Vector3(record.plane_normal.row(j))), 2));
      rows.emplace_back(std::sqrt(w) * n.x(), std::sqrt(w) * n.y(), std::sqrt(w) * n.z(), std::sqrt(w) * n.dot(a - u));
    }
  for (int k = 0; k < 3; ++k) {
    rows.emplace_back(Eigen::RowVector4d::Zero());
    rows.back()(k) = std::sqrt(record.damping[static_cast<std::size_t>(j)]);
  }
  Eigen::MatrixXd a(rows.size(), 3);
  Eigen::VectorXd b(rows.size());
  for (std::size_t r = 0; r < rows.size(); ++r) {
    a.row(static_cast<Eigen::Index>(r)) = rows[r].head<3>();
    b(static_cast<Eigen::Index>(r)) = rows[r](3);
  }
  const Vector3 n = record.plane_normal.row(j);
  if (n.isZero()) return a.colPivHouseholderQr().solve(b);
  const Eigen::Matrix<double, 3, 2> basis =
      Eigen::FullPivHouseholderQR<Eigen::Matrix3d>(n * n.transpose()).matrixQ().rightCols<2>();
  return basis * (a * basis).colPivHouseholderQr().solve(b);
}

TEST(Refine, StepsToTheLeastSquaresSolutionOfEquation8) {
  for (const bool in_plane : {false, true}) {
    const Meshed m(shapes::figure());
    RefineOptions options;
    options.in_plane = in_plane;
    options.push = 1;
    options.delta = 0.01;
    const Refinement r = m.refined(options);
    ASSERT_GT(r.records.size(), 2u);
    const Points* last = &m.result.cage->points;
    for (const RefineRecord& record : r.records) {
      EXPECT_EQ(record.before, *last) << "a record begins where the one before ends";
      last = &record.after;
      for (Eigen::Index t = 0; t < r.cage.triangles.rows(); ++t)
        for (int i = 0; i < 3; ++i) {
          const double d = (corner(r.cage, record.before, t, i) - Vector3(record.anchors.row(t))).norm();
          if (d > 2e-6 * m.model.diagonal) {
            EXPECT_NEAR(record.weights(t, i) * d * d, 1, 1e-10);
          }
        }
      for (int j = 0; j < record.before.rows(); ++j) {
        double trace = 0;
        const Vector3 step = dense_step(r.cage, record, j, trace);
        const Vector3 taken = record.after.row(j) - record.before.row(j);
        EXPECT_LT((step - taken).norm(), 1e-12 * m.model.diagonal) << "vertex " << j;
        EXPECT_GE(record.damping[static_cast<std::size_t>(j)], 0.01 * trace * (1 - 1e-12));
      }
    }
  }
}

TEST(Refine, WeighsTrianglesThatStillMoveWithPush) {
  const Meshed m(shapes::fork(2));
  RefineOptions options;
  options.iterations = 1;
  const RefineRecord pushed = m.refined(options).records.at(0);
  options.push = 1;
  const RefineRecord plain = m.refined(options).records.at(0);
  int moving = 0;
  for (Eigen::Index t = 0; t < plain.weights.rows(); ++t) {
    const double d = plain.signed_distance[static_cast<std::size_t>(t)];
    if (std::abs(d) < 1e-8) continue;
    moving += d > 0;
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(pushed.weights(t, i) / plain.weights(t, i), d > 0 ? 8 : 1, 1e-12);
  }
  EXPECT_GT(moving, 0);
}

TEST(Refine, KeepsSectionCornersInTheirPlanesWhereAskedTo) {
  const Meshed m(shapes::figure());
  RefineOptions options;
  const auto off_plane = [&](const Refinement& r) {
    double worst = 0;
    for (Eigen::Index v = 0; v < r.cage.points.rows(); ++v) {
      const int k = r.cage.vertex_section[static_cast<std::size_t>(v)];
      if (k < 0) continue;
      const SectionFrame& section = m.result.sections[static_cast<std::size_t>(k)];
      worst = std::max(worst, std::abs(section.normal.dot(Vector3(r.cage.points.row(v)) - section.center)));
    }
    return worst / m.model.diagonal;
  };
  EXPECT_GT(off_plane(m.refined(options)), 1e-3);
  options.in_plane = true;
  const Refinement r = m.refined(options);
  EXPECT_LT(off_plane(r), 1e-12);
  EXPECT_TRUE(r.converged);
}

TEST(Refine, NeverLetsATriangleTurnAwayFromItsCenterAndRaisesDampingInstead) {
  int raised = 0;
  for (const SlidBody& body : shapes::slid_bodies())
    for (const double damping : {0.01, 1e-5}) {
      SCOPED_TRACE(body.name + ", damping " + std::to_string(damping));
      const Meshed m(body);
      RefineOptions options;
      options.damping = damping;
      options.delta = 0.1;
      options.iterations = 12;
      const Refinement r = m.refined(options);
      for (const RefineRecord& record : r.records) {
        for (Eigen::Index t = 0; t < r.cage.triangles.rows(); ++t)
          EXPECT_GE(facing(r.cage, record.after, t), 0.5 * facing(r.cage, record.before, t) - 1e-12);
        for (int j = 0; j < record.before.rows(); ++j) {
          double trace = 0;
          dense_step(r.cage, record, j, trace);
          raised += record.damping[static_cast<std::size_t>(j)] > 5 * damping * trace;
        }
      }
    }
  EXPECT_GT(raised, 0) << "no triangle ever objected";
}

TEST(Refine, TakesNoMoreStepsThanAllowed) {
  const Meshed m(shapes::figure());
  for (const int iterations : {0, 1, 3}) {
    RefineOptions options;
    options.iterations = iterations;
    const Refinement r = m.refined(options);
    EXPECT_EQ(r.records.size(), static_cast<std::size_t>(iterations));
    EXPECT_FALSE(r.converged);
    if (iterations == 0) {
      EXPECT_EQ(r.cage.points, m.result.cage->points);
    }
    EXPECT_GT(r.max_signed_distance, 0);
  }
}

TEST(Refine, SaysWhichPartFallsShortOfEquation9) {
  const Meshed m(shapes::figure());
  RefineOptions options;
  options.iterations = 1;
  const Refinement r = m.refined(options);
  ASSERT_FALSE(r.converged);
  EXPECT_NE(r.shortfall.find("the vertex near ("), std::string::npos) << r.shortfall;
  EXPECT_NE(r.shortfall.find("of the diagonal from where it has to be; cut the part b"), std::string::npos)
      << r.shortfall;
  EXPECT_NE(r.shortfall.find("refine.iterations"), std::string::npos) << r.shortfall;
  EXPECT_EQ(r.shortfall.find("refine.delta"), std::string::npos) << r.shortfall;
  EXPECT_TRUE(m.refined({}).shortfall.empty());
}

TEST(Refine, SaysThatACageIsLooserThanAsked) {
  const Meshed m(shapes::limb(2));
  Cage cage = *m.result.cage;
  cage.points *= 3;
  RefineOptions options;
  options.iterations = 0;
  const Refinement r = refine(m.result.segmentation, m.result.sections, cage, m.model.diagonal, m.names, options);
  EXPECT_FALSE(r.converged);
  EXPECT_NE(r.shortfall.find("of the diagonal looser everywhere; allow more steps"), std::string::npos) << r.shortfall;
}

TEST(Refine, StopsWhenProgressSaysSo) {
  const Meshed m(shapes::figure());
  const Points before = m.result.cage->points;
  int calls = 0;
  expect_error([&] { m.refined({}, [&](double) { return ++calls < 3; }); }, ErrorCode::cancelled, {"cancelled"});
  EXPECT_EQ(calls, 3);
  EXPECT_EQ(m.result.cage->points, before);
}

TEST(Refine, RefusesACageThatFliesAwayAndNamesVertexAndSlides) {
  const Meshed m(shapes::limb(2));
  Cage cage = *m.result.cage;
  cage.points.row(5) += Eigen::RowVector3d(0, 0, 500);
  const Error error =
      expect_error([&] { refine(m.result.segmentation, m.result.sections, cage, m.model.diagonal, m.names, {}); },
                   ErrorCode::refine_diverged, {"vertex", "'slide", "cut the part"});
  EXPECT_TRUE(error.place().part);
  EXPECT_TRUE(error.place().slide);
  EXPECT_TRUE(error.place().point);
}

}  // namespace
}  // namespace cagewright
