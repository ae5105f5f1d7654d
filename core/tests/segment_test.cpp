// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "core/segment/segment.h"
#include "core/slide/plane_loops.h"
#include "core/tests/cage_checks.h"
#include "core/tests/expect_error.h"
#include "core/tests/meshes.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

using shapes::SlidBody;

Slide across(const std::string& name, const Vector3& point, const Vector3& normal) {
  return {name, PointNormalDefinition{point, normal}};
}

IndexedMesh piece(const Segmentation& s, int part) {
  IndexedMesh mesh{s.cut.points, Triangles(0, 3)};
  for (std::size_t t = 0; t < s.triangle_part.size(); ++t) {
    if (s.triangle_part[t] != part) continue;
    mesh.triangles.conservativeResize(mesh.triangles.rows() + 1, 3);
    mesh.triangles.row(mesh.triangles.rows() - 1) = s.cut.triangles.row(static_cast<Eigen::Index>(t));
  }
  return mesh;
}

long euler_of(const IndexedMesh& mesh) {
  std::set<int> vertices;
  std::set<std::pair<int, int>> edges;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t)
    for (int i = 0; i < 3; ++i) {
      vertices.insert(mesh.triangles(t, i));
      edges.insert(std::minmax({mesh.triangles(t, i), mesh.triangles(t, (i + 1) % 3)}));
    }
  return static_cast<long>(vertices.size()) - static_cast<long>(edges.size()) + mesh.triangles.rows();
}

// The slides whose loops run along the boundary of the part, found from the triangles alone: boundary edges of the
// piece matched with the slides by the distance of their ends from the loop's points.
std::map<int, int> boundary_edges_by_slide(const Segmentation& s, const IndexedMesh& part) {
  std::set<std::pair<int, int>> edges;
  for (Eigen::Index t = 0; t < part.triangles.rows(); ++t)
    for (int i = 0; i < 3; ++i) edges.emplace(part.triangles(t, i), part.triangles(t, (i + 1) % 3));
  std::map<int, int> count;
  for (const auto& [a, b] : edges) {
    if (edges.count({b, a})) continue;
    for (std::size_t k = 0; k < s.loops.size(); ++k)
      if ((s.loops[k].rowwise() - s.cut.points.row(a)).rowwise().squaredNorm().minCoeff() == 0)
        ++count[static_cast<int>(k)];
  }
  return count;
}

TEST(Segment, CutsTheSurfaceIntoExactPiecesAlongThePlanes) {
  for (const SlidBody& body : shapes::slid_bodies()) {
    SCOPED_TRACE(body.name);
    const Model model = prepare_model(body.mesh);
    const Segmentation s = segment(model, body.slides);
    checks::expect_closed_manifold(s.cut.points, s.cut.triangles, *model.report.genus);
    EXPECT_NEAR(checks::area_of(s.cut), checks::area_of(body.mesh), 1e-11 * checks::area_of(body.mesh));
    EXPECT_NEAR(checks::volume_of(s.cut), model.volume, 1e-11 * model.volume);
    EXPECT_EQ(s.cut.points.topRows(static_cast<Eigen::Index>(model.mesh.n_vertices())),
              to_indexed_mesh(model.mesh).points)
        << "cutting only adds vertices";
    for (std::size_t k = 0; k < s.loops.size(); ++k) {
      const auto& plane = std::get<PointNormalDefinition>(body.slides[k].definition);
      const Eigen::VectorXd heights = (s.loops[k].rowwise() - plane.point.transpose()) * plane.normal.normalized();
      EXPECT_LT(heights.cwiseAbs().maxCoeff(), 1e-14 * model.diagonal);
      EXPECT_NEAR(s.ellipses[k].normal.dot(plane.normal.normalized()), 1, 1e-12);
    }
  }
}

TEST(Segment, GivesPartsTheTopologyAndTheSectionsThatTheirTrianglesShow) {
  for (const SlidBody& body : shapes::slid_bodies()) {
    SCOPED_TRACE(body.name);
    const Segmentation s = segment(prepare_model(body.mesh), body.slides);
    for (std::size_t p = 0; p < s.parts.size(); ++p) {
      SCOPED_TRACE("part " + std::to_string(p));
      const Part& part = s.parts[p];
      const IndexedMesh mesh = piece(s, static_cast<int>(p));
      std::set<int> used(mesh.triangles.data(), mesh.triangles.data() + mesh.triangles.size());
      EXPECT_EQ(std::vector<int>(used.begin(), used.end()), part.vertices);
      // These bodies are cut so that every part is a sphere with a hole for each section.
      EXPECT_EQ(euler_of(mesh), 2 - static_cast<long>(part.sections.size()));
      const auto boundary = boundary_edges_by_slide(s, mesh);
      ASSERT_EQ(boundary.size(), part.sections.size());
      for (const PartSection& side : part.sections) {
        EXPECT_EQ(boundary.at(side.slide), s.loops[static_cast<std::size_t>(side.slide)].rows());
        EXPECT_EQ(s.slide_parts[static_cast<std::size_t>(side.slide)][side.outward ? 0 : 1], static_cast<int>(p));
      }
    }
  }
}

TEST(Segment, PutsTheTrianglesAtALoopOnTheSideThatTheSlideSays) {
  for (const SlidBody& body : shapes::slid_bodies()) {
    SCOPED_TRACE(body.name);
    const Segmentation s = segment(prepare_model(body.mesh), body.slides);
    for (std::size_t k = 0; k < s.loops.size(); ++k) {
      std::set<std::array<double, 3>> on_loop;
      for (Eigen::Index i = 0; i < s.loops[k].rows(); ++i)
        on_loop.insert({s.loops[k](i, 0), s.loops[k](i, 1), s.loops[k](i, 2)});
      int seen = 0;
      for (Eigen::Index t = 0; t < s.cut.triangles.rows(); ++t) {
        double height = 0;
        int touching = 0;
        for (int i = 0; i < 3; ++i) {
          const Vector3 p = s.cut.points.row(s.cut.triangles(t, i));
          touching += on_loop.count({p.x(), p.y(), p.z()}) > 0;
          const double h = s.ellipses[k].normal.dot(p - s.ellipses[k].center);
          if (std::abs(h) > std::abs(height)) height = h;
        }
        if (touching < 2) continue;
        ++seen;
        EXPECT_EQ(s.triangle_part[static_cast<std::size_t>(t)], s.slide_parts[k][height > 0 ? 1 : 0]);
      }
      EXPECT_GE(seen, 2 * s.loops[k].rows());
    }
  }
}

TEST(Segment, LeavesTheOtherLegAlone) {
  const SlidBody body = shapes::figure();
  const Model model = prepare_model(body.mesh);
  const Slide left = across("left", {0.37, 0.03, -1.2}, {0, 0, 1});
  const Segmentation s = segment(model, {left});
  ASSERT_GE(plane_loops(model.mesh, model.edge_blocks, {0.37, 0.03, -1.2}, {0, 0, 1}).size(), 2u)
      << "the plane meets both legs";
  ASSERT_EQ(s.parts.size(), 2u);
  for (int v : s.parts[0].vertices) EXPECT_GT(s.cut.points(v, 0), 0) << "only the left foot is behind the slide";
  EXPECT_EQ(s.parts[0].vertices.size() + s.parts[1].vertices.size(),
            static_cast<std::size_t>(s.cut.points.rows() + s.loops[0].rows()));
}

TEST(Segment, CutsThroughVerticesAndAlongEdges) {
  // Rings of vertices lie in the planes z = const of the capsule; the slides go exactly through three of them.
  const IndexedMesh capsule = meshes::capsule(1, 4, 24, 6);
  const Model model = prepare_model(capsule);
  for (const double z : {2.0, -2.0, 2.0 + std::sin(0.25 * 3.14159265358979323846)}) {
    const Segmentation s = segment(model, {across("ring", {0.01, 0, z}, {0, 0, 1})});
    ASSERT_EQ(s.parts.size(), 2u) << z;
    EXPECT_NEAR(checks::volume_of(s.cut), model.volume, 1e-12 * model.volume);
    EXPECT_EQ(euler_of(piece(s, 0)), 1);
    EXPECT_EQ(euler_of(piece(s, 1)), 1);
  }
  // Through the poles and along the meridians.
  const Segmentation lengthwise = segment(model, {across("lengthwise", {0, 0.01, 0}, {1, 0, 0})});
  EXPECT_EQ(lengthwise.parts.size(), 2u);
  const Segmentation corner =
      segment(prepare_model(meshes::box({0, 0, 0}, {1, 1, 1})), {across("diagonal", {0.5, 0.5, 0.5}, {1, -1, 0})});
  EXPECT_EQ(corner.parts.size(), 2u);
  EXPECT_NEAR(checks::area_of(corner.cut), 6, 1e-14);
}

TEST(Segment, DoesNotDependOnVertexAndTriangleOrder) {
  for (const SlidBody& body : shapes::slid_bodies()) {
    SCOPED_TRACE(body.name);
    const Segmentation one = segment(prepare_model(body.mesh), body.slides);
    for (unsigned seed = 1; seed <= 3; ++seed) {
      const Segmentation other = segment(prepare_model(meshes::shuffled(body.mesh, seed)), body.slides);
      EXPECT_EQ(one.slide_parts, other.slide_parts);
      const auto parts = checks::parts_by_position(one), others = checks::parts_by_position(other);
      ASSERT_EQ(parts.size(), others.size());
      for (std::size_t p = 0; p < parts.size(); ++p) {
        std::set<checks::Corner> points, other_points;
        for (const auto& triangle : parts[p]) points.insert(triangle.begin(), triangle.end());
        for (const auto& triangle : others[p]) other_points.insert(triangle.begin(), triangle.end());
        EXPECT_EQ(points, other_points) << "part " << p;
        EXPECT_EQ(parts[p].size(), others[p].size());
      }
    }
  }
}

TEST(Segment, RefusesSlidesThatTouchAndNamesBothAndThePlace) {
  const SlidBody body = shapes::limb(0);
  const Model model = prepare_model(body.mesh);
  const std::vector<Slide> crossing = {across("upright", {0, 0, 0}, {1, 0, 0}),
                                       across("apart", {-0.8, 0.05, 0}, {1, 0, 0}),
                                       across("tilted", {0, 0, 0}, {1, 0, 0.5})};
  const Error error = expect_error([&] { segment(model, crossing); }, ErrorCode::slides_touch,
                                   {"'upright'", "'tilted'", "move one of them", " at ("});
  EXPECT_EQ(error.place().slide, 0u);
  EXPECT_EQ(error.place().other_slide, 2u);
  ASSERT_TRUE(error.place().point);
  EXPECT_NEAR(error.place().point->x(), 0, 0.1);
  const std::vector<Slide> same = {across("one", {0, 0, 0}, {1, 0, 0}), across("again", {0, 0.01, 0}, {-1, 0, 0})};
  expect_error([&] { segment(model, same); }, ErrorCode::slides_touch, {"'one'", "'again'"});
}

TEST(Segment, LooksAtEverySlideThoughOneFails) {
  const Model model = prepare_model(shapes::limb(0).mesh);
  const std::vector<Slide> slides = {across("away", {-70, 0, 0}, {1, 0, 0}), across("upright", {0, 0, 0}, {1, 0, 0}),
                                     across("apart", {-0.8, 0.05, 0}, {1, 0, 0}),
                                     across("tilted", {0, 0, 0}, {1, 0, 0.5}), across("far", {90, 0, 0}, {1, 0, 0})};
  const auto cut = [&] { segment(model, slides); };
  const Error error = expect_error(cut, ErrorCode::slide_misses_model, {"'away'"});
  EXPECT_EQ(error.place().slide, 0u);
  ASSERT_EQ(error.others().size(), 2u);
  EXPECT_EQ(error.others()[0].code(), ErrorCode::slides_touch);
  EXPECT_EQ(error.others()[0].place().slide, 1u);
  EXPECT_EQ(error.others()[0].place().other_slide, 3u);
  EXPECT_EQ(error.others()[1].code(), ErrorCode::slide_misses_model);
  EXPECT_EQ(error.others()[1].place().slide, 4u);
}

TEST(Segment, RefusesARingThatIsCutOnce) {
  const SlidBody body = shapes::ring(1);
  const Error error =
      expect_error([&] { segment(prepare_model(body.mesh), body.slides); }, ErrorCode::part_sees_slide_twice,
                   {"'slide 0'", "both sides", "add two more slides round it"});
  EXPECT_EQ(error.place().slide, 0u);
  EXPECT_EQ(error.place().part, 0u);
}

TEST(Segment, SaysOfAPipeThatItsInsideWallJoinsBothSides) {
  // In the plane of a torus the outer loop has an inside wall within it, as a pipe's has.
  const Slide slide{"across", PointNormalDefinition{{0, 0, 0.01}, {0, 0, 1}}};
  expect_error([&] { segment(prepare_model(meshes::torus(1.5, 0.4, 61, 37)), {slide}); },
               ErrorCode::part_sees_slide_twice, {"'across'", "pipe", "inside wall", "remove the slide"});
}

TEST(Segment, RefusesASlideThatOnlyTouchesAFlatEnd) {
  const Model model = prepare_model(meshes::box(Vector3::Zero(), Vector3(1, 1, 3)));
  for (const double end : {0.0, 3.0}) {
    const Slide slide{"end", PointNormalDefinition{{0.4, 0.4, end}, {0, 0, 1}}};
    const Error error =
        expect_error([&] { segment(model, {slide}); }, ErrorCode::slide_misses_model, {"'end'", "move"});
    EXPECT_EQ(error.place().slide, 0u);
  }
}

TEST(Segment, MarksWhatLiesInsideAsEnclosedAndNothingElse) {
  const SlidBody limb = shapes::limb(2);
  const IndexedMesh ball = meshes::moved(meshes::icosphere(1), 0.1, Vector3::Zero());
  const IndexedMesh beside = meshes::moved(meshes::icosphere(1), 0.1, {0, 0.62, 0});
  const Segmentation s =
      segment(prepare_model(meshes::together(meshes::together(limb.mesh, beside), ball)), limb.slides);
  ASSERT_EQ(s.parts.size(), 5u);
  for (const Part& part : s.parts) {
    const bool is_ball = s.cut.points(part.vertices[0], 1) < 0.3 && part.sections.empty();
    EXPECT_EQ(part.enclosed, is_ball);
  }
  const Slide equator{"equator", PointNormalDefinition{Vector3::Zero(), Vector3(0.1, 0.2, 1)}};
  const Segmentation hollow = segment(prepare_model(meshes::hollow_sphere(2)), {equator});
  ASSERT_EQ(hollow.parts.size(), 3u);
  EXPECT_FALSE(hollow.parts[0].enclosed);
  EXPECT_FALSE(hollow.parts[1].enclosed);
  EXPECT_TRUE(hollow.parts[2].enclosed);
}

TEST(Segment, TakesTheWholeModelForOnePartWhereThereIsNoSlide) {
  const Segmentation s = segment(prepare_model(meshes::hollow_sphere(2)), {});
  ASSERT_EQ(s.parts.size(), 1u);
  EXPECT_FALSE(s.parts[0].enclosed);
  EXPECT_EQ(s.parts[0].vertices.size(), static_cast<std::size_t>(s.cut.points.rows()));
}

TEST(Segment, StopsWhenProgressSaysSo) {
  const SlidBody body = shapes::figure();
  const Model model = prepare_model(body.mesh);
  int calls = 0;
  double last = -1;
  segment(model, body.slides, [&](double fraction) {
    EXPECT_GT(fraction, last);
    EXPECT_LT(fraction, 1);
    last = fraction;
    ++calls;
    return true;
  });
  EXPECT_EQ(calls, static_cast<int>(body.slides.size()));
  calls = 0;
  expect_error([&] { segment(model, body.slides, [&](double) { return ++calls < 3; }); }, ErrorCode::cancelled, {});
  EXPECT_EQ(calls, 3);
}

}  // namespace
}  // namespace cagewright
