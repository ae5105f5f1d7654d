// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "host/command/slide_commands.h"
#include "host/file/file_error.h"
#include "host/tests/scene/command_test_scene.h"

namespace cagewright::host::test {
namespace {

using Kind = SceneNode::Kind;
using Matrix = std::array<double, 16>;

std::vector<std::string> names(const SceneDocument& document, Kind kind) {
  std::vector<std::string> names;
  for (const SceneNode& node : document.nodes()) {
    if (node.kind == kind) names.push_back(node.name);
  }
  return names;
}

TEST(Outline, HasMeshesSlidesAndCagesAsTheyAreNow) {
  SceneDocument document = own_scene("slides_two_caged_meshes.gltf");
  const std::vector<SceneNode> nodes = document.nodes();
  ASSERT_EQ(nodes.size(), 6U);
  EXPECT_EQ(names(document, Kind::mesh), (std::vector<std::string>{"left", "right"}));
  EXPECT_EQ(names(document, Kind::slide), (std::vector<std::string>{"waist left", "waist right"}));
  EXPECT_EQ(names(document, Kind::cage).size(), 2U);
  EXPECT_EQ(nodes[0].index, 0);
  EXPECT_EQ(nodes[0].parent, -1);
  EXPECT_EQ(nodes[3].slide, 2);
  EXPECT_EQ(nodes[3].parent, 1);
  EXPECT_EQ(nodes[3].index, -1);
  AddSlide(1, "new", some_ellipse(1)).doIt(document);
  RemoveSlide(1).doIt(document);
  EXPECT_EQ(names(document, Kind::slide), (std::vector<std::string>{"waist right", "new"}));
}

TEST(Outline, NodesOfOthersBelowASlideAreBelowItsMesh) {
  const SceneDocument document = own_scene("slides_foreign_child.gltf");
  std::set<int> known = {-1};
  for (const SceneNode& node : document.nodes()) known.insert(node.index);
  for (const SceneNode& node : document.nodes()) EXPECT_TRUE(known.count(node.parent)) << node.name;
  EXPECT_FALSE(names(document, Kind::plain).empty());
}

TEST(Outline, OfEveryOwnSceneIsATree) {
  for (const std::filesystem::path& path : own_scenes()) {
    SCOPED_TRACE(path.filename().string());
    const SceneDocument document(path, SceneDocument::Unreadable::stray);
    std::set<int> known = {-1};
    std::size_t ours = 0;
    for (const SceneNode& node : document.nodes()) {
      if (node.index >= 0) known.insert(node.index);
      if (node.kind != Kind::plain && node.kind != Kind::mesh) ++ours;
    }
    for (const SceneNode& node : document.nodes()) EXPECT_TRUE(known.count(node.parent)) << node.name;
    EXPECT_EQ(ours, document.slides().size() + document.cages().size() + document.strays().size());
  }
}

TEST(ToScene, PlacesMeshesByTheirNodes) {
  const SceneDocument document = own_scene("slides_two_caged_meshes.gltf");
  EXPECT_EQ(document.to_scene(0), (Matrix{1, 0, 0, -2, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}));
  EXPECT_EQ(document.to_scene(1)[3], 2);
  EXPECT_THROW(document.to_scene(77), FileError);
  EXPECT_THROW(document.to_scene(-1), FileError);
}

TEST(ToScene, PlacesASkinnedMeshByItsBindPoseWhateverItsNode) {
  const Matrix identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const SceneDocument bound = own_scene("geometry_skin.glb");
  EXPECT_EQ(bound.to_scene(bound.mesh_nodes().front().node), identity) << "its matrices take back where the joint is";
  const SceneDocument unbound = own_scene("geometry_skin_without_matrices.glb");
  Matrix at_joint = identity;
  at_joint[7] = -1;
  EXPECT_EQ(unbound.to_scene(unbound.mesh_nodes().front().node), at_joint);
}

}  // namespace
}  // namespace cagewright::host::test
