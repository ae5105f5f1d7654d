// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/command_stack.h"

#include "host/command/cage_commands.h"
#include "host/command/slide_commands.h"
#include "host/tests/scene/command_test_scene.h"

namespace cagewright::host::test {
namespace {

class Stack : public testing::Test {
 protected:
  void add(const std::string& name) { stack.run(std::make_unique<AddSlide>(0, name, some_ellipse(1))); }

  SceneDocument document = own_scene("material_texture.glb");
  const std::string original = document.bytes();
  CommandStack stack{document};
};

TEST_F(Stack, HasNothingToUndoOrRedoAtFirst) {
  EXPECT_FALSE(stack.undo());
  EXPECT_FALSE(stack.redo());
  EXPECT_EQ(stack.undo_label() + stack.redo_label(), "");
  EXPECT_EQ(document.bytes(), original);
}

TEST_F(Stack, UndoesTheLastFirstAndNamesIt) {
  add("a");
  add("b");
  EXPECT_EQ(stack.undo_label(), "add slide \"b\"");
  EXPECT_TRUE(stack.undo());
  EXPECT_EQ(document.slides().size(), 1u);
  EXPECT_EQ(document.slides()[0].name, "a");
  EXPECT_EQ(stack.undo_label(), "add slide \"a\"");
  EXPECT_EQ(stack.redo_label(), "add slide \"b\"");
  EXPECT_TRUE(stack.undo());
  EXPECT_EQ(document.bytes(), original);
  EXPECT_FALSE(document.is_changed());
}

TEST_F(Stack, ForgetsWhatWasUndoneAtTheNextCommand) {
  add("a");
  stack.undo();
  add("b");
  EXPECT_FALSE(stack.redo());
  EXPECT_EQ(document.slides().at(0).name, "b");
}

TEST_F(Stack, KeepsWhatWasUndoneWhereACommandFails) {
  add("a");
  add("b");
  const std::string both = document.bytes();
  stack.undo();
  EXPECT_THROW(add("a"), CommandError);
  EXPECT_THROW(stack.run(std::make_unique<RemoveCage>(0)), CommandError);
  EXPECT_EQ(stack.redo_label(), "add slide \"b\"");
  EXPECT_TRUE(stack.redo());
  EXPECT_EQ(document.bytes(), both);
  EXPECT_TRUE(stack.undo());
  EXPECT_TRUE(stack.undo());
  EXPECT_FALSE(stack.undo()) << "what failed is not there to be undone";
}

}  // namespace
}  // namespace cagewright::host::test
