// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "host/file/file_bytes.h"
#include "host/file/file_error.h"
#include "host/file/gltf_json.h"
#include "host/tests/scene/scene_files.h"

namespace cagewright::host::test {
namespace {

double distance(const Point3& a, const Point3& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

void expect_same_ellipse(const Slide::Ellipse& a, const Slide::Ellipse& b) {
  EXPECT_LT(distance(a.center, b.center), 1e-12);
  EXPECT_LT(distance(a.u, b.u), 1e-12);
  EXPECT_LT(distance(a.v, b.v), 1e-12);
}

void expect_same_content(const SceneDocument& before, const SceneDocument& after) {
  ASSERT_EQ(before.slides().size(), after.slides().size());
  for (const SceneSlide& a : before.slides()) {
    const SceneSlide* b = after.find_slide(a.id);
    ASSERT_NE(b, nullptr) << a.id;
    EXPECT_EQ(a.name, b->name);
    EXPECT_EQ(a.mesh_node, b->mesh_node);
    EXPECT_EQ(a.stroke, b->stroke);
    expect_same_ellipse(a.ellipse, b->ellipse);
  }
  ASSERT_EQ(before.cages().size(), after.cages().size());
  for (const SceneCage& a : before.cages()) {
    const SceneCage* b = after.find_cage(a.mesh_node);
    ASSERT_NE(b, nullptr) << a.mesh_node;
    EXPECT_EQ(a.name, b->name);
    EXPECT_EQ(a.mesh.triangles, b->mesh.triangles);
    EXPECT_EQ(a.parameters, b->parameters);
    EXPECT_EQ(a.slides, b->slides);
    EXPECT_EQ(a.sections, b->sections);
    EXPECT_EQ(a.certificate, b->certificate);
    ASSERT_EQ(a.mesh.points.size(), b->mesh.points.size());
    for (std::size_t i = 0; i < a.mesh.points.size(); ++i) {
      EXPECT_EQ(static_cast<float>(a.mesh.points[i]), static_cast<float>(b->mesh.points[i]));
    }
  }
}

// load -> add slides and cages -> save -> load -> remove ours -> save.
void expect_round_trip(const std::filesystem::path& path) {
  SCOPED_TRACE(path.string());
  const std::string file = read_bytes(path);
  SceneDocument untouched(path, file);
  EXPECT_FALSE(untouched.is_changed());
  EXPECT_EQ(untouched.bytes(), file);
  const bool had_ours = !untouched.slides().empty() || !untouched.cages().empty();

  SceneDocument document(path, file);
  add_slides_and_cages(document);
  EXPECT_EQ(document.is_changed(), !document.mesh_nodes().empty());
  const std::string with_ours = document.bytes();
  EXPECT_EQ(chunks(path, with_ours), chunks(path, file));
  SceneDocument again(path, with_ours);
  EXPECT_EQ(again.bytes(), with_ours);
  expect_same_content(document, again);

  remove_all_of_ours(again);
  const std::string without = again.bytes();
  EXPECT_EQ(chunks(path, without), chunks(path, file));
  if (had_ours) return;  // then it is the file without what it had of ours
  const GltfJson original = parse_gltf_json(path, json_text(path, file));
  const GltfJson left = parse_gltf_json(path, json_text(path, without));
  EXPECT_EQ(gltf_json_text(original), gltf_json_text(left));
}

bool is_readable(const std::filesystem::path& path) {
  try {
    SceneDocument document(path);
    return true;
  } catch (const FileError&) {
    return false;
  }
}

TEST(SceneRoundTrip, LosesNothingOfOurOwnScenes) {
  const auto files = own_scenes();
  EXPECT_GT(files.size(), 20u);
  for (const auto& path : files) expect_round_trip(path);
}

TEST(SceneRoundTrip, LosesNothingOfForeignScenes) {
  const auto files = foreign_scenes();
  if (files.empty()) GTEST_SKIP() << "no folder of foreign scenes is given: see CONTRIBUTING.md";
  std::size_t readable = 0;
  for (const auto& path : files) {
    if (!is_readable(path)) continue;
    ++readable;
    expect_round_trip(path);
  }
  EXPECT_GT(readable, files.size() / 2);
  RecordProperty("readable", static_cast<int>(readable));
}

}  // namespace
}  // namespace cagewright::host::test
