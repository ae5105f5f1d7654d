// SPDX-License-Identifier: BSD-3-Clause
//
// Slides by a point alone, and what a slide would be without adding it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "plugin/tests/loaded_plugin.h"

namespace {

using namespace cagewright::plugin::test;

double norm(const double (&v)[3]) { return std::hypot(v[0], v[1], v[2]); }

cgw_slide_info fit(const Session& session, const cgw_slide_input& input) {
  cgw_slide_info info = CGW_SLIDE_INFO_INIT;
  EXPECT_EQ(api().slide_fit(session, &input, &info), CGW_OK) << session.error();
  return info;
}

void expect_same_ellipse(const cgw_slide_info& a, const cgw_slide_info& b) {
  EXPECT_EQ(a.has_ellipse, 1u);
  EXPECT_EQ(b.has_ellipse, 1u);
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(a.center[k], b.center[k], 1e-9);
    EXPECT_NEAR(a.normal[k], b.normal[k], 1e-9);
    EXPECT_NEAR(a.u[k], b.u[k], 1e-9);
    EXPECT_NEAR(a.v[k], b.v[k], 1e-9);
  }
}

// It fails with that status and with all the words in its sentence, and writes nothing.
void expect_no_fit(const Session& session, const cgw_slide_input& input, cgw_status status,
                   const std::vector<std::string>& words) {
  cgw_slide_info info = CGW_SLIDE_INFO_INIT;
  info.kind = 4711;
  EXPECT_EQ(api().slide_fit(session, &input, &info), status) << session.error();
  EXPECT_EQ(info.kind, 4711);
  EXPECT_EQ(session.error_info().code, status);
  EXPECT_EQ(session.error_info().slide, CGW_NO_ID);
  for (const std::string& word : words) EXPECT_NE(session.error().find(word), std::string::npos) << session.error();
}

TEST(AbiSlideFit, OfEveryKindIsWhatASolveGivesIt) {
  const Session session(capsule());
  const std::vector<double> points = stroke_points(0.9, 30);
  const std::vector<cgw_slide_input> inputs = {stroke("a", points), plane("b", 2.5, 1, 0.1), ellipse("c", 4, 1),
                                               point_alone("d", 5.3)};
  for (const cgw_slide_input& input : inputs) add(session, input);
  std::vector<cgw_slide_info> fitted;
  for (const cgw_slide_input& input : inputs) fitted.push_back(fit(session, input));
  ASSERT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    expect_same_ellipse(fitted[k], info(session, k));
    EXPECT_EQ(fitted[k].kind, inputs[k].kind);
    EXPECT_EQ(fitted[k].id, CGW_NO_ID);
    EXPECT_EQ(fitted[k].status, CGW_OK);
    EXPECT_STREQ(fitted[k].name, "");
    EXPECT_STREQ(fitted[k].message, "");
  }
}

TEST(AbiSlideFit, ChangesNothing) {
  const SolvedCapsule solved;
  const Cage before = cage_of(solved.session);
  fit(solved.session, point_alone("left", 2));
  EXPECT_EQ(api().slide_count(solved.session), 3u);
  EXPECT_EQ(info(solved.session, 0).status, CGW_OK);
  EXPECT_EQ(cage_of(solved.session), before);
}

TEST(AbiSlideFit, OfCentreAndNormalHasItsCentreInTheMiddleOfTheLoop) {
  const Session session(capsule());
  cgw_slide_input aside = ellipse("aside", 2.2, 0.5);
  aside.point[1] = 0.3;
  const cgw_slide_info off = fit(session, aside);
  EXPECT_NEAR(off.center[1], 0.3, 1e-12);
  cgw_slide_input again = CGW_SLIDE_INPUT_INIT;
  again.kind = CGW_SLIDE_POINT_NORMAL;
  std::copy_n(off.center, 3, again.point);
  std::copy_n(off.normal, 3, again.normal);
  const cgw_slide_info middle = fit(session, again);
  EXPECT_NEAR(middle.center[1], 0, 1e-9);
  EXPECT_NEAR(norm(middle.u), 1, 0.02);
}

TEST(AbiSlideFit, NeedsNoName) {
  const Session session(capsule());
  cgw_slide_input input = plane(nullptr, 3);
  EXPECT_EQ(fit(session, input).has_ellipse, 1u);
  expect_no_fit(session, plane(nullptr, 30), CGW_ERROR_SLIDE_MISSES_MODEL, {"the slide misses the model"});
  expect_no_fit(session, plane("", 3, 0), CGW_ERROR_SLIDE_DEGENERATE, {"the slide: its normal is zero"});
  expect_no_fit(session, plane("wrist", 30), CGW_ERROR_SLIDE_MISSES_MODEL, {"slide 'wrist' misses the model"});
  input.kind = 17;
  expect_no_fit(session, input, CGW_ERROR_INVALID_ARGUMENT, {"the slide: kind 17"});
  expect_no_fit(session, plane("\xC3\x28", 3), CGW_ERROR_INVALID_ARGUMENT, {"UTF-8"});
}

TEST(AbiSlideFit, TellsWhatIsWrongWithTheSlideAlone) {
  expect_no_fit(Session(), plane("a", 1), CGW_ERROR_NOT_READY, {"set_mesh"});
  const Session session(capsule());
  const std::vector<double> four = stroke_points(2, 4);
  expect_no_fit(session, stroke("a", four), CGW_ERROR_STROKE_TOO_SHORT, {"'a'", "longer stroke"});
  expect_no_fit(session, ellipse("a", 30, 1), CGW_ERROR_SLIDE_MISSES_MODEL, {"'a'", "does not cut it"});
  cgw_slide_input beside = ellipse("a", 3, 1);
  beside.point[1] = 5;
  expect_no_fit(session, beside, CGW_ERROR_SLIDE_NOT_ENCLOSED, {"'a'", "move the centre"});
  cgw_slide_input far = point_alone("a", 3);
  far.point[2] = 4;
  expect_no_fit(session, far, CGW_ERROR_SLIDE_MISSES_MODEL, {"'a'", "not on the model"});
  EXPECT_EQ(session.error_info().has_point, 1u);
  EXPECT_EQ(session.error_info().point[2], 4);
  far.point[2] = std::numeric_limits<double>::infinity();
  expect_no_fit(session, far, CGW_ERROR_SLIDE_NOT_FINITE, {"'a'", "its point"});
}

TEST(AbiSlideFit, WritesNoMoreThanTheCallerHasRoomFor) {
  const Session session(capsule());
  cgw_slide_info info = CGW_SLIDE_INFO_INIT;
  info.struct_size = offsetof(cgw_slide_info, u);
  info.u[0] = 4711;
  const cgw_slide_input input = plane("a", 3);
  EXPECT_EQ(api().slide_fit(session, &input, &info), CGW_OK);
  EXPECT_EQ(info.has_ellipse, 1u);
  EXPECT_EQ(info.u[0], 4711);
}

TEST(AbiSlidesByAPoint, AreAcrossTheLimbAfterASolve) {
  const Session session(capsule());
  add(session, point_alone("wrist", 2));
  EXPECT_EQ(info(session, 0).kind, CGW_SLIDE_POINT);
  EXPECT_EQ(info(session, 0).has_ellipse, 0u);
  for (int solve = 0; solve < 2; ++solve) {
    ASSERT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
    const cgw_slide_info slide = info(session, 0);
    ASSERT_EQ(slide.has_ellipse, 1u);
    EXPECT_NEAR(std::abs(slide.normal[0]), 1, 1e-4);
    EXPECT_NEAR(slide.center[0], 2, 0.01);
    EXPECT_NEAR(norm(slide.v), 1, 0.02);
  }
}

TEST(AbiSlidesByAPoint, FollowTheModelThatIsSet) {
  const Session session(capsule());
  cgw_slide_input input = point_alone("wrist", 0);
  input.point[1] = 1;
  add(session, input);
  ASSERT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
  EXPECT_GT(std::abs(info(session, 0).normal[0]), 0.99);
  Mesh upright = capsule();  // along z
  for (std::size_t k = 0; k < upright.vertices.size(); k += 3)
    std::rotate(&upright.vertices[k], &upright.vertices[k + 1], &upright.vertices[k + 3]);
  const cgw_mesh view = upright.view();
  ASSERT_EQ(api().set_mesh(session, &view), CGW_OK);
  EXPECT_EQ(info(session, 0).has_ellipse, 0u);
  ASSERT_EQ(api().solve(session, nullptr), CGW_OK) << session.error();
  EXPECT_GT(std::abs(info(session, 0).normal[2]), 0.99);
}

TEST(AbiSlidesByAPoint, ThatMissTheModelAreBlamed) {
  const Session session(capsule());
  cgw_slide_input far = point_alone("wrist", 3);
  far.point[2] = 4;
  add(session, point_alone("good", 1));
  const std::uint64_t id = add(session, far);
  EXPECT_EQ(api().solve(session, nullptr), CGW_ERROR_SLIDE_MISSES_MODEL);
  EXPECT_EQ(session.error_info().slide, id);
  EXPECT_EQ(info(session, 1).status, CGW_ERROR_SLIDE_MISSES_MODEL);
  EXPECT_STREQ(info(session, 1).message, session.error().c_str());
  EXPECT_EQ(info(session, 0).status, CGW_SLIDE_UNSOLVED);
}

}  // namespace
