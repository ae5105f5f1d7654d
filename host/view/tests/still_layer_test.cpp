// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/still_layer.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkRenderPass.h>
#include <vtkRenderStepsPass.h>

#include "host/view/tests/window_fixture.h"

namespace cagewright::host {
namespace {

class Still : public Window {
 protected:
  int frames_saved() const {
    auto* steps = vtkRenderStepsPass::SafeDownCast(renderer->GetPass());
    return StillLayer::SafeDownCast(steps->GetOpaquePass())->frames_saved();
  }
  void show_slide_at(double y) {
    view->set_slides({level_slide(1, 1.3, y)});
    const ShownCage cage = box_cage(1.4 + 0.01 * y);
    view->set_cage(&cage);
  }
};

TEST_F(Still, AFrameOfAKeptModelIsTheSamePixelForPixel) {
  view->set_meshes({shown(sphere_mesh(24))});
  show_slide_at(0.5);
  frame_all();
  for (int frame = 0; frame < 4; ++frame) draw("still_before");
  EXPECT_GE(frames_saved(), 2);
  show_slide_at(-0.2);
  const int before = frames_saved();
  const Image kept = draw("still_kept");
  EXPECT_EQ(frames_saved(), before + 1) << "the slide moved, the model did not";
  const vtkNew<vtkCamera> here;
  here->DeepCopy(renderer->GetActiveCamera());
  camera->tumble(10, 0);
  EXPECT_NE(draw("still_turned").pixels, kept.pixels);
  EXPECT_EQ(frames_saved(), before + 1) << "nothing kept can be of another camera";
  renderer->GetActiveCamera()->DeepCopy(here);
  renderer->GetPass()->ReleaseGraphicsResources(window);
  const Image drawn = draw("still_drawn");
  EXPECT_EQ(frames_saved(), before + 1) << "what was kept is gone";
  EXPECT_TRUE(kept.pixels == drawn.pixels);
}

TEST_F(Still, AModelThatHasChangedIsDrawnAgain) {
  view->set_meshes({shown(sphere_mesh(24))});
  frame_all();
  for (int frame = 0; frame < 4; ++frame) draw();
  const int before = frames_saved();
  ViewOptions options = view->options();
  options.model = false;
  show(options);
  EXPECT_EQ(draw("still_without_model").count(is_model_grey), 0);
  options.model = true;
  options.wireframe = true;
  show(options);
  const long wires = draw("still_wires").count(is_model_grey);
  options.wireframe = false;
  show(options);
  const long shaded = draw("still_shaded").count(is_model_grey);
  EXPECT_GT(shaded, 1.2 * static_cast<double>(wires));
  EXPECT_EQ(frames_saved(), before);
}

}  // namespace
}  // namespace cagewright::host
