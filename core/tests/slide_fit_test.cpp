// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "core/slide/fit_ellipse.h"
#include "core/tests/expect_error.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

Ellipse random_ellipse(Random& random) {
  Ellipse e;
  e.center = 5 * random.direction();
  e.normal = random.direction();
  const double short_radius = random.uniform(0.2, 2);
  e.u = random.uniform(1.2, 4) * short_radius * e.normal.unitOrthogonal();
  e.u = Eigen::AngleAxisd(random.uniform(0, 6), e.normal) * e.u;
  e.v = short_radius * e.normal.cross(e.u).normalized();
  return e;
}

Points arc_of(const Ellipse& e, double from, double to, int count) {
  Points points(count, 3);
  for (int i = 0; i < count; ++i) {
    const double angle = from + (to - from) * i / count;
    points.row(i) = (e.center + std::cos(angle) * e.u + std::sin(angle) * e.v).transpose();
  }
  return points;
}

// The same set of points in space, u and v up to sign.
void expect_same_ellipse(const Ellipse& found, const Ellipse& expected, double tolerance) {
  const double size = expected.u.norm();
  EXPECT_LT((found.center - expected.center).norm(), tolerance * size);
  EXPECT_LT(found.normal.cross(expected.normal).norm(), tolerance);
  EXPECT_NEAR(found.u.norm(), expected.u.norm(), tolerance * size);
  EXPECT_NEAR(found.v.norm(), expected.v.norm(), tolerance * size);
  EXPECT_LT(found.u.normalized().cross(expected.u.normalized()).norm(), 10 * tolerance);
}

void expect_well_formed(const Ellipse& e) {
  EXPECT_NEAR(e.normal.norm(), 1, 1e-12);
  EXPECT_GE(e.u.norm(), e.v.norm() * (1 - 1e-12));
  EXPECT_LT((e.u.cross(e.v).normalized() - e.normal).norm(), 1e-9);
  EXPECT_NEAR(e.u.normalized().dot(e.v.normalized()), 0, 1e-9);
}

Points column(const std::vector<Vector3>& rows) {
  Points points(static_cast<Eigen::Index>(rows.size()), 3);
  for (std::size_t i = 0; i < rows.size(); ++i) points.row(static_cast<Eigen::Index>(i)) = rows[i].transpose();
  return points;
}

// The plane of these is ambiguous, and the first point falls on the fitted circle's centre.
TEST(FitStroke, GivesTheCornersOfAnOctahedronRadii) {
  Points stroke(6, 3);
  stroke << -2, 0, 0, 0, -2, 0, 0, 0, 2, 2, 0, 0, 0, 2, 0, 0, 0, -2;
  const Ellipse ellipse = fit_stroke(stroke, "round");
  EXPECT_GT(ellipse.v.norm(), 0.5);
  EXPECT_NEAR(ellipse.u.norm(), ellipse.v.norm(), 1e-6);
}

TEST(FitStroke, RecoversEllipsesFromAllOrPartOfTheirWay) {
  Random random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Ellipse e = random_ellipse(random);
    const double start = random.uniform(0, 6), length = random.uniform(2.5, 6.2);
    const Ellipse found = fit_stroke(arc_of(e, start, start + length, 5 + random.below(60)), "slide");
    expect_same_ellipse(found, e, 1e-7);
    expect_well_formed(found);
  }
}

TEST(FitStroke, StaysNearTheEllipseUnderNoise) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Ellipse e = random_ellipse(random);
    Points stroke = arc_of(e, 0, 5.5, 80);
    for (Eigen::Index i = 0; i < stroke.rows(); ++i)
      stroke.row(i) += 0.01 * e.v.norm() * random.uniform(-1, 1) * random.direction().transpose();
    expect_same_ellipse(fit_stroke(stroke, "slide"), e, 0.03);
  }
}

TEST(FitStroke, MovesWithTheStrokeAtAnyScale) {
  Random random(3);
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const Ellipse e = random_ellipse(random);
    Points stroke = arc_of(e, 0.5, 5, 30);
    for (Eigen::Index i = 0; i < stroke.rows(); ++i) stroke.row(i) += 0.02 * random.direction().transpose();
    const double scale = std::pow(10, random.uniform(-6, 6));
    const shapes::Motion motion = shapes::random_motion(seed, scale, 3 * scale);
    const Slide moved = shapes::moved(Slide{"slide", StrokeDefinition{stroke}}, motion);
    const Ellipse here = fit_stroke(stroke, "slide");
    const Ellipse there = fit_stroke(std::get<StrokeDefinition>(moved.definition).points, "slide");
    EXPECT_LT((motion(here.center) - there.center).norm(), 1e-8 * scale);
    EXPECT_LT((scale * motion.turn(here.u) - there.u).norm(), 1e-7 * scale);
    EXPECT_LT((scale * motion.turn(here.v) - there.v).norm(), 1e-7 * scale);
    EXPECT_LT((motion.turn(here.normal) - there.normal).norm(), 1e-9);
  }
}

TEST(FitStroke, TakesTheSignsFromTheWayTheStrokeRuns) {
  Random random(4);
  for (int trial = 0; trial < 50; ++trial) {
    const Ellipse e = random_ellipse(random);
    const Points stroke = arc_of(e, 0.2, 5, 40), backward = stroke.colwise().reverse();
    const Ellipse there = fit_stroke(stroke, "slide"), back = fit_stroke(backward, "slide");
    EXPECT_GT(there.normal.dot(e.normal), 0.99) << "counter-clockwise about the normal";
    EXPECT_LT(back.normal.dot(e.normal), -0.99);
    EXPECT_GE(there.u.dot(Vector3(stroke.row(0)) - there.center), 0);
    EXPECT_GE(back.u.dot(Vector3(backward.row(0)) - back.center), 0);
  }
}

TEST(FitStroke, RefusesTooFewDistinctPoints) {
  const Vector3 p(1, 2, 3);
  const Points four = column({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {1, 0, 0}});
  expect_error([&] { fit_stroke(four, "left wrist"); }, ErrorCode::stroke_too_short,
               {"'left wrist'", "4 distinct points", "needs 5", "longer"});
  expect_error([&] { fit_stroke(Points(0, 3), "empty"); }, ErrorCode::stroke_too_short, {"'empty'", "0 distinct"});
  expect_error([&] { fit_stroke(column({p, p, p, p, p, p}), "dot"); }, ErrorCode::stroke_too_short, {"'dot'"});
}

TEST(FitStroke, RefusesAStraightLine) {
  Random random(5);
  for (int trial = 0; trial < 30; ++trial) {
    const Vector3 from = 3 * random.direction(), along = random.direction();
    std::vector<Vector3> line;
    for (int i = 0; i < 12; ++i) line.push_back(from + i * 0.1 * along);
    expect_error([&] { fit_stroke(column(line), "knee"); }, ErrorCode::stroke_collinear, {"'knee'", "straight line"});
  }
}

TEST(FitStroke, RefusesWhatNoEllipseFits) {
  std::vector<Vector3> branch, nearly_straight, parabola;
  for (int i = -20; i <= 20; ++i) {
    const double t = 0.1 * i;
    branch.emplace_back(std::cosh(t), std::sinh(t), 0);
    nearly_straight.emplace_back(t, 1e-4 * t * t, 0);
    parabola.emplace_back(t, t * t, 0);
  }
  for (const auto& points : {branch, nearly_straight, parabola}) {
    try {
      const Ellipse e = fit_stroke(column(points), "neck");
      // The direct fit always finds some ellipse; it may be handed out only where it is a plausible one.
      EXPECT_LT(e.u.norm(), 50 * 4);
      expect_well_formed(e);
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::stroke_no_ellipse) << error.what();
      EXPECT_NE(std::string(error.what()).find("'neck'"), std::string::npos);
    }
  }
  expect_error([&] { fit_stroke(column(nearly_straight), "neck"); }, ErrorCode::stroke_no_ellipse,
               {"'neck'", "no ellipse fits", "farther round"});
}

TEST(FitStroke, NamesThePointThatIsNotFinite) {
  Random random(6);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    Points stroke = arc_of(random_ellipse(random), 0, 6, 20);
    stroke(13, 1) = bad;
    const Error error =
        expect_error([&] { fit_stroke(stroke, "tail"); }, ErrorCode::slide_not_finite, {"'tail'", "point 13"});
    EXPECT_EQ(error.place().element, 13u);
  }
}

TEST(FitLoop, GivesThePolygonOfAnEllipseItsRadiiWhicheverWayItRuns) {
  Random random(7);
  for (int trial = 0; trial < 50; ++trial) {
    const Ellipse e = random_ellipse(random);
    const Points loop = arc_of(e, 0, 2 * M_PI, 720), reversed = loop.colwise().reverse();
    const Ellipse found = fit_loop(loop, e.center + 3 * e.u, e.normal, "s");
    expect_same_ellipse(found, e, 1e-4);  // the polygon is a little smaller
    EXPECT_LT(found.u.norm(), e.u.norm());
    expect_well_formed(found);
    expect_same_ellipse(fit_loop(reversed, e.center, e.normal, "s"), found, 1e-10);
  }
}

TEST(FitLoop, HasTheMomentsOfARectangle) {
  const Points loop = column({{-3, -1, 2}, {3, -1, 2}, {3, 1, 2}, {-3, 1, 2}});
  const Ellipse e = fit_loop(loop, {0, 0, 2}, {0, 0, 1}, "s");  // variance a^2/3 of a side 2a, r^2/4 of an ellipse
  EXPECT_NEAR(e.u.norm(), 2 * 3 / std::sqrt(3), 1e-12);
  EXPECT_NEAR(e.v.norm(), 2 * 1 / std::sqrt(3), 1e-12);
  EXPECT_LT((e.center - Vector3(0, 0, 2)).norm(), 1e-12);
}

TEST(FitLoop, RefusesALoopWithoutArea) {
  const Points loop = column({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0}});
  expect_error([&] { fit_loop(loop, {0, 0, 0}, {0, 0, 1}, "toe"); }, ErrorCode::slide_degenerate, {"'toe'", "no area"});
}

TEST(FromRadii, GivesThePrincipalRadiiOfConjugateOnes) {
  Random random(8);
  for (int trial = 0; trial < 100; ++trial) {
    const Ellipse e = random_ellipse(random);
    const double a = random.uniform(0, 6);
    const EllipseDefinition conjugate{e.center, std::cos(a) * e.u + std::sin(a) * e.v,
                                      -std::sin(a) * e.u + std::cos(a) * e.v};
    const Ellipse found = from_radii(conjugate, "s");
    expect_same_ellipse(found, e, 1e-12);
    EXPECT_GT(found.normal.dot(e.normal), 0.999);
    expect_well_formed(found);
  }
}

TEST(FromRadii, RefusesRadiiThatSpanNoPlane) {
  for (const EllipseDefinition& bad :
       {EllipseDefinition{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, EllipseDefinition{{0, 0, 0}, {0, 0, 0}, {1, 0, 0}},
        EllipseDefinition{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}})
    expect_error([&] { from_radii(bad, "hip"); }, ErrorCode::slide_degenerate, {"'hip'", "zero or parallel"});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  expect_error(
      [&] {
        from_radii({{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}}, "hip");
      },
      ErrorCode::slide_not_finite, {"'hip'", "center"});
  expect_error(
      [&] {
        from_radii({{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}, "hip");
      },
      ErrorCode::slide_not_finite, {"'hip'", "its v"});
}

TEST(CheckDefinition, RefusesAPlaneWithoutNormalOrPoint) {
  expect_error(
      [] {
        check_definition({"ear", PointNormalDefinition{{0, 0, 0}, {0, 0, 0}}});
      },
      ErrorCode::slide_degenerate, {"'ear'", "normal is zero"});
  const double infinity = std::numeric_limits<double>::infinity();
  expect_error(
      [=] {
        check_definition({"ear", PointNormalDefinition{{0, 0, infinity}, {0, 0, 1}}});
      },
      ErrorCode::slide_not_finite, {"'ear'", "point"});
  EXPECT_NO_THROW(check_definition({"ear", PointNormalDefinition{{0, 0, 0}, {0, 0, 1e-300}}}));
}

}  // namespace
}  // namespace cagewright
