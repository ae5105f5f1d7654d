// SPDX-License-Identifier: BSD-3-Clause
#include <functional>
#include <thread>

#include "host/file/file_error.h"
#include "host/file/mesh_reader.h"
#include "host/tests/workspace/workspace_fixture.h"

namespace cagewright::host::test {
namespace {

class WorkspaceFilesTest : public WorkspaceTest {};

TEST_F(WorkspaceFilesTest, WhatIsSavedOpensWithItsSlidesParametersAndCage) {
  for (const char* name : {"a.glb", "a.gltf"}) {
    SCOPED_TRACE(name);
    open_with_slides({-0.7, 0.6});
    workspace_.rename_slide(id("slide 2"), "hip");
    workspace_.set_parameter("refine.delta", 0.01);
    const std::filesystem::path path = folder_ / name;
    workspace_.save(path);
    EXPECT_EQ(workspace_.path(), path);
    EXPECT_TRUE(workspace_.is_saved());
    const CageState& cage = workspace_.cage();
    EXPECT_TRUE(cage.is_of_now) << "saving waits for the cage";

    Workspace bare(nullptr, {});
    bare.open(path);
    ASSERT_EQ(bare.slides().size(), 2U);
    EXPECT_EQ(bare.slides()[1]->name, "hip");
    EXPECT_EQ(bare.cage().cage.triangles, cage.cage.triangles) << "what the file holds is shown";
    EXPECT_EQ(bare.cage().cage.points, cage.cage.points);
    const SceneCage& saved = bare.document().cages().front();
    EXPECT_EQ(saved.slides, cage.section_slides);
    EXPECT_EQ(saved.sections, cage.vertex_sections);
    EXPECT_TRUE(holds(saved.certificate, "\"encloses\":true"));

    Workspace again(plugin_, {});
    again.open(path);
    EXPECT_EQ(again.parameter("refine.delta"), 0.01);
    again.wait_for_cage();
    EXPECT_EQ(again.cage().cage.points, cage.cage.points) << "the same cage from what was saved";
    again.save(folder_ / (std::string("again_") + name));
    EXPECT_EQ(folder_.read(std::string("again_") + name), folder_.read(name));
  }
}

TEST_F(WorkspaceFilesTest, ParametersOfAModelWithoutSlidesAreSavedAndWithoutThemNoCageIs) {
  workspace_.open(model_);
  workspace_.save(folder_ / "plain.glb");
  EXPECT_TRUE(SceneDocument(folder_ / "plain.glb").cages().empty());
  workspace_.set_parameter("refine.delta", 0.02);
  workspace_.save(folder_ / "a.glb");
  Workspace again(plugin_, {});
  again.open(folder_ / "a.glb");
  EXPECT_EQ(again.parameter("refine.delta"), 0.02);
  EXPECT_TRUE(again.slides().empty());
}

TEST_F(WorkspaceFilesTest, SavedFollowsTheStepsOfUndo) {
  open_with_slides({0});
  EXPECT_FALSE(workspace_.is_saved());
  workspace_.save(folder_ / "a.glb");
  EXPECT_TRUE(workspace_.is_saved());
  workspace_.rename_slide(id("slide 1"), "waist");
  EXPECT_FALSE(workspace_.is_saved());
  workspace_.undo();
  EXPECT_TRUE(workspace_.is_saved());
  workspace_.undo();
  EXPECT_FALSE(workspace_.is_saved());
  workspace_.rename_slide(workspace_.add_slide(across("", 0)), "another way");
  workspace_.undo();
  EXPECT_FALSE(workspace_.is_saved()) << "as many steps as when it was saved, but others";
}

TEST_F(WorkspaceFilesTest, AModelBecomesANewSceneBesideIt) {
  workspace_.open(model_);
  EXPECT_EQ(workspace_.path(), folder_ / "limb.glb");
  EXPECT_TRUE(workspace_.is_saved()) << "nothing to lose";
  EXPECT_EQ(folder_.names(), std::set<std::string>{"limb.off"}) << "nothing is written";
  for (const char* name : {"m.obj", "m.ply", "m.stl", "m.glb"}) {
    workspace_.open(write_model(name, ellipsoid(6, 8)));
    EXPECT_EQ(workspace_.mesh().triangle_count(), 2U * 8U * 5U) << name;
  }
}

TEST_F(WorkspaceFilesTest, AnOpenedScenesCageIsMadeAgainToTheBit) {
  open_with_slides({-0.91, 0.27, 1.13});
  workspace_.add_slide({"turned", Slide::PointNormal{{0.3, -0.3, 0}, {0.1, 1, 0.2}}});
  workspace_.wait_for_cage();
  workspace_.save(folder_ / "saved.glb");
  Workspace opened(plugin_, {});
  opened.open(folder_ / "saved.glb");
  opened.solve();
  opened.wait_for_cage();
  ASSERT_TRUE(opened.cage().is_of_now);
  for (const SceneSlide* slide : workspace_.slides())
    EXPECT_EQ(opened.find_slide(slide->name)->ellipse, slide->ellipse);
  EXPECT_EQ(opened.cage().cage.points, workspace_.cage().cage.points);
  EXPECT_EQ(opened.cage().cage.triangles, workspace_.cage().cage.triangles);
}

TEST_F(WorkspaceFilesTest, WhereOpeningFailsEverythingStays) {
  open_with_slides({0.3});
  workspace_.wait_for_cage();
  const std::string before = bytes();
  const TriangleMesh cage = workspace_.cage().cage;
  EXPECT_TRUE(holds(sentence_of<FileError>([&] { workspace_.open(folder_ / "none.glb"); }), "none.glb"));
  const auto broken = folder_.write("broken.off", "OFF\n1 2");
  EXPECT_TRUE(holds(sentence_of<FileError>([&] { workspace_.open(broken); }), "broken.off"));
  EXPECT_EQ(bytes(), before);
  EXPECT_EQ(workspace_.cage().cage.points, cage.points);
  EXPECT_TRUE(workspace_.stack().can_undo());
}

TEST_F(WorkspaceFilesTest, SavingWhereItCannotBeLeavesTheSceneUnsaved) {
  open_with_slides({0.3});
  EXPECT_TRUE(holds(sentence_of<FileError>([&] { workspace_.save(folder_ / "a.obj"); }), ".glb or .gltf"));
  EXPECT_THROW(workspace_.save(folder_ / "no such folder" / "a.glb"), FileError);
  EXPECT_FALSE(workspace_.is_saved());
  EXPECT_EQ(workspace_.path(), folder_ / "limb.glb");
}

TEST_F(WorkspaceFilesTest, ACopyIsSavedWithoutAnyChangeOfTheWorkspace) {
  open_with_slides({0.3});
  workspace_.wait_for_cage();
  const std::string before = bytes();
  workspace_.save_copy(folder_ / "copy.glb");
  EXPECT_EQ(bytes(), before);
  EXPECT_FALSE(workspace_.is_saved());
  EXPECT_EQ(workspace_.path(), folder_ / "limb.glb");
  workspace_.save(folder_ / "scene.glb");
  EXPECT_EQ(folder_.read("copy.glb"), folder_.read("scene.glb"));
}

TEST_F(WorkspaceFilesTest, TheCageAloneIsExportedInEveryFormat) {
  workspace_.open(model_);
  workspace_.cancel_solve();
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] { workspace_.export_cage(folder_ / "c.obj"); }), "no cage"));
  workspace_.add_slide(across("", 0.3));
  for (const char* name : {"c.obj", "c.off", "c.ply", "c.stl", "c.glb", "c.gltf"}) {
    workspace_.export_cage(folder_ / name);
    EXPECT_EQ(read_mesh(folder_ / name).mesh.triangle_count(), workspace_.cage().cage.triangle_count()) << name;
  }
  EXPECT_THROW(workspace_.export_cage(folder_ / "c.fbx"), FileError);
}

TEST_F(WorkspaceFilesTest, CagesOfAllMeshesThatWereChangedAreSaved) {
  workspace_.open(own_scene("nodes_several_meshes.glb"));
  const std::vector<SceneMeshNode> nodes = workspace_.document().mesh_nodes();
  workspace_.add_slide({"cut", Slide::PointNormal{{0, 0, 0}, {0, 1, 0}}});
  workspace_.choose_mesh(nodes[1].node);  // before the first one's cage is there
  workspace_.add_slide({"cut", Slide::PointNormal{{0, 3, 0}, {0, 1, 0}}});
  workspace_.save(folder_ / "both.glb");
  const SceneDocument saved(folder_ / "both.glb");
  ASSERT_EQ(saved.cages().size(), 2U);
  for (const SceneCage& cage : saved.cages()) EXPECT_EQ(cage.slides.size(), 1U);
  EXPECT_NE(saved.cages()[0].mesh.points, saved.cages()[1].mesh.points);
}

TEST_F(WorkspaceFilesTest, AMeshWithoutSlidesGetsNoCageInTheFile) {
  workspace_.open(own_scene("nodes_several_meshes.glb"));
  workspace_.wait_for_cage();
  EXPECT_FALSE(workspace_.cage().cage.triangles.empty()) << "its box is shown";
  workspace_.save(folder_ / "none.glb");
  EXPECT_TRUE(SceneDocument(folder_ / "none.glb").cages().empty());
}

TEST_F(WorkspaceFilesTest, WhereTheSlidesFailTheLastGoodCageIsSavedWithTheParametersAsTheyAreNow) {
  open_with_slides({0});
  workspace_.wait_for_cage();
  const TriangleMesh good = workspace_.cage().cage;
  workspace_.set_parameter("refine.delta", 0.02);
  Slide::Ellipse away = ellipse("slide 1");
  away.center[1] = 7;
  workspace_.add_slide({"away", away});
  workspace_.save(folder_ / "a.glb");
  const SceneDocument saved(folder_ / "a.glb");
  EXPECT_EQ(saved.slides().size(), 2U);
  ASSERT_EQ(saved.cages().size(), 1U);
  EXPECT_EQ(saved.cages()[0].mesh.triangles, good.triangles);
  workspace_.open(folder_ / "a.glb");
  EXPECT_EQ(workspace_.parameter("refine.delta"), 0.02);
}

TEST_F(WorkspaceFilesTest, ACopyIsOfTheMomentItWasMadeAndIsWrittenByAnyThreadWhileTheWorkspaceGoesOn) {
  for (const auto& scene : {model_, own_scene("slides_two_caged_meshes.gltf")}) {
    workspace_.open(scene);
    workspace_.set_parameter("orient.lambda", 5);
    workspace_.add_slide(across("early", 0.4));
    workspace_.wait_for_cage();
    workspace_.save_copy(folder_ / "now.glb");
    const std::function<void()> write = workspace_.copy_to_write(folder_ / "later.glb");
    workspace_.add_slide(across("late", -0.4));
    std::thread writer([&write] { write(); });
    for (int k = 0; k < 20; ++k) {
      workspace_.rename_slide(id("late"), "later");
      workspace_.save_copy(folder_ / "other.glb");
      workspace_.undo();
    }
    writer.join();
    EXPECT_TRUE(folder_.read("later.glb") == folder_.read("now.glb"));
    workspace_.close();
    EXPECT_NO_THROW(write()) << "it needs no workspace";
  }
  EXPECT_THROW(workspace_.copy_to_write(folder_ / "a.glb"), CommandError);
  workspace_.open(model_);
  EXPECT_THROW(workspace_.copy_to_write(folder_ / "a.obj"), FileError);
  const std::function<void()> nowhere = workspace_.copy_to_write(model_ / "a.glb");
  EXPECT_THROW(nowhere(), FileError);
}

TEST_F(WorkspaceFilesTest, FilesThatASceneNamesComeAlong) {
  const std::filesystem::path from = own_scene("material_external_image.gltf");
  workspace_.open(from);
  std::filesystem::create_directory(folder_ / "there");
  workspace_.save(folder_ / "there" / "scene.gltf");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "there" / "material_external_image.png"));
  Workspace again(plugin_, {});
  again.open(folder_ / "there" / "scene.gltf");
  EXPECT_EQ(again.mesh().points, workspace_.mesh().points);
}

}  // namespace
}  // namespace cagewright::host::test
