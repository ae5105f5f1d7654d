// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_APP_CANVAS_H
#define CAGEWRIGHT_HOST_APP_CANVAS_H

#include <memory>

class QWidget;
class vtkRenderWindow;

namespace cagewright::host {

enum class Graphics {
  automatic,  // card, if there is one
  card,       // OpenGL into the window, which Qt puts together by OpenGL
  processor   // OpenGL into a picture, which Qt paints: without a graphics card a third of the time for a frame
};

// What the view is drawn on: a widget that the mouse goes through. The picture is the same whichever it is, but for
// the edges of lines.
class Canvas {
 public:
  virtual ~Canvas() = default;
  virtual QWidget& widget() = 0;
  virtual vtkRenderWindow& window() = 0;  // with an interactor
  virtual void draw() = 0;                // shown when the event loop comes round
};

// To be deleted before the parent.
std::unique_ptr<Canvas> make_canvas(Graphics graphics, QWidget& parent);
std::unique_ptr<Canvas> make_card_canvas(QWidget& parent);
std::unique_ptr<Canvas> make_processor_canvas(QWidget& parent);

}  // namespace cagewright::host

#endif
