// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plugin/tests/loaded_plugin.h"

namespace {

using namespace cagewright::plugin::test;

double norm(const double (&v)[3]) { return std::hypot(v[0], v[1], v[2]); }

// Adding it fails with that status, a sentence with the name in it, and no slide more.
void expect_refused(const cgw_slide_input& input, cgw_status status) {
  const Session session(capsule());
  add(session, plane("taken", 3));
  std::uint64_t id = 4711;
  EXPECT_EQ(api().slide_add(session, &input, &id), status) << session.error();
  EXPECT_EQ(id, 4711u);
  EXPECT_EQ(api().slide_count(session), 1u);
  EXPECT_NE(session.error().find(input.name), std::string::npos) << session.error();
  EXPECT_EQ(session.error_info().code, status);
}

TEST(AbiSlides, AreListedInTheOrderInWhichTheyWereAdded) {
  const Session session;
  const std::uint64_t b = add(session, plane("b", 1));
  const std::uint64_t a = add(session, ellipse("a", 2, 1));
  EXPECT_NE(a, b);
  ASSERT_EQ(api().slide_count(session), 2u);
  EXPECT_EQ(info(session, 0).id, b);
  EXPECT_STREQ(info(session, 0).name, "b");
  EXPECT_EQ(info(session, 0).kind, CGW_SLIDE_POINT_NORMAL);
  EXPECT_EQ(info(session, 1).id, a);
  EXPECT_EQ(info(session, 1).kind, CGW_SLIDE_ELLIPSE);
  EXPECT_EQ(info(session, 1).status, CGW_SLIDE_UNSOLVED);
  EXPECT_STREQ(info(session, 1).message, "");
}

TEST(AbiSlides, NeverGetAnIdThatAnotherHad) {
  const Session session;
  const std::uint64_t first = add(session, plane("a", 1));
  ASSERT_EQ(api().slide_remove(session, first), CGW_OK);
  EXPECT_NE(add(session, plane("a", 1)), first);
}

TEST(AbiSlides, KeepIdAndPlaceWhenChanged) {
  const Session session;
  const std::uint64_t a = add(session, plane("a", 1));
  add(session, plane("b", 2));
  const cgw_slide_input input = ellipse("renamed", 1.5, 1);
  ASSERT_EQ(api().slide_change(session, a, &input), CGW_OK);
  EXPECT_EQ(info(session, 0).id, a);
  EXPECT_STREQ(info(session, 0).name, "renamed");
  EXPECT_EQ(info(session, 0).kind, CGW_SLIDE_ELLIPSE);
}

TEST(AbiSlides, KeepTheirNameWhereOthersComeAndGo) {
  const Session session;
  const std::uint64_t other = add(session, plane("other", 1));
  add(session, plane("kept", 2));
  const char* name = info(session, 1).name;
  for (int k = 0; k < 100; ++k) add(session, plane(("slide " + std::to_string(k)).c_str(), 3));
  ASSERT_EQ(api().slide_remove(session, other), CGW_OK);
  EXPECT_EQ(info(session, 0).name, name);
  EXPECT_STREQ(name, "kept");
}

TEST(AbiSlides, OfStrokesAndEllipsesKnowTheirEllipseAtOnce) {
  const Session session;
  const std::vector<double> points = stroke_points(2, 30);
  add(session, stroke("stroke", points));
  add(session, ellipse("ellipse", 4, 1));
  add(session, plane("plane", 6));
  const cgw_slide_info drawn = info(session, 0);
  ASSERT_EQ(drawn.has_ellipse, 1u);
  EXPECT_NEAR(drawn.center[0], 2, 1e-9);
  EXPECT_NEAR(norm(drawn.u), 1, 1e-6);
  EXPECT_NEAR(std::abs(drawn.normal[0]), 1, 1e-9);
  const cgw_slide_info given = info(session, 1);
  ASSERT_EQ(given.has_ellipse, 1u);
  EXPECT_NEAR(norm(given.u), 1.2, 1e-12);
  EXPECT_NEAR(norm(given.v), 1, 1e-12);
  EXPECT_EQ(info(session, 2).has_ellipse, 0u);
}

TEST(AbiSlides, OfAPointKnowTheirEllipseAfterASolve) {
  const SolvedCapsule solved;
  for (std::uint64_t k = 0; k < 3; ++k) {
    const cgw_slide_info slide = info(solved.session, k);
    EXPECT_EQ(slide.status, CGW_OK);
    ASSERT_EQ(slide.has_ellipse, 1u);
    EXPECT_NEAR(slide.center[1], 0, 1e-6);
    EXPECT_NEAR(norm(slide.u), 1, 0.05);
  }
  const Mesh other = torus();
  const cgw_mesh view = other.view();
  ASSERT_EQ(api().set_mesh(solved.session, &view), CGW_OK);
  EXPECT_EQ(info(solved.session, 0).has_ellipse, 0u) << "of another model";
  EXPECT_EQ(info(solved.session, 0).status, CGW_SLIDE_UNSOLVED);
}

TEST(AbiSlides, WithoutANameOfTheirOwnAreRefused) {
  const Session session;
  const std::uint64_t taken = add(session, plane("wrist", 1));
  std::uint64_t id = 0;
  cgw_slide_input input = plane("", 2);
  EXPECT_EQ(api().slide_add(session, &input, &id), CGW_ERROR_SLIDE_NAME);
  EXPECT_NE(session.error().find("empty"), std::string::npos) << session.error();
  input = plane("wrist", 2);
  EXPECT_EQ(api().slide_add(session, &input, &id), CGW_ERROR_SLIDE_NAME);
  EXPECT_NE(session.error().find("'wrist'"), std::string::npos) << session.error();
  EXPECT_EQ(session.error_info().other_slide, taken);
  const std::uint64_t knee = add(session, plane("knee", 2));
  EXPECT_EQ(api().slide_change(session, knee, &input), CGW_ERROR_SLIDE_NAME);
  EXPECT_EQ(session.error_info().slide, knee);
  EXPECT_STREQ(info(session, 1).name, "knee");
  EXPECT_EQ(api().slide_change(session, taken, &input), CGW_OK) << "its own name is not taken by another";
}

TEST(AbiSlides, ThatAreUnknownAreNamedByTheirId) {
  const Session session;
  const cgw_slide_input input = plane("a", 1);
  EXPECT_EQ(api().slide_change(session, 4711, &input), CGW_ERROR_UNKNOWN_SLIDE);
  EXPECT_NE(session.error().find("4711"), std::string::npos) << session.error();
  EXPECT_EQ(session.error_info().slide, 4711u);
  EXPECT_EQ(api().slide_remove(session, 0), CGW_ERROR_UNKNOWN_SLIDE);
}

TEST(AbiSlides, OfBadStrokesAreRefused) {
  const std::vector<double> four = stroke_points(2, 4);
  expect_refused(stroke("short one", four), CGW_ERROR_STROKE_TOO_SHORT);
  expect_refused(stroke("empty one", {}), CGW_ERROR_STROKE_TOO_SHORT);
  std::vector<double> line, zigzag, holed = stroke_points(2, 20);
  for (int k = 0; k < 10; ++k) {
    line.insert(line.end(), {2, 0.1 * k, 0.2 * k});
    zigzag.insert(zigzag.end(), {2, 0.1 * k, 0.1 * (k % 2)});
  }
  holed[31] = std::numeric_limits<double>::quiet_NaN();
  expect_refused(stroke("straight one", line), CGW_ERROR_STROKE_COLLINEAR);
  expect_refused(stroke("zigzag one", zigzag), CGW_ERROR_STROKE_NO_ELLIPSE);
  expect_refused(stroke("holed one", holed), CGW_ERROR_SLIDE_NOT_FINITE);
}

TEST(AbiSlides, OfBadRadiiOrNormalsAreRefused) {
  cgw_slide_input input = ellipse("flat one", 2, 1);
  input.u[1] = 0;
  expect_refused(input, CGW_ERROR_SLIDE_DEGENERATE);
  input = ellipse("parallel one", 2, 1);
  input.v[1] = input.u[1] = 1;
  input.v[2] = 0;
  expect_refused(input, CGW_ERROR_SLIDE_DEGENERATE);
  expect_refused(plane("normal one", 2, 0), CGW_ERROR_SLIDE_DEGENERATE);
  expect_refused(plane("far one", std::numeric_limits<double>::infinity()), CGW_ERROR_SLIDE_NOT_FINITE);
}

TEST(AbiSlides, StayAsTheyWereWhereAChangeFails) {
  const SolvedCapsule solved;
  const cgw_slide_input input = plane("left", 2, 0);
  EXPECT_EQ(api().slide_change(solved.session, solved.left, &input), CGW_ERROR_SLIDE_DEGENERATE);
  EXPECT_EQ(solved.session.error_info().slide, solved.left);
  EXPECT_EQ(info(solved.session, 0).status, CGW_OK);
  EXPECT_EQ(info(solved.session, 0).has_ellipse, 1u);
}

}  // namespace
