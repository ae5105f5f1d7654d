// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "core/pipeline/pipeline.h"
#include "core/tests/cage_checks.h"
#include "core/tests/expect_error.h"
#include "core/tests/meshes.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

using shapes::Motion;
using shapes::SlidBody;

PipelineResult cage_of(const IndexedMesh& mesh, const std::vector<Slide>& slides, const PipelineOptions& options = {}) {
  return make_cage(prepare_model(mesh), slides, options);
}

// The same slides as ellipses and as strokes five sixths of the way round their loops.
std::vector<Slide> as_ellipses(const PipelineResult& result, std::vector<Slide> slides) {
  for (std::size_t k = 0; k < slides.size(); ++k) {
    const Ellipse& e = result.segmentation.ellipses[k];
    slides[k].definition = EllipseDefinition{e.center, 0.8 * e.u + 0.6 * e.v, -0.6 * e.u + 0.8 * e.v};
  }
  return slides;
}
std::vector<Slide> as_strokes(const PipelineResult& result, std::vector<Slide> slides) {
  for (std::size_t k = 0; k < slides.size(); ++k) {
    const Points& loop = result.segmentation.loops[k];
    slides[k].definition = StrokeDefinition{loop.topRows(5 * loop.rows() / 6)};
  }
  return slides;
}

void expect_moves_along(const std::string& what, const IndexedMesh& mesh, const std::vector<Slide>& slides,
                        const PipelineOptions& options = {}) {
  SCOPED_TRACE(what);
  const Model model = prepare_model(mesh);
  const PipelineResult here = make_cage(model, slides, options);
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const double scale = std::vector<double>{1, 0.001, 37, 1, 1e4}[seed - 1];
    const Motion motion = shapes::random_motion(seed, scale, scale * 5);
    Model moved_model = prepare_model(shapes::moved(mesh, motion));
    moved_model.diagonal =
        scale * model.diagonal;  // that of an axis-aligned box: it alone does not turn with the model
    const PipelineResult there = make_cage(moved_model, shapes::moved(slides, motion), options);
    checks::expect_same_cage(*here.cage, *there.cage, 1e-7 * scale * model.diagonal, motion);
    EXPECT_EQ(here.segmentation.slide_parts, there.segmentation.slide_parts);
    ASSERT_EQ(here.refinement.has_value(), there.refinement.has_value());
    if (!here.refinement) continue;
    EXPECT_EQ(here.refinement->records.size(), there.refinement->records.size());
    EXPECT_NEAR(here.refinement->max_signed_distance * scale, there.refinement->max_signed_distance,
                1e-7 * scale * model.diagonal);
  }
}

TEST(Pipeline, MovesTheCageWithModelAndSlides) {
  for (const SlidBody& body : shapes::slid_bodies()) expect_moves_along(body.name, body.mesh, body.slides);
}

// Every choice is a tie on these, and rounding may not be what decides it.
std::vector<SlidBody> symmetric_bodies() {
  const auto slide = [](const char* name, const Vector3& point, const Vector3& normal) {
    return Slide{name, PointNormalDefinition{point, normal}};
  };
  const std::vector<Slide> across = {slide("low", {0, 0, -1}, {0, 0, 1}), slide("high", {0, 0, 1}, {0, 0, 1})};
  IndexedMesh flat = meshes::capsule(1, 4, 24, 6);
  flat.points.col(1) *= 0.7;
  const Eigen::AngleAxisd third(2 * std::numbers::pi / 3, Vector3::UnitZ());
  std::vector<Slide> around;
  for (const char* name : {"first", "second", "third"}) {
    const Eigen::AngleAxisd turn(third.angle() * static_cast<double>(around.size()), Vector3::UnitZ());
    around.push_back(slide(name, turn * Vector3(3, 0, 0), turn * Vector3::UnitY()));
  }
  return {{"round capsule", meshes::capsule(1, 4, 24, 6), across, 0},
          {"flat capsule", flat, across, 0},
          {"torus", meshes::torus(3, 1, 48, 24), around, 1},
          {"box", meshes::box({-1, -2, -5}, {1, 2, 5}), across, 0}};
}

TEST(Pipeline, MovesTheCageOfAnExactlySymmetricModel) {
  for (const SlidBody& body : symmetric_bodies()) expect_moves_along(body.name, body.mesh, body.slides);
}

TEST(Pipeline, KeepsThePartsOfASymmetricModelWhereVerticesAndTrianglesAreShuffled) {
  for (const SlidBody& body : symmetric_bodies()) {
    SCOPED_TRACE(body.name);
    const PipelineResult one = cage_of(body.mesh, body.slides);
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const PipelineResult other = cage_of(meshes::shuffled(body.mesh, seed), body.slides);
      EXPECT_EQ(one.segmentation.slide_parts, other.segmentation.slide_parts);
      ASSERT_EQ(one.segmentation.parts.size(), other.segmentation.parts.size());
      EXPECT_EQ(one.cage->triangles.rows(), other.cage->triangles.rows());
    }
  }
}

TEST(Pipeline, MovesTheCageWithSlidesGivenAsEllipses) {
  for (const SlidBody& body : shapes::slid_bodies())
    expect_moves_along(body.name, body.mesh, as_ellipses(cage_of(body.mesh, body.slides), body.slides));
}

TEST(Pipeline, MovesTheCageWithSlidesGivenAsStrokes) {
  for (const SlidBody& body : shapes::slid_bodies())
    expect_moves_along(body.name, body.mesh, as_strokes(cage_of(body.mesh, body.slides), body.slides));
}

TEST(Pipeline, MovesTheCageWithModelAndSlidesForOtherOptions) {
  PipelineOptions options;
  options.lambda = 0.5;
  options.refine.in_plane = true;
  options.refine.delta = 0.02;
  for (const SlidBody& body : {shapes::fork(2), shapes::figure()})
    expect_moves_along(body.name, body.mesh, body.slides, options);
}

// Where the axis-aligned box turns with the model, nothing has to be held fixed.
TEST(Pipeline, MovesTheCageThroughQuarterTurnsTranslationsAndScales) {
  Eigen::Matrix3d cycle;
  cycle << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  Eigen::Matrix3d quarter;
  quarter << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  for (const SlidBody& body : {shapes::figure(), shapes::handle_body()})
    for (const double delta : {0.0, 0.01}) {
      PipelineOptions options;
      options.refine.delta = delta;
      const PipelineResult here = cage_of(body.mesh, body.slides, options);
      for (const Motion& motion : {Motion{1, cycle, {1, 2, 3}}, Motion{1e-4, quarter, {0, 0, 0}},
                                   Motion{1e6, cycle * quarter, {1e6, 0, -2e6}}}) {
        SCOPED_TRACE(body.name + ", scale " + std::to_string(motion.scale));
        const PipelineResult there =
            cage_of(shapes::moved(body.mesh, motion), shapes::moved(body.slides, motion), options);
        checks::expect_same_cage(*here.cage, *there.cage, 1e-8 * motion.scale, motion);
        EXPECT_NEAR(*here.volume_ratio, *there.volume_ratio, 1e-8);
      }
    }
}

TEST(Pipeline, GivesTheSameBitsForAnyNumberOfThreads) {
  const SlidBody body = shapes::figure();
  for (const RefineScope scope : {RefineScope::local, RefineScope::part}) {
    PipelineOptions options;
    options.refine.scope = scope;
    options.refine.iterations = 5;
    options.refine.threads = 1;
    const PipelineResult one = cage_of(body.mesh, body.slides, options);
    for (const unsigned threads : {2u, 3u, 7u, 0u}) {
      options.refine.threads = threads;
      const PipelineResult many = cage_of(body.mesh, body.slides, options);
      EXPECT_EQ(one.cage->points, many.cage->points) << threads;
      EXPECT_EQ(one.cage->triangles, many.cage->triangles) << threads;
      ASSERT_EQ(one.refinement->records.size(), many.refinement->records.size());
      for (std::size_t k = 0; k < one.refinement->records.size(); ++k) {
        EXPECT_EQ(one.refinement->records[k].anchors, many.refinement->records[k].anchors);
        EXPECT_EQ(one.refinement->records[k].outermost, many.refinement->records[k].outermost);
      }
    }
  }
}

TEST(Pipeline, KeepsPartsAndCageWhereVerticesAndTrianglesAreShuffled) {
  for (const SlidBody& body : shapes::slid_bodies()) {
    SCOPED_TRACE(body.name);
    const Model model = prepare_model(body.mesh);
    const PipelineResult one = make_cage(model, body.slides, {});
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const PipelineResult other = cage_of(meshes::shuffled(body.mesh, seed), body.slides);
      EXPECT_EQ(one.segmentation.slide_parts, other.segmentation.slide_parts);
      ASSERT_EQ(one.segmentation.parts.size(), other.segmentation.parts.size());
      for (std::size_t p = 0; p < one.segmentation.parts.size(); ++p)
        EXPECT_EQ(one.segmentation.parts[p].vertices.size(), other.segmentation.parts[p].vertices.size());
      checks::expect_same_cage(*one.cage, *other.cage, 1e-9 * model.diagonal);
    }
  }
}

TEST(Pipeline, StopsAfterTheStageAskedFor) {
  const SlidBody body = shapes::fork(1);
  const Model model = prepare_model(body.mesh);
  for (const Stage stage : {Stage::segment, Stage::orient, Stage::meshing, Stage::refine}) {
    PipelineOptions options;
    options.last_stage = stage;
    const PipelineResult result = make_cage(model, body.slides, options);
    EXPECT_EQ(result.last_stage, stage);
    EXPECT_EQ(result.segmentation.parts.size(), 4u);
    EXPECT_EQ(result.sections.size(), stage >= Stage::orient ? 3u : 0u);
    EXPECT_EQ(result.cage.has_value(), stage >= Stage::meshing);
    EXPECT_EQ(result.volume_ratio.has_value(), stage >= Stage::meshing);
    EXPECT_EQ(result.refinement.has_value(), stage == Stage::refine);
    if (result.refinement) {
      EXPECT_EQ(result.cage->points, result.refinement->cage.points);
      EXPECT_NEAR(*result.volume_ratio,
                  checks::volume_of({result.cage->points, result.cage->triangles}) / checks::volume_of(body.mesh),
                  1e-10);
    }
  }
}

TEST(Pipeline, TellsProgressThatNeverFallsAndStopsAtAnyCall) {
  const SlidBody body = shapes::figure();
  const Model model = prepare_model(body.mesh);
  double last = 0;
  Stage last_stage = Stage::segment;
  int calls = 0;
  make_cage(model, body.slides, {}, [&](double fraction, Stage stage) {
    EXPECT_GE(fraction, last);
    EXPECT_LE(fraction, 1);
    EXPECT_GE(stage, last_stage);
    last = fraction;
    last_stage = stage;
    ++calls;
    return true;
  });
  EXPECT_GT(calls, static_cast<int>(body.slides.size()) + 4);
  for (int stop = 1; stop <= calls; ++stop) {
    int count = 0;
    expect_error([&] { make_cage(model, body.slides, {}, [&](double, Stage) { return ++count < stop; }); },
                 ErrorCode::cancelled, {"cancelled"});
    EXPECT_EQ(count, stop);
  }
}

}  // namespace
}  // namespace cagewright
