// SPDX-License-Identifier: BSD-3-Clause
// What is shown while the slides as they are give no cage.
#include "host/tests/workspace/workspace_fixture.h"

namespace cagewright::host::test {
namespace {

using LastGoodCageTest = WorkspaceTest;

TEST_F(LastGoodCageTest, AFailingSlideIsNamedInAProblemAndTheLastGoodCageStays) {
  open_with_slides({-0.5, 0.5});
  workspace_.wait_for_cage();
  const TriangleMesh good = workspace_.cage().cage;
  workspace_.add_slide({"across it", Slide::PointNormal{{0.3, -0.5, 0}, {0.4, 1, 0}}});
  workspace_.wait_for_cage();
  const CageState& cage = workspace_.cage();
  EXPECT_EQ(cage.cage.points, good.points);
  EXPECT_TRUE(cage.failed);
  EXPECT_FALSE(cage.is_of_now);
  ASSERT_FALSE(cage.problems.empty());
  const Problem& problem = cage.problems.front();
  EXPECT_EQ(std::set(problem.slides.begin(), problem.slides.end()), (std::set{id("slide 1"), id("across it")}));
  EXPECT_TRUE(holds(problem.sentence, "'across it'")) << problem.sentence;
  workspace_.undo();
  workspace_.wait_for_cage();
  EXPECT_FALSE(workspace_.cage().failed);
  EXPECT_TRUE(workspace_.cage().is_of_now);
  EXPECT_TRUE(workspace_.cage().problems.empty());
}

TEST_F(LastGoodCageTest, TheLastGoodCageIsThatOfTheDragThatWentWrongAndNotAnOlderOne) {
  open_with_slides({-0.5});
  workspace_.wait_for_cage();
  const TriangleMesh of_one = workspace_.cage().cage;
  workspace_.add_slide(across("", 0.5));  // no whole cage of both is waited for
  Slide::Ellipse dragged = ellipse("slide 2");
  dragged.center[1] = 0.2;
  workspace_.set_preview({{id("slide 2"), dragged}});
  workspace_.wait_for_cage();
  ASSERT_TRUE(workspace_.cage().is_of_editing);
  const TriangleMesh of_drag = workspace_.cage().cage;
  dragged.center[1] = -0.5;
  dragged.u = {1, 0.4, 0};
  workspace_.set_preview({{id("slide 2"), dragged}});
  workspace_.wait_for_cage();
  workspace_.change_slides({{id("slide 2"), dragged}}, "move slide");
  workspace_.wait_for_cage();
  ASSERT_TRUE(workspace_.cage().failed);
  EXPECT_FALSE(workspace_.cage().is_of_now);
  EXPECT_FALSE(workspace_.cage().problems.empty());
  EXPECT_EQ(workspace_.cage().cage.points, of_drag.points);
  EXPECT_NE(workspace_.cage().cage.points, of_one.points);
  workspace_.undo();
  workspace_.wait_for_cage();
  EXPECT_TRUE(workspace_.cage().is_of_now);
  EXPECT_EQ(workspace_.cage().section_slides.size(), 2U);
}

TEST_F(LastGoodCageTest, ADragThatWasGivenUpLeavesNoLastGoodCage) {
  open_with_slides({-0.5, 0.5});
  workspace_.wait_for_cage();
  const TriangleMesh good = workspace_.cage().cage;
  Slide::Ellipse dragged = ellipse("slide 2");
  dragged.center[1] = 0.2;
  workspace_.set_preview({{id("slide 2"), dragged}});
  workspace_.wait_for_cage();
  workspace_.clear_preview();
  workspace_.add_slide({"across it", Slide::PointNormal{{0.3, -0.5, 0}, {0.4, 1, 0}}});
  workspace_.wait_for_cage();
  ASSERT_TRUE(workspace_.cage().failed);
  EXPECT_EQ(workspace_.cage().cage.points, good.points);
}

TEST_F(LastGoodCageTest, ADragThatWasGivenUpWhereSlidesFailLeavesTheLastGoodCageAsItWas) {
  open_with_slides({-0.5, 0.5});
  workspace_.wait_for_cage();
  const TriangleMesh good = workspace_.cage().cage;
  workspace_.add_slide({"across it", Slide::PointNormal{{0.3, -0.5, 0}, {0.4, 1, 0}}});
  workspace_.wait_for_cage();
  ASSERT_TRUE(workspace_.cage().failed);
  Slide::Ellipse away = ellipse("across it");
  away.center[1] = 0;
  away.u = {0.8, 0, 0};
  away.v = {0, 0, 0.8};
  workspace_.set_preview({{id("across it"), away}});
  workspace_.wait_for_cage();
  ASSERT_NE(workspace_.cage().cage.points, good.points) << "the drag's cage is shown while it goes on";
  workspace_.clear_preview();
  workspace_.wait_for_cage();
  EXPECT_TRUE(workspace_.cage().failed);
  EXPECT_EQ(workspace_.cage().cage.points, good.points);
}

}  // namespace
}  // namespace cagewright::host::test
