// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/measure/section_quality.h"
#include "core/meshing/meshing.h"
#include "core/pipeline/pipeline.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

constexpr double pi = std::numbers::pi;

// A rectangle round `center` in the plane of `normal`, its first axis `turn` from `axis` (projected) round the normal.
PlacedSection rectangle(const Vector3& center, const Vector3& normal, const Vector3& axis, double turn = 0,
                        double width = 2, double height = 1) {
  const Vector3 n = normal.normalized(), e1 = (axis - n.dot(axis) * n).normalized(), e2 = n.cross(e1);
  const Vector3 p = width * (std::cos(turn) * e1 + std::sin(turn) * e2);
  const Vector3 q = height * (std::cos(turn) * e2 - std::sin(turn) * e1);
  return {{center + p + q, center - p + q, center - p - q, center + p - q}, center, n};
}

double twist_of(const PlacedSection& k, const PlacedSection& h) {
  return measure_sections({k, h}, {{0, 1}}, 1).twist.at(0);
}

PlacedSection moved(const PlacedSection& section, const shapes::Motion& motion) {
  PlacedSection result{{}, motion(section.center), motion.turn(section.normal)};
  for (std::size_t i = 0; i < 4; ++i) result.corners[i] = motion(section.corners[i]);
  return result;
}

PlacedSection random_section(Random& random) {
  PlacedSection section =
      rectangle(Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)), random.direction(),
                random.direction(), 0, random.uniform(0.5, 2), random.uniform(0.5, 2));
  for (Vector3& corner : section.corners) corner += 0.1 * random.direction();
  return section;
}

TEST(SectionQuality, IsPerfectForRectanglesThatFollowEachOther) {
  const std::vector<PlacedSection> sections = {rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}),
                                               rectangle({0, 0, 1}, {0, 0, -1}, {0, 1, 0}),
                                               rectangle({2, 0, 2}, {1, 0, 0}, {0, 0, 1})};
  const SectionQuality quality = measure_sections(sections, {{0, 1}, {0, 2}, {1, 2}}, 10);
  EXPECT_EQ(quality.squareness.size(), 3u);
  EXPECT_EQ(quality.twist.size(), 3u);
  EXPECT_LT(quality.worst_squareness(), 1e-14);
  EXPECT_LT(quality.worst_planarity(), 1e-14);
  EXPECT_LT(quality.worst_twist(), 1e-14);
  EXPECT_EQ(measure_sections({}, {}, 1).worst_twist(), 0);
}

TEST(SectionQuality, SeesTheTwistOfATurnedSection) {
  for (const double turn : {0.0, 0.1, 0.5, pi / 4, 0.9, pi / 2, 1.7, 3.0, -0.2}) {
    const double expected = std::abs(std::remainder(turn, pi / 2));
    for (const double side : {1.0, -1.0}) {  // which way the second normal points does not matter
      EXPECT_NEAR(twist_of(rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}),
                           rectangle({0, 0, 3}, {0, 0, side}, {1, 0, 0}, turn, 1, 1)),
                  expected, 1e-12);
      // Round a bend of 0.6: the minimal rotation carries the axis of the bend, and what is turned from it, along.
      const Vector3 bent(std::sin(0.6), 0, std::cos(0.6));
      EXPECT_NEAR(twist_of(rectangle({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 0.3),
                           rectangle({0, 0, 3}, side * bent, {0, 1, 0}, side * (0.3 + turn))),
                  expected, 1e-12);
    }
  }
}

TEST(SectionQuality, ComparesPerpendicularSectionsWithTheBend) {
  for (const double turn : {0.0, 0.1, 0.7, 1.4}) {
    const PlacedSection straight = rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
    const PlacedSection other = rectangle({2, 0, 2}, {1, 0, 0.3}, {0, 1, 0}, turn);
    EXPECT_NEAR(twist_of(straight, other), std::abs(std::remainder(turn, pi / 2)), 1e-12);
    EXPECT_NEAR(twist_of(other, straight), twist_of(straight, other), 1e-12);
    const PlacedSection as_much = rectangle({0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 0.3),
                        mirrored = rectangle({2, 0, 2}, {1, 0, 0}, {0, 1, 0}, -0.3);
    EXPECT_NEAR(twist_of(as_much, mirrored), 0.3, 1e-12) << "both are off the bend";
  }
}

// Equation (1) without alignment, as core/orient evaluates it, is w (2 sin 2t)^2 for one pair.
TEST(SectionQuality, AgreesWithTheEnergyOfThePaper) {
  Random random(3);
  int perpendicular = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Ellipse> slides(2);
    std::vector<double> angles;
    std::vector<PlacedSection> sections;
    for (Ellipse& slide : slides) {
      slide.center = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
      slide.normal = random.direction();
      slide.u = slide.normal.unitOrthogonal();
      slide.v = slide.normal.cross(slide.u);
      angles.push_back(random.uniform(-pi, pi));
      sections.push_back(rectangle(slide.center, slide.normal, slide.u, angles.back()));
    }
    const double weight = 4 / (slides[0].center - slides[1].center).squaredNorm();
    const double energy = orientation_energy(slides, {{0, 1}}, 0, angles);
    const double term = std::pow(2 * std::sin(2 * twist_of(sections[0], sections[1])), 2) * weight;
    const double cosine = std::abs(slides[0].normal.dot(slides[1].normal));
    if (cosine <= std::sqrt(0.5)) {  // (2) is taken both ways: the larger term, and the other
      ++perpendicular;
      EXPECT_LE(term, energy * (1 + 1e-9));
      EXPECT_GE(2 * term, energy * (1 - 1e-9));
    } else {
      EXPECT_NEAR(term, energy, 1e-9 * weight);
    }
  }
  EXPECT_GT(perpendicular, 50);
  EXPECT_LT(perpendicular, 250);
}

TEST(SectionQuality, SeesHowFarACornerIsFromARightAngle) {
  PlacedSection section = rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1, 1);
  const double shear = 0.2;
  section.corners[0].x() += 2 * std::tan(shear);
  section.corners[1].x() += 2 * std::tan(shear);
  EXPECT_NEAR(measure_sections({section}, {}, 1).worst_squareness(), shear, 1e-12);
  EXPECT_NEAR(measure_sections({rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 5, 0.01)}, {}, 1).worst_squareness(), 0,
              1e-12);
}

TEST(SectionQuality, SeesACornerThatTurnsInward) {
  PlacedSection section = rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 0, 1, 1);
  section.corners[0] = {-0.5, -0.5, 0};  // past the diagonal between its neighbours
  const Vector3 to_next(-0.5, 1.5, 0), to_previous(1.5, -0.5, 0);
  const double between = std::acos(to_next.dot(to_previous) / to_next.squaredNorm());
  EXPECT_NEAR(measure_sections({section}, {}, 1).worst_squareness(), 2 * pi - between - pi / 2, 1e-12);
  section.corners[0] = section.corners[1];
  EXPECT_NEAR(measure_sections({section}, {}, 1).worst_squareness(), pi / 2, 1e-12);
}

TEST(SectionQuality, SeesACornerOutOfItsPlane) {
  PlacedSection section = rectangle({1, 2, 3}, {0, 0, 1}, {1, 0, 0});
  section.corners[2].z() -= 0.5;
  const SectionQuality quality = measure_sections({section, rectangle({0, 0, 0}, {0, 0, 1}, {1, 0, 0})}, {}, 20);
  EXPECT_NEAR(quality.planarity[0], 0.025, 1e-15);
  EXPECT_EQ(quality.planarity[1], 0);
  EXPECT_EQ(quality.worst_planarity(), quality.planarity[0]);
  EXPECT_GT(quality.squareness[0], 0);
}

TEST(SectionQuality, StaysUnderMotionsAndScales) {
  Random random(4);
  for (unsigned seed = 1; seed <= 30; ++seed) {
    const std::vector<PlacedSection> here = {random_section(random), random_section(random), random_section(random)};
    const shapes::Motion motion = shapes::random_motion(seed, random.uniform(0.1, 10), 10);
    std::vector<PlacedSection> there;
    for (const PlacedSection& section : here) there.push_back(moved(section, motion));
    const NeighbourPairs pairs = {{0, 1}, {0, 2}, {1, 2}};
    const SectionQuality a = measure_sections(here, pairs, 5), b = measure_sections(there, pairs, 5 * motion.scale);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(a.squareness[i], b.squareness[i], 1e-11);
      EXPECT_NEAR(a.planarity[i], b.planarity[i], 1e-12);
      EXPECT_NEAR(a.twist[i], b.twist[i], 1e-10);
    }
  }
}

TEST(SectionQuality, DoesNotDependOnWhichCornerIsTheFirst) {
  Random random(5);
  for (int trial = 0; trial < 30; ++trial) {
    const PlacedSection other = random_section(random);
    PlacedSection section = random_section(random);
    const SectionQuality plain = measure_sections({section, other}, {{0, 1}}, 1);
    std::rotate(section.corners.begin(), section.corners.begin() + 1, section.corners.end());
    const SectionQuality turned = measure_sections({section, other}, {{0, 1}}, 1);
    EXPECT_NEAR(plain.squareness[0], turned.squareness[0], 1e-13);
    EXPECT_NEAR(plain.twist[0], turned.twist[0], 1e-12);
  }
}

TEST(SectionQuality, FindsTheSectionsOfACageAsMeshed) {
  for (const shapes::SlidBody& body : shapes::slid_bodies()) {
    const Model model = prepare_model(body.mesh);
    PipelineOptions options;
    options.last_stage = Stage::meshing;
    const PipelineResult result = make_cage(model, body.slides, options);
    const SectionQuality quality = measure_sections(place_sections(result.sections, *result.cage), {}, model.diagonal);
    EXPECT_EQ(quality.squareness.size(), body.slides.size());
    EXPECT_LT(quality.worst_squareness(), 1e-12);
    EXPECT_LT(quality.worst_planarity(), 1e-14);
  }
}

}  // namespace
}  // namespace cagewright
