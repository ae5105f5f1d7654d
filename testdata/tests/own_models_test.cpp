// SPDX-License-Identifier: BSD-3-Clause
// What cagewright_testdata wrote keeps its promises, and the slides that belong to it cut it soundly.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>
#include <ostream>
#include <set>
#include <string>

#include "testdata/generate/mesh_facts.h"
#include "testdata/tests/plane_loops.h"
#include "testdata/tests/slide_file.h"

namespace cagewright::testdata {
namespace {

struct Model {
  const char* name;
  int genus;
  std::size_t parts;  // into which its slides cut it
};

void PrintTo(const Model& model, std::ostream* out) { *out << model.name; }

class OwnModel : public testing::TestWithParam<Model> {
 protected:
  TriangleMesh mesh() const {
    return read_mesh(std::filesystem::path(CAGEWRIGHT_OWN_MODELS) / (std::string(GetParam().name) + ".off"));
  }
  std::vector<Slide> slides() const {
    return read_slides(std::filesystem::path(CAGEWRIGHT_SLIDE_FILES) / (std::string(GetParam().name) + ".slides.json"));
  }
};

// The one loop of the slide's plane that runs round its point; without points where there is none or more than one.
PlaneLoop cut(const TriangleMesh& mesh, const Slide& slide) {
  std::vector<PlaneLoop> loops = cut_by_plane(mesh, slide.point, slide.normal);
  std::erase_if(loops, [&](const PlaneLoop& loop) { return !encloses(loop, slide.point, slide.normal); });
  return loops.size() == 1 ? loops.front() : PlaneLoop{};
}

TEST_P(OwnModel, IsOneClosedManifoldPieceOfTheDesignedGenus) {
  const MeshFacts facts = count_facts(mesh());
  EXPECT_EQ(broken_promise(facts, GetParam().genus), "");
  EXPECT_GE(facts.triangles, 10'000u);
  EXPECT_LE(facts.triangles, 40'000u);
}

TEST_P(OwnModel, HasNoSlivers) {
  const TriangleMesh model = mesh();
  for (const auto& t : model.triangles) {
    const Eigen::Vector3d &a = model.vertices[t[0]], &b = model.vertices[t[1]], &c = model.vertices[t[2]];
    const double longest = std::max({(b - a).norm(), (c - b).norm(), (a - c).norm()});
    const double height = (b - a).cross(c - a).norm() / longest;
    ASSERT_GT(height, 0.1 * longest);
  }
}

TEST_P(OwnModel, EverySlideCutsOneLoopRoundItsPoint) {
  const TriangleMesh model = mesh();
  for (const Slide& slide : slides()) EXPECT_FALSE(cut(model, slide).points.empty()) << slide.name;
}

TEST_P(OwnModel, NoTwoLoopsShareATriangle) {
  const TriangleMesh model = mesh();
  const std::vector<Slide> all = slides();
  std::vector<PlaneLoop> loops;
  for (const Slide& slide : all) loops.push_back(cut(model, slide));
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      std::vector<std::size_t> shared;
      std::ranges::set_intersection(loops[i].triangles, loops[j].triangles, std::back_inserter(shared));
      EXPECT_TRUE(shared.empty()) << all[i].name << " and " << all[j].name;
    }
  }
}

// Vertices are in one part where a path of edges that no loop crosses leads from one to the other.
TEST_P(OwnModel, FallsIntoTheIntendedParts) {
  const TriangleMesh model = mesh();
  std::set<std::array<std::uint32_t, 2>> crossed;
  for (const Slide& slide : slides()) {
    const PlaneLoop loop = cut(model, slide);
    crossed.insert(loop.edges.begin(), loop.edges.end());
  }
  std::vector<std::vector<std::uint32_t>> neighbours(model.vertices.size());
  for (const auto& triangle : model.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3];  // its other direction is in another triangle
      if (!crossed.contains({std::min(a, b), std::max(a, b)})) neighbours[a].push_back(b);
    }
  }
  std::vector<bool> seen(model.vertices.size(), false);
  std::size_t parts = 0;
  for (std::uint32_t start = 0; start < seen.size(); ++start) {
    if (seen[start]) continue;
    ++parts;
    seen[start] = true;
    for (std::vector<std::uint32_t> open{start}; !open.empty();) {
      const std::uint32_t at = open.back();
      open.pop_back();
      for (const std::uint32_t next : neighbours[at]) {
        if (!seen[next]) open.push_back(next);
        seen[next] = true;
      }
    }
  }
  EXPECT_EQ(parts, GetParam().parts);
}

INSTANTIATE_TEST_SUITE_P(Testdata, OwnModel,
                         testing::Values(Model{"biped", 0, 18}, Model{"quadruped", 0, 24}, Model{"octopus", 0, 35},
                                         Model{"genus3", 3, 16}, Model{"blob", 0, 12}, Model{"legs", 0, 8}),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace cagewright::testdata
