// SPDX-License-Identifier: BSD-3-Clause
//
// Needs a display: pictures of what is open.
#include <nlohmann/json.hpp>

#include "host/plugin_client/plugin_error.h"
#include "host/tests/workspace/workspace_fixture.h"
#include "host/view/tests/image.h"
#include "host/workspace/script.h"

namespace cagewright::host::test {
namespace {

using Json = nlohmann::json;

bool blue(int r, int g, int b) { return b > 90 && r < b - 50 && g < b - 50; }
bool red(int r, int g, int b) { return r > 150 && g < 90 && b < 90; }
bool orange(int r, int g, int b) { return r > 170 && g > 90 && g < r - 40 && b < g - 60; }
bool drawn(int r, int g, int b) { return r != 255 || g != 255 || b != 255; }

class ScriptPictureTest : public WorkspaceTest {
 protected:
  Image picture(Json arguments) {
    arguments["command"] = "picture";
    arguments["path"] = (folder_ / "p.png").string();
    runner_.run(arguments);
    return read_png(folder_ / "p.png");
  }

  ScriptRunner runner_{workspace_};
};

TEST_F(ScriptPictureTest, APictureShowsMeshSlidesAndCageAsTheyAreNow) {
  open_with_slides({-0.7, 0.7});
  const Image first = picture({{"size", {320, 400}}, {"from", {0, 0.4, 1}}});
  EXPECT_EQ(first.width, 320);
  EXPECT_EQ(first.height, 400);
  EXPECT_GT(first.count(blue), 100) << "the cage";
  EXPECT_GT(first.count(red), 50) << "the slides";
  EXPECT_EQ(first.count(orange), 0);
  Slide::Ellipse away = ellipse("slide 1");
  away.center[1] = 3;
  workspace_.change_slides({{id("slide 1"), away}}, "move slide");
  EXPECT_GT(picture({{"size", {320, 400}}, {"from", {0, 0.4, 1}}}).count(orange), 20) << "the slide that misses";
}

TEST_F(ScriptPictureTest, ATurntableIsAWholeTurnRoundWhatIsUp) {
  workspace_.open(model_);
  workspace_.add_slide({"a", Slide::PointNormal{{0.3, 0.5, 0}, {0, 1, 0}}});
  const Json turn = {{"command", "turntable"},
                     {"folder", (folder_ / "turn").string()},
                     {"frames", 4},
                     {"from", {0, 0, 1}},
                     {"up", {0, 1, 0}},
                     {"size", {200, 200}}};
  EXPECT_EQ(runner_.run(turn)["frames"], 4);
  std::vector<double> aspects;
  for (const char* name : {"frame_0001.png", "frame_0002.png", "frame_0003.png", "frame_0004.png"}) {
    aspects.push_back(read_png(folder_ / "turn" / name).aspect(drawn));
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "turn" / "frame_0005.png"));
  EXPECT_NEAR(aspects[0], aspects[2], 0.03);
  EXPECT_NEAR(aspects[1], aspects[3], 0.03);
  EXPECT_LT(aspects[1], aspects[0]) << "from the side it is narrower";
}

TEST_F(ScriptPictureTest, ATurntableAsksBeforeEachFrameWhetherToGoOnAndKeepsWhatItHasWritten) {
  workspace_.open(model_);
  int asked = 0;
  runner_.interrupt_where([&] {
    workspace_.close();  // whoever is asked may change what is open
    return ++asked > 2;
  });
  EXPECT_THROW(
      runner_.run(
          {{"command", "turntable"}, {"folder", (folder_ / "turn").string()}, {"frames", 4}, {"size", {64, 64}}}),
      Cancelled);
  EXPECT_EQ(asked, 3);
  EXPECT_TRUE(std::filesystem::exists(folder_ / "turn" / "frame_0002.png"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "turn" / "frame_0003.png"));
}

TEST_F(ScriptPictureTest, WithoutAMeshThereIsNoPicture) { EXPECT_THROW(picture(Json::object()), CommandError); }

}  // namespace
}  // namespace cagewright::host::test
