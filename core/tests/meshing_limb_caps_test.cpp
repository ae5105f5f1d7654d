// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/mesh/tolerance.h"
#include "core/meshing/convex_hull.h"
#include "core/meshing/limb_caps.h"
#include "core/pipeline/pipeline.h"
#include "core/tests/cage_checks.h"
#include "core/tests/meshes.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

using shapes::Motion;
using shapes::SlidBody;

struct CutPart {
  const Part* part;
  std::vector<SectionFrame> sections;
  std::vector<Vector3> corners;  // of the sections
};

std::vector<CutPart> parts_of(const PipelineResult& result) {
  std::vector<CutPart> parts;
  for (const Part& part : result.segmentation.parts) {
    if (part.sections.size() < 2) continue;  // a leaf's first cap is none of these
    CutPart cut{&part, {}, {}};
    for (const PartSection& side : part.sections) {
      cut.sections.push_back(result.sections[static_cast<std::size_t>(side.slide)]);
      for (const Vector3& corner : cut.sections.back().corners()) cut.corners.push_back(corner);
    }
    parts.push_back(cut);
  }
  EXPECT_FALSE(parts.empty());
  return parts;
}

PipelineResult run(const Model& model, const std::vector<Slide>& slides, Stage last) {
  PipelineOptions options;
  options.last_stage = last;
  return make_cage(model, slides, options);
}

std::vector<CapCorners> caps_of(const PipelineResult& result, const CutPart& cut) {
  return limb_caps(result.segmentation.cut.points, *cut.part, cut.corners, cut.sections);
}

double height_over_hull(const std::vector<Vector3>& corners, const Vector3& point) {
  double height = 0;
  for (const auto& [normal, offset] : hull_planes(corners)) height = std::max(height, normal.dot(point) + offset);
  return height;
}

// What limb_caps.h leaves outside the hull of `corners`.
double near_enough(const CutPart& cut, const std::vector<Vector3>& corners) {
  double half_side = 0, size = 0;
  for (const SectionFrame& section : cut.sections)
    half_side += (section.p.norm() + section.q.norm()) / 2 / static_cast<double>(cut.sections.size());
  for (const auto& [normal, offset] : hull_planes(corners))
    for (const Vector3& corner : corners) size = std::max(size, -(normal.dot(corner) + offset));
  return std::max(tolerance::far_of_sections * half_side, tolerance::far_of_hull * size);
}

// The figure with its first slide only and that of one leg: head and arms, and the other leg, are not cut off.
std::vector<Slide> few_slides(const SlidBody& figure) { return {figure.slides[0], figure.slides[4]}; }

TEST(LimbCaps, AreRectanglesThroughTheEndsOfLimbsThatNoSlideCuts) {
  const SlidBody figure = shapes::figure();
  const PipelineResult result = run(prepare_model(figure.mesh), few_slides(figure), Stage::orient);
  for (const CutPart& cut : parts_of(result)) {
    const std::vector<CapCorners> caps = caps_of(result, cut);
    ASSERT_GE(caps.size(), 2u);
    std::vector<Vector3> corners = cut.corners;
    for (const CapCorners& cap : caps) {
      const Vector3 along = cap[0] - cap[1], across = cap[1] - cap[2], out = along.cross(across).normalized();
      EXPECT_LT((cap[0] - cap[1] + cap[2] - cap[3]).norm(), 1e-12);
      EXPECT_NEAR(along.normalized().dot(across.normalized()), 0, 1e-12);
      const double near = near_enough(cut, corners);
      double nearest = 1, farthest = 0;
      for (const int v : cut.part->vertices) {
        const Vector3 point = result.segmentation.cut.points.row(v);
        farthest = std::max(farthest, height_over_hull(corners, point));
        nearest = std::min(nearest, std::abs(out.dot(point - cap[0])));
      }
      EXPECT_LT(nearest, 1e-12) << "a cap goes through the end of its limb";
      EXPECT_GT(farthest, near) << "there is a limb where a cap is";
      corners.insert(corners.end(), cap.begin(), cap.end());
    }
    for (const int v : cut.part->vertices)
      EXPECT_LT(height_over_hull(corners, result.segmentation.cut.points.row(v)), near_enough(cut, corners))
          << "vertex " << v;
  }
}

TEST(LimbCaps, AreNoneWhereEveryLimbIsCutOff) {
  const SlidBody figure = shapes::figure();
  const PipelineResult result = run(prepare_model(figure.mesh), figure.slides, Stage::orient);
  for (const CutPart& cut : parts_of(result)) EXPECT_TRUE(caps_of(result, cut).empty());
}

TEST(LimbCaps, MoveWithTheModel) {
  const SlidBody figure = shapes::figure();
  const std::vector<Slide> slides = few_slides(figure);
  const PipelineResult here = run(prepare_model(figure.mesh), slides, Stage::meshing);
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const Motion motion = shapes::random_motion(seed, seed == 1 ? 1e-3 : 7.0, 5);
    const PipelineResult there =
        run(prepare_model(shapes::moved(figure.mesh, motion)), shapes::moved(slides, motion), Stage::meshing);
    checks::expect_same_cage(*here.cage, *there.cage, 1e-10 * motion.scale, motion);
  }
}

// A trunk along z with two arms of different lengths, their ends flat: of a flat end's vertices all are as far, those
// of its sides half as far as its end are on the limit.
IndexedMesh body_of_cells() {
  std::set<std::array<int, 3>> cells;
  const auto fill = [&](const std::array<int, 3>& from, const std::array<int, 3>& to) {
    for (int x = from[0]; x < to[0]; ++x)
      for (int y = from[1]; y < to[1]; ++y)
        for (int z = from[2]; z < to[2]; ++z) cells.insert({x, y, z});
  };
  fill({-1, -2, -6}, {1, 2, 6});
  fill({1, -2, 0}, {9, 1, 2});
  fill({-7, -1, -1}, {-1, 2, 1});
  return meshes::surface_of_cells(cells);
}

TEST(LimbCaps, OfFlatEndsDependNeitherOnTheOrderOfVerticesNorOnMotion) {
  const IndexedMesh body = body_of_cells();
  const std::vector<Slide> slides = {{"top", EllipseDefinition{{0, 0, 4.5}, {1.5, 0, 0}, {0, 3, 0}}},
                                     {"bottom", EllipseDefinition{{0, 0, -4.5}, {1.5, 0, 0}, {0, 3, 0}}}};
  const PipelineResult here = run(prepare_model(body), slides, Stage::meshing);
  EXPECT_EQ(here.cage->points.rows(), 4 * (2 + 2 + 2)) << "two sections, two leaves, two arms";
  for (const unsigned seed : {1u, 2u, 3u, 4u, 5u, 6u}) {
    const PipelineResult shuffled = run(prepare_model(meshes::shuffled(body, seed)), slides, Stage::meshing);
    checks::expect_same_cage(*here.cage, *shuffled.cage, 1e-12);
    const Motion motion = shapes::random_motion(seed, 1, 5);
    const PipelineResult there =
        run(prepare_model(shapes::moved(body, motion)), shapes::moved(slides, motion), Stage::meshing);
    checks::expect_same_cage(*here.cage, *there.cage, 1e-10, motion);
  }
}

// Each slide as if it were the first that a person draws.
TEST(LimbCaps, KeepTheCageOfAFirstSlideSmallerThanTheModelsBox) {
  for (const SlidBody& body : {shapes::figure(), shapes::fork(2)}) {
    const Model model = prepare_model(body.mesh);
    const double box = (model.report.box_max - model.report.box_min).prod();
    for (const Slide& slide : body.slides) {
      const PipelineResult result = run(model, {slide}, Stage::enclose);
      EXPECT_TRUE(result.enclosure->certificate.encloses()) << body.name << ", " << slide.name;
      EXPECT_LT(*result.volume_ratio * model.volume, box) << body.name << ", " << slide.name;
    }
  }
}

}  // namespace
}  // namespace cagewright
