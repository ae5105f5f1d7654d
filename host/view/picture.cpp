// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/picture.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkImageShrink3D.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

#include "host/file/atomic_file.h"
#include "host/file/file_error.h"
#include "host/view/display.h"
#include "host/view/picture_actors.h"

namespace cagewright::host {
namespace {

using Eigen::Vector3d;

constexpr int kSamples = 2;  // rendered that much larger either way, then averaged: smooth edges on any OpenGL
constexpr double kMargin = 1.04;
// Layers of translucent surface that are sorted. Beyond that light is nearly used up.
constexpr int kPeels = 12;

[[noreturn]] void bad_input(const std::string& sentence) { throw PictureError(PictureFault::bad_input, sentence); }

void check_mesh(const std::string& name, std::span<const double> points, std::span<const std::uint32_t> triangles) {
  if (points.size() % 3 != 0 || triangles.size() % 3 != 0) {
    bad_input("the picture's " + name + " has points or triangles that are not rows of three");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i])) {
      bad_input("the picture's " + name + " has a position that is not finite, at vertex " + std::to_string(i / 3));
    }
  }
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (triangles[i] >= points.size() / 3) {
      bad_input("the picture's " + name + " names vertex " + std::to_string(triangles[i]) + " in triangle " +
                std::to_string(i / 3) + ", but has only " + counted(points.size() / 3, "vertex"));
    }
  }
}

bool all_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

void check_input(const PictureInput& input) {
  check_mesh("model", input.model_points, input.model_triangles);
  check_mesh("cage", input.cage_points, input.cage_triangles);
  for (std::size_t i = 0; i < input.slides.size(); ++i) {
    const SlideMark& slide = input.slides[i];
    if (!all_finite(slide.center) || !all_finite(slide.u) || !all_finite(slide.v)) {
      bad_input("the picture's slide " + std::to_string(i) + " has a number that is not finite");
    }
  }
  for (std::size_t i = 0; i < input.sections.size(); ++i) {
    if (!all_finite(input.sections[i])) {
      bad_input("the picture's section " + std::to_string(i) + " has a corner that is not finite");
    }
  }
  if (input.model_triangles.empty() && input.cage_triangles.empty() && input.slides.empty() && input.sections.empty()) {
    bad_input("there is nothing to draw: no model, no cage, no slide and no section");
  }
}

Vector3d direction(const std::array<double, 3>& vector) { return Vector3d(vector.data()).stableNormalized(); }

// To the viewer's right; too short to be one where the view is not sound.
Vector3d right_of(const View& view) { return direction(view.up).cross(direction(view.toward_viewer)); }

// The viewer's axes as columns: to the right, up, towards the viewer.
Eigen::Matrix3d axes_of(const View& view, std::size_t index) {
  if (!is_sound(view)) {
    bad_input("view " + std::to_string(index) +
              " of the picture has no direction, no up, or both along one line; take another up");
  }
  Eigen::Matrix3d axes;
  axes.col(2) = direction(view.toward_viewer);
  axes.col(0) = right_of(view).normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return axes;
}

void check_options(const PictureOptions& options) {
  const auto outside = [](int size) { return size < smallest_picture || size > largest_picture; };
  if (outside(options.width) || outside(options.height)) {
    bad_input("a picture of " + std::to_string(options.width) + " x " + std::to_string(options.height) +
              " pixels cannot be made; take " + std::to_string(smallest_picture) + " to " +
              std::to_string(largest_picture) + " either way");
  }
  if (options.views.empty() || options.width / static_cast<int>(options.views.size()) < smallest_picture) {
    bad_input("a picture of " + counted(options.views.size(), "view") + " does not fit into a width of " +
              std::to_string(options.width) + " pixels");
  }
}

struct Frame {
  Vector3d center;     // of the box round the points along the viewer's axes, model units
  Vector3d half_size;  // of that box
};

Frame frame_of(const std::vector<Point>& points, const Eigen::Matrix3d& axes) {
  Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity());
  Vector3d high = -low;
  for (const Point& point : points) {
    const Vector3d seen = axes.transpose() * Vector3d(point.data());
    low = low.cwiseMin(seen);
    high = high.cwiseMax(seen);
  }
  return {axes * ((low + high) / 2), (high - low) / 2};
}

vtkSmartPointer<vtkRenderer> make_renderer(const PictureInput& input, const Eigen::Matrix3d& axes, double aspect,
                                           int height) {
  const Frame frame = frame_of(outline_points(input), axes);
  const double extent = frame.half_size.norm();
  const double half_height = kMargin * std::max({frame.half_size.y(), frame.half_size.x() / aspect, 1e-3 * extent});
  if (!(half_height > 0) || !std::isfinite(half_height)) {
    bad_input("all that the picture has to show lies in one point, or too far apart for numbers");
  }
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetBackground(1, 1, 1);
  renderer->UseDepthPeelingOn();  // or translucent triangles are blended in the order of the file
  renderer->SetMaximumNumberOfPeels(kPeels);
  renderer->SetOcclusionRatio(0);
  for (const auto& actor : make_actors(input, 2 * half_height / height)) {
    renderer->AddActor(actor);
  }
  const Vector3d eye = frame.center + 2 * extent * axes.col(2);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetFocalPoint(frame.center.data());
  camera->SetPosition(eye.data());
  camera->SetViewUp(axes(0, 1), axes(1, 1), axes(2, 1));
  camera->SetParallelScale(half_height);
  camera->SetClippingRange(0.5 * extent, 3.5 * extent);
  return renderer;
}

// Gathers what VTK reports instead of letting it print.
class ErrorListener {
 public:
  ErrorListener(std::initializer_list<vtkObject*> objects) {
    command_->SetClientData(&text_);
    command_->SetCallback([](vtkObject*, unsigned long, void* text, void* message) {
      if (message != nullptr) {
        static_cast<std::string*>(text)->append(static_cast<const char*>(message));
      }
    });
    for (vtkObject* object : objects) {
      object->AddObserver(vtkCommand::ErrorEvent, command_);
    }
  }
  void check() const {
    if (!text_.empty()) {
      std::string line = text_;
      std::replace(line.begin(), line.end(), '\n', ' ');
      throw PictureError(PictureFault::render, "VTK could not render the picture: " + line);
    }
  }

 private:
  std::string text_;
  vtkNew<vtkCallbackCommand> command_;
};

std::vector<std::uint8_t> encode(vtkRenderWindow& window) {
  const vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(&window);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  image->ShouldRerenderOff();
  const vtkNew<vtkImageShrink3D> average;
  average->SetInputConnection(image->GetOutputPort());
  average->SetShrinkFactors(kSamples, kSamples, 1);
  average->MeanOn();
  const vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(average->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->SetCompressionLevel(9);
  const ErrorListener errors({image, average, writer});
  writer->Write();
  errors.check();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  if (bytes == nullptr || bytes->GetNumberOfValues() == 0) {
    throw PictureError(PictureFault::render, "VTK made no picture and did not say why");
  }
  return {bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues()};
}

}  // namespace

View default_view(const std::array<double, 3>& up) {
  View view;
  const auto turn = Eigen::Quaterniond::FromTwoVectors(direction(view.up), direction(up));
  Eigen::Map<Vector3d>(view.toward_viewer.data()) = turn * Vector3d(view.toward_viewer.data());
  view.up = up;
  return view;
}

bool is_sound(const View& view) {
  constexpr double kNearlyParallel = 1e-6;
  return all_finite(view.up) && all_finite(view.toward_viewer) && right_of(view).norm() > kNearlyParallel;
}

void require_display() { display_connection(); }

std::vector<std::uint8_t> render_picture(const PictureInput& input, const PictureOptions& options) {
  check_input(input);
  check_options(options);
  const vtkNew<vtkRenderWindow> window;
  const ErrorListener errors({window});
  window->SetDisplayId(display_connection());
  window->SetMultiSamples(0);
  window->SetAlphaBitPlanes(1);
  window->SetShowWindow(false);
  window->SetOffScreenRendering(1);
  window->SetSize(kSamples * options.width, kSamples * options.height);
  const auto count = static_cast<double>(options.views.size());
  const double aspect = options.width / count / options.height;
  for (std::size_t i = 0; i < options.views.size(); ++i) {
    const auto renderer = make_renderer(input, axes_of(options.views[i], i), aspect, options.height);
    const auto left = static_cast<double>(i);
    renderer->SetViewport(left / count, 0, (left + 1) / count, 1);
    window->AddRenderer(renderer);
  }
  window->Render();
  errors.check();
  return encode(*window);
}

void write_picture(const PictureInput& input, const PictureOptions& options, const std::filesystem::path& path) {
  const std::vector<std::uint8_t> png = render_picture(input, options);
  write_atomically(path, {reinterpret_cast<const char*>(png.data()), png.size()});
}

}  // namespace cagewright::host
