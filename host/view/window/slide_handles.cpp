// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/slide_handles.h"

#include <vtkActor.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "host/view/window/depth_order.h"
#include "host/view/window/handle_drag.h"
#include "host/view/window/handle_shapes.h"
#include "host/view/window/projection.h"

namespace cagewright::host {
namespace {

using Eigen::Vector3d;

constexpr double kLength = 90;  // pixels of an arrow, before pixel_ratio()
constexpr Point3 kUnderMouse{1.0, 1.0, 0.55};

struct Handle {
  HandleShape shape;
  vtkSmartPointer<vtkActor> actor;
};

Handle make_handle(HandleShape shape) {
  const vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(shape.surface);
  mapper->ScalarVisibilityOff();
  Handle handle{std::move(shape), vtkSmartPointer<vtkActor>::New()};
  handle.actor->SetMapper(mapper);
  handle.actor->GetProperty()->LightingOff();
  handle.actor->PickableOff();
  handle.actor->UseBoundsOff();
  draw_on_top(*handle.actor, TopLayer::handles);
  return handle;
}

double distance_to_segment(const Eigen::Vector2d& at, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double length = (b - a).squaredNorm();
  const double t = length > 0 ? std::clamp((at - a).dot(b - a) / length, 0.0, 1.0) : 0;
  return (at - a - t * (b - a)).norm();
}

}  // namespace

struct SlideHandles::State {
  State(vtkRenderer& of, const SceneView& shown) : renderer(of), view(shown) {}

  bool is_shown() const { return frame.has_value() && !handles.empty(); }
  double length() const { return kLength * pixel_ratio(renderer); }
  // From the handles' own space to the scene's: arrows have the same length in pixels, however the mesh is stretched.
  Eigen::Matrix4d placement() const {
    const Eigen::Matrix4d to_scene = to_matrix(view.active_to_scene());
    const Vector3d center = transformed(to_scene, frame->center);
    const double size = length() * Projection(renderer).pixel_at(center);
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
    for (Eigen::Index k = 0; k < 3; ++k) {
      matrix.block<3, 1>(0, k) = size * (to_scene.topLeftCorner<3, 3>() * frame->axes.col(k)).stableNormalized();
    }
    matrix.block<3, 1>(0, 3) = center;
    return matrix;
  }
  int handle_at(double x, double y) const;
  void mark(int index);
  void place();

  vtkRenderer& renderer;
  const SceneView& view;
  Mode mode = Mode::none;
  SlideEllipses slides;
  std::optional<HandleFrame> frame;
  std::vector<Handle> handles;
  int marked = -1;
  std::optional<HandleDrag> drag;
  vtkNew<vtkCallbackCommand> frame_listener;
};

// The one whose outline is nearest on the screen, measured by its reach; -1: none.
int SlideHandles::State::handle_at(double x, double y) const {
  if (!is_shown()) return -1;
  const Projection projection(renderer);
  const Eigen::Matrix4d matrix = placement();
  const double ratio = pixel_ratio(renderer);
  int best = -1;
  double least = 1;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const HandleShape& shape = handles[i].shape;
    std::optional<Eigen::Vector2d> before;
    for (const Vector3d& point : shape.outline) {
      const auto seen = projection.see(transformed(matrix, point));
      if (!seen.is_visible) {
        before.reset();
        continue;
      }
      const Eigen::Vector2d now(seen.x, seen.y);
      const double distance = distance_to_segment({x, y}, before.value_or(now), now) / (shape.reach * ratio);
      if (distance < least) {
        least = distance;
        best = static_cast<int>(i);
      }
      before = now;
    }
  }
  return best;
}

void SlideHandles::State::mark(int index) {
  marked = index;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const Point3& colour = static_cast<int>(i) == index ? kUnderMouse : handles[i].shape.colour;
    handles[i].actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
  }
}

void SlideHandles::State::place() {
  for (const Handle& handle : handles) handle.actor->SetVisibility(is_shown());
  if (!is_shown()) return;
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows = placement();
  const vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(rows.data());
  for (const Handle& handle : handles) handle.actor->SetUserMatrix(matrix);
}

SlideHandles::SlideHandles(vtkRenderer& renderer, const SceneView& view)
    : state_(std::make_unique<State>(renderer, view)) {
  state_->frame_listener->SetClientData(state_.get());
  state_->frame_listener->SetCallback(
      [](vtkObject*, unsigned long, void* state, void*) { static_cast<State*>(state)->place(); });
  renderer.AddObserver(vtkCommand::StartEvent, state_->frame_listener);
}

SlideHandles::~SlideHandles() {
  state_->renderer.RemoveObserver(state_->frame_listener);
  for (const Handle& handle : state_->handles) state_->renderer.RemoveActor(handle.actor);
}

void SlideHandles::set_mode(Mode mode) {
  if (mode == state_->mode) return;
  end();
  for (const Handle& handle : state_->handles) state_->renderer.RemoveActor(handle.actor);
  state_->handles.clear();
  state_->mode = mode;
  for (HandleShape& shape : handle_shapes(mode)) {
    state_->handles.push_back(make_handle(std::move(shape)));
    state_->renderer.AddActor(state_->handles.back().actor);
  }
  state_->mark(-1);
  state_->place();
}

SlideHandles::Mode SlideHandles::mode() const { return state_->mode; }

void SlideHandles::set_slides(std::vector<std::pair<std::int64_t, Slide::Ellipse>> slides) {
  state_->slides = std::move(slides);
  state_->frame = state_->slides.empty() ? std::nullopt : handle_frame(state_->slides.back().second);
  state_->place();
}

void SlideHandles::update() { state_->place(); }

bool SlideHandles::hover(double x, double y) {
  const int index = is_dragging() ? state_->marked : state_->handle_at(x, y);
  if (index != state_->marked) state_->mark(index);
  return index >= 0;
}

bool SlideHandles::begin(double x, double y) {
  const int index = state_->handle_at(x, y);
  const Eigen::Matrix4d to_scene = to_matrix(state_->view.active_to_scene());
  if (index < 0 || !Eigen::FullPivLU<Eigen::Matrix4d>(to_scene).isInvertible()) return false;
  state_->mark(index);
  const HandleWay way = state_->handles[static_cast<std::size_t>(index)].shape.way;
  state_->drag.emplace(
      HandleDrag::Begin{state_->mode, way, *state_->frame, state_->slides, to_scene, state_->length(), x, y},
      Projection(state_->renderer));
  return true;
}

std::vector<std::pair<std::int64_t, Slide::Ellipse>> SlideHandles::drag(double x, double y, bool snap) {
  if (!is_dragging()) return state_->slides;
  set_slides(state_->drag->to(x, y, snap));
  return state_->slides;
}

void SlideHandles::end() {
  state_->drag.reset();
  state_->mark(-1);
}

bool SlideHandles::is_dragging() const { return state_->drag.has_value(); }

std::string SlideHandles::label() const {
  switch (state_->mode) {
    case Mode::move:
      return "move slide";
    case Mode::turn:
      return "turn slide";
    case Mode::scale:
      return "scale slide";
    case Mode::none:
      break;
  }
  return {};
}

std::vector<Point3> SlideHandles::places() const {
  std::vector<Point3> places;
  if (!state_->is_shown()) return places;
  const Eigen::Matrix4d matrix = state_->placement();
  const Eigen::Matrix4d from_scene = to_matrix(state_->view.active_to_scene()).inverse();
  const Projection projection(state_->renderer);
  for (std::size_t i = 0; i < state_->handles.size(); ++i) {
    const auto& candidates = state_->handles[i].shape.places;
    const auto found = std::find_if(candidates.begin(), candidates.end(), [&](const Vector3d& candidate) {
      const auto seen = projection.see(transformed(matrix, candidate));
      return seen.is_visible && state_->handle_at(seen.x, seen.y) == static_cast<int>(i);
    });
    const Vector3d& place = found == candidates.end() ? candidates.front() : *found;
    places.push_back(to_point(transformed(from_scene, transformed(matrix, place))));
  }
  return places;
}

}  // namespace cagewright::host
