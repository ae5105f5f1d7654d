// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/slide_commands.h"

#include <cmath>
#include <limits>
#include <random>

#include "host/tests/scene/command_test_scene.h"

namespace cagewright::host::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

void expect_near(const Slide::Ellipse& a, const Slide::Ellipse& b) {
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(a.center[i], b.center[i], 1e-12);
    EXPECT_NEAR(a.u[i], b.u[i], 1e-12);
    EXPECT_NEAR(a.v[i], b.v[i], 1e-12);
  }
}

// What the scene is once it was saved and read again.
SceneDocument saved(const SceneDocument& document) { return {document.path(), document.bytes()}; }

const SceneSlide& slide_named(const SceneDocument& document, const std::string& name) {
  for (const SceneSlide& slide : document.slides()) {
    if (slide.name == name) return slide;
  }
  throw std::runtime_error("no slide " + name);
}

// slides_plain.gltf: slides 1 "waist", with its stroke, and 7 "foot".
class SlideCommands : public testing::TestWithParam<const char*> {
 protected:
  SceneDocument document = own_scene(GetParam());
  const int node = document.mesh_nodes().front().node;
};

TEST_P(SlideCommands, AddAndTakeBack) {
  const std::vector<Point3> stroke = {{1, 2, 3}, {4, 5, 6}, {7, 8, 10}};
  AddSlide command(node, "kn\"e\xc3\xa9", some_ellipse(3), stroke);
  expect_reversible(document, command);
  EXPECT_EQ(command.label(), "add slide \"kn\"e??\"");
  EXPECT_GT(command.id(), 7);
  const SceneDocument again = saved(document);
  const SceneSlide& slide = slide_named(again, "kn\"e\xc3\xa9");
  EXPECT_EQ(slide.id, command.id());
  EXPECT_EQ(slide.mesh_node, node);
  EXPECT_EQ(slide.stroke, stroke);
  expect_near(slide.ellipse, some_ellipse(3));
}

// Or the cage that a window makes of an opened scene is another one than that which was saved.
TEST_P(SlideCommands, SlidesAreAfterSavingWhatTheyWereToTheBit) {
  std::mt19937 random(5);
  std::normal_distribution<double> any;
  for (int k = 0; k < 200; ++k) {
    Slide::Ellipse ellipse = some_ellipse(k);
    for (Point3* vector : {&ellipse.center, &ellipse.u, &ellipse.v})
      for (double& value : *vector) value = any(random) * std::pow(10, k % 7 - 3);
    AddSlide add(node, "random " + std::to_string(k), ellipse);
    add.doIt(document);
    if (k % 3 != 0) continue;
    ChangeSlide change(add.id(), ellipse);
    change.doIt(document);
    ChangeSlide as_it_is(add.id(), document.find_slide(add.id())->ellipse);
    const Slide::Ellipse before = document.find_slide(add.id())->ellipse;
    as_it_is.doIt(document);
    EXPECT_EQ(document.find_slide(add.id())->ellipse, before) << "rounding again changes nothing";
  }
  ChangeSlide(1, some_ellipse(4)).doIt(document);
  const SceneDocument again = saved(document);
  ASSERT_EQ(again.slides().size(), document.slides().size());
  for (const SceneSlide& slide : document.slides())
    EXPECT_EQ(again.find_slide(slide.id)->ellipse, slide.ellipse) << slide.name;
}

TEST_P(SlideCommands, ChangeTheEllipseAndTakeItBack) {
  ASSERT_FALSE(document.find_slide(1)->stroke.empty());
  ChangeSlide command(1, some_ellipse(4));
  expect_reversible(document, command);
  EXPECT_EQ(command.label(), "change slide \"waist\"");
  const SceneDocument again = saved(document);
  expect_near(again.find_slide(1)->ellipse, some_ellipse(4));
  EXPECT_EQ(again.find_slide(1)->name, "waist");
  EXPECT_TRUE(again.find_slide(1)->stroke.empty()) << "the stroke was of the old ellipse";
}

TEST_P(SlideCommands, ChangeTheStrokeWithTheEllipse) {
  const std::vector<Point3> stroke = {{0, 0, 1}, {0, 1, 0}, {1, 0, 0}};
  ChangeSlide command(7, some_ellipse(5), stroke);
  expect_reversible(document, command);
  EXPECT_EQ(saved(document).find_slide(7)->stroke, stroke);
}

TEST_P(SlideCommands, RenameAndTakeItBack) {
  const SceneSlide before = *document.find_slide(1);
  RenameSlide command(1, "hip");
  expect_reversible(document, command);
  EXPECT_EQ(command.label(), "rename slide \"waist\"");
  const SceneDocument again = saved(document);
  EXPECT_EQ(again.find_slide(1)->name, "hip");
  EXPECT_EQ(again.find_slide(1)->stroke, before.stroke);
  expect_near(again.find_slide(1)->ellipse, before.ellipse);
}

TEST_P(SlideCommands, RemoveAndBringBackInItsPlace) {
  RemoveSlide command(1);
  expect_reversible(document, command);
  EXPECT_EQ(command.label(), "remove slide \"waist\"");
  EXPECT_EQ(document.find_slide(1), nullptr);
  EXPECT_EQ(saved(document).slides().size(), 1u);
  command.undoIt(document);
  EXPECT_EQ(document.slides().front().id, 1);
  EXPECT_EQ(document.slides().front().name, "waist");
}

TEST_P(SlideCommands, NeverGiveAnIdTwice) {
  AddSlide first(node, "first", some_ellipse(1)), second(node, "second", some_ellipse(2));
  first.doIt(document);
  first.undoIt(document);
  second.doIt(document);
  EXPECT_NE(first.id(), second.id());
}

TEST_P(SlideCommands, RefuseNodesWithoutAMesh) {
  for (const int wrong : {-1, 1, 999}) {
    ASSERT_NE(wrong, node);
    expect_refused(document, AddSlide(wrong, "a", some_ellipse(1)),
                   {"node " + std::to_string(wrong), "no mesh to cut", "choose"});
  }
}

TEST_P(SlideCommands, RefuseNamesThatAreEmptyTakenOrNotUtf8) {
  expect_refused(document, AddSlide(node, "", some_ellipse(1)), {"needs a name"});
  expect_refused(document, AddSlide(node, "foot", some_ellipse(1)), {"\"foot\"", "already", "another name"});
  expect_refused(document, AddSlide(node, "a\xff", some_ellipse(1)), {"\"a?\"", "not UTF-8"});
  expect_refused(document, RenameSlide(1, ""), {"needs a name"});
  expect_refused(document, RenameSlide(1, "foot"), {"\"foot\"", "already", "another name"});
  expect_refused(document, RenameSlide(1, "\xc3"), {"\"?\"", "not UTF-8"});
}

TEST_P(SlideCommands, RefuseEllipsesThatAreNone) {
  const Point3 center = {0, 0, 0}, x = {1, 0, 0}, y = {0, 1, 0};
  const std::vector<Slide::Ellipse> none = {{center, x, x},
                                            {center, x, {-2, 0, 0}},
                                            {center, x, {0, 0, 0}},
                                            {{0, infinity, 0}, x, y},
                                            {{0, 0, not_a_number}, x, y},
                                            {center, {not_a_number, 0, 0}, y},
                                            {center, x, {0, infinity, 0}}};
  for (const Slide::Ellipse& ellipse : none) {
    expect_refused(document, AddSlide(node, "new", ellipse), {"slide \"new\"", "ellipse", "not parallel"});
    expect_refused(document, ChangeSlide(7, ellipse), {"slide \"foot\"", "ellipse", "not parallel"});
  }
}

TEST_P(SlideCommands, RefuseStrokesThatAreNotFinite) {
  const std::vector<Point3> stroke = {{0, 0, 0}, {0, not_a_number, 0}};
  expect_refused(document, AddSlide(node, "new", some_ellipse(1), stroke), {"slide \"new\"", "point 1", "stroke"});
  expect_refused(document, ChangeSlide(7, some_ellipse(1), {{infinity, 0, 0}}),
                 {"slide \"foot\"", "point 0", "stroke"});
}

TEST_P(SlideCommands, RefuseIdsThatNoSlideHas) {
  for (const std::int64_t id : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{2}}) {
    const std::vector<std::string> parts = {"no slide", "id " + std::to_string(id)};
    expect_refused(document, ChangeSlide(id, some_ellipse(1)), parts);
    expect_refused(document, RenameSlide(id, "a"), parts);
    expect_refused(document, RemoveSlide(id), parts);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, SlideCommands, testing::Values("slides_plain.gltf", "slides_plain.glb"),
                         [](const auto& scene) { return std::string(scene.index == 0 ? "Text" : "Binary"); });

TEST(SlideCommandsOfSeveralMeshes, KeepNamesApartUnderEachMeshOnly) {
  SceneDocument document = own_scene("slides_two_caged_meshes.gltf");
  const SceneSlide first = document.slides().at(0), second = document.slides().at(1);
  ASSERT_NE(first.mesh_node, second.mesh_node);
  AddSlide same_name(second.mesh_node, first.name == second.name ? "other" : first.name, some_ellipse(1));
  expect_reversible(document, same_name);
  expect_refused(document, AddSlide(first.mesh_node, document.find_slide(1)->name, some_ellipse(1)), {"already"});
}

TEST(SlideCommandsOnForeignContent, LeaveWhatOthersPutIntoTheNode) {
  SceneDocument document = own_scene("slides_foreign_child.gltf");
  RemoveSlide command(1);
  expect_reversible(document, command);
  EXPECT_NE(document.bytes().find("lamp"), std::string::npos);
  EXPECT_EQ(document.bytes().find("CAGEWRIGHT"), std::string::npos);
}

TEST(SlideCommandsOnForeignContent, LeaveASlideWhereItIsWhoseNodeIsBelowAnother) {
  SceneDocument document = own_scene("slides_deep.gltf");
  const SceneSlide below = *document.find_slide(2);
  ChangeSlide command(1, some_ellipse(6));
  expect_reversible(document, command);
  const SceneDocument again = saved(document);
  expect_near(again.find_slide(1)->ellipse, some_ellipse(6));
  expect_near(again.find_slide(2)->ellipse, below.ellipse);
  EXPECT_EQ(again.find_slide(2)->name, below.name);
  RemoveSlide(1).doIt(document);
  expect_near(saved(document).find_slide(2)->ellipse, below.ellipse);
}

TEST(SlideCommandsOnForeignContent, MoveASlideThatIsBelowOtherNodes) {
  for (const char* name : {"slides_deep.gltf", "slides_moved_sheared.gltf", "slides_parent_gone.gltf"}) {
    SCOPED_TRACE(name);
    SceneDocument document = own_scene(name);
    ChangeSlide command(1, some_ellipse(6));
    expect_reversible(document, command);
    const SceneDocument again = saved(document);
    expect_near(again.find_slide(1)->ellipse, some_ellipse(6));
  }
}

}  // namespace
}  // namespace cagewright::host::test
