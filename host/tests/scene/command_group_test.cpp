// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/command_group.h"

#include <limits>

#include "host/command/command_stack.h"
#include "host/command/set_parameters.h"
#include "host/command/slide_commands.h"
#include "host/tests/scene/command_test_scene.h"

namespace cagewright::host::test {
namespace {

template <class... Commands>
CommandGroup group(const std::string& label, Commands&&... commands) {
  std::vector<std::unique_ptr<Command>> list;
  (list.push_back(std::make_unique<std::decay_t<Commands>>(std::forward<Commands>(commands))), ...);
  return CommandGroup(label, std::move(list));
}

TEST(CommandGroup, IsOneStepOfAllItsCommands) {
  SceneDocument document = own_scene("slides_plain.gltf");
  CommandGroup step = group("two at once", RemoveSlide(1), AddSlide(0, "waist", some_ellipse(3)), RemoveSlide(7));
  EXPECT_EQ(step.label(), "two at once");
  expect_reversible(document, step);
  EXPECT_EQ(document.slides().size(), 1U);
}

TEST(CommandGroup, WhereOneFailsThoseBeforeItAreUndone) {
  SceneDocument document = own_scene("slides_plain.gltf");
  expect_refused(document, group("two", RemoveSlide(1), RenameSlide(7, "knee"), RemoveSlide(99)), {"99"});
}

TEST(CommandStack, ItsStateIsTheSameWhereTheDocumentIsTheSame) {
  SceneDocument document = own_scene("slides_plain.gltf");
  CommandStack stack(document);
  const std::uint64_t first = stack.state();
  stack.run(std::make_unique<RenameSlide>(1, "a"));
  const std::uint64_t second = stack.state();
  EXPECT_NE(second, first);
  stack.run(std::make_unique<RenameSlide>(1, "b"));
  stack.undo();
  EXPECT_EQ(stack.state(), second);
  stack.undo();
  EXPECT_EQ(stack.state(), first);
  stack.run(std::make_unique<RenameSlide>(1, "c"));
  EXPECT_NE(stack.state(), second) << "as many steps, but others";
}

TEST(SetParameters, AreOfTheFilesCageFirstAndThenWhatWasSet) {
  SceneDocument document = own_scene("slides_two_caged_meshes.gltf");
  using Values = SetParameters::Values;
  const Values before = document.parameters(0);
  EXPECT_EQ(before, (Values{{"orient.lambda", 4}, {"refine.delta", 0.01}}));
  EXPECT_TRUE(document.parameters(4).empty());
  std::vector<SceneEvent> events;
  const auto subscription = document.listen([&](const SceneEvent& event) { events.push_back(event); });
  SetParameters command(1, {{"orient.lambda", 7}}, "set Alignment");
  command.doIt(document);
  EXPECT_EQ(document.parameters(1), (Values{{"orient.lambda", 7}}));
  EXPECT_EQ(document.parameters(0), before);
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events[0].kind, SceneEvent::Kind::parameters_set);
  EXPECT_EQ(events[0].mesh_node, 1);
  command.undoIt(document);
  EXPECT_EQ(document.parameters(1), before);
  command.redoIt(document);
  EXPECT_EQ(document.parameters(1), (Values{{"orient.lambda", 7}}));
  EXPECT_EQ(command.label(), "set Alignment");
}

TEST(SetParameters, RefuseWhatAFileCouldNotHold) {
  SceneDocument document = own_scene("slides_plain.gltf");
  expect_refused(document, SetParameters(5, {}, "x"), {"node 5", "choose one that has"});
  expect_refused(document, SetParameters(0, {{"\xff", 1}}, "x"), {"not UTF-8"});
  expect_refused(document, SetParameters(0, {{"a", std::numeric_limits<double>::infinity()}}, "x"),
                 {"\"a\"", "finite"});
}

}  // namespace
}  // namespace cagewright::host::test
