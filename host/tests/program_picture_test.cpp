// SPDX-License-Identifier: BSD-3-Clause
//
// The pictures of the program; needs a display.
#include <cstdlib>

#include "host/tests/program_fixture.h"
#include "host/view/tests/image.h"

namespace cagewright::host {
namespace {

class ProgramPictureTest : public ProgramFixture {
 protected:
  // Three times as high along z as it is wide.
  ProgramPictureTest() {
    TriangleMesh tower = unit_cube();
    for (std::size_t i = 2; i < tower.points.size(); i += 3) tower.points[i] *= 3;
    folder.write("tower.off", mesh_bytes(tower, "tower.off"));
    folder.write("none.json", R"({"version": 1, "slides": []})");
  }

  Image draw(std::vector<std::string> options) const {
    options.insert(options.begin(),
                   {"cage", at("tower.off"), "--slides", at("none.json"), "--quiet", "--picture", at("p.PNG")});
    const char* display = std::getenv("DISPLAY");
    const ProgramRun run = run_program(options, {{"DISPLAY", display == nullptr ? "" : display}});
    EXPECT_EQ(run.exit_code, 0) << run.errors;
    return read_png(at("p.PNG"));
  }

  static bool drawn(int r, int g, int b) { return r != 255 || g != 255 || b != 255; }
};

TEST_F(ProgramPictureTest, HasTheSizeThatWasAskedFor) {
  const Image image = draw({"--picture-size", "320x200"});
  EXPECT_EQ(image.width, 320);
  EXPECT_EQ(image.height, 200);
  const Image standard = draw({});
  EXPECT_EQ(standard.width, 1280);
  EXPECT_EQ(standard.height, 800);
}

TEST_F(ProgramPictureTest, IsSeenFromWhereAndWithWhatUpWasAskedFor) {
  const auto aspect = [&](std::vector<std::string> options) {
    options.insert(options.end(), {"--picture-size", "300x300"});
    return draw(options).aspect(drawn);
  };
  EXPECT_NEAR(aspect({"--picture-up", "0,0,1", "--picture-from", "0,-1,0"}), 1 / 3., 0.03);
  EXPECT_NEAR(aspect({"--picture-up", "1,0,0", "--picture-from", "0,-1,0"}), 3, 0.2);
  EXPECT_NEAR(aspect({"--picture-up", "0,1,0", "--picture-from", "0,0,1"}), 1, 0.03);
  EXPECT_NEAR(aspect({"--picture-from", "-1,0,0"}), 3, 0.2);
  EXPECT_LT(aspect({"--picture-up", "0,0,1"}), 0.7) << "the view turns with what is up";
}

TEST_F(ProgramPictureTest, IsNotDrawnOfSeveralCages) {
  const std::string scene = std::string(CAGEWRIGHT_OWN_SCENES) + "/slides_two_caged_meshes.gltf";
  const char* display = std::getenv("DISPLAY");
  const ProgramRun run = run_program({"cage", scene, "--quiet", "--picture", at("p.png")},
                                     {{"DISPLAY", display == nullptr ? "" : display}});
  EXPECT_EQ(run.exit_code, 3);
  for (const char* part : {"--picture", "p.png", "2 meshes", "node 0 (\"left\")", "--node"}) {
    EXPECT_NE(run.errors.find(part), std::string::npos) << part << "\nis not in: " << run.errors;
  }
  EXPECT_FALSE(std::filesystem::exists(at("p.png")));
}

}  // namespace
}  // namespace cagewright::host
