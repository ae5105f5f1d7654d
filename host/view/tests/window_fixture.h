// SPDX-License-Identifier: BSD-3-Clause
#ifndef CAGEWRIGHT_HOST_VIEW_TESTS_WINDOW_FIXTURE_H
#define CAGEWRIGHT_HOST_VIEW_TESTS_WINDOW_FIXTURE_H

#include <gtest/gtest.h>
#include <vtkNew.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/view/tests/image.h"
#include "host/view/window/camera_control.h"
#include "host/view/window/scene_view.h"

namespace cagewright::host {

// An off-screen window of 640 x 480 pixels with a view and a camera.
class Window : public testing::Test {
 protected:
  Window();
  ~Window() override;

  // The frame as it is now. Written as a PNG where CAGEWRIGHT_TEST_PICTURES names a folder: a person may want to look.
  Image draw(const std::string& name = {});
  void frame_all();
  void show(const ViewOptions& changed);
  void set_size(int width, int height);

  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  std::unique_ptr<SceneView> view;
  std::unique_ptr<CameraControl> camera;
  int pictures = 0;
};

// Colours as they appear in the window.
bool is_red(int r, int g, int b);
bool is_yellow(int r, int g, int b);
bool is_orange(int r, int g, int b);
bool is_green(int r, int g, int b);
bool is_blue(int r, int g, int b);
bool is_model_grey(int r, int g, int b);  // lit, brighter than the background

std::shared_ptr<const TriangleMesh> box_mesh(double half_size);
// A sphere of rows x 2 rows quads round the origin, radius 1, closed.
std::shared_ptr<const TriangleMesh> sphere_mesh(int rows);
ShownMesh shown(std::shared_ptr<const TriangleMesh> mesh, int node = 0, bool is_active = true);
// In the plane y = height.
ShownSlide level_slide(std::int64_t id, double radius, double height = 0);
// The box [-half_size, half_size]^3 with one section, at y = 0.
ShownCage box_cage(double half_size);

Matrix4 translation(double x, double y, double z);
Matrix4 scaling(double x, double y, double z);
Matrix4 product(const Matrix4& a, const Matrix4& b);
Point3 moved_by(const Matrix4& matrix, const Point3& point);

}  // namespace cagewright::host

#endif
