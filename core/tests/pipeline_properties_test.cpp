// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <vector>

#include "core/pipeline/pipeline.h"
#include "core/tests/cage_checks.h"
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
    moved_model.diagonal = scale * model.diagonal;  // that of an axis-aligned box: it alone does not turn with the model
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

}  // namespace
}  // namespace cagewright
