// SPDX-License-Identifier: BSD-3-Clause
//
// Random sessions, undone and done again, byte for byte.
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "host/tests/run_program.h"
#include "host/tests/workspace/random_session.h"
#include "host/tests/workspace/workspace_fixture.h"
#include "host/workspace/script.h"

namespace cagewright::host::test {
namespace {

using Json = nlohmann::json;

// With sanitizers half of a session, in two scenes, is enough.
constexpr std::size_t commands_of_a_session = is_sanitized ? 100 : 200;

class UndoTest : public WorkspaceTest {
 protected:
  // What saving writes once every mesh's cage is made anew, as .glb and .gltf; nothing where one of them fails: then it
  // is the last good one, which is that of another moment.
  std::optional<RandomSession::Bytes> saved_with_cages() {
    const int chosen = workspace_.mesh_node();
    bool are_there = true;
    for (const SceneMeshNode& node : workspace_.document().mesh_nodes()) {
      workspace_.choose_mesh(node.node);
      workspace_.solve();
      workspace_.wait_for_cage();
      are_there = are_there && workspace_.cage().is_of_now;
    }
    workspace_.choose_mesh(chosen);
    if (!are_there) return {};
    workspace_.save_copy(folder_ / "saved.glb");
    workspace_.save_copy(folder_ / "saved.gltf");
    return RandomSession::Bytes{folder_.read("saved.glb"), folder_.read("saved.gltf")};
  }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  ScriptRunner runner_{workspace_};
};

TEST_F(UndoTest, UndoAllAndRedoAllGiveTheSameDocumentByteForByteAtEveryStep) {
  // Our own model; several meshes; slides and cages that are there; transforms; what others have put into a scene.
  std::vector<std::filesystem::path> scenes = {model_};
  for (const char* name :
       {"nodes_several_meshes.glb", "slides_two_caged_meshes.gltf", "slides_cage.glb", "nodes_non_uniform_scale.gltf",
        "json_unknown_extensions.glb", "slides_foreign_child.gltf", "slides_moved_stroke.gltf"}) {
    scenes.push_back(own_scene(name));
  }
  if (is_sanitized) scenes.resize(2);
  unsigned seed = 0;
  std::map<std::string, std::size_t> done, refused;
  for (const std::filesystem::path& scene : scenes) {
    SCOPED_TRACE(scene.string() + ", seed " + std::to_string(++seed));
    workspace_.open(scene);
    RandomSession session(workspace_, runner_, seed);
    const RandomSession::Bytes begin = session.bytes();
    session.run(commands_of_a_session);
    session.undo_to(0);
    EXPECT_FALSE(workspace_.stack().can_undo());
    EXPECT_TRUE(session.bytes() == begin);
    EXPECT_TRUE(workspace_.is_saved());
    session.redo_to(session.steps());
    EXPECT_FALSE(workspace_.stack().can_redo());
    EXPECT_NE(session.bytes().glb, begin.glb);
    if (HasFailure()) return;
    for (const auto& [name, count] : session.done()) done[name] += count;
    for (const auto& [name, count] : session.refused()) refused[name] += count;
  }
  if (is_sanitized) return;
  for (const std::string& name : RandomCommands::changing()) {
    EXPECT_GT(done[name], 5U) << name;
    EXPECT_GT(refused[name], 5U) << name;
  }
}

TEST_F(UndoTest, TheRandomCommandsAreAllThatThereAre) {
  std::set<std::string> known = {"open",          "close",  "save",     "save_copy", "export_cage", "load_plugin",
                                 "unload_plugin", "report", "validate", "picture",   "turntable"};
  known.insert(RandomCommands::changing().begin(), RandomCommands::changing().end());
  known.insert(RandomCommands::others().begin(), RandomCommands::others().end());
  std::set<std::string> there;
  for (const ScriptRunner::Description& command : ScriptRunner::commands()) there.insert(command.name);
  EXPECT_EQ(known, there) << "a new command is to be among the random ones, too, or in this list";
}

TEST_F(UndoTest, AChangeAfterUndoIsOneStepAndTheRestCanNoLongerBeRedone) {
  workspace_.open(own_scene("slides_two_caged_meshes.gltf"));
  RandomSession session(workspace_, runner_, 20);
  for (const std::size_t steps : {40, 1, 17, 0}) {
    session.run(commands_of_a_session / 4);
    session.undo_to(session.position() - std::min(steps, session.position()));
    const std::size_t before = session.position();
    session.give({{"command", "set_parameter"}, {"id", "orient.lambda"}, {"value", 5 + session.steps()}});
    EXPECT_EQ(session.position(), before + 1);
    EXPECT_EQ(session.steps(), before + 1);
    session.give({{"command", "redo"}});  // refused
    EXPECT_EQ(session.position(), before + 1);
  }
  session.undo_to(0);
  session.redo_to(session.steps());
}

TEST_F(UndoTest, TheSameSlidesAreSavedWithTheSameCageHoweverOneCameThere) {
  unsigned seed = 30;
  for (const auto& scene : {model_, own_scene("slides_two_caged_meshes.gltf")}) {
    SCOPED_TRACE(scene);
    workspace_.open(scene);
    RandomSession session(workspace_, runner_, ++seed);
    std::map<std::size_t, RandomSession::Bytes> saved;  // by the position in the session
    std::size_t compared = 0;
    const auto compare = [&] {
      if (session.position() % (is_sanitized ? 32 : 8) != 0) return;
      const auto now = saved_with_cages();
      if (!now) return;
      const auto [entry, is_new] = saved.try_emplace(session.position(), *now);
      EXPECT_TRUE(entry->second == *now) << "at step " << session.position();
      compared += is_new ? 0 : 1;
    };
    compare();
    ASSERT_EQ(saved.size(), 1U) << "the scene as it was read has a cage";
    session.run(commands_of_a_session);
    session.undo_to(0, compare);
    session.redo_to(session.steps(), compare);
    EXPECT_GT(saved.size(), is_sanitized ? 0U : 3U);
    EXPECT_GT(compared, is_sanitized ? 0U : 3U);
    if (HasFailure()) return;
  }
}

TEST_F(UndoTest, ARandomSessionReplayedByTheProgramWritesTheSameBytes) {
  std::string script;
  runner_.record([&](const Json& command) { script += command.dump() + "\n"; });
  runner_.run({{"command", "open"}, {"path", model_.string()}});
  RandomSession session(workspace_, runner_, 40);
  session.run(commands_of_a_session);
  while (!saved_with_cages() && session.position() > 0 && !HasFailure()) session.undo_to(session.position() - 1);
  runner_.run({{"command", "save"}, {"path", path("session.glb")}});
  const std::string saved = folder_.read("session.glb");
  std::filesystem::remove(folder_ / "session.glb");
  const ProgramRun replay = run_program({"--command", folder_.write("session.jsonl", script).string()},
                                        {{"CAGEWRIGHT_PLUGIN", CAGEWRIGHT_PLUGIN_FILE}});
  EXPECT_LE(replay.exit_code, 1) << replay.errors;
  EXPECT_EQ(replay.errors, "");
  EXPECT_TRUE(folder_.read("session.glb") == saved);
}

}  // namespace
}  // namespace cagewright::host::test
