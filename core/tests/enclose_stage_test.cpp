// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/enclose/enclose.h"
#include "core/enclose/triangle_distance.h"
#include "core/enclose/triangle_intersection.h"
#include "core/pipeline/pipeline.h"
#include "core/tests/cage_checks.h"
#include "core/tests/expect_error.h"
#include "core/tests/meshes.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

using shapes::SlidBody;

struct Refined {
  SlidBody body;
  Model model;
  PipelineResult result;
  std::vector<std::string> names;

  explicit Refined(SlidBody slid, double delta = 0, bool in_plane = false)
      : body(std::move(slid)), model(prepare_model(body.mesh)), names(checks::names_of(body.slides)) {
    PipelineOptions options;
    options.refine.delta = delta;
    options.refine.in_plane = in_plane;
    result = make_cage(model, body.slides, options);
  }
  Enclosure enclosed(const EncloseOptions& options = {}, const Progress& progress = {}) const {
    return enclose(model, result.segmentation, result.sections, *result.cage, names, options, progress);
  }
  double volume_of(const Points& points) const { return checks::volume_of({points, result.cage->triangles}); }
};

double least_distance(const IndexedMesh& model, const IndexedMesh& cage) {
  double least = std::numeric_limits<double>::infinity();
  const auto corners = [](const IndexedMesh& mesh, Eigen::Index t) -> Triangle3 {
    return {mesh.points.row(mesh.triangles(t, 0)), mesh.points.row(mesh.triangles(t, 1)),
            mesh.points.row(mesh.triangles(t, 2))};
  };
  for (Eigen::Index t = 0; t < cage.triangles.rows(); ++t)
    for (Eigen::Index k = 0; k < model.triangles.rows(); ++k)
      least = std::min(least, triangle_distance(corners(model, k), corners(cage, t)));
  return least;
}

Eigen::AlignedBox3d box_of(const Points& points) {
  Eigen::AlignedBox3d box;
  for (Eigen::Index v = 0; v < points.rows(); ++v) box.extend(Vector3(points.row(v)));
  return box;
}

// Each has a sentence of its own, and together they are the shortfall; a finding's slides are those that it names.
void expect_findings(const Enclosure& enclosure, const std::vector<std::string>& names) {
  ASSERT_FALSE(enclosure.findings.empty());
  EXPECT_EQ(sentences_of(enclosure.findings), enclosure.shortfall);
  for (const Finding& finding : enclosure.findings) {
    EXPECT_FALSE(finding.slides.empty()) << finding.sentence;
    for (int k = 0; k < static_cast<int>(names.size()); ++k)
      EXPECT_EQ(std::ranges::count(finding.slides, k), finding.sentence.find(quoted({k}, names)) != std::string::npos)
          << finding.sentence;
  }
}

TEST(Enclose, EarnsTheCertificateOnEveryBody) {
  for (const SlidBody& body : shapes::slid_bodies())
    for (const bool in_plane : {false, true}) {
      SCOPED_TRACE(body.name + (in_plane ? ", in plane" : ""));
      const Refined refined(body, 0, in_plane);
      EncloseOptions options;
      options.in_plane = in_plane;
      const Enclosure enclosure = refined.enclosed(options);
      EXPECT_TRUE(enclosure.certificate.encloses()) << enclosure.shortfall;
      EXPECT_TRUE(enclosure.shortfall.empty());
      EXPECT_TRUE(certify(body.mesh, {enclosure.points, refined.result.cage->triangles}).encloses());
      checks::expect_closed_manifold(enclosure.points, refined.result.cage->triangles, body.cage_genus);
      EXPECT_EQ(enclosure.points, Points(enclosure.points.cast<float>().cast<double>())) << "as files hold them";
    }
}

// Of all section corners: the farthest from its slide's plane, and the largest deviation from a right angle, degrees.
struct Squareness {
  double out_of_plane = 0, off_square = 0;
};
Squareness squareness_of(const Points& points, const std::vector<SectionFrame>& sections) {
  Squareness worst;
  for (std::size_t k = 0; k < sections.size(); ++k)
    for (int i = 0; i < 4; ++i) {
      const auto corner = [&](int j) -> Vector3 { return points.row(static_cast<Eigen::Index>(4 * k) + j % 4); };
      const double height = std::abs(sections[k].normal.dot(corner(i) - sections[k].center));
      worst.out_of_plane = std::max(worst.out_of_plane, height);
      const Vector3 next = (corner(i + 1) - corner(i)).normalized(), last = (corner(i + 3) - corner(i)).normalized();
      const double angle = std::acos(next.dot(last)) * 180 / std::numbers::pi;
      worst.off_square = std::max(worst.off_square, std::abs(angle - 90));
      EXPECT_GT(sections[k].normal.dot(next.cross(last)), 0) << "the section has turned over";
    }
  return worst;
}

TEST(Enclose, KeepsSectionsInTheirPlanesAndNearlySquare) {
  for (const SlidBody& body : shapes::slid_bodies()) {
    SCOPED_TRACE(body.name);
    const Refined refined(body, 0, true);
    EncloseOptions options;
    const Enclosure rounded = refined.enclosed(options);
    options.round_to_float = false;
    const Enclosure exact = refined.enclosed(options);
    const Squareness of_exact = squareness_of(exact.points, refined.result.sections);
    EXPECT_LE(of_exact.out_of_plane, 1e-12 * refined.model.diagonal);
    EXPECT_LE(of_exact.off_square, 15);
    EXPECT_NEAR(of_exact.off_square, exact.most_off_square, 1e-6);
    const Squareness of_rounded = squareness_of(rounded.points, refined.result.sections);
    EXPECT_LE(of_rounded.out_of_plane, 1e-6 * refined.model.diagonal);
    EXPECT_LE(of_rounded.off_square, 15);
  }
}

TEST(Enclose, PutsSectionsThatWereRefinedFreelyBackIntoTheirPlanes) {
  const Refined refined(shapes::fork(2), 0, false);
  EncloseOptions options;
  options.round_to_float = false;
  options.corner_angle = 5;
  ASSERT_GT(squareness_of(refined.result.cage->points, refined.result.sections).out_of_plane,
            1e-3 * refined.model.diagonal);
  const Enclosure enclosure = refined.enclosed(options);
  EXPECT_TRUE(enclosure.certificate.encloses()) << enclosure.shortfall;
  const Squareness squareness = squareness_of(enclosure.points, refined.result.sections);
  EXPECT_LE(squareness.out_of_plane, 1e-12 * refined.model.diagonal);
  EXPECT_LE(squareness.off_square, 5);
}

TEST(Enclose, GivesTheSameBitsForAnyNumberOfThreads) {
  const Refined refined(shapes::figure(), 0, true);
  EncloseOptions options;
  options.delta = 0.002;
  options.threads = 1;
  const Enclosure one = refined.enclosed(options);
  EXPECT_GT(one.pushes, 0);
  EXPECT_GT(one.sweeps, 0);
  for (const unsigned threads : {2u, 3u}) {
    options.threads = threads;
    const Enclosure many = refined.enclosed(options);
    EXPECT_EQ(one.points, many.points);
    EXPECT_EQ(one.pushes, many.pushes);
    EXPECT_EQ(one.sweeps, many.sweeps);
  }
}

// Steps of a descent part company after rounding, so a moved model's cage is another one, but of much the same volume.
TEST(Enclose, BoundsAModelThatWasMovedAsTightly) {
  const SlidBody body = shapes::fork(2);
  const Refined here(body, 0, true);
  const double ratio = here.volume_of(here.enclosed().points) / here.model.volume;
  for (unsigned seed = 0; seed < 3; ++seed) {
    const shapes::Motion motion = shapes::random_motion(seed, 20, 5);
    const Refined there(
        {body.name, shapes::moved(body.mesh, motion), shapes::moved(body.slides, motion), body.cage_genus}, 0, true);
    const Enclosure enclosure = there.enclosed();
    EXPECT_TRUE(enclosure.certificate.encloses()) << enclosure.shortfall;
    EXPECT_NEAR(there.volume_of(enclosure.points) / there.model.volume, ratio, 0.03 * ratio);
  }
}

TEST(Enclose, TakesVolumeOffAndKeepsTheCertificate) {
  for (const SlidBody& body : shapes::slid_bodies()) {
    SCOPED_TRACE(body.name);
    const Refined refined(body);
    EncloseOptions loose;
    loose.tighten = false;
    const Enclosure first = refined.enclosed(loose), tight = refined.enclosed();
    EXPECT_EQ(first.sweeps, 0);
    EXPECT_GT(tight.sweeps, 0);
    EXPECT_TRUE(first.certificate.encloses());
    EXPECT_LT(refined.volume_of(tight.points), 0.995 * refined.volume_of(first.points));
    EXPECT_GT(refined.volume_of(tight.points), refined.model.volume);
  }
}

TEST(Enclose, KeepsTheClearance) {
  for (const double delta : {0.001, 0.01, 0.05}) {
    SCOPED_TRACE(delta);
    const Refined refined(shapes::limb(3), 0, true);
    EncloseOptions options;
    options.delta = delta;
    const Enclosure enclosure = refined.enclosed(options);
    EXPECT_TRUE(enclosure.certificate.encloses()) << enclosure.shortfall;
    EXPECT_TRUE(enclosure.keeps_delta);
    const double least = least_distance(refined.body.mesh, {enclosure.points, refined.result.cage->triangles});
    EXPECT_GE(least, delta * refined.model.diagonal * (1 - 1e-9));
    EXPECT_LE(least, 1.5 * delta * refined.model.diagonal);
  }
}

TEST(Enclose, SaysWhereTheClearanceIsNotKept) {
  const Refined refined(shapes::figure(), 0, true);  // its legs are closer to each other than that
  EncloseOptions options;
  options.delta = 0.06;
  options.merge = false;
  const Enclosure enclosure = refined.enclosed(options);
  EXPECT_TRUE(enclosure.certificate.encloses()) << enclosure.shortfall;
  ASSERT_FALSE(enclosure.keeps_delta);
  const double least = least_distance(refined.body.mesh, {enclosure.points, refined.result.cage->triangles});
  EXPECT_LT(least, 0.06 * refined.model.diagonal);
  EXPECT_GE(least, enclosure.least_distance * (1 - 1e-5));
  EXPECT_NE(enclosure.shortfall.find("not with the distance asked for everywhere"), std::string::npos);
  EXPECT_NE(enclosure.shortfall.find("near '"), std::string::npos) << enclosure.shortfall;
  EXPECT_NE(enclosure.shortfall.find("in each other's way may be the limbs at '"), std::string::npos)
      << enclosure.shortfall;
  expect_findings(enclosure, refined.names);
  ASSERT_TRUE(enclosure.findings[0].place);
  EXPECT_LT(box_of(refined.body.mesh.points).exteriorDistance(*enclosure.findings[0].place),
            0.06 * refined.model.diagonal)
      << "it is where the cage is nearest";
}

TEST(Enclose, SaysWhichSlidesAreInTheWayWhereItFails) {
  const Refined refined(shapes::figure());
  Cage crossed = *refined.result.cage;  // two caps in each other's places, so that the tubes cross
  const Eigen::Index caps = 4 * static_cast<Eigen::Index>(refined.result.sections.size());
  const Points first = crossed.points.middleRows(caps, 4);
  crossed.points.middleRows(caps, 4) = crossed.points.middleRows(caps + 4, 4);
  crossed.points.middleRows(caps + 4, 4) = first;
  EncloseOptions options;
  options.merge = false;
  const Enclosure enclosure =
      enclose(refined.model, refined.result.segmentation, refined.result.sections, crossed, refined.names, options);
  ASSERT_FALSE(enclosure.certificate.encloses());
  EXPECT_NE(enclosure.shortfall.find("could not be made to enclose"), std::string::npos) << enclosure.shortfall;
  EXPECT_NE(enclosure.shortfall.find("that is near the slides '"), std::string::npos) << enclosure.shortfall;
  EXPECT_NE(enclosure.shortfall.find("': move or turn one of them"), std::string::npos) << enclosure.shortfall;
  expect_findings(enclosure, refined.names);
  ASSERT_EQ(enclosure.findings.size(), 1u);
  EXPECT_TRUE(enclosure.findings[0].place);
}

double distance_to(const IndexedMesh& model, const Vector3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index t = 0; t < model.triangles.rows(); ++t) {
    const Triangle3 triangle = triangle_of(model, t);
    least = std::min(least, (point - at_barycentric(triangle, nearest_on_triangle(point, triangle))).norm());
  }
  return least;
}

// The cage of a body, three times as large.
Enclosure enclosed_by_far(const Refined& refined) {
  Cage large = *refined.result.cage;
  const Eigen::RowVector3d middle = large.points.colwise().mean();
  large.points = (3 * (large.points.rowwise() - middle)).rowwise() + middle;
  EncloseOptions options;
  options.tighten = false;
  return enclose(refined.model, refined.result.segmentation, refined.result.sections, large, refined.names, options);
}

TEST(Enclose, SaysWhatToDoWhereTheCageIsFarTooLarge) {
  const Refined refined(shapes::fork(1));
  const Enclosure enclosure = enclosed_by_far(refined);
  ASSERT_TRUE(enclosure.certificate.encloses()) << enclosure.shortfall;
  EXPECT_NE(enclosure.shortfall.find("times as large as the model: let sections leave their slides' planes "
                                     "(enclose.in_plane=false), or add slides where it stands off, farthest near '"),
            std::string::npos)
      << enclosure.shortfall;
  expect_findings(enclosure, refined.names);
  EXPECT_TRUE(enclosure.findings.back().is_advice);
  const Enclosure tight = refined.enclosed();
  EXPECT_EQ(tight.shortfall, "");
  EXPECT_TRUE(tight.findings.empty());
}

TEST(Enclose, SaysWhereACageThatIsFarTooLargeStandsOffFarthestHoweverItIsTurned) {
  const Refined refined(shapes::fork(1));
  const Enclosure enclosure = enclosed_by_far(refined);
  const Finding& finding = enclosure.findings.back();
  ASSERT_TRUE(finding.place);
  const double off = distance_to(refined.body.mesh, *finding.place) * (1 + 1e-9);
  const Triangles& triangles = refined.result.cage->triangles;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    const Triangle3 wall = triangle_of({enclosure.points, triangles}, t);
    EXPECT_LE(distance_to(refined.body.mesh, (wall[0] + wall[1] + wall[2]) / 3), off);
    for (const Vector3& corner : wall) EXPECT_LE(distance_to(refined.body.mesh, corner), off);
  }
  const shapes::Motion motion = shapes::random_motion(3, 1, 5);
  const SlidBody& body = refined.body;
  const Enclosure turned = enclosed_by_far(
      Refined({body.name, shapes::moved(body.mesh, motion), shapes::moved(body.slides, motion), body.cage_genus}));
  EXPECT_EQ(turned.findings.back().slides, finding.slides);
  EXPECT_LT((*turned.findings.back().place - motion(*finding.place)).norm(), 1e-4 * refined.model.diagonal)
      << "the cage is rounded to floats";
}

TEST(Enclose, IsCancelledAtAnyCall) {
  const Refined refined(shapes::fork(1));
  int calls = 0;
  double last = 0;
  refined.enclosed({}, [&](double fraction) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return ++calls > 0;
  });
  EXPECT_GT(calls, 3);
  for (int stop = 1; stop <= calls; stop += 3) {
    int count = 0;
    expect_error([&] { refined.enclosed({}, [&](double) { return ++count < stop; }); }, ErrorCode::cancelled,
                 {"cancelled"});
  }
}

TEST(TriangleDistance, AgreesWithSamples) {
  Random random(8);
  const auto point = [&] { return Vector3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)); };
  for (int trial = 0; trial < 300; ++trial) {
    const Triangle3 s = {point(), point(), point()};
    const Vector3 offset = random.uniform(0, 3) * random.direction();
    const Triangle3 t = {Vector3(point() + offset), Vector3(point() + offset), Vector3(point() + offset)};
    if (triangles_meet(s, t)) continue;
    const auto at = [](const Triangle3& c, int i, int j) -> Vector3 {
      return c[0] + (c[1] - c[0]) * (i / 20.0) + (c[2] - c[0]) * (j / 20.0);
    };
    double sampled = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 231; ++a)
      for (int b = 0; b < 231; ++b) {
        const auto row = [](int index) { return static_cast<int>((std::sqrt(8.0 * index + 1) - 1) / 2); };
        const int i = row(a), j = a - i * (i + 1) / 2, k = row(b), l = b - k * (k + 1) / 2;
        sampled = std::min(sampled, (at(s, i - j, j) - at(t, k - l, l)).norm());
      }
    const double distance = triangle_distance(s, t);
    EXPECT_LE(distance, sampled + 1e-12);
    EXPECT_GE(distance, sampled - 0.15);
    EXPECT_NEAR(distance, triangle_distance(t, s), 1e-12);
  }
}

}  // namespace
}  // namespace cagewright
