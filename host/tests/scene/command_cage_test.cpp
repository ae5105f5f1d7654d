// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/cage_commands.h"

#include <limits>

#include "host/tests/scene/command_test_scene.h"

namespace cagewright::host::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void expect_same(const SceneCage& a, const SceneCage& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  ASSERT_EQ(a.mesh.points.size(), b.mesh.points.size());
  for (std::size_t i = 0; i < a.mesh.points.size(); ++i) EXPECT_NEAR(a.mesh.points[i], b.mesh.points[i], 1e-6);
  EXPECT_EQ(a.parameters, b.parameters);
  EXPECT_EQ(a.slides, b.slides);
  EXPECT_EQ(a.sections, b.sections);
  EXPECT_EQ(a.certificate, b.certificate);
}

SceneDocument saved(const SceneDocument& document) { return {document.path(), document.bytes()}; }

TEST(CageCommands, SetTheFirstCage) {
  for (const char* name : {"material_texture.glb", "buffers_glb_without_bin.glb", "json_whitespace.gltf"}) {
    SceneDocument document = own_scene(name);
    const int node = document.mesh_nodes().front().node;
    SetCage command(some_cage(node, {}, 1));
    expect_reversible(document, command);
    EXPECT_EQ(command.label(), "set the cage of node " + std::to_string(node));
    expect_same(*saved(document).find_cage(node), some_cage(node, {}, 1));
  }
}

TEST(CageCommands, SetAnotherCageInThePlaceOfTheOld) {
  for (const char* name : {"slides_cage.gltf", "slides_cage.glb", "slides_before_foreign_nodes.gltf"}) {
    SceneDocument document = own_scene(name);
    const int node = document.cages().front().mesh_node;
    const std::size_t cages = document.cages().size();
    SetCage command(some_cage(node, {document.slides().front().id}, 2));
    expect_reversible(document, command);
    EXPECT_EQ(saved(document).cages().size(), cages);
    expect_same(*saved(document).find_cage(node), some_cage(node, {document.slides().front().id}, 2));
  }
}

TEST(CageCommands, RemoveTheCageAndBringItBack) {
  for (const char* name :
       {"slides_cage.gltf", "slides_cage.glb", "slides_before_foreign_nodes.gltf", "slides_two_caged_meshes.gltf"}) {
    SCOPED_TRACE(name);
    SceneDocument document = own_scene(name);
    const SceneCage before = document.cages().front();
    RemoveCage command(before.mesh_node);
    expect_reversible(document, command);
    EXPECT_EQ(command.label(), "remove the cage of node " + std::to_string(before.mesh_node));
    EXPECT_EQ(saved(document).find_cage(before.mesh_node), nullptr);
    command.undoIt(document);
    expect_same(*document.find_cage(before.mesh_node), before);
  }
}

TEST(CageCommands, GiveTheSameBytesInWhateverOrderMeshesGetTheirs) {
  SceneDocument one = own_scene("nodes_several_meshes.glb"), other = own_scene("nodes_several_meshes.glb");
  const int first = one.mesh_nodes().at(0).node, second = one.mesh_nodes().at(1).node;
  SetCage(some_cage(first, {}, 1)).doIt(one);
  SetCage(some_cage(second, {}, 2)).doIt(one);
  SetCage(some_cage(second, {}, 2)).doIt(other);
  SetCage(some_cage(first, {}, 1)).doIt(other);
  EXPECT_EQ(one.bytes(), other.bytes());
}

TEST(CageCommands, RefuseNodesWithoutAMeshAndWithoutACage) {
  SceneDocument document = own_scene("slides_cage.gltf");
  const int cage_node = 2;  // of ours, and no mesh to cage
  for (const int wrong : {-1, 1, cage_node, 999}) {
    const std::string node = "node " + std::to_string(wrong);
    expect_refused(document, SetCage(some_cage(wrong, {}, 1)), {node, "no mesh for a cage", "choose"});
    expect_refused(document, RemoveCage(wrong), {node, "no cage"});
  }
  RemoveCage(document.cages().front().mesh_node).doIt(document);
  expect_refused(document, RemoveCage(0), {"node 0", "no cage"});
}

// Each is the good cage with one thing wrong.
class CageThatNoFileCanHold : public testing::Test {
 protected:
  template <class Spoil>
  void expect(Spoil spoil, std::vector<std::string> parts) {
    SceneDocument document = own_scene("slides_cage.glb");
    const int node = document.cages().front().mesh_node;
    SceneCage cage = some_cage(node, {3}, 1);
    spoil(cage);
    parts.push_back("the cage of node " + std::to_string(node));
    expect_refused(document, SetCage(std::move(cage)), parts);
  }
};

TEST_F(CageThatNoFileCanHold, HasWrongGeometry) {
  expect([](SceneCage& cage) { cage.mesh.triangles.clear(); }, {"no triangles"});
  expect([](SceneCage& cage) { cage.mesh.points[4] = 1e39; }, {"vertex 1", "too far out", "scale the model down"});
  expect([](SceneCage& cage) { cage.mesh.points[9] = -infinity; }, {"vertex 3", "too far out"});
  expect([](SceneCage& cage) { cage.mesh.points[9] = std::numeric_limits<double>::quiet_NaN(); }, {"vertex 3"});
  expect([](SceneCage& cage) { cage.mesh.triangles[5] = 4; }, {"triangle 1", "vertex 4 of 4"});
}

TEST_F(CageThatNoFileCanHold, HasWrongNotes) {
  expect([](SceneCage& cage) { cage.name = "\xff"; }, {"name", "\"?\"", "not UTF-8"});
  expect([](SceneCage& cage) { cage.parameters[1].second = infinity; }, {"\"refine.delta\"", "not finite"});
  expect([](SceneCage& cage) { cage.slides = {0}; }, {"slide without an id"});
  expect([](SceneCage& cage) { cage.slides = {(std::int64_t{1} << 53) + 1}; }, {"slide without an id"});
  expect([](SceneCage& cage) { cage.parameters[1].first = "\xff"; }, {"parameter", "not UTF-8"});
  expect([](SceneCage& cage) { cage.sections.pop_back(); }, {"4 vertices", "3"});
  expect([](SceneCage& cage) { cage.sections[2] = 1; }, {"vertex 2", "section 1 of 1"});
  expect([](SceneCage& cage) { cage.sections[2] = -2; }, {"vertex 2", "section -2"});
  expect([](SceneCage& cage) { cage.certificate = "{"; }, {"certificate", "no JSON object"});
  expect([](SceneCage& cage) { cage.certificate = R"({"a": 1, "a": 2})"; }, {"certificate", "no JSON object"});
}

}  // namespace
}  // namespace cagewright::host::test
