// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/equation_1.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "host/validate/orientation_checks.h"
#include "host/validate/orientation_search.h"

namespace cagewright::host {
namespace {

// A section at height z, its ellipse with radii a and b turned by `angle` round z.
ObservedSection section(double z, double a, double b, double angle) {
  ObservedSection s;
  s.slide = std::string("waist");
  s.center = {0, 0, z};
  s.normal = Eigen::Vector3d::UnitZ();
  s.u = a * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0);
  s.v = b * Eigen::Vector3d(-std::sin(angle), std::cos(angle), 0);
  s.p = s.u;
  s.q = s.v;
  s.x = s.linear = Eigen::Vector2d::UnitX();
  return s;
}

// Two neighbours, the second one turned by 0.2.
ObservedCage two_sections() {
  ObservedCage seen;
  seen.lambda = 4;
  seen.sections = {section(0, 2, 1, 0), section(1, 2, 1, 0.2)};
  seen.sections[0].parts = {0, 1};
  seen.sections[1].parts = {1, 2};
  return seen;
}

TEST(Equation1, HasThePapersWeights) {
  const Equation1 equation = equation_1(two_sections());
  ASSERT_EQ(equation.ties.size(), 1u);
  EXPECT_DOUBLE_EQ(equation.ties[0].weight, 10);  // (5 + 5 - 0) / 1
  ASSERT_EQ(equation.pulls.size(), 2u);
  EXPECT_DOUBLE_EQ(equation.pulls[0].weight, 4.0 / 5);  // 4 (2 - 1)^2 / (4 + 1)
}

TEST(Equation1, IsLeastInSpaceWhereSectionsPointTheSameWay) {
  const Equation1 equation = equation_1(two_sections());
  const double alignment = 0.8 * std::pow(2 * std::sin(0.4), 2);  // of the second, turned back by 0.2
  EXPECT_NEAR(equation.at_angles({0, -0.2}), alignment, 1e-12);
  EXPECT_GT(equation.at_angles({0, 0}), alignment);
}

TEST(Equation1, TurnsTheOtherWayForAnOppositeNormal) {
  ObservedCage seen = two_sections();
  ObservedSection& other = seen.sections[1];
  other.normal = -other.normal;
  other.v = -other.v;
  // The same direction in space has the opposite angle in a frame that is seen from behind.
  EXPECT_NEAR(equation_1(seen).at_angles({0, 0.2}), 0.8 * std::pow(2 * std::sin(0.4), 2), 1e-12);
}

TEST(Equation1, PerpendicularSlidesFollowEachOthersNormals) {
  ObservedCage seen = two_sections();
  ObservedSection& other = seen.sections[1];
  other.normal = Eigen::Vector3d::UnitX();
  other.u = 2 * Eigen::Vector3d::UnitY();
  other.v = Eigen::Vector3d::UnitZ();
  const Equation1 equation = equation_1(seen);
  EXPECT_TRUE(equation.ties.empty());
  ASSERT_EQ(equation.pulls.size(), 4u);
  for (const Equation1::Pull& pull : equation.pulls)
    EXPECT_NEAR((pull.target - Eigen::Vector2d(1, 0)).norm(), 0, 1e-12);
}

TEST(OrientationSearch, FindsTheSameMinimumAsTheEnergyOnAGrid) {
  const Equation1 equation = equation_1(two_sections());
  double least = 1e9;
  const double quarter = std::numbers::pi / 2;
  for (int i = 0; i < 400; ++i)
    for (int j = 0; j < 400; ++j) least = std::min(least, equation.at_angles({quarter * i / 400, quarter * j / 400}));
  const OrientationSearch search = search_angles(equation, {0.5, 0.1}, 20);
  EXPECT_LE(search.best, least);
  EXPECT_NEAR(search.best, least, 1e-3);
  EXPECT_EQ(search.starts, 20u);
}

TEST(OrientationSearch, GivesTheSameInEveryRun) {
  const Equation1 equation = equation_1(two_sections());
  EXPECT_EQ(search_angles(equation, {0, 0}, 7).angles, search_angles(equation, {0, 0}, 7).angles);
}

TEST(OrientationChecks, NameSectionsThatAreFarFromTheLeast) {
  ObservedCage seen = two_sections();
  const std::vector<Eigen::Vector2d> linear = minimise_quadratic(equation_1(seen));
  for (std::size_t k = 0; k < 2; ++k) {
    ObservedSection& s = seen.sections[k];
    s.linear = linear[k];
    s.p = 2 * (s.u.normalized() + s.v.normalized());  // 45 degrees off
    s.q = 2 * (s.v.normalized() - s.u.normalized());
    s.x = -Eigen::Vector2d::UnitX();
  }
  EXPECT_EQ(check_orientation(seen, 5).checks.size(), 2u) << "the linear solution need not be the least";
  seen.is_over_angles = true;
  const OrientationReport report = check_orientation(seen, 5);
  ASSERT_EQ(report.checks.size(), 3u);
  EXPECT_EQ(report.checks[0].fault, "");
  EXPECT_NE(report.checks[2].fault.find("orient: equation (1) is "), std::string::npos) << report.checks[2].fault;
}

}  // namespace
}  // namespace cagewright::host
