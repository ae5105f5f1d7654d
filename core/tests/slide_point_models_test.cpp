// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "core/error/error.h"
#include "core/mesh/prepare.h"
#include "core/slide/plane_loops.h"
#include "core/tests/clicks.h"
#include "core/tests/model_files.h"

// Slides that are a point alone on models of tens of thousands of triangles; one that is in no folder is skipped.
namespace cagewright {
namespace {

class SlideByPointOnModel : public testing::TestWithParam<const char*> {};

TEST_P(SlideByPointOnModel, EndsWithALoopThroughThePointOrASentence) {
  const auto mesh = find_model(GetParam());
  if (!mesh) GTEST_SKIP() << GetParam() << ".off is in no model folder (see testdata/README.md)";
  const Model model = prepare_model(*mesh);
  Random random(1);
  int found = 0;
  for (int trial = 0; trial < 500; ++trial) {
    const Vector3 point = random_point_on(model.mesh, random);
    try {
      const SlideOnModel placed = place_slide(model.mesh, model.edge_blocks, {"click", PointDefinition{point}}, 0);
      EXPECT_GT(placed.ellipse.v.norm(), 0);
      EXPECT_GT(winding_number(placed.loop.points, placed.ellipse.center, placed.ellipse.normal), 0);
      found += distance_to(placed.loop.points, point) < 1e-5 * model.diagonal;
    } catch (const Error& error) {
      EXPECT_NE(std::string(error.what()).find("slide 'click'"), std::string::npos) << error.what();
    }
  }
  EXPECT_GE(found, 495);
}

INSTANTIATE_TEST_SUITE_P(Own, SlideByPointOnModel, testing::Values("biped", "quadruped", "octopus"));
INSTANTIATE_TEST_SUITE_P(Real, SlideByPointOnModel, testing::Values("armadillo", "elephant"));

// As the slides that were placed there by hand are.
TEST(SlideByPoint, IsPerpendicularToArmsAndLegsOfTheBiped) {
  const auto mesh = find_model("biped");
  if (!mesh) GTEST_SKIP() << "biped.off is in no model folder (see testdata/README.md)";
  const Model model = prepare_model(*mesh);
  std::vector<double> angles;
  for (const Slide& slide : read_slides("biped")) {
    const bool is_across = slide.name.find("heel") == std::string::npos && slide.name.find("toes") == std::string::npos;
    if (!is_across) continue;
    const SlideOnModel across = place_slide(model.mesh, model.edge_blocks, slide, 0);
    for (Eigen::Index i = 0; i < 8; ++i) {
      const Vector3 point = across.loop.points.row(i * across.loop.points.rows() / 8);
      const SlideOnModel placed = place_slide(model.mesh, model.edge_blocks, {"click", PointDefinition{point}}, 0);
      angles.push_back(angle_between_lines(placed.ellipse.normal, across.ellipse.normal) * 180 / std::numbers::pi);
      EXPECT_LT(placed.ellipse.u.norm(), 1.3 * across.ellipse.u.norm()) << slide.name;
    }
  }
  std::sort(angles.begin(), angles.end());
  EXPECT_LT(angles[angles.size() / 2], 4);
  EXPECT_LT(angles.back(), 25);
}

}  // namespace
}  // namespace cagewright
