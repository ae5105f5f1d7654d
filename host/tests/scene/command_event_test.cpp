// SPDX-License-Identifier: BSD-3-Clause
#include "host/command/cage_commands.h"
#include "host/command/slide_commands.h"
#include "host/tests/scene/command_test_scene.h"

namespace cagewright::host {

void PrintTo(const SceneEvent& event, std::ostream* out) {
  *out << "kind " << static_cast<int>(event.kind) << ", slide " << event.slide << ", node " << event.mesh_node;
}

}  // namespace cagewright::host

namespace cagewright::host::test {
namespace {

using Kind = SceneEvent::Kind;

// Two mesh nodes, each with a slide and a cage.
class Events : public testing::Test {
 protected:
  void expect(Kind kind, std::int64_t slide, int mesh_node) {
    ASSERT_EQ(heard.size(), 1u);
    EXPECT_EQ(heard[0].kind, kind) << testing::PrintToString(heard[0]);
    EXPECT_EQ(heard[0].slide, slide);
    EXPECT_EQ(heard[0].mesh_node, mesh_node);
    heard.clear();
  }

  SceneDocument document = own_scene("slides_two_caged_meshes.gltf");
  const int node = document.find_slide(2)->mesh_node;
  std::vector<SceneEvent> heard;
  std::unique_ptr<SceneDocument::Subscription> subscription =
      document.listen([this](const SceneEvent& event) { heard.push_back(event); });
};

TEST_F(Events, OfAnAddedSlide) {
  AddSlide command(node, "new", some_ellipse(1));
  command.doIt(document);
  expect(Kind::slide_added, command.id(), node);
  command.undoIt(document);
  expect(Kind::slide_removed, command.id(), node);
  command.redoIt(document);
  expect(Kind::slide_added, command.id(), node);
}

TEST_F(Events, OfARemovedSlide) {
  RemoveSlide command(2);
  command.doIt(document);
  expect(Kind::slide_removed, 2, node);
  command.undoIt(document);
  expect(Kind::slide_added, 2, node);
  command.redoIt(document);
  expect(Kind::slide_removed, 2, node);
}

TEST_F(Events, OfAChangedAndARenamedSlide) {
  ChangeSlide change(2, some_ellipse(1));
  RenameSlide rename(2, "new");
  for (Command* command : std::initializer_list<Command*>{&change, &rename}) {
    command->doIt(document);
    expect(Kind::slide_changed, 2, node);
    command->undoIt(document);
    expect(Kind::slide_changed, 2, node);
    command->redoIt(document);
    expect(Kind::slide_changed, 2, node);
  }
}

TEST_F(Events, OfACage) {
  SetCage other(some_cage(node, {2}, 1));
  other.doIt(document);
  expect(Kind::cage_set, 0, node);
  other.undoIt(document);
  expect(Kind::cage_set, 0, node);
  RemoveCage remove(node);
  remove.doIt(document);
  expect(Kind::cage_removed, 0, node);
  SetCage first(some_cage(node, {2}, 1));
  first.doIt(document);
  expect(Kind::cage_set, 0, node);
  first.undoIt(document);
  expect(Kind::cage_removed, 0, node);
  first.redoIt(document);
  expect(Kind::cage_set, 0, node);
  first.undoIt(document);
  expect(Kind::cage_removed, 0, node);
  remove.undoIt(document);
  expect(Kind::cage_set, 0, node);
}

TEST_F(Events, ComeAfterTheChange) {
  bool has_seen = false;
  const auto looking = document.listen([&](const SceneEvent& event) {
    has_seen = event.kind == Kind::slide_added && document.find_slide(event.slide) != nullptr;
  });
  AddSlide(node, "new", some_ellipse(1)).doIt(document);
  EXPECT_TRUE(has_seen);
}

TEST_F(Events, AreNotToldWhereACommandFails) {
  expect_refused(document, RemoveSlide(99), {});
  expect_refused(document, AddSlide(node, "", some_ellipse(1)), {});
  expect_refused(document, SetCage(some_cage(-1, {}, 1)), {});
  EXPECT_TRUE(heard.empty());
}

TEST_F(Events, GoToEveryListenerUntilItsSubscriptionEnds) {
  int others = 0;
  auto other = document.listen([&](const SceneEvent&) { ++others; });
  RenameSlide(2, "a").doIt(document);
  other.reset();
  RenameSlide(2, "b").doIt(document);
  EXPECT_EQ(others, 1);
  EXPECT_EQ(heard.size(), 2u);
  subscription.reset();
  RenameSlide(2, "c").doIt(document);
  EXPECT_EQ(heard.size(), 2u);
}

TEST_F(Events, EndWithASubscriptionThatIsDestroyedWhileTheyAreTold) {
  int others = 0;
  std::unique_ptr<SceneDocument::Subscription> later;
  const auto ending = document.listen([&](const SceneEvent&) { later.reset(); });
  later = document.listen([&](const SceneEvent&) { ++others; });
  RenameSlide(2, "a").doIt(document);
  RenameSlide(2, "b").doIt(document);
  EXPECT_EQ(others, 0);
  EXPECT_EQ(heard.size(), 2u);
}

TEST_F(Events, ReachAListenerThatComesWhileTheyAreToldFromTheNextOneOn) {
  int others = 0;
  std::vector<std::unique_ptr<SceneDocument::Subscription>> later;
  const auto adding = document.listen([&](const SceneEvent&) {
    for (int i = 0; i < 100; ++i) later.push_back(document.listen([&](const SceneEvent&) { ++others; }));
  });
  const auto last = document.listen([](const SceneEvent&) {});
  RenameSlide(2, "a").doIt(document);
  EXPECT_EQ(others, 0);
  RenameSlide(2, "b").doIt(document);
  EXPECT_EQ(others, 100);
}

TEST_F(Events, SubscriptionMayOutliveTheDocument) {
  std::unique_ptr<SceneDocument::Subscription> left;
  {
    SceneDocument gone = own_scene("slides_plain.gltf");
    left = gone.listen([](const SceneEvent&) {});
  }
  left.reset();
}

TEST_F(Events, FollowADocumentThatIsMoved) {
  SceneDocument moved = std::move(document);
  RenameSlide(2, "a").doIt(moved);
  expect(Kind::slide_changed, 2, node);
}

}  // namespace
}  // namespace cagewright::host::test
