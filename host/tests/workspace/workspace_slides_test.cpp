// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>

#include "host/file/file_error.h"
#include "host/plugin_client/plugin_error.h"
#include "host/tests/workspace/workspace_fixture.h"

namespace cagewright::host::test {
namespace {

using Names = std::vector<std::string>;

double length(const Point3& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

class WorkspaceSlidesTest : public WorkspaceTest {
 protected:
  // One step: undo leads to the bytes before, redo to those after, and its label is named.
  template <class Action>
  void expect_one_step(const std::string& label, const Action& action) {
    SCOPED_TRACE(label);
    const std::string before = bytes();
    action();
    const std::string after = bytes();
    EXPECT_NE(after, before);
    EXPECT_EQ(workspace_.stack().undo_label(), label);
    workspace_.undo();
    EXPECT_EQ(bytes(), before);
    EXPECT_EQ(workspace_.stack().redo_label(), label);
    workspace_.redo();
    EXPECT_EQ(bytes(), after);
  }
  // On the front of the ellipsoid (z > 0), from x = -reach to reach at height y + slope x.
  static std::vector<Point3> front_stroke(double y, double slope, double reach) {
    std::vector<Point3> stroke;
    for (int k = -4; k <= 4; ++k) {
      const double x = reach * k / 4, height = y + slope * x;
      const double rest = 1 - x * x / 0.25 - height * height / 4;
      stroke.push_back({x, height, 0.4 * std::sqrt(rest)});
    }
    return stroke;
  }
  static std::vector<Point3> ring(double y, int from, int to, int count) {
    std::vector<Point3> points;
    const double size = std::sqrt(1 - y * y / 4);
    for (int k = from; k < to; ++k) {
      const double angle = 2 * 3.14159265358979 * k / count;
      points.push_back({0.5 * size * std::cos(angle), y, 0.4 * size * std::sin(angle)});
    }
    return points;
  }
};

TEST_F(WorkspaceSlidesTest, WhatIsFittedToAPreparedMeshIsWhatIsFittedToAnother) {
  workspace_.prepare_to_fit();  // nothing is open
  workspace_.open(model_);
  const Slide::Ellipse unprepared = workspace_.fit(across("", 0.2));
  workspace_.open(write_model("other.off", ellipsoid(12, 20)));
  workspace_.prepare_to_fit();
  workspace_.prepare_to_fit();
  const Slide::Ellipse of_other = workspace_.fit(across("", 0.2));
  EXPECT_NE(of_other.u, unprepared.u);
  workspace_.open(model_);
  workspace_.prepare_to_fit();
  const Slide::Ellipse prepared = workspace_.fit(across("", 0.2));
  EXPECT_EQ(prepared.center, unprepared.center);
  EXPECT_EQ(prepared.u, unprepared.u);
  EXPECT_EQ(prepared.v, unprepared.v);
}

TEST_F(WorkspaceSlidesTest, AMeshThatCannotBePreparedIsToldByEveryFit) {
  TriangleMesh open = ellipsoid(12, 20);
  open.triangles.resize(open.triangles.size() - 3);
  workspace_.open(write_model("open.off", open));
  workspace_.prepare_to_fit();
  const auto fit = [&] { static_cast<void>(workspace_.fit(across("", 0.2))); };
  const std::string sentence = sentence_of<PluginError>(fit);
  EXPECT_PRED2(holds, sentence, "open");
  EXPECT_EQ(sentence_of<PluginError>(fit), sentence);
  workspace_.unload_plugin();
  workspace_.prepare_to_fit();
}

TEST_F(WorkspaceSlidesTest, EveryChangeIsOneStepThatUndoAndRedoLeadRoundToTheByte) {
  open_with_slides({0.2});
  const std::int64_t first = id("slide 1");
  expect_one_step("add slide \"knee\"", [&] { workspace_.add_slide(across("knee", -0.8)); });
  expect_one_step("add slide \"slide 2\"", [&] { workspace_.add_slide({"", ellipse("knee")}); });
  expect_one_step("remove slide \"slide 2\"", [&] { workspace_.remove_slides({id("slide 2")}); });
  expect_one_step("rename slide \"slide 1\"", [&] { workspace_.rename_slide(first, "hip"); });
  expect_one_step("duplicate 2 slides", [&] { workspace_.duplicate_slides({first, id("knee")}); });
  expect_one_step("remove 2 slides", [&] { workspace_.remove_slides({id("hip copy"), id("knee copy")}); });
  expect_one_step("mirror 2 slides", [&] { workspace_.mirror_slides({first, id("knee")}, 0, 1.5); });
  expect_one_step("turn slides", [&] {
    Slide::Ellipse a = ellipse("hip"), b = ellipse("knee");
    a.center[1] += 0.1;
    b.center[1] += 0.1;
    workspace_.change_slides({{first, a}, {id("knee"), b}}, "turn slides");
  });
  expect_one_step("snap 2 slides", [&] { workspace_.snap_slides({first, id("knee")}); });
  const std::string copied = workspace_.copy_slides({first, id("knee")});
  expect_one_step("paste 2 slides", [&] { workspace_.paste_slides(copied); });
}

TEST_F(WorkspaceSlidesTest, UndoOfEverythingIsTheDocumentAsItWasRead) {
  workspace_.open(own_scene("slides_two_caged_meshes.gltf"));
  const std::string before = bytes();
  const auto rename_and_more = [&] {
    const std::int64_t first = workspace_.slides().front()->id;
    workspace_.rename_slide(first, "waist");
    workspace_.duplicate_slides({first});
    workspace_.mirror_slides({first}, 0, {});
    workspace_.set_parameter("orient.lambda", 7);
    workspace_.remove_slides({first});
  };
  rename_and_more();
  workspace_.choose_mesh(1);
  rename_and_more();
  const std::string after = bytes();
  while (workspace_.stack().can_undo()) workspace_.undo();
  EXPECT_EQ(bytes(), before);
  EXPECT_TRUE(workspace_.is_saved());
  while (workspace_.stack().can_redo()) workspace_.redo();
  EXPECT_EQ(bytes(), after);
}

TEST_F(WorkspaceSlidesTest, AShortStrokeAcrossALimbMakesTheLoopOfThePlaneThatHoldsItAndTheLineOfSight) {
  workspace_.open(model_);
  const Workspace::SlideAcross added = workspace_.add_slide_across(front_stroke(0.3, 0.5, 0.15), {0, 0, -2}, "cut");
  const SceneSlide& slide = *workspace_.document().find_slide(added.id);
  EXPECT_EQ(added.tilt, 0);
  EXPECT_EQ(slide.name, "cut");
  EXPECT_TRUE(slide.stroke.empty()) << "the ellipse was not fitted to it";
  // The plane y = 0.3 + 0.5 x: its normal has no part along the line of sight, its loop goes all round.
  const double tilt = std::atan(0.5);
  const Point3& u = slide.ellipse.u;
  const Point3& v = slide.ellipse.v;
  const Point3 n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
  EXPECT_NEAR(std::abs(n[0]) / length(n), std::sin(tilt), 1e-6);
  EXPECT_NEAR(std::abs(n[1]) / length(n), std::cos(tilt), 1e-6);
  EXPECT_NEAR(n[2] / length(n), 0, 1e-6);
  EXPECT_GT(length(u), 0.45);
  EXPECT_NEAR(slide.ellipse.center[2], 0, 0.01);
  const Slide::Ellipse preview = workspace_.fit_across(front_stroke(0.3, 0.5, 0.15), {0, 0, -1});
  EXPECT_EQ(preview.center, slide.ellipse.center);
}

TEST_F(WorkspaceSlidesTest, AStrokeThatSaysNoPlaneIsRefusedAndNothingChanges) {
  workspace_.open(model_);
  const std::string before = bytes();
  const std::vector<Point3> along_sight = {{0, 0, 0.4}, {0, 0, 0.2}};
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] {
                      workspace_.add_slide_across(along_sight, {0, 0, 1});
                    }),
                    "no direction across the line of sight"));
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] {
                      workspace_.add_slide_across({{0, 0, 0}}, {0, 0, 1});
                    }),
                    "needs two points"));
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] {
                      workspace_.add_slide_across(front_stroke(0, 0, 0.1), {0, 0, 0});
                    }),
                    "line of sight"));
  EXPECT_EQ(bytes(), before);
  EXPECT_FALSE(workspace_.stack().can_undo());
}

TEST_F(WorkspaceSlidesTest, AStrokeThatTheEllipseIsFittedToIsKeptAndCanBeExtended) {
  workspace_.open(model_);
  const std::int64_t added = workspace_.add_slide({"ring", Slide::Stroke{ring(0.4, 0, 10, 20)}});
  EXPECT_EQ(workspace_.document().find_slide(added)->stroke.size(), 10U);
  workspace_.extend_stroke(added, ring(0.4, 10, 20, 20));
  const SceneSlide& slide = *workspace_.document().find_slide(added);
  EXPECT_EQ(slide.stroke.size(), 20U);
  EXPECT_NEAR(length(slide.ellipse.u), 0.5 * std::sqrt(1 - 0.04), 1e-6);
  EXPECT_EQ(workspace_.stack().undo_label(), "extend the stroke of \"ring\"");
  workspace_.undo();
  EXPECT_EQ(workspace_.document().find_slide(added)->stroke.size(), 10U);
  workspace_.change_slides({{added, ellipse("ring")}}, "move slide");
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] { workspace_.extend_stroke(added, ring(0.4, 10, 20, 20)); }),
                    "\"ring\" was not fitted to a stroke"));
}

TEST_F(WorkspaceSlidesTest, MirroredSlidesAreOnTheOtherSideWithTheirNormalsMirrored) {
  open_with_slides({});
  workspace_.add_slide({"left arm", Slide::PointNormal{{0.3, 0.5, 0}, {0.2, 1, 0}}});
  const auto made = workspace_.mirror_slides({id("left arm")}, 0, {});
  EXPECT_EQ(names(), (Names{"left arm", "right arm"}));
  EXPECT_EQ(workspace_.selection(), made);
  const Slide::Ellipse here = ellipse("left arm");
  const Slide::Ellipse there = ellipse("right arm");
  EXPECT_NEAR(there.center[0], -here.center[0], 1e-7) << "across the middle of the box";
  EXPECT_EQ(there.center[1], here.center[1]);
  const auto normal = [](const Slide::Ellipse& e) {
    return Point3{e.u[1] * e.v[2] - e.u[2] * e.v[1], e.u[2] * e.v[0] - e.u[0] * e.v[2],
                  e.u[0] * e.v[1] - e.u[1] * e.v[0]};
  };
  EXPECT_NEAR(normal(there)[0], -normal(here)[0], 1e-12);
  EXPECT_NEAR(normal(there)[1], normal(here)[1], 1e-12);
  workspace_.mirror_slides({id("left arm")}, 1, 0.0);
  EXPECT_EQ(names().back(), "right arm 2");
  EXPECT_NEAR(ellipse("right arm 2").center[1], -here.center[1], 1e-12);
}

TEST_F(WorkspaceSlidesTest, SnappedSlidesAreThoseOfTheLoopInTheirPlane) {
  open_with_slides({0.5});
  const Slide::Ellipse good = ellipse("slide 1");
  Slide::Ellipse off = good;
  off.center[0] += 0.1;
  for (double& x : off.u) x *= 1.5;
  workspace_.change_slides({{id("slide 1"), off}}, "move slide");
  workspace_.snap_slides({id("slide 1")});
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(ellipse("slide 1").center[k], good.center[k], 1e-9);
  EXPECT_NEAR(length(ellipse("slide 1").u), length(good.u), 1e-9);
}

TEST_F(WorkspaceSlidesTest, CopiedSlidesCanBePastedIntoAnotherSceneUnderFreeNames) {
  open_with_slides({-0.5, 0.5});
  const std::string text = workspace_.copy_slides({id("slide 1"), id("slide 2")});
  const Slide::Ellipse first = ellipse("slide 1");
  workspace_.paste_slides(text);
  EXPECT_EQ(names(), (Names{"slide 1", "slide 2", "slide 1 2", "slide 2 2"}));
  workspace_.close();
  workspace_.open(write_model("other.off", ellipsoid(12, 24)));
  workspace_.paste_slides(text);
  EXPECT_EQ(names(), (Names{"slide 1", "slide 2"}));
  EXPECT_EQ(ellipse("slide 1").u, first.u) << "the same doubles";
  const std::string before = bytes();
  EXPECT_TRUE(holds(sentence_of<FileError>([&] { workspace_.paste_slides("some text"); }), "is not JSON"));
  EXPECT_EQ(bytes(), before);
}

TEST_F(WorkspaceSlidesTest, WhatIsSelectedGoesWithItsSlideAndIsNoStepOfUndo) {
  open_with_slides({-0.5, 0.5});
  EXPECT_EQ(workspace_.selection(), std::vector{id("slide 2")}) << "a new slide is selected";
  workspace_.select({id("slide 1"), id("slide 2")});
  workspace_.undo();
  EXPECT_EQ(workspace_.selection(), std::vector{id("slide 1")});
  EXPECT_THROW(workspace_.select({12345}), CommandError);
}

TEST_F(WorkspaceSlidesTest, WhatUndoAndRedoBringBackOrChangeIsSelected) {
  open_with_slides({-0.5, 0.5, 0.9});
  const std::int64_t first = id("slide 1"), second = id("slide 2");
  workspace_.remove_slides({first, second});
  workspace_.select({id("slide 3")});
  workspace_.undo();
  EXPECT_EQ(std::ranges::count(workspace_.selection(), first), 1);
  EXPECT_EQ(std::ranges::count(workspace_.selection(), second), 1);
  EXPECT_EQ(workspace_.selection().size(), 2U) << "slide 3 has not changed";
  workspace_.redo();
  EXPECT_TRUE(workspace_.selection().empty());
  workspace_.undo();

  const std::vector<std::int64_t> mirrored = workspace_.mirror_slides({first}, 1, {});
  workspace_.undo();
  EXPECT_TRUE(workspace_.selection().empty());
  workspace_.redo();
  EXPECT_EQ(workspace_.selection(), mirrored);

  workspace_.rename_slide(second, "knee");
  workspace_.select({});
  workspace_.undo();
  EXPECT_EQ(workspace_.selection(), std::vector{second});
}

TEST_F(WorkspaceSlidesTest, ACopysCopyIsAnotherCopyOfTheSame) {
  open_with_slides({-0.5});
  std::vector<std::int64_t> last = {id("slide 1")};
  for (int i = 0; i < 3; ++i) last = workspace_.duplicate_slides(last);
  EXPECT_EQ(names(), (Names{"slide 1", "slide 1 copy", "slide 1 copy 2", "slide 1 copy 3"}));
  workspace_.rename_slide(id("slide 1"), "copy");
  workspace_.duplicate_slides({id("copy")});
  EXPECT_EQ(names().back(), "copy copy");
}

TEST_F(WorkspaceSlidesTest, CopiesOfALongNameAndOfOnesThatEndInNumbers) {
  open_with_slides({-0.5});
  for (const auto& [name, copy] :
       {std::pair<std::string, std::string>(std::string(1000000, 'a'), std::string(1000000, 'a') + " copy"),
        {"rib 7", "rib 7 copy"},
        {"7", "7 copy"},
        {"rib copy7", "rib copy7 copy"},
        {" copy", " copy copy"}}) {
    workspace_.rename_slide(workspace_.slides().front()->id, name);
    workspace_.duplicate_slides({workspace_.slides().front()->id});
    EXPECT_TRUE(names().back() == copy) << copy.substr(0, 20);
    workspace_.undo();
  }
}

TEST_F(WorkspaceSlidesTest, WhatCannotBeDoneIsSaidInASentenceAndChangesNothing) {
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] { workspace_.add_slide(across("a", 0)); }), "no scene is open"));
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] { workspace_.undo(); }), "no scene is open"));
  open_with_slides({0});
  const std::string before = bytes();
  EXPECT_TRUE(holds(sentence_of<PluginError>([&] { workspace_.add_slide(across("far", 9)); }), "'far'"));
  EXPECT_TRUE(
      holds(sentence_of<CommandError>([&] { workspace_.add_slide(across("slide 1", 1)); }), "choose another name"));
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] { workspace_.remove_slides({id("slide 1"), 99}); }), "id 99"));
  Slide::Ellipse bad = ellipse("slide 1");
  bad.u[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] {
                      workspace_.change_slides({{id("slide 1"), ellipse("slide 1")}, {id("slide 1"), bad}}, "move");
                    }),
                    "\"slide 1\""));
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] { workspace_.mirror_slides({id("slide 1")}, 3, {}); }), "axis"));
  EXPECT_TRUE(
      holds(sentence_of<CommandError>([&] { workspace_.set_parameter("no.such", 1); }), "no parameter \"no.such\""));
  EXPECT_TRUE(
      holds(sentence_of<CommandError>([&] { workspace_.set_parameter("refine.iterations", -1); }), "has to be from"));
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] { workspace_.set_parameter("refine.iterations", 2.5); }), "whole"));
  EXPECT_EQ(bytes(), before);
  EXPECT_EQ(workspace_.stack().undo_label(), "add slide \"slide 1\"");
}

TEST_F(WorkspaceSlidesTest, WithoutAPluginSlidesCanBeMovedButNotFitted) {
  Workspace bare(nullptr, {});
  bare.open(own_scene("slides_plain.gltf"));
  const SceneSlide& slide = *bare.slides().front();
  bare.change_slides({{slide.id, slide.ellipse}}, "move slide");
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] { bare.add_slide(across("a", 0)); }), "none is loaded"));
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] { bare.set_parameter("orient.lambda", 1); }), "no plug-in"));
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] { bare.solve(); }), "none is loaded"));
  bare.wait_for_cage();
  EXPECT_TRUE(bare.cage().cage.triangles.empty());
  bare.save(folder_ / "moved.glb");
  Workspace again(nullptr, {});
  again.open(folder_ / "moved.glb");
  EXPECT_EQ(again.slides().size(), bare.slides().size());
}

TEST_F(WorkspaceSlidesTest, ParametersAreStepsThatUndoTakesBack) {
  open_with_slides({0});
  const double before = workspace_.parameter("orient.lambda");
  workspace_.set_parameter("orient.lambda", 9);
  EXPECT_EQ(workspace_.parameter("orient.lambda"), 9);
  workspace_.set_parameter("orient.lambda", 9);
  workspace_.set_parameter("refine.iterations", 12);
  workspace_.reset_parameters();
  EXPECT_EQ(workspace_.parameter("orient.lambda"), before);
  EXPECT_EQ(workspace_.stack().undo_label(), "reset the parameters");
  workspace_.undo();
  EXPECT_EQ(workspace_.parameter("refine.iterations"), 12);
  workspace_.undo();
  workspace_.undo();
  EXPECT_EQ(workspace_.parameter("orient.lambda"), before) << "the value that was there already is no step";
}

}  // namespace
}  // namespace cagewright::host::test
