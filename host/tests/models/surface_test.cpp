// SPDX-License-Identifier: BSD-3-Clause
//
// The judges of the cages can say no.
#include <gtest/gtest.h>

#include <stdexcept>
#include <utility>

#include "host/tests/models/same_cage.h"
#include "host/tests/models/similarity.h"
#include "host/tests/models/surface.h"

namespace cagewright::host {
namespace {

Surface octahedron() {
  return obj_surface(
      "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n"
      "f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n");
}

TEST(SurfaceFacts, OfAClosedOrientedManifold) {
  const SurfaceFacts facts = facts_of(octahedron());
  EXPECT_EQ(facts.unpaired_edges, 0u);
  EXPECT_EQ(facts.torn_vertices, 0u);
  EXPECT_EQ(facts.euler, 2);
  EXPECT_NEAR(facts.volume, 4.0 / 3, 1e-15);
}

TEST(SurfaceFacts, SeeAMissingTriangle) {
  Surface open = octahedron();
  open.triangles.pop_back();
  EXPECT_EQ(facts_of(open).unpaired_edges, 3u);
  EXPECT_EQ(facts_of(open).torn_vertices, 3u);
  EXPECT_EQ(facts_of(open).euler, 1);
}

TEST(SurfaceFacts, SeeATurnedTriangleAndATurnedSurface) {
  Surface turned = octahedron();
  std::swap(turned.triangles[0][0], turned.triangles[0][1]);
  EXPECT_GT(facts_of(turned).unpaired_edges, 0u);
  for (std::size_t i = 1; i < 8; ++i) std::swap(turned.triangles[i][0], turned.triangles[i][1]);
  EXPECT_EQ(facts_of(turned).unpaired_edges, 0u);
  EXPECT_NEAR(facts_of(turned).volume, -4.0 / 3, 1e-15);
}

TEST(SurfaceFacts, SeeATriangleThatIsThereTwice) {
  Surface doubled = octahedron();
  doubled.triangles.push_back(doubled.triangles[3]);
  EXPECT_GT(facts_of(doubled).unpaired_edges, 0u);
}

TEST(SurfaceFacts, SeeTwoFansAtOneVertexAndAVertexWithout) {
  Surface tie = octahedron();
  const Surface other = octahedron();
  for (const Eigen::Vector3d& point : other.vertices) tie.vertices.emplace_back(point + Eigen::Vector3d(2, 0, 0));
  for (auto triangle : other.triangles) {
    for (std::size_t& corner : triangle) corner = corner == 1 ? 0 : corner + 6;
    tie.triangles.push_back(triangle);
  }
  EXPECT_EQ(facts_of(tie).unpaired_edges, 0u);
  EXPECT_EQ(facts_of(tie).torn_vertices, 2u) << "vertex 0 joins both, vertex 7 is left alone";
}

TEST(ObjSurface, RefusesWhatTheProgramDoesNotWrite) {
  EXPECT_THROW(obj_surface("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), std::runtime_error);
  EXPECT_THROW(obj_surface("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"), std::runtime_error);
  EXPECT_THROW(obj_surface("v 0 0\n"), std::runtime_error);
  EXPECT_THROW(obj_surface("v 0 0 nothing\n"), std::runtime_error);
  EXPECT_THROW(obj_surface("v 0 0 0\nf 1 1 1 1\n"), std::runtime_error);
  EXPECT_THROW(obj_surface("vn 0 0 1\n"), std::runtime_error);
}

TEST(SameCage, TellsTheSameFromOthers) {
  const Surface a = octahedron();
  Surface bent = a, other_edges = a;
  bent.vertices[4].z() += 2e-9;
  other_edges.triangles[0] = {0, 2, 1};
  for (const auto differ : {difference, difference_in_any_order}) {
    EXPECT_EQ(differ(a, a, 0), "");
    EXPECT_EQ(differ(a, bent, 3e-9), "");
    EXPECT_NE(differ(a, bent, 1e-9).find("vertex 4 is 2e-09 away"), std::string::npos) << differ(a, bent, 1e-9);
    EXPECT_EQ(differ(a, other_edges, 1), "the triangles are not the same");
    bent.vertices.emplace_back();
    EXPECT_NE(differ(a, bent, 1).find("but 7 vertices"), std::string::npos);
    bent.vertices.pop_back();
  }
}

TEST(SameCage, KnowsAShuffledCageAgain) {
  const Surface a = octahedron(), b = shuffled(a, 1);
  EXPECT_NE(difference(a, b, 1e-9), "");
  EXPECT_EQ(difference_in_any_order(a, b, 0), "");
  Surface turned = b;
  for (auto& triangle : turned.triangles) std::swap(triangle[0], triangle[1]);
  EXPECT_EQ(difference_in_any_order(a, turned, 0), "the triangles are not the same");
}

TEST(Similarity, KeepsShapeAndOrientation) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Similarity motion = random_similarity(seed, 1);
    EXPECT_LT((motion.rotation.transpose() * motion.rotation - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    const double volume = facts_of(moved(octahedron(), motion)).volume;
    EXPECT_NEAR(volume / (motion.scale * motion.scale * motion.scale), 4.0 / 3, 1e-9);
  }
}

TEST(Similarity, MovesEveryKindOfSlide) {
  const Similarity motion = {(Eigen::Matrix3d() << 0, -1, 0, 1, 0, 0, 0, 0, 1).finished(), 2, {10, 0, 0}};
  const auto file = nlohmann::json::parse(R"({"version": 1, "slides": [{"name": "a", "stroke": [[1, 0, 0], [0, 1, 0]]},
      {"name": "b", "point": [1, 0, 0], "normal": [1, 0, 0]},
      {"name": "c", "center": [0, 1, 0], "u": [1, 0, 0], "v": [0, 0, 1]}]})");
  const auto expected = nlohmann::json::parse(R"({"version": 1, "slides": [
      {"name": "a", "stroke": [[10.0, 2.0, 0.0], [8.0, 0.0, 0.0]]},
      {"name": "b", "point": [10.0, 2.0, 0.0], "normal": [0.0, 1.0, 0.0]},
      {"name": "c", "center": [8.0, 0.0, 0.0], "u": [0.0, 2.0, 0.0], "v": [0.0, 0.0, 2.0]}]})");
  EXPECT_EQ(moved_slides(file, motion), expected);
}

}  // namespace
}  // namespace cagewright::host
