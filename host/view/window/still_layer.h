// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_WINDOW_STILL_LAYER_H
#define CAGEWRIGHT_HOST_VIEW_WINDOW_STILL_LAYER_H

#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpaquePass.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkRenderPass.h>

#include <functional>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkProp;

namespace cagewright::host {

// Draws what is opaque. What stands still while other things move, the models, is kept as a picture with its depths and
// drawn again only when it, the camera, the light or the window's size has changed: while a slide is dragged, a frame
// then costs what moves. The picture is the same pixel for pixel.
class StillLayer : public vtkRenderPass {
 public:
  static StillLayer* New();
  vtkTypeMacro(StillLayer, vtkRenderPass)

      StillLayer(const StillLayer&) = delete;
  StillLayer& operator=(const StillLayer&) = delete;

  // Those that stand still, of those that the renderer has; drawn before all others.
  void set_still(std::function<std::vector<vtkProp*>()> still) { still_ = std::move(still); }
  // Of frames so far, for which the models were not drawn.
  int frames_saved() const { return frames_saved_; }

  void Render(const vtkRenderState* state) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  StillLayer() = default;
  ~StillLayer() override = default;

 private:
  using Look = std::vector<double>;  // everything that the picture depends on

  using Props = std::vector<vtkProp*>;

  void draw(const vtkRenderState& state, Props& props);
  bool can_keep(vtkRenderer& renderer) const;
  bool make_room(vtkOpenGLRenderWindow& window, const int* size, int depth_bits);
  void keep(vtkOpenGLRenderWindow& window, const int* size, const Look& look);

  vtkNew<vtkOpaquePass> opaque_;
  vtkNew<vtkOpenGLFramebufferObject> kept_;
  std::function<std::vector<vtkProp*>()> still_;
  Look look_, kept_look_;  // of the last frame; of what is kept: empty where nothing is
  int frames_saved_ = 0;
  bool driver_copies_ = true;  // depths, too
};

}  // namespace cagewright::host

#endif
