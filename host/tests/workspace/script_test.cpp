// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "host/file/file_error.h"
#include "host/plugin_client/plugin_error.h"
#include "host/tests/workspace/workspace_fixture.h"
#include "host/workspace/script.h"

namespace cagewright::host::test {
namespace {

using Json = nlohmann::json;

class ScriptTest : public WorkspaceTest {
 protected:
  Json run(const std::string& command) { return runner_.run(Json::parse(command)); }
  Json run(const std::string& name, Json arguments) {
    arguments["command"] = name;
    return runner_.run(arguments);
  }
  void open_model() { run("open", {{"path", model_.string()}}); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  std::string refusal(const std::string& command) {
    return sentence_of<std::runtime_error>([&] { run(command); });
  }

  ScriptRunner runner_{workspace_};
};

// But for the last digits that a file has.
void expect_near(const Point3& a, const Point3& b, const char* what) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(a[i], b[i], 1e-13) << what;
}

TEST_F(ScriptTest, EverySlideCommandDoesWhatItsNameSays) {
  open_model();
  EXPECT_EQ(run(R"({"command": "add_slide", "point": [0.3, 0, 0], "normal": [0, 1, 0]})")["slide"], "slide 1");
  run(R"({"command": "add_slide", "name": "hip", "center": [0, 1, 0], "u": [0.43, 0, 0], "v": [0, 0, -0.35]})");
  EXPECT_EQ(run(R"({"command": "duplicate_slides", "slides": "hip"})"), Json::parse(R"({"slides": ["hip copy"]})"));
  EXPECT_EQ(run(R"({"command": "mirror_slides", "slides": ["hip"], "axis": "y", "at": 0})")["slides"][0],
            "hip mirrored");
  EXPECT_EQ(ellipse("hip mirrored").center[1], -1);
  run(R"({"command": "rename_slide", "slide": "hip mirrored", "name": "knee"})");
  run(R"({"command": "remove_slides", "slides": ["slide 1", "hip copy"]})");
  EXPECT_EQ(names(), (std::vector<std::string>{"hip", "knee"}));
  run(R"({"command": "change_slide", "slide": "hip", "center": [0, 0.9, 0], "u": [0.5, 0, 0]})");
  EXPECT_EQ(ellipse("hip").center, (Point3{0, 0.9, 0}));
  expect_near(ellipse("hip").v, {0, 0, -0.35}, "what is not given stays");
  run(R"({"command": "change_slide", "slide": ["hip", "knee"], "move": [0, 0.1, 0], "scale": [2, 1]})");
  EXPECT_EQ(ellipse("hip").center, (Point3{0, 1, 0}));
  expect_near(ellipse("hip").u, {1, 0, 0}, "scaled");
  EXPECT_EQ(ellipse("knee").center, (Point3{0, -0.9, 0}));
  run(R"({"command": "change_slide", "slide": "hip", "turn": 90, "axis": [0, 0, 1], "label": "turn slide"})");
  EXPECT_NEAR(ellipse("hip").u[1], 1, 1e-12);
  EXPECT_EQ(run(R"({"command": "undo"})")["undone"], "turn slide");
  EXPECT_EQ(run(R"({"command": "redo"})")["redone"], "turn slide");
  run(R"({"command": "change_slide", "slide": "hip", "turn": -90, "axis": "normal"})");
  run(R"({"command": "change_slides", "label": "move slides", "slides": [
      {"name": "hip", "center": [0, 0.8, 0], "u": [0.4, 0, 0], "v": [0, 0, -0.3]},
      {"name": "knee", "center": [0, -0.8, 0], "u": [0.4, 0, 0], "v": [0, 0, -0.3]}]})");
  EXPECT_EQ(run(R"({"command": "undo"})")["undone"], "move slides");
  run(R"({"command": "snap_slides", "slides": "knee"})");
  EXPECT_NEAR(ellipse("knee").center[0], 0, 1e-9);
  run(R"({"command": "select", "slides": ["knee"]})");
  EXPECT_EQ(workspace_.selection(), std::vector{id("knee")});
}

TEST_F(ScriptTest, StrokesMakeSlidesWithAndWithoutALineOfSight) {
  open_model();
  run(R"({"command": "add_slide", "name": "a", "stroke": [[-0.1, 0.5, 0.38], [0.1, 0.5, 0.38]], "line_of_sight": [0, 0, -1]})");
  EXPECT_TRUE(workspace_.find_slide("a")->stroke.empty());
  Json ring = Json::array();
  for (int k = 0; k < 8; ++k) ring.push_back({0.5 * std::cos(0.7 * k), 0, 0.4 * std::sin(0.7 * k)});
  run("add_slide", {{"name", "b"}, {"stroke", ring}, {"line_of_sight", {0, 0, -1}}, {"complete", false}});
  EXPECT_EQ(workspace_.find_slide("b")->stroke.size(), 8U);
  run("extend_stroke", {{"slide", "b"}, {"points", {ring[0], ring[3]}}});
  EXPECT_EQ(workspace_.find_slide("b")->stroke.size(), 10U);
}

TEST_F(ScriptTest, APointAloneMakesASlideAcrossTheLimb) {
  open_model();
  run(R"({"command": "add_slide", "name": "click", "point": [0, 0.4, 0.392]})");
  EXPECT_NEAR(ellipse("click").center[0], 0, 0.02);
  EXPECT_NEAR(ellipse("click").center[1], 0.4, 0.1);
  EXPECT_NEAR(ellipse("click").center[2], 0, 0.02);
}

TEST_F(ScriptTest, SlidesGoThroughTheClipboardAFileOrTheCommandItself) {
  open_with_slides({-0.5, 0.5});
  const Json copied = run("copy_slides", {{"slides", {"slide 1", "slide 2"}}, {"path", path("two.json")}});
  EXPECT_EQ(read_slides(folder_ / "two.json").size(), 2U);
  run(R"({"command": "paste_slides"})");
  run("paste_slides", {{"path", path("two.json")}});
  run("paste_slides", {{"slides", copied["slides"]}});
  EXPECT_EQ(names().size(), 8U);
  EXPECT_EQ(ellipse("slide 1").center, ellipse("slide 1 4").center);
}

TEST_F(ScriptTest, ParametersAreSetByNumberTruthOrTheNameOfAChoice) {
  open_with_slides({0});
  run(R"({"command": "set_parameter", "id": "orient.lambda", "value": 6.5})");
  run(R"({"command": "set_parameter", "id": "enclose.merge", "value": false})");
  run(R"({"command": "set_parameter", "id": "enclose.mode", "value": "off"})");
  EXPECT_EQ(workspace_.parameter("orient.lambda"), 6.5);
  EXPECT_EQ(workspace_.parameter("enclose.merge"), 0);
  EXPECT_EQ(run(R"({"command": "report"})")["options"]["enclose.mode"], "off");
  run(R"({"command": "reset_parameters"})");
  EXPECT_EQ(run(R"({"command": "report"})")["options"]["enclose.mode"], "certify");
  EXPECT_TRUE(holds(refusal(R"({"command": "set_parameter", "id": "enclose.mode", "value": "of"})"), "certify"));
  EXPECT_TRUE(holds(refusal(R"({"command": "set_parameter", "id": "orient.lambda", "value": "x"})"), "a number"));
}

TEST_F(ScriptTest, FilesCagesAndReportsAreWritten) {
  open_with_slides({-0.5, 0.5});
  run("save", {{"path", path("a.glb")}});
  run("export_cage", {{"path", path("c.obj")}});
  run("report", {{"path", path("r.json")}});
  const Json report = Json::parse(folder_.read("r.json"));
  EXPECT_EQ(report["certificate"]["encloses"], true);
  EXPECT_EQ(report["slides"].size(), 2U);
  EXPECT_EQ(report["options"]["model"], path("a.glb"));
  run(R"({"command": "rename_slide", "slide": "slide 1", "name": "waist"})");
  run("save_copy", {{"path", path("b.gltf")}});
  EXPECT_FALSE(workspace_.is_saved());
  run(R"({"command": "save"})");
  EXPECT_TRUE(workspace_.is_saved());
  run(R"({"command": "close"})");
  EXPECT_FALSE(workspace_.has_scene());
  run("open", {{"path", path("b.gltf")}});
  EXPECT_EQ(names(), (std::vector<std::string>{"waist", "slide 2"}));
}

TEST_F(ScriptTest, MeshesAreChosenByNameOrNumber) {
  run("open", {{"path", own_scene("slides_two_caged_meshes.gltf").string()}});
  run(R"({"command": "select_mesh", "node": "right"})");
  EXPECT_EQ(names(), std::vector<std::string>{"waist right"});
  run(R"({"command": "select_mesh", "node": 0})");
  EXPECT_EQ(names(), std::vector<std::string>{"waist left"});
  EXPECT_TRUE(holds(refusal(R"({"command": "select_mesh", "node": "middle"})"), "no node"));
  run("open", {{"path", own_scene("nodes_several_meshes.glb").string()}});
  EXPECT_TRUE(holds(refusal(R"({"command": "select_mesh", "node": "limb"})"), "more than one node"));
}

TEST_F(ScriptTest, WaitSaysWhatIsWrongAndWhere) {
  open_with_slides({0});
  EXPECT_EQ(run(R"({"command": "wait"})")["problems"], Json::array());
  run(R"({"command": "change_slide", "slide": "slide 1", "move": [0, 9, 0]})");
  const Json said = run(R"({"command": "wait"})");
  EXPECT_EQ(said["problems"][0]["slides"], Json{"slide 1"});
  EXPECT_EQ(said["is_of_now"], false);
  EXPECT_TRUE(holds(refusal(R"({"command": "report"})"), "'slide 1'"));
  run(R"({"command": "undo"})");
  run(R"({"command": "cancel"})");
  run(R"({"command": "solve"})");
  EXPECT_EQ(run(R"({"command": "wait"})")["is_of_now"], true);
}

TEST_F(ScriptTest, CeresChecksWhatIsOpen) {
  open_with_slides({-0.5, 0.5});
  const Json found = run(R"({"command": "validate", "seconds": 0, "starts": 3})");
  EXPECT_EQ(found["agrees"], true);
  EXPECT_EQ(
      run("validate", {{"seconds", 0}, {"starts", 3}, {"json", path("v.json")}, {"html", path("v.html")}})["agrees"],
      true);
  EXPECT_EQ(Json::parse(folder_.read("v.json"))["agrees"], true);
  EXPECT_TRUE(holds(folder_.read("v.html"), "<html"));
  runner_.interrupt_where([] { return true; });
  EXPECT_THROW(run(R"({"command": "validate", "seconds": 0, "starts": 3})"), Cancelled);
}

TEST_F(ScriptTest, ThePluginIsLoadedAndUnloaded) {
  EXPECT_TRUE(holds(refusal(R"({"command": "load_plugin", "path": "/no/such.so"})"), "/no/such.so"));
  run(R"({"command": "unload_plugin"})");
  EXPECT_EQ(workspace_.plugin(), nullptr);
  run("load_plugin", {{"path", CAGEWRIGHT_PLUGIN_FILE}});
  ASSERT_NE(workspace_.plugin(), nullptr);
}

TEST_F(ScriptTest, WhatIsOfAViewIsCheckedAndHandedToIt) {
  std::vector<Json> seen;
  ScriptRunner with_view(workspace_, [&](const Json& command) { seen.push_back(command); });
  for (const char* command :
       {R"({"command": "frame", "what": "all"})", R"({"command": "frame", "what": "model"})",
        R"({"command": "look", "axis": "top"})", R"({"command": "up", "axis": "z"})",
        R"({"command": "projection", "orthographic": true})", R"({"command": "show", "what": "grid", "on": false})",
        R"({"command": "colours", "by": "coverage"})"}) {
    with_view.run(Json::parse(command));
    EXPECT_EQ(seen.back(), Json::parse(command));
    EXPECT_EQ(run(command), Json::object()) << "without a view it does nothing";
  }
  EXPECT_TRUE(holds(refusal(R"({"command": "colours", "by": "rainbow"})"), "plain, parts, coverage"));
  EXPECT_TRUE(holds(refusal(R"({"command": "frame", "what": "slide"})"), "\"slide\""));
}

// What says that it waits has to be known for it, and what makes the cage in the background must not be.
TEST_F(ScriptTest, CommandsThatWaitForTheCageAreKnown) {
  for (const ScriptRunner::Description& command : ScriptRunner::commands()) {
    const bool says_so = holds(command.doc, "Waits for the cage") || holds(command.doc, "and waits") ||
                         holds(command.doc, "of a whole turn");
    EXPECT_EQ(ScriptRunner::waits_for_cage({{"command", command.name}}), says_so) << command.name;
  }
  EXPECT_FALSE(ScriptRunner::waits_for_cage({{"command", "no such"}}));
  EXPECT_FALSE(ScriptRunner::waits_for_cage({{"command", 3}}));
  EXPECT_FALSE(ScriptRunner::waits_for_cage("wait"));
}

TEST_F(ScriptTest, CommandsThatMakeNoSenseAreRefusedWithASentenceAndChangeNothing) {
  open_with_slides({0});
  const std::string before = bytes();
  const std::vector<std::pair<std::string, std::string>> refusals = {
      {R"([1])", "a command is an object"},
      {R"({"slide": "a"})", "needs its name"},
      {R"({"command": "fly"})", "no command \"fly\""},
      {R"({"command": "open"})", "open: needs \"path\", text"},
      {R"({"command": "open", "path": 3})", "open: \"path\" has to be text"},
      {R"({"command": "close", "now": true})", "close: there is no argument \"now\""},
      {R"({"command": "add_slide"})", "add_slide: needs \"stroke\", \"point\""},
      {R"({"command": "add_slide", "point": [0, 0]})", "\"point\" has to be [x, y, z]"},
      {R"({"command": "add_slide", "normal": [0, 0, 1]})", "\"normal\" needs \"point\""},
      {R"({"command": "add_slide", "point": [0, 0, 0], "center": [0, 0, 0]})", "in one way only"},
      {R"({"command": "add_slide", "center": [0, 0, 0]})", "\"center\" needs \"u\" and \"v\""},
      {R"({"command": "add_slide", "stroke": [], "complete": true})", "\"complete\" needs \"line_of_sight\""},
      {R"({"command": "change_slide", "slide": "slide 1"})", "needs \"center\""},
      {R"({"command": "change_slide", "slide": "slide 1", "turn": 3})", "need each other"},
      {R"({"command": "change_slide", "slide": "slide 1", "turn": 3, "axis": "w"})", "is one of u, v, normal"},
      {R"({"command": "change_slide", "slide": [], "turn": 3})", "one slide at least"},
      {R"({"command": "change_slides", "slides": [{"name": "slide 1", "stroke": []}]})", "needs \"center\""},
      {R"({"command": "change_slides", "slides": [{"name": "b", "center": [0,0,0], "u": [1,0,0], "v": [0,0,1]}]})",
       "no slide \"b\""},
      {R"({"command": "remove_slides", "slides": ["slide 1", "knee"]})", "no slide \"knee\""},
      {R"({"command": "remove_slides", "slides": ["slide 1", "slide 1"]})", "twice"},
      {R"({"command": "paste_slides"})", "nothing has been copied"},
      {R"({"command": "mirror_slides", "slides": "slide 1", "axis": "w"})", "is one of x, y, z"},
      {R"({"command": "redo"})", "nothing to redo"},
      {R"({"command": "picture", "path": "a.jpg"})", "written as .png"},
      {R"({"command": "picture", "path": "a.png", "size": [5, 5]})", "\"size\" has to be from"},
      {R"({"command": "picture", "path": "a.png", "from": [0, 2, 0]})", "parallel to what is up"},
      {R"({"command": "turntable", "folder": "t", "frames": 0})", "\"frames\" has to be from 1"},
      {R"({"command": "validate", "seconds": -1})", "0 or more"},
      {R"({"command": "unload_plugin"})", "close it first"},
  };
  std::vector<Json> recorded;
  runner_.record([&](const Json& command) { recorded.push_back(command); });
  for (const auto& [command, part] : refusals) {
    const std::string sentence = refusal(command);
    EXPECT_TRUE(holds(sentence, part)) << sentence;
    EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  }
  EXPECT_EQ(bytes(), before);
  EXPECT_TRUE(recorded.empty());
}

TEST_F(ScriptTest, ARecordedSessionReplayedWritesTheSameBytes) {
  std::vector<Json> recorded;
  runner_.record([&](const Json& command) { recorded.push_back(command); });
  open_model();
  for (const char* command :
       {R"({"command": "add_slide", "point": [0.3, -0.6, 0], "normal": [0.1, 1, 0]})",
        R"({"command": "add_slide", "stroke": [[-0.1, 0.5, 0.38], [0.1, 0.52, 0.38]], "line_of_sight": [0, 0, -1]})",
        R"({"command": "mirror_slides", "slides": ["slide 1"], "axis": "y"})",
        R"({"command": "set_parameter", "id": "refine.delta", "value": 0.01})",
        R"({"command": "remove_slides", "slides": ["slide 2"]})", R"({"command": "undo"})",
        R"({"command": "change_slide", "slide": "slide 2", "move": [0, -0.05, 0]})",
        R"({"command": "remove_slides", "slides": ["slide 2"]})"}) {
    run(command);
  }
  EXPECT_THROW(run(R"({"command": "add_slide", "point": [0, 9, 0], "normal": [0, 1, 0]})"), PluginError);
  run(R"({"command": "add_slide", "name": "last", "point": [0.3, 0.1, 0], "normal": [0, 1, 0.2]})");
  run("save", {{"path", path("first.glb")}});
  const std::string first = folder_.read("first.glb");

  Workspace other(plugin_, {});
  ScriptRunner replayed(other);
  for (Json command : recorded) replayed.run(command);
  EXPECT_EQ(folder_.read("first.glb"), first);
  EXPECT_EQ(other.slides().size(), 3U);
}

TEST_F(ScriptTest, TheDocumentListsEveryCommandWithItsArguments) {
  std::ifstream file(CAGEWRIGHT_SCRIPT_DOCUMENT);
  const std::string document{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(document.empty()) << CAGEWRIGHT_SCRIPT_DOCUMENT;
  std::set<std::string> listed, known;
  std::istringstream lines(document);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("| `")) listed.insert(line);
  }
  for (const ScriptRunner::Description& command : ScriptRunner::commands()) {
    known.insert("| `" + command.name + "` | " + command.arguments + " | " + command.doc + " |");
  }
  EXPECT_EQ(listed, known);
}

}  // namespace
}  // namespace cagewright::host::test
