// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/enclose/enclose.h"
#include "core/enclose/triangle_distance.h"
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
      if (!in_plane) continue;
      const auto& sections = refined.result.cage->vertex_section;
      for (std::size_t v = 0; v < sections.size(); ++v) {
        if (sections[v] < 0) continue;
        const SectionFrame& section = refined.result.sections[static_cast<std::size_t>(sections[v])];
        const Vector3 corner = enclosure.points.row(static_cast<Eigen::Index>(v));
        EXPECT_LT(std::abs(section.normal.dot(corner - section.center)), 1e-9 * refined.model.diagonal);
      }
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
  for (const double delta : {0.001, 0.01}) {
    const Refined refined(shapes::limb(3), delta);
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

TEST(Enclose, SaysWhichSlidesAreInTheWayWhereItFails) {
  const Refined refined(shapes::figure());
  Cage crossed = *refined.result.cage;  // two sections in each other's places
  const Points first = crossed.points.topRows(4);
  crossed.points.topRows(4) = crossed.points.middleRows(12, 4);
  crossed.points.middleRows(12, 4) = first;
  const Enclosure enclosure =
      enclose(refined.model, refined.result.segmentation, refined.result.sections, crossed, refined.names, {});
  ASSERT_FALSE(enclosure.certificate.encloses());
  EXPECT_NE(enclosure.shortfall.find("could not be made to enclose"), std::string::npos) << enclosure.shortfall;
  EXPECT_NE(enclosure.shortfall.find("move or turn one of the slides '"), std::string::npos) << enclosure.shortfall;
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
