// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/file_ending.h"

#include <gtest/gtest.h>

namespace cagewright::host {
namespace {

constexpr const char* meshes = "Meshes (*.obj *.off *.ply)";

TEST(FileEnding, ANameWithoutOneGetsTheFirstOfTheFilter) {
  EXPECT_EQ(with_ending_of(meshes, "/a.b/cage"), "/a.b/cage.obj");
  EXPECT_EQ(with_ending_of("glTF, text (*.gltf)", "scene"), "scene.gltf");
  EXPECT_EQ(with_ending_of(meshes, "/a/cage."), "/a/cage.obj");
}

TEST(FileEnding, ANameWithOneStaysAsItIs) {
  EXPECT_EQ(with_ending_of(meshes, "/a/cage.PLY"), "/a/cage.PLY");
  EXPECT_EQ(with_ending_of(meshes, "/a/cage.txt"), "/a/cage.txt");
}

}  // namespace
}  // namespace cagewright::host
