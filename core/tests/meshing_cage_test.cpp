// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/pipeline/pipeline.h"
#include "core/tests/cage_checks.h"
#include "core/tests/expect_error.h"
#include "core/tests/meshes.h"
#include "core/tests/random_numbers.h"
#include "core/tests/shapes.h"

namespace cagewright {
namespace {

using shapes::SlidBody;

PipelineResult mesh_only(const Model& model, const std::vector<Slide>& slides) {
  PipelineOptions options;
  options.last_stage = Stage::meshing;
  return make_cage(model, slides, options);
}

long leaves(const Segmentation& segmentation) {
  return std::count_if(segmentation.parts.begin(), segmentation.parts.end(),
                       [](const Part& part) { return part.sections.size() == 1; });
}

// Everything that mesh_cage promises of any soundly cut model.
void expect_sound_cage(const PipelineResult& result, long model_genus_at_most) {
  const Segmentation& s = result.segmentation;
  const Cage& cage = *result.cage;
  const long genus = checks::genus_of_slides(s);
  checks::expect_closed_manifold(cage.points, cage.triangles, genus);
  EXPECT_LE(genus, model_genus_at_most);
  EXPECT_EQ(result.cage_genus, genus);
  const auto slides = static_cast<Eigen::Index>(s.ellipses.size());
  EXPECT_GE(cage.points.rows(), 4 * slides + 4 * leaves(s));
  EXPECT_EQ(cage.points.rows() % 4, 0) << "every cap has four corners";
  for (Eigen::Index v = 0; v < cage.points.rows(); ++v)
    EXPECT_EQ(cage.vertex_section[static_cast<std::size_t>(v)], v < 4 * slides ? static_cast<int>(v / 4) : -1);
  for (Eigen::Index k = 0; k < slides; ++k)
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(Vector3(cage.points.row(4 * k + i)),
                result.sections[static_cast<std::size_t>(k)].corners()[static_cast<std::size_t>(i)]);
  EXPECT_GT(checks::volume_of({cage.points, cage.triangles}), 0);
}

// Every triangle faces away from its part's centre, and section edges are edges of both parts beside the slide.
void expect_walls_round_their_centers(const PipelineResult& result) {
  const Cage& cage = *result.cage;
  std::set<std::array<int, 3>> edge_of_part;
  for (Eigen::Index t = 0; t < cage.triangles.rows(); ++t) {
    const int part = cage.triangle_part[static_cast<std::size_t>(t)];
    const auto at = [&](int i) { return Vector3(cage.points.row(cage.triangles(t, i))); };
    const Vector3 center = cage.part_center[static_cast<std::size_t>(part)];
    EXPECT_GT((at(1) - at(0)).cross(at(2) - at(0)).dot(at(0) - center), 0) << "triangle " << t;
    for (int i = 0; i < 3; ++i) {
      const auto [a, b] = std::minmax({cage.triangles(t, i), cage.triangles(t, (i + 1) % 3)});
      edge_of_part.insert({part, a, b});
    }
  }
  for (std::size_t k = 0; k < result.sections.size(); ++k)
    for (const int part : result.segmentation.slide_parts[k])
      for (int i = 0; i < 4; ++i) {
        const int first = 4 * static_cast<int>(k);
        const auto [a, b] = std::minmax({first + i, first + (i + 1) % 4});
        EXPECT_TRUE(edge_of_part.count({part, a, b})) << "slide " << k << " edge " << i << " of part " << part;
      }
}

TEST(MeshCage, IsClosedWithTheGenusOfTheSlideGraph) {
  for (const SlidBody& body : shapes::slid_bodies()) {
    SCOPED_TRACE(body.name);
    const PipelineResult result = mesh_only(prepare_model(body.mesh), body.slides);
    expect_sound_cage(result, body.cage_genus);
    if (body.cage_genus == 0) {  // bends of rings reach far out of their sections' hulls, and get caps
      const auto slides = static_cast<Eigen::Index>(body.slides.size());
      EXPECT_EQ(result.cage->points.rows(), 4 * (slides + leaves(result.segmentation))) << "every limb is cut off";
    }
    EXPECT_EQ(result.cage_genus, body.cage_genus);
    expect_walls_round_their_centers(result);
  }
}

TEST(MeshCage, IsClosedOrRefusedWithSlidesNamedForAnySubsetOfSlides) {
  Random random(5);
  int made = 0, refused = 0;
  for (const SlidBody& body : {shapes::figure(), shapes::handle_body(), shapes::ring(7), shapes::fork(3)}) {
    const Model model = prepare_model(body.mesh);
    for (int trial = 0; trial < 15; ++trial) {
      std::vector<Slide> slides;
      for (const Slide& slide : body.slides)
        if (random.below(3) > 0)
          slides.insert(slides.begin() + random.below(static_cast<int>(slides.size()) + 1), slide);
      if (slides.empty()) continue;
      SCOPED_TRACE(body.name + ", trial " + std::to_string(trial));
      try {
        const PipelineResult result = mesh_only(model, slides);
        expect_sound_cage(result, body.cage_genus);
        expect_walls_round_their_centers(result);
        ++made;
      } catch (const Error& error) {
        const ErrorCode code = error.code();
        EXPECT_TRUE(code == ErrorCode::sections_overlap || code == ErrorCode::part_sees_slide_twice ||
                    code == ErrorCode::parts_share_wall)
            << error.what();
        ASSERT_TRUE(error.place().slide) << error.what();
        EXPECT_NE(std::string(error.what()).find("'" + slides[*error.place().slide].name + "'"), std::string::npos);
        ++refused;
      }
    }
  }
  EXPECT_GT(made, 40);
  EXPECT_LT(refused, 20);
}

TEST(MeshCage, IsTheBoundingBoxWithoutSlides) {
  const Model model = prepare_model(shapes::fork(1).mesh);
  const PipelineResult result = mesh_only(model, {});
  checks::expect_closed_manifold(result.cage->points, result.cage->triangles, 0);
  EXPECT_EQ(result.cage->triangles.rows(), 12);
  EXPECT_EQ(Vector3(result.cage->points.colwise().minCoeff()), model.report.box_min);
  EXPECT_EQ(Vector3(result.cage->points.colwise().maxCoeff()), model.report.box_max);
  const Vector3 size = model.report.box_max - model.report.box_min;
  EXPECT_NEAR(checks::volume_of({result.cage->points, result.cage->triangles}), size.prod(), 1e-12 * size.prod());
}

TEST(MeshCage, GivesEveryComponentACageOfItsOwnButNoneToWhatIsEnclosed) {
  const SlidBody limb = shapes::limb(2);
  const IndexedMesh apart = meshes::moved(meshes::icosphere(2), 0.5, {0, 5, 0});
  const IndexedMesh inside = meshes::moved(meshes::icosphere(1), 0.1, Vector3::Zero());
  const PipelineResult result =
      mesh_only(prepare_model(meshes::together(meshes::together(limb.mesh, inside), apart)), limb.slides);
  checks::expect_closed_manifold(result.cage->points, result.cage->triangles, 0);
  EXPECT_EQ(checks::components_of(result.cage->triangles), 2);
  EXPECT_EQ(result.cage->triangles.rows(), 28 + 12);
}

TEST(MeshCage, CapsReachTheFarEndOfTheirLeaves) {
  const SlidBody body = shapes::fork(1);
  const PipelineResult result = mesh_only(prepare_model(body.mesh), body.slides);
  const Segmentation& s = result.segmentation;
  Eigen::Index cap = 4 * static_cast<Eigen::Index>(s.ellipses.size());
  for (const Part& part : s.parts) {
    if (part.sections.size() != 1) continue;
    const SectionFrame& section = result.sections[static_cast<std::size_t>(part.sections[0].slide)];
    const Vector3 into = part.sections[0].outward ? Vector3(-section.normal) : section.normal;
    double height = 0;
    for (int v : part.vertices) height = std::max(height, into.dot(Vector3(s.cut.points.row(v)) - section.center));
    for (int i = 0; i < 4; ++i) {
      const Vector3 corner = result.cage->points.row(cap + i);
      EXPECT_NEAR(into.dot(corner - section.center), height, 1e-12);
      const Vector3 edge = Vector3(result.cage->points.row(cap + (i + 1) % 4)) - corner;
      EXPECT_NEAR(
          edge.normalized().cross(section.p.normalized()).norm() * edge.normalized().dot(section.p.normalized()), 0,
          1e-12)
          << "a cap's edge runs along p or q of its section";
    }
    cap += 4;
  }
  EXPECT_EQ(cap, result.cage->points.rows());
}

TEST(MeshCage, RefusesTwoPartsBetweenTheSameSlides) {
  const double tilt = 0.7;
  const std::vector<Slide> slides = {
      {"east", PointNormalDefinition{{1.5, 0.01, 0}, {0, std::cos(tilt), std::sin(tilt)}}},
      {"west", PointNormalDefinition{{-1.5, 0.01, 0}, {0, std::cos(tilt), -std::sin(tilt)}}}};
  const Model model = prepare_model(meshes::torus(1.5, 0.4, 61, 37));
  const Error error = expect_error([&] { mesh_only(model, slides); }, ErrorCode::parts_share_wall,
                                   {"'east'", "'west'", "parts", "add a slide"});
  EXPECT_EQ(error.place().slide, 0u);
  EXPECT_EQ(error.place().other_slide, 1u);
  EXPECT_TRUE(error.place().part);
}

TEST(MeshCage, EndsForASlideAsThinAsANeedle) {
  const SlidBody body = shapes::limb(1);
  const Ellipse ellipse = segment(prepare_model(body.mesh), body.slides).ellipses.front();
  for (const double thinness : {1e-2, 1e-3, 1e-4}) {
    const Slide needle{"needle", EllipseDefinition{ellipse.center, 12.0 * ellipse.u, thinness * ellipse.v}};
    const PipelineResult result = mesh_only(prepare_model(body.mesh), {needle});
    EXPECT_EQ(result.cage->triangles.rows(), 20);
  }
}

TEST(MeshCage, BoxesAFlatComponentWithAThickness) {
  IndexedMesh card = meshes::box(Vector3(3, 0, 0), Vector3(4, 1, 1e-12));
  const SlidBody body = shapes::limb(1);
  const PipelineResult result = mesh_only(prepare_model(meshes::together(body.mesh, card)), body.slides);
  EXPECT_TRUE(result.cage_genus);
}

TEST(MeshCage, RefusesSectionsThatNoPointSeesSideBySide) {
  const double tilt = 0.4;  // the loops are apart, the rectangles round three times as wide ellipses cross
  const auto across = [&](const std::string& name, double z, double angle) {
    return Slide{name, EllipseDefinition{{0, 0, z}, {3 * std::cos(angle), 0, 3 * std::sin(angle)}, {0, 3, 0}}};
  };
  const std::vector<Slide> slides = {across("upper", 0.6, tilt), across("lower", -0.6, -tilt)};
  const Error error = expect_error([&] { mesh_only(prepare_model(meshes::capsule(1, 4, 24, 24)), slides); },
                                   ErrorCode::sections_overlap, {"'upper'", "'lower'", "turn or move"});
  EXPECT_TRUE(error.place().slide);
  EXPECT_TRUE(error.place().part);
  EXPECT_TRUE(error.place().point);
}

// What is between two slides on one side of a ring is not enclosed by walls between them alone.
TEST(MeshCage, RefusesHalfRingsWithTheSlidesToAddOneBetween) {
  const SlidBody body = shapes::ring(2);
  const Error error = expect_error([&] { mesh_only(prepare_model(body.mesh), body.slides); },
                                   ErrorCode::parts_share_wall, {"'slide 0'", "'slide 1'", "add a slide"});
  EXPECT_TRUE(error.place().slide);
  EXPECT_TRUE(error.place().point);
}

}  // namespace
}  // namespace cagewright
