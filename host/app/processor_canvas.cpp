// SPDX-License-Identifier: BSD-3-Clause
#include <vtkGenericRenderWindowInteractor.h>
#include <vtkNew.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtk_glew.h>

#include <QImage>
#include <QPainter>
#include <QWidget>
#include <utility>

#include "host/app/canvas.h"

namespace cagewright::host {
namespace {

// Where the processor draws, what costs is copying: Qt's OpenGL widgets copy each frame six times, pixel by pixel in
// shaders, and the rest of the window with it.
class ProcessorCanvas : public Canvas, private QWidget {
 public:
  explicit ProcessorCanvas(QWidget& parent) : QWidget(&parent) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    window_->SetMultiSamples(0);
    window_->SetShowWindow(false);
    window_->SetOffScreenRendering(1);
    window_->SetSwapBuffers(0);  // or the finished frame is copied within VTK
    interactor_->SetRenderWindow(window_);
  }
  QWidget& widget() override { return *this; }
  vtkRenderWindow& window() override { return *window_; }
  void draw() override {
    draw_picture();
    update();
  }

 private:
  QSize wanted() const { return (QSizeF(QWidget::size()) * devicePixelRatioF()).toSize(); }

  void draw_picture() {
    constexpr int points_per_inch = 72;  // as QVTKOpenGLNativeWidget has it
    const QSize size = wanted();
    if (size.isEmpty()) return;
    window_->SetDPI(qRound(points_per_inch * devicePixelRatioF()));
    window_->SetSize(size.width(), size.height());
    window_->Render();
    read(size);
  }

  void read(const QSize& size) {
    if (picture_.size() != size) picture_ = QImage(size, QImage::Format_RGB32);
    auto& window = *vtkOpenGLRenderWindow::SafeDownCast(window_);
    window.MakeCurrent();
    window.GetState()->PushFramebufferBindings();
    window.GetRenderFramebuffer()->Bind(GL_READ_FRAMEBUFFER);
    window.GetRenderFramebuffer()->ActivateReadBuffer(0);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    // The order that Qt paints without converting.
    glReadPixels(0, 0, size.width(), size.height(), GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, picture_.bits());
    window.GetState()->PopFramebufferBindings();
    picture_ = std::move(picture_).mirrored();  // OpenGL's first row is the lowest
    picture_.setDevicePixelRatio(devicePixelRatioF());
  }

  void paintEvent(QPaintEvent*) override {
    if (picture_.isNull()) draw_picture();
    QPainter painter(this);
    // Of another size until the view has drawn itself in the new one.
    picture_.size() == wanted() ? painter.drawImage(0, 0, picture_) : painter.drawImage(rect(), picture_);
  }

  vtkNew<vtkRenderWindow> window_;
  vtkNew<vtkGenericRenderWindowInteractor> interactor_;
  QImage picture_;
};

}  // namespace

std::unique_ptr<Canvas> make_processor_canvas(QWidget& parent) { return std::make_unique<ProcessorCanvas>(parent); }

}  // namespace cagewright::host
