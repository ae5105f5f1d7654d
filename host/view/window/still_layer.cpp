// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/still_layer.h"

#include <vtkCamera.h>
#include <vtkLight.h>
#include <vtkLightCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtkRenderState.h>
#include <vtkRenderer.h>
#include <vtk_glew.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace cagewright::host {
namespace {

constexpr int most_errors = 100;

void add(vtkMatrix4x4* matrix, std::vector<double>& look) {
  look.insert(look.end(), matrix->GetData(), matrix->GetData() + 16);
}

std::vector<double> look_of(vtkRenderer& renderer, const std::vector<vtkProp*>& still) {
  std::vector<double> look;
  add(renderer.GetActiveCamera()->GetModelViewTransformMatrix(), look);
  add(renderer.GetActiveCamera()->GetProjectionTransformMatrix(renderer.GetTiledAspectRatio(), -1, 1), look);
  const int* size = renderer.GetSize();
  look.insert(look.end(), {static_cast<double>(size[0]), static_cast<double>(size[1])});
  for (const double* colour : {renderer.GetBackground(), renderer.GetBackground2()})
    look.insert(look.end(), colour, colour + 3);
  vtkCollectionSimpleIterator place;
  renderer.GetLights()->InitTraversal(place);
  while (vtkLight* light = renderer.GetLights()->GetNextLight(place))
    look.push_back(static_cast<double>(light->GetMTime()));
  for (vtkProp* prop : still) {
    look.push_back(prop->GetVisibility());
    look.push_back(static_cast<double>(prop->GetRedrawMTime()));
  }
  return look;
}

// Colour and depth of the whole. False where the graphics driver would not.
bool copy(vtkOpenGLRenderWindow& window, vtkOpenGLFramebufferObject& from, vtkOpenGLFramebufferObject& to,
          const int* size) {
  vtkOpenGLState* state = window.GetState();
  state->PushFramebufferBindings();
  from.Bind(GL_READ_FRAMEBUFFER);
  from.ActivateReadBuffer(0);
  to.Bind(GL_DRAW_FRAMEBUFFER);
  to.ActivateDrawBuffer(0);
  for (int i = 0; i < most_errors && glGetError() != GL_NO_ERROR; ++i) {  // of others
  }
  // Not vtkOpenGLFramebufferObject::Blit, which takes the error away.
  glBlitFramebuffer(0, 0, size[0], size[1], 0, 0, size[0], size[1], GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT,
                    GL_NEAREST);
  const bool is_copied = glGetError() == GL_NO_ERROR;
  state->PopFramebufferBindings();
  return is_copied;
}

}  // namespace

vtkStandardNewMacro(StillLayer);

void StillLayer::draw(const vtkRenderState& state, Props& props) {
  vtkRenderState some(state.GetRenderer());
  some.SetPropArrayAndCount(props.data(), static_cast<int>(props.size()));
  some.SetFrameBuffer(state.GetFrameBuffer());
  some.SetRequiredKeys(state.GetRequiredKeys());
  opaque_->Render(&some);
  NumberOfRenderedProps += opaque_->GetNumberOfRenderedProps();
}

bool StillLayer::can_keep(vtkRenderer& renderer) const {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer.GetRenderWindow());
  const int *size = renderer.GetSize(), *all = renderer.GetRenderWindow()->GetSize();
  return driver_copies_ && window && window->GetRenderFramebuffer() && window->GetMultiSamples() == 0 &&
         size[0] == all[0] && size[1] == all[1];
}

bool StillLayer::make_room(vtkOpenGLRenderWindow& window, const int* size, int depth_bits) {
  kept_look_.clear();
  kept_->ReleaseGraphicsResources(&window);
  kept_->SetContext(&window);
  window.GetState()->PushFramebufferBindings();
  const bool is_there = kept_->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, true, depth_bits, 0,
                                                   window.GetStencilCapable() != 0);
  window.GetState()->PopFramebufferBindings();
  return is_there;
}

// Depths can be copied between buffers of one format only, and windows differ in theirs.
void StillLayer::keep(vtkOpenGLRenderWindow& window, const int* size, const Look& look) {
  for (const int depth_bits : {32, 24}) {
    if (!make_room(window, size, depth_bits) || !copy(window, *window.GetRenderFramebuffer(), *kept_, size)) continue;
    kept_look_ = look;
    return;
  }
  driver_copies_ = false;
}

void StillLayer::Render(const vtkRenderState* state) {
  NumberOfRenderedProps = 0;
  vtkRenderer& renderer = *state->GetRenderer();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer.GetRenderWindow());
  const Props named = still_ ? still_() : Props();
  Props still, moving;
  for (int i = 0; i < state->GetPropArrayCount(); ++i) {
    vtkProp* prop = state->GetPropArray()[i];
    (std::find(named.begin(), named.end(), prop) == named.end() ? moving : still).push_back(prop);
  }
  Look look = can_keep(renderer) ? look_of(renderer, named) : Look();
  const int* size = renderer.GetSize();
  const bool is_kept = !look.empty() && look == kept_look_;
  if (is_kept && copy(*window, *kept_, *window->GetRenderFramebuffer(), size)) {
    ++frames_saved_;
  } else {
    if (is_kept) {
      driver_copies_ = false;
      kept_look_.clear();
      renderer.Clear();
    }
    draw(*state, still);
    // What changes with every frame, as when the view is turned, is not worth keeping.
    if (driver_copies_ && !look.empty() && look == look_) keep(*window, size, look);
  }
  look_ = std::move(look);
  draw(*state, moving);
}

void StillLayer::ReleaseGraphicsResources(vtkWindow* window) {
  kept_look_.clear();
  kept_->ReleaseGraphicsResources(window);
  opaque_->ReleaseGraphicsResources(window);
  vtkRenderPass::ReleaseGraphicsResources(window);
}

}  // namespace cagewright::host
