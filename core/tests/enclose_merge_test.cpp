// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/enclose/triangle_distance.h"
#include "core/measure/section_quality.h"
#include "core/pipeline/pipeline.h"
#include "core/tests/cage_checks.h"
#include "core/tests/expect_error.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

constexpr double gap = 1e-6;  // between the legs: no wall fits there

shapes::SlidBody close_legs() { return shapes::close_legs(gap); }

PipelineResult made(const shapes::SlidBody& body, const EncloseOptions& enclose, const StageProgress& progress = {}) {
  PipelineOptions options;
  options.refine.in_plane = enclose.in_plane;
  options.enclose = enclose;
  options.last_stage = Stage::enclose;
  return make_cage(prepare_model(body.mesh), body.slides, options, progress);
}

double least_distance(const IndexedMesh& model, const Cage& cage) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index t = 0; t < cage.triangles.rows(); ++t)
    for (Eigen::Index k = 0; k < model.triangles.rows(); ++k)
      least = std::min(least, triangle_distance(triangle_of(model, k), triangle_of({cage.points, cage.triangles}, t)));
  return least;
}

void expect_sound(const Cage& cage, std::size_t slides) {
  ASSERT_EQ(cage.vertex_section.size(), static_cast<std::size_t>(cage.points.rows()));
  ASSERT_EQ(cage.triangle_part.size(), static_cast<std::size_t>(cage.triangles.rows()));
  ASSERT_EQ(cage.section_vertices.size(), slides);
  for (std::size_t k = 0; k < slides; ++k)
    for (const int row : cage.section_vertices[k]) {
      if (row < 0) continue;
      EXPECT_EQ(cage.vertex_section[static_cast<std::size_t>(row)], static_cast<int>(k));
    }
}

// The case of the paper's figure 18.
TEST(Merge, EnclosesLegsThatNearlyTouchAndNothingElseDoes) {
  const shapes::SlidBody body = close_legs();
  for (const bool in_plane : {true, false}) {
    SCOPED_TRACE(in_plane);
    EncloseOptions options;
    options.in_plane = in_plane;
    options.merge = false;
    const PipelineResult apart = made(body, options);
    EXPECT_FALSE(apart.enclosure->certificate.encloses());
    EXPECT_FALSE(apart.enclosure->merged);
    options.merge = true;
    const PipelineResult one = made(body, options);
    ASSERT_TRUE(one.enclosure->certificate.encloses()) << one.enclosure->shortfall;
    ASSERT_TRUE(one.enclosure->merged);
    EXPECT_TRUE(certify(body.mesh, {one.cage->points, one.cage->triangles}).encloses());
    EXPECT_EQ(one.cage->points, one.enclosure->points);
    expect_sound(*one.cage, body.slides.size());
    EXPECT_FALSE(one.enclosure->sections_merged.empty());
    EXPECT_LE(one.cage->triangles.rows(), apart.cage->triangles.rows() * 3 / 2);
    EXPECT_NE(one.enclosure->shortfall.find("the cages of the limbs at '"), std::string::npos);
    EXPECT_NE(one.enclosure->shortfall.find("run into each other and were made one there"), std::string::npos)
        << one.enclosure->shortfall;
    const Finding& finding = one.enclosure->findings.back();
    EXPECT_GE(finding.slides.size(), 2u);
    EXPECT_TRUE(finding.is_advice);
    EXPECT_NE(finding.sentence.find(", which took away the section"), std::string::npos) << finding.sentence;
    for (const int k : one.enclosure->sections_merged)
      EXPECT_EQ(std::ranges::count(finding.slides, k), 1) << "a slide that has lost its section is named";
  }
}

TEST(Merge, KeepsSectionsThatItLeavesWhole) {
  shapes::SlidBody body = close_legs();
  const PipelineResult result = made(body, {});
  const std::vector<PlacedSection> sections = place_sections(result.sections, *result.cage);
  const SectionQuality quality = measure_sections(sections, result.neighbours, 1);
  const auto& merged = result.enclosure->sections_merged;
  for (int k = 0; k < static_cast<int>(body.slides.size()); ++k) {
    const bool is_merged = std::find(merged.begin(), merged.end(), k) != merged.end();
    EXPECT_EQ(is_merged, !result.cage->has_whole(k));
    EXPECT_EQ(is_merged, std::isnan(quality.squareness[static_cast<std::size_t>(k)]));
  }
  EXPECT_FALSE(std::isnan(quality.worst_squareness()));
}

TEST(Merge, IsNotNeededWhereLimbsKeepApart) {
  for (const shapes::SlidBody& body : shapes::slid_bodies()) {
    SCOPED_TRACE(body.name);
    EncloseOptions options;
    const PipelineResult with = made(body, options);
    options.merge = false;
    const PipelineResult without = made(body, options);
    EXPECT_FALSE(with.enclosure->merged);
    EXPECT_EQ(with.cage->points, without.cage->points);
    EXPECT_EQ(with.cage->triangles, without.cage->triangles);
  }
}

TEST(Merge, KeepsAClearanceWiderThanTheGapBetweenLimbs) {
  const shapes::SlidBody body = shapes::figure();
  const double diagonal = prepare_model(body.mesh).diagonal;
  for (const double delta : {0.05, 0.08}) {
    SCOPED_TRACE(delta);
    EncloseOptions options;
    options.delta = delta;
    const PipelineResult result = made(body, options);
    ASSERT_TRUE(result.enclosure->certificate.encloses()) << result.enclosure->shortfall;
    EXPECT_TRUE(result.enclosure->keeps_delta) << result.enclosure->shortfall;
    const double least = least_distance(body.mesh, *result.cage);
    EXPECT_GE(least, delta * diagonal * (1 - 1e-6));
    EXPECT_LE(least, 1.5 * delta * diagonal);
  }
}

TEST(Merge, GivesTheSameBitsForAnyNumberOfThreads) {
  EncloseOptions options;
  options.threads = 1;
  const PipelineResult one = made(close_legs(), options);
  options.threads = 3;
  const PipelineResult many = made(close_legs(), options);
  EXPECT_EQ(one.cage->points, many.cage->points);
  EXPECT_EQ(one.cage->triangles, many.cage->triangles);
}

TEST(Merge, IsCancelledAtAnyCall) {
  int calls = 0;
  double last = 0;
  made(close_legs(), {}, [&](double fraction, Stage) {
    EXPECT_GE(fraction, last);
    last = fraction;
    return ++calls > 0;
  });
  for (int stop = calls; stop > 0; stop -= std::max(1, calls / 5)) {
    int count = 0;
    expect_error([&] { made(close_legs(), {}, [&](double, Stage) { return ++count < stop; }); }, ErrorCode::cancelled,
                 {"cancelled"});
  }
}

}  // namespace
}  // namespace cagewright
