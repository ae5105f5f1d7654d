// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/tests/window_fixture.h"

#include <vtkImageData.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "host/view/display.h"

namespace cagewright::host {
namespace {

constexpr int kWidth = 640, kHeight = 480;

}  // namespace

Window::Window() {
  window->SetDisplayId(display_connection());
  window->SetMultiSamples(0);
  window->SetShowWindow(false);
  window->SetOffScreenRendering(1);
  window->SetSize(kWidth, kHeight);
  window->AddRenderer(renderer);
  view = std::make_unique<SceneView>(*renderer);
  camera = std::make_unique<CameraControl>(*renderer);
  ViewOptions options;
  options.grid = false;
  view->set_options(options);
}

Window::~Window() = default;

void Window::set_size(int width, int height) { window->SetSize(width, height); }

void Window::show(const ViewOptions& changed) { view->set_options(changed); }

void Window::frame_all() {
  const auto bounds = view->bounds();
  ASSERT_TRUE(bounds.has_value());
  camera->frame(*bounds);
}

Image Window::draw(const std::string& name) {
  camera->update_clipping();
  window->Render();
  const vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  grab->ShouldRerenderOff();
  grab->Update();
  vtkImageData* data = grab->GetOutput();
  Image image{data->GetDimensions()[0], data->GetDimensions()[1], {}};
  const auto* bytes = static_cast<const unsigned char*>(data->GetScalarPointer());
  for (int i = 0; i < image.width * image.height; ++i, bytes += 3) {
    image.pixels.push_back({bytes[0], bytes[1], bytes[2]});
  }
  if (const char* folder = std::getenv("CAGEWRIGHT_TEST_PICTURES")) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    const std::string file =
        std::string(folder) + "/" + test->name() + "-" + std::to_string(pictures++) + (name.empty() ? "" : "-") + name;
    const vtkNew<vtkPNGWriter> writer;
    writer->SetFileName((file + ".png").c_str());
    writer->SetInputData(data);
    writer->Write();
  }
  return image;
}

bool is_red(int r, int g, int b) { return r > 130 && g < r / 3 && b < r / 3; }
bool is_yellow(int r, int g, int b) { return r > 180 && g > 140 && g < r && b < g - 90; }
bool is_orange(int r, int g, int b) { return r > 200 && g > 70 && g < 130 && b < 60; }
bool is_green(int r, int g, int b) { return g > 110 && r < g - 60 && b < g - 50; }
bool is_blue(int r, int g, int b) { return b > 150 && r < b - 80 && g < b - 40; }
bool is_model_grey(int r, int g, int b) { return r > 70 && std::abs(r - g) < 12 && std::abs(g - b) < 12; }

std::shared_ptr<const TriangleMesh> box_mesh(double half_size) {
  auto mesh = std::make_shared<TriangleMesh>();
  for (int i = 0; i < 8; ++i) {
    for (const int bit : {1, 2, 4}) mesh->points.push_back((i & bit) != 0 ? half_size : -half_size);
  }
  mesh->triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                     2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  return mesh;
}

std::shared_ptr<const TriangleMesh> sphere_mesh(int rows) {
  auto mesh = std::make_shared<TriangleMesh>();
  const int columns = 2 * rows;
  mesh->points = {0, 1, 0};
  for (int i = 1; i < rows; ++i) {
    for (int j = 0; j < columns; ++j) {
      const double a = std::numbers::pi * i / rows, b = 2 * std::numbers::pi * j / columns;
      mesh->points.insert(mesh->points.end(), {std::sin(a) * std::cos(b), std::cos(a), std::sin(a) * std::sin(b)});
    }
  }
  mesh->points.insert(mesh->points.end(), {0, -1, 0});
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(1 + (i - 1) * columns + j % columns); };
  const auto last = static_cast<std::uint32_t>(mesh->points.size() / 3 - 1);
  for (int j = 0; j < columns; ++j) {
    mesh->triangles.insert(mesh->triangles.end(), {0, at(1, j + 1), at(1, j)});
    for (int i = 1; i + 1 < rows; ++i) {
      mesh->triangles.insert(mesh->triangles.end(), {at(i, j), at(i, j + 1), at(i + 1, j)});
      mesh->triangles.insert(mesh->triangles.end(), {at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
    mesh->triangles.insert(mesh->triangles.end(), {last, at(rows - 1, j), at(rows - 1, j + 1)});
  }
  return mesh;
}

ShownMesh shown(std::shared_ptr<const TriangleMesh> mesh, int node, bool is_active) {
  ShownMesh result;
  result.node = node;
  result.mesh = std::move(mesh);
  result.is_active = is_active;
  return result;
}

ShownSlide level_slide(std::int64_t id, double radius, double height) {
  ShownSlide slide;
  slide.id = id;
  slide.ellipse = {{0, height, 0}, {radius, 0, 0}, {0, 0, -radius}};
  return slide;
}

ShownCage box_cage(double half_size) {
  ShownCage cage;
  cage.mesh = *box_mesh(half_size);
  const double s = half_size;
  cage.sections = {{Point3{s, 0, s}, Point3{-s, 0, s}, Point3{-s, 0, -s}, Point3{s, 0, -s}}};
  return cage;
}

Matrix4 translation(double x, double y, double z) { return {1, 0, 0, x, 0, 1, 0, y, 0, 0, 1, z, 0, 0, 0, 1}; }
Matrix4 scaling(double x, double y, double z) { return {x, 0, 0, 0, 0, y, 0, 0, 0, 0, z, 0, 0, 0, 0, 1}; }

Matrix4 product(const Matrix4& a, const Matrix4& b) {
  Matrix4 result{};
  for (std::size_t i = 0; i < 16; ++i) {
    for (std::size_t k = 0; k < 4; ++k) result[i] += a[i / 4 * 4 + k] * b[4 * k + i % 4];
  }
  return result;
}

Point3 moved_by(const Matrix4& matrix, const Point3& point) {
  Point3 result{};
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = matrix[4 * i + 3];
    for (std::size_t k = 0; k < 3; ++k) result[i] += matrix[4 * i + k] * point[k];
  }
  return result;
}

}  // namespace cagewright::host
