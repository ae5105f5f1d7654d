// SPDX-License-Identifier: BSD-3-Clause
#include <QVTKOpenGLNativeWidget.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include "host/app/canvas.h"

namespace cagewright::host {
namespace {

class CardCanvas : public Canvas {
 public:
  explicit CardCanvas(QWidget& parent) : widget_(&parent) {
    window_->SetMultiSamples(0);
    widget_.setRenderWindow(window_);
    widget_.setFocusPolicy(Qt::NoFocus);
    widget_.setAttribute(Qt::WA_TransparentForMouseEvents);
  }
  QWidget& widget() override { return widget_; }
  vtkRenderWindow& window() override { return *window_; }
  void draw() override { window_->Render(); }

 private:
  vtkNew<vtkGenericOpenGLRenderWindow> window_;
  QVTKOpenGLNativeWidget widget_;
};

}  // namespace

std::unique_ptr<Canvas> make_card_canvas(QWidget& parent) { return std::make_unique<CardCanvas>(parent); }

}  // namespace cagewright::host
