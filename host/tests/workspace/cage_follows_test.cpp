// SPDX-License-Identifier: BSD-3-Clause
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

#include "host/tests/workspace/workspace_fixture.h"
#include "host/workspace/cage_solver.h"
#include "host/workspace/find_problem.h"
#include "host/workspace/solved_cage.h"

namespace cagewright::host::test {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

std::size_t thread_count() {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) count += entry.exists() ? 1 : 0;
  return count;
}

// Counts the plug-in's news and lets a test sleep until there are some.
class News {
 public:
  std::function<void()> teller() {
    return [this] {
      const std::lock_guard lock(mutex_);
      ++count_;
      changed_.notify_all();
    };
  }
  // False after ten seconds without.
  bool wait_for(const std::function<bool()>& is_so) {
    std::unique_lock lock(mutex_);
    const auto end = Clock::now() + std::chrono::seconds(10);
    while (!is_so()) {
      const int seen = count_;
      if (!changed_.wait_until(lock, end, [&] { return count_ != seen; })) return is_so();
    }
    return true;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  int count_ = 0;
};

class CageFollowsTest : public WorkspaceTest {
 protected:
  // As the window does: told by the solver's thread, asked on this one.
  static bool wait_until(Workspace& workspace, News& news, const std::function<bool()>& is_so) {
    return news.wait_for([&] {
      workspace.poll();
      return is_so();
    });
  }
};

TEST_F(CageFollowsTest, TheCageIsThatOfTheSlidesWithoutBeingAskedFor) {
  News news;
  Workspace workspace(plugin_, news.teller());
  workspace.open(model_);
  workspace.add_slide(across("waist", 0.1));
  EXPECT_FALSE(workspace.cage().is_of_now);
  ASSERT_TRUE(wait_until(workspace, news, [&] { return workspace.cage().is_of_now; }));
  const CageState& cage = workspace.cage();
  EXPECT_FALSE(cage.is_of_editing);
  EXPECT_TRUE(cage.problems.empty());
  ASSERT_TRUE(cage.certificate);
  EXPECT_TRUE(cage.certificate->encloses);
  EXPECT_EQ(cage.section_slides, std::vector{workspace.find_slide("waist")->id});
  EXPECT_EQ(cage.vertex_sections.size(), cage.cage.vertex_count());
  EXPECT_EQ(cage.triangle_parts.size(), cage.cage.triangle_count());
  EXPECT_EQ(cage.cut_model_parts.size(), cage.cut_model.triangle_count());
  EXPECT_GT(cage.measures->volume_ratio, 1);
  EXPECT_EQ(cage.max_signed_distances.size(), cage.summary.iterations + 1);
  ASSERT_TRUE(cage.report);
  EXPECT_EQ(cage.report->slides.size(), 1U);
}

TEST_F(CageFollowsTest, ADragShowsAPreviewAndIsOneStepOfUndo) {
  open_with_slides({-0.5, 0.5});
  workspace_.wait_for_cage();
  const std::string before = bytes();
  const CageState good = workspace_.cage();
  const std::string label_before = workspace_.stack().undo_label();
  Slide::Ellipse dragged = ellipse("slide 2");
  for (int step = 0; step < 5; ++step) {
    dragged.center[1] += 0.05;
    workspace_.set_preview({{id("slide 2"), dragged}});
  }
  EXPECT_EQ(bytes(), before);
  workspace_.wait_for_cage();
  EXPECT_TRUE(workspace_.cage().is_of_editing);
  EXPECT_TRUE(workspace_.cage().is_of_now);
  EXPECT_FALSE(workspace_.cage().certificate);
  EXPECT_EQ(workspace_.cage().section_slides, (std::vector{id("slide 1"), id("slide 2")}));
  EXPECT_NE(workspace_.cage().cage.points, good.cage.points);

  workspace_.clear_preview();  // the mouse let go where it was: nothing has to be solved
  EXPECT_TRUE(workspace_.cage().is_of_now);
  EXPECT_EQ(workspace_.cage().cage.points, good.cage.points);
  EXPECT_EQ(workspace_.stack().undo_label(), label_before);

  workspace_.set_preview({{id("slide 2"), dragged}});
  workspace_.change_slides({{id("slide 2"), dragged}}, "move slide");
  EXPECT_TRUE(workspace_.preview().empty());
  workspace_.wait_for_cage();
  EXPECT_FALSE(workspace_.cage().is_of_editing);
  EXPECT_TRUE(workspace_.cage().is_of_now);
  EXPECT_TRUE(workspace_.cage().certificate->encloses);
  EXPECT_EQ(workspace_.stack().undo_label(), "move slide");
  workspace_.undo();
  EXPECT_EQ(bytes(), before);
  workspace_.wait_for_cage();
  EXPECT_EQ(workspace_.cage().cage.points, good.cage.points) << "the same bits on the way back";
}

TEST_F(CageFollowsTest, TheCageOfAPreviewThatComesLateIsNotShown) {
  open_with_slides({-0.5, 0.5});
  workspace_.wait_for_cage();
  Slide::Ellipse dragged = ellipse("slide 2");
  dragged.center[1] += 0.2;
  workspace_.set_preview({{id("slide 2"), dragged}});
  while (workspace_.progress().fraction < 1) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  workspace_.rename_slide(id("slide 1"), "knee");  // before anybody has taken it
  workspace_.poll();
  EXPECT_FALSE(workspace_.cage().is_of_editing);
  workspace_.wait_for_cage();
  EXPECT_FALSE(workspace_.cage().is_of_editing);
  EXPECT_TRUE(workspace_.cage().is_of_now);
}

TEST_F(CageFollowsTest, AStrokeThatIsBeingDrawnIsASlideOfTheCageWithoutAnId) {
  open_with_slides({-0.5});
  workspace_.set_preview({{-1, workspace_.fit(across("", 0.5))}});
  workspace_.wait_for_cage();
  EXPECT_EQ(workspace_.cage().section_slides, (std::vector<std::int64_t>{id("slide 1"), -1}));
  EXPECT_EQ(names(), std::vector<std::string>{"slide 1"});
}

TEST_F(CageFollowsTest, ASlideThatMissesTheModelIsAProblemOfThatSlideAlone) {
  open_with_slides({0});
  Slide::Ellipse away = ellipse("slide 1");
  away.center[1] = 7;
  workspace_.add_slide({"away", away});
  workspace_.wait_for_cage();
  ASSERT_EQ(workspace_.cage().problems.size(), 1U);
  EXPECT_EQ(workspace_.cage().problems[0].slides, std::vector{id("away")});
}

TEST_F(CageFollowsTest, EverySlideThatFailsIsAProblemAndAPairIsOne) {
  open_with_slides({-0.5, 0});
  Slide::Ellipse away = ellipse("slide 1");
  away.center[1] = 7;
  workspace_.add_slide({"away", away});
  workspace_.add_slide({"across it", Slide::PointNormal{{0, 0, 0}, {0.4, 1, 0}}});
  workspace_.wait_for_cage();
  const CageState& cage = workspace_.cage();
  ASSERT_EQ(cage.problems.size(), 2U);
  EXPECT_EQ(cage.problems[0].slides, std::vector{id("away")});
  EXPECT_EQ(cage.problems[1].slides, (std::vector{id("slide 2"), id("across it")}));
  for (const char* name : {"slide 2", "across it", "away"}) EXPECT_NE(find_problem(cage, id(name)), nullptr) << name;
  EXPECT_EQ(find_problem(cage, id("slide 1")), nullptr);
}

TEST_F(CageFollowsTest, ASlideThatThePluginDoesNotEvenTakeIsNamedToo) {
  CageSolver solver(plugin_, {});
  const auto mesh = std::make_shared<const TriangleMesh>(ellipsoid(24, 48));
  const Slide::Ellipse good{{0, 0, 0}, {0.5, 0, 0}, {0, 0, -0.4}}, flat{{0, 1, 0}, {0.5, 0, 0}, {0.5, 0, 0}};
  const Slide::Ellipse other{{0, -1, 0}, {0.43, 0, 0}, {0, 0, -0.35}};
  solver.request({0, mesh, {{4, {"good", good}}, {7, {"old", other}}}, {}, false, 1});
  solver.wait();
  EXPECT_FALSE(solver.take_result()->state.failed);
  solver.request({0, mesh, {{4, {"good", good}}, {5, {"flat", flat}}, {6, {"other", other}}}, {}, false, 2});
  solver.wait();
  const SolveResult refused = *solver.take_result();
  EXPECT_TRUE(refused.state.failed);
  ASSERT_EQ(refused.state.problems.size(), 1U);
  EXPECT_EQ(refused.state.problems[0].slides, std::vector<std::int64_t>{5}) << refused.state.problems[0].sentence;
  solver.request({0, mesh, {{4, {"good", good}}, {6, {"other", other}}}, {}, false, 3});
  solver.wait();
  const SolveResult mended = *solver.take_result();
  EXPECT_FALSE(mended.state.failed);
  EXPECT_EQ(mended.state.section_slides, (std::vector<std::int64_t>{4, 6}));
}

TEST_F(CageFollowsTest, ACertificateThatFailsIsAProblemThatNamesItsSlidesAndAPlace) {
  CageState state;
  SolveRequest request;
  request.mesh = std::make_shared<const TriangleMesh>(ellipsoid(4, 4));
  request.slides = {{4, {"a", Slide::Ellipse{}}}, {5, {"b", Slide::Ellipse{}}}};
  state.summary.last_stage = CGW_STAGE_ENCLOSE;
  state.certificate = Certificate{};
  state.certificate->message = "2 vertices are outside: that is near the slide 'b': add a slide there";
  state.certificate->vertices_outside = {0};
  const std::vector<Problem> problems = problems_of(state, request);
  ASSERT_EQ(problems.size(), 1U);
  EXPECT_EQ(problems[0].sentence, state.certificate->message);
  EXPECT_EQ(problems[0].slides, std::vector<std::int64_t>{5});
  EXPECT_EQ(problems[0].place, (Point3{0, -2, 0}));
  state.summary.last_stage = CGW_STAGE_REFINE;
  EXPECT_TRUE(problems_of(state, request).empty()) << "nobody asked for one";
}

TEST_F(CageFollowsTest, WhatCouldBeBetterOfACertifiedCageIsAdviceAndNoFault) {
  CageState state;
  SolveRequest request;
  request.slides = {{4, {"a", Slide::Ellipse{}}}, {5, {"b", Slide::Ellipse{}}}};
  state.summary.last_stage = CGW_STAGE_ENCLOSE;
  state.certificate = Certificate{};
  state.certificate->encloses = state.certificate->keeps_distance = true;
  EXPECT_TRUE(problems_of(state, request).empty());
  state.certificate->message = "the sections of the slide 'b' could not stay in their planes: move it";
  state.problems = problems_of(state, request);
  ASSERT_EQ(state.problems.size(), 1U);
  EXPECT_EQ(state.problems[0].sentence, state.certificate->message);
  EXPECT_EQ(state.problems[0].slides, std::vector<std::int64_t>{5});
  EXPECT_TRUE(state.problems[0].is_advice);
  EXPECT_EQ(find_problem(state, 5), nullptr) << "it would be drawn as failing";
  state.certificate->keeps_distance = false;
  EXPECT_FALSE(problems_of(state, request)[0].is_advice);
}

TEST_F(CageFollowsTest, EachFindingOfACertificateIsAProblemOfItsOwn) {
  CageState state;
  SolveRequest request;
  request.slides = {{4, {"a", Slide::Ellipse{}}}, {5, {"b", Slide::Ellipse{}}}};
  state.summary.last_stage = CGW_STAGE_ENCLOSE;
  state.certificate = Certificate{};
  state.certificate->encloses = state.certificate->keeps_distance = true;
  state.certificate->message = "turn 'b'; add one";
  state.findings = {{"turn 'b'", {5}, {}, true}, {"add one", {}, Point3{1, 2, 3}, true}};
  const std::vector<Problem> problems = problems_of(state, request);
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_EQ(problems[0].sentence, "turn 'b'");
  EXPECT_EQ(problems[0].slides, std::vector<std::int64_t>{5});
  EXPECT_EQ(problems[1].sentence, "add one");
  EXPECT_EQ(problems[1].place, (Point3{1, 2, 3}));
  EXPECT_TRUE(problems[0].is_advice && problems[1].is_advice);
}

// Asked for a distance that it cannot keep, and with a slide that lies across two limbs.
TEST_F(CageFollowsTest, AdviceBesideAFaultStaysAdvice) {
  CageState state;
  state.summary.last_stage = CGW_STAGE_ENCLOSE;
  state.certificate = Certificate{};
  state.certificate->encloses = true;
  state.certificate->message = "not with the distance; turn 'b'";
  state.findings = {{"not with the distance", {}, {}, false}, {"turn 'b'", {}, {}, true}};
  const std::vector<Problem> problems = problems_of(state, {});
  ASSERT_EQ(problems.size(), 2U);
  EXPECT_FALSE(problems[0].is_advice);
  EXPECT_TRUE(problems[1].is_advice);
}

TEST_F(CageFollowsTest, AModelThatThePluginRefusesIsAProblemAndOpens) {
  TriangleMesh open_mesh = ellipsoid(8, 16);
  open_mesh.triangles.resize(open_mesh.triangles.size() - 3);
  workspace_.open(write_model("open.off", open_mesh));
  workspace_.wait_for_cage();
  ASSERT_EQ(workspace_.cage().problems.size(), 1U);
  EXPECT_TRUE(holds(workspace_.cage().problems[0].sentence, "the model is open"));
  EXPECT_TRUE(workspace_.cage().problems[0].place);
  EXPECT_TRUE(workspace_.cage().failed);
}

TEST_F(CageFollowsTest, TheLatestOfManyRequestsIsTheOneThatIsAnswered) {
  CageSolver solver(plugin_, {});
  const auto mesh = std::make_shared<const TriangleMesh>(ellipsoid(24, 48));
  for (std::uint64_t revision = 1; revision <= 20; ++revision) {
    const double y = -1 + 0.1 * static_cast<double>(revision);
    const Slide::Ellipse ellipse{{0, y, 0}, {0.5, 0, 0}, {0, 0, -0.4}};
    solver.request({3, mesh, {{7, {"a", ellipse}}}, {}, revision % 2 == 0, revision});
  }
  solver.wait();
  EXPECT_TRUE(solver.progress().is_solving) << "nobody has the cage yet";
  const auto result = solver.take_result();
  ASSERT_TRUE(result);
  EXPECT_EQ(result->revision, 20U);
  EXPECT_EQ(result->mesh_node, 3);
  EXPECT_FALSE(result->was_cancelled);
  EXPECT_EQ(result->state.section_slides, std::vector<std::int64_t>{7});
  EXPECT_FALSE(solver.take_result()) << "once";
  EXPECT_FALSE(solver.progress().is_solving);
}

// Else the solver would make cages that nobody sees, with the time that drawing them needs.
TEST_F(CageFollowsTest, ACageForEditingIsNotOvertakenBeforeItIsTaken) {
  CageSolver solver(plugin_, {});
  const auto mesh = std::make_shared<const TriangleMesh>(ellipsoid(24, 48));
  const Slide::Ellipse ellipse{{0, 0.3, 0}, {0.5, 0, 0}, {0, 0, -0.4}};
  const auto request = [&](bool editing, std::uint64_t revision) {
    solver.request({3, mesh, {{7, {"a", ellipse}}}, {}, editing, revision});
  };
  const auto rest = [] { std::this_thread::sleep_for(std::chrono::milliseconds(200)); };
  const auto taken = [&] {
    const auto result = solver.take_result();
    return result ? result->revision : 0;
  };
  request(true, 1);
  solver.wait();
  request(true, 2);
  rest();
  EXPECT_EQ(taken(), 1U);
  solver.wait();
  EXPECT_EQ(taken(), 2U) << "it begins when the one before has been taken";
  request(true, 3);
  solver.wait();
  request(true, 4);
  solver.wait();
  EXPECT_EQ(taken(), 4U) << "and where somebody waits for it";
  request(true, 5);
  solver.wait();
  request(false, 6);
  for (int i = 0; i < 50 && solver.progress().fraction < 1; ++i) rest();
  EXPECT_EQ(taken(), 6U) << "a whole cage waits for nobody";
}

TEST_F(CageFollowsTest, AWholeSolveOfABigModelIsCancelledWithinASecondAndLeavesNoThread) {
  const std::size_t threads_before = thread_count();
  const auto big = write_model("big.off", ellipsoid(500, 500));
  {
    News news;
    Workspace workspace(plugin_, news.teller());
    workspace.open(big);
    for (const double y : {-1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5}) workspace.add_slide(across("", y));
    ASSERT_TRUE(wait_until(workspace, news, [&] {
      return workspace.cage().is_of_now || workspace.progress().stage == "refine" ||
             workspace.progress().stage == "enclose";
    }));
    const auto begin = Clock::now();
    workspace.cancel_solve();
    workspace.wait_for_cage();
    EXPECT_LT(seconds_since(begin), is_sanitized ? 10.0 : 1.0);
    EXPECT_FALSE(workspace.progress().is_solving);
    EXPECT_FALSE(workspace.cage().is_of_now) << "it was done before it could be cancelled";
    EXPECT_FALSE(workspace.cage().failed);

    workspace.solve();  // and while it solves, the workspace goes
    ASSERT_TRUE(wait_until(workspace, news, [&] { return workspace.progress().stage == "refine"; }));
  }
  EXPECT_EQ(thread_count(), threads_before);
}

TEST_F(CageFollowsTest, AfterCancelTheCageIsFollowedFromTheNextChangeOn) {
  open_with_slides({0});
  workspace_.cancel_solve();
  workspace_.wait_for_cage();
  EXPECT_FALSE(workspace_.cage().is_of_now);
  workspace_.rename_slide(id("slide 1"), "waist");
  workspace_.wait_for_cage();
  EXPECT_TRUE(workspace_.cage().is_of_now);
}

TEST_F(CageFollowsTest, EveryMeshOfASceneHasACageOfItsOwn) {
  workspace_.open(own_scene("nodes_several_meshes.glb"));
  const std::vector<SceneMeshNode> nodes = workspace_.document().mesh_nodes();
  ASSERT_EQ(nodes.size(), 2U);
  EXPECT_EQ(workspace_.mesh_node(), nodes[0].node) << "without slides, the first";
  workspace_.add_slide({"cut", Slide::PointNormal{{0, 0, 0}, {0, 1, 0}}});
  workspace_.wait_for_cage();
  const TriangleMesh first = workspace_.cage().cage;
  workspace_.choose_mesh(nodes[1].node);
  EXPECT_TRUE(workspace_.slides().empty());
  workspace_.add_slide({"cut", Slide::PointNormal{{0, 3, 0}, {0, 1, 0}}});
  workspace_.wait_for_cage();
  EXPECT_TRUE(workspace_.cage().is_of_now);
  EXPECT_NE(workspace_.cage().cage.points, first.points);
  workspace_.choose_mesh(nodes[0].node);
  EXPECT_TRUE(workspace_.cage().is_of_now) << "kept, not made again";
  EXPECT_EQ(workspace_.cage().cage.points, first.points);
  EXPECT_THROW(workspace_.choose_mesh(77), CommandError);
}

TEST_F(CageFollowsTest, UndoChoosesTheMeshThatItIsAboutAndCagesOfOthersAreMadeAfterwards) {
  workspace_.open(own_scene("nodes_several_meshes.glb"));
  const std::vector<SceneMeshNode> nodes = workspace_.document().mesh_nodes();
  workspace_.add_slide({"cut", Slide::PointNormal{{0, 0, 0}, {0, 1, 0}}});
  workspace_.choose_mesh(nodes[1].node);  // the first one's cage is not there yet
  EXPECT_TRUE(workspace_.has_to_wait_to_save());
  workspace_.wait_for_cage();
  workspace_.wait_for_cage();
  EXPECT_FALSE(workspace_.has_to_wait_to_save());
  workspace_.undo();
  EXPECT_EQ(workspace_.mesh_node(), nodes[0].node);
  workspace_.wait_for_cage();
  EXPECT_TRUE(workspace_.cage().is_of_now);
  workspace_.choose_mesh(nodes[1].node);
  workspace_.redo();
  EXPECT_EQ(workspace_.mesh_node(), nodes[0].node);
  EXPECT_EQ(names(), std::vector<std::string>{"cut"});
}

TEST_F(CageFollowsTest, ListenersAreToldWhatChanged) {
  std::set<WorkspaceChange> told;
  workspace_.listen([&](WorkspaceChange change) { told.insert(change); });
  const auto told_now = [&] { return std::exchange(told, {}); };
  open_with_slides({0});
  EXPECT_TRUE(told_now().count(WorkspaceChange::scene));
  workspace_.wait_for_cage();
  EXPECT_TRUE(told_now().count(WorkspaceChange::cage));
  workspace_.set_parameter("orient.lambda", 5);
  std::set<WorkspaceChange> now = told_now();
  EXPECT_TRUE(now.count(WorkspaceChange::parameters) && now.count(WorkspaceChange::cage));
  EXPECT_FALSE(now.count(WorkspaceChange::slides));
  workspace_.save(folder_ / "a.glb");
  EXPECT_TRUE(told_now().count(WorkspaceChange::saved));
  workspace_.rename_slide(id("slide 1"), "waist");
  now = told_now();
  EXPECT_TRUE(now.count(WorkspaceChange::slides) && now.count(WorkspaceChange::saved));
  workspace_.select({});
  EXPECT_EQ(told_now(), std::set{WorkspaceChange::selection});
}

TEST_F(CageFollowsTest, ThePluginCanBeUnloadedOnlyWhereTheSceneDoesNotUseIt) {
  open_with_slides({0});
  EXPECT_TRUE(holds(sentence_of<CommandError>([&] { workspace_.unload_plugin(); }), "close it first"));
  workspace_.close();
  workspace_.unload_plugin();
  EXPECT_EQ(workspace_.plugin(), nullptr);
  workspace_.load_plugin(CAGEWRIGHT_PLUGIN_FILE);
  open_with_slides({0});
  workspace_.wait_for_cage();
  EXPECT_TRUE(workspace_.cage().is_of_now);
}

}  // namespace
}  // namespace cagewright::host::test
