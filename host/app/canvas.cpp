// SPDX-License-Identifier: BSD-3-Clause
#include "host/app/canvas.h"

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <string>

namespace cagewright::host {
namespace {

bool has_graphics_card() {
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || !context.makeCurrent(&surface)) return false;
  const auto* told = reinterpret_cast<const char*>(context.functions()->glGetString(GL_RENDERER));
  const std::string name = told == nullptr ? "" : told;
  context.doneCurrent();
  for (const char* processor : {"llvmpipe", "softpipe", "swrast", "Software Rasterizer", "SwiftShader", "GDI Generic",
                                "Microsoft Basic Render"})
    if (name.find(processor) != std::string::npos) return false;
  return !name.empty();
}

}  // namespace

std::unique_ptr<Canvas> make_canvas(Graphics graphics, QWidget& parent) {
  const bool by_card = graphics == Graphics::card || (graphics == Graphics::automatic && has_graphics_card());
  return by_card ? make_card_canvas(parent) : make_processor_canvas(parent);
}

}  // namespace cagewright::host
