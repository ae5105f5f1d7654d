// SPDX-License-Identifier: BSD-3-Clause
#include "host/view/window/scene_view.h"

#include <vtkCommand.h>
#include <vtkRenderer.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "host/view/polydata.h"
#include "host/view/window/colours.h"
#include "host/view/window/open_edges.h"
#include "host/view/window/projection.h"
#include "host/view/window/scene_state.h"

namespace cagewright::host {
namespace {

// On top of the model: both looks alike, before and behind it.
constexpr LineStyle kStroke{colours::stroke, 3, 1, 1};

constexpr LineStyle kOpenEdges{colours::failed_slide, 3, 1, 0.35};

constexpr std::size_t kMostOpenEdges = 20000;  // more would take long to draw
constexpr std::size_t kMostMarks = 5000;       // of vertices outside; so many are seen by their colour

Eigen::AlignedBox3d bounds_of(const TriangleMesh& mesh, const Eigen::Matrix4d& to_scene) {
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < mesh.points.size(); i += 3) {
    box.extend(transformed(to_scene, Eigen::Vector3d(&mesh.points[i])));
  }
  return box;
}

bool is_finite(const Slide::Ellipse& ellipse) {
  return to_vector(ellipse.center).allFinite() && to_vector(ellipse.u).allFinite() && to_vector(ellipse.v).allFinite();
}

void place(MeshEntry& entry) {
  const Eigen::Matrix4d to_scene = to_matrix(entry.shown.to_scene);
  entry.to_scene = to_scene;
  const Eigen::FullPivLU<Eigen::Matrix4d> solver(to_scene);
  entry.is_flat = !solver.isInvertible();
  entry.from_scene = entry.is_flat ? Eigen::Matrix4d(Eigen::Matrix4d::Identity()) : Eigen::Matrix4d(solver.inverse());
  entry.bounds = bounds_of(*entry.shown.mesh, to_scene);
  entry.surface->set_transform(entry.shown.to_scene);
}

}  // namespace

SceneView::State::State(vtkRenderer& of)
    : renderer(of),
      grid(of),
      outside_marks(of),
      cage_actors(of),
      slide_actors(of),
      slide_labels(of),
      place_mark(of),
      stroke(of, kStroke),
      open_edges(of, kOpenEdges) {
  renderer.AutomaticLightCreationOff();
  renderer.RemoveAllLights();
  light->SetLightTypeToCameraLight();
  light->SetPosition(0.35, 0.55, 1);  // above the viewer's shoulder
  light->SetFocalPoint(0, 0, 0);
  renderer.AddLight(light);
  // A renderer without passes of its own sorts what is translucent by the pixel: half of the frame's time without a
  // graphics card. Faces of one colour need no order.
  still_layer->set_still([this] { return models(); });
  pass->SetOpaquePass(still_layer);
  renderer.SetPass(pass);
  frame_listener->SetClientData(this);
  frame_listener->SetCallback(
      [](vtkObject*, unsigned long, void* state, void*) { static_cast<State*>(state)->before_frame(); });
  renderer.AddObserver(vtkCommand::StartEvent, frame_listener);
  apply_background();
  apply_look();
}

SceneView::State::~State() {
  renderer.RemoveObserver(frame_listener);
  renderer.RemoveLight(light);
  renderer.SetPass(nullptr);
  for (const MeshEntry& entry : meshes) renderer.RemoveActor(&entry.surface->actor());
  if (parts != nullptr) renderer.RemoveActor(&parts->actor());
}

const MeshEntry* SceneView::State::active() const {
  const auto found =
      std::find_if(meshes.begin(), meshes.end(), [](const auto& entry) { return entry.shown.is_active; });
  return found == meshes.end() ? nullptr : &*found;
}

bool SceneView::State::shows(const MeshEntry& entry) const {
  return options.model && (entry.shown.is_active || options.other_meshes);
}

Eigen::Matrix4d SceneView::State::active_to_scene() const {
  return active() == nullptr ? Eigen::Matrix4d(Eigen::Matrix4d::Identity()) : active()->to_scene;
}

Eigen::Matrix4d SceneView::State::active_from_scene() const {
  return active() == nullptr ? Eigen::Matrix4d(Eigen::Matrix4d::Identity()) : active()->from_scene;
}

void SceneView::State::apply_transform() {
  const Matrix4 to_scene = active() == nullptr ? ShownMesh{}.to_scene : active()->shown.to_scene;
  outside_marks.set_transform(to_scene);
  cage_actors.set_transform(to_scene);
  slide_actors.set_transform(to_scene);
  stroke.set_transform(to_scene);
  open_edges.set_transform(to_scene);
  if (parts != nullptr) parts->set_transform(to_scene);
}

void SceneView::State::apply_background() {
  const Point3 low = options.dark ? Point3{0.118, 0.122, 0.133} : Point3{0.80, 0.81, 0.83};
  const Point3 high = options.dark ? Point3{0.190, 0.192, 0.200} : Point3{0.95, 0.95, 0.96};
  renderer.GradientBackgroundOn();
  renderer.SetBackground(low[0], low[1], low[2]);
  renderer.SetBackground2(high[0], high[1], high[2]);
}

void SceneView::State::make_parts() {
  parts = std::make_unique<SurfaceActor>(cut_model);
  std::vector<Point3> colours(cut_model.triangle_count(), colours::model);
  for (std::size_t i = 0; i < std::min(colours.size(), cut_model_parts.size()); ++i) {
    colours[i] = colour_of_part(cut_model_parts[i]);
  }
  parts->set_triangle_colours(colours);
  parts->show_own_colours(true);
  renderer.AddActor(&parts->actor());
  apply_transform();
}

std::vector<vtkProp*> SceneView::State::models() const {
  std::vector<vtkProp*> props;
  for (const MeshEntry& entry : meshes) props.push_back(&entry.surface->actor());
  if (parts != nullptr) props.push_back(&parts->actor());
  return props;
}

void SceneView::State::colour_outside() {
  const TriangleMesh& mesh = *active()->shown.mesh;
  std::vector<Point3> colours(mesh.vertex_count(), colours::model);
  std::vector<Point3> marks;
  for (const std::uint32_t vertex : outside) {
    if (vertex >= mesh.vertex_count()) continue;
    colours[vertex] = colours::outside;
    if (marks.size() < kMostMarks) marks.push_back(to_point(Eigen::Vector3d(&mesh.points[3 * std::size_t{vertex}])));
  }
  active()->surface->set_vertex_colours(colours);
  outside_marks.set(marks);
  outside_is_coloured = true;
}

void SceneView::State::apply_look() {
  using Colours = ViewOptions::Colours;
  const bool shows_parts = options.colours == Colours::parts && !cut_model.triangles.empty() && active() != nullptr;
  const bool shows_coverage = options.colours == Colours::coverage && active() != nullptr;
  if (shows_parts && options.model && parts == nullptr) make_parts();
  if (shows_coverage && options.model && !outside_is_coloured) colour_outside();
  for (const MeshEntry& entry : meshes) {
    const bool is_active = entry.shown.is_active;
    entry.surface->actor().SetVisibility(shows(entry) && !(is_active && shows_parts));
    entry.surface->set_colour(is_active      ? colours::model
                              : options.dark ? colours::other_model
                                             : colours::other_model_on_light);
    entry.surface->set_wireframe(options.wireframe);
    entry.surface->show_own_colours(is_active && shows_coverage);
  }
  if (parts != nullptr) {
    parts->actor().SetVisibility(options.model && shows_parts);
    parts->set_wireframe(options.wireframe);
  }
  outside_marks.set_visible(options.model && shows_coverage);
  open_edges.set_visible(options.model && shows_open_edges);
  cage_actors.set_options(options);
  slide_actors.set_visible(options.slides);
  slide_labels.set_visible(options.slides);
  grid.set_look(options.grid, options.dark);
}

void SceneView::State::before_frame() {
  const double ratio = pixel_ratio(renderer);
  grid.set_pixel_ratio(ratio);
  outside_marks.set_pixel_ratio(ratio);
  cage_actors.set_pixel_ratio(ratio);
  slide_actors.set_pixel_ratio(ratio);
  stroke.set_pixel_ratio(ratio);
  open_edges.set_pixel_ratio(ratio);
  slide_labels.place(active_to_scene());
  place_mark.follow(active_to_scene());
}

void SceneView::State::fit_grid() {
  Eigen::AlignedBox3d box;
  for (const MeshEntry& entry : meshes) box.extend(entry.bounds);
  const int up = options.z_up ? 2 : 1;
  if (box.isEmpty()) {
    box = Eigen::AlignedBox3d(-Eigen::Vector3d::Ones(), Eigen::Vector3d::Ones());
    box.min()[up] = 0;
  }
  grid.fit({box.min().x(), box.max().x(), box.min().y(), box.max().y(), box.min().z(), box.max().z()}, up);
}

SceneView::SceneView(vtkRenderer& renderer) : state_(std::make_unique<State>(renderer)) {}
SceneView::~SceneView() = default;

void SceneView::set_meshes(std::vector<ShownMesh> meshes) {
  const MeshEntry* before = state_->active();
  const std::shared_ptr<const TriangleMesh> active_before = before == nullptr ? nullptr : before->shown.mesh;
  std::vector<MeshEntry> entries;
  for (ShownMesh& shown : meshes) {
    if (shown.mesh == nullptr) continue;
    const auto same = std::find_if(state_->meshes.begin(), state_->meshes.end(), [&](const MeshEntry& entry) {
      return entry.surface != nullptr && entry.shown.mesh == shown.mesh;
    });
    if (same != state_->meshes.end()) {
      const bool moved = same->shown.to_scene != shown.to_scene;
      entries.push_back(std::move(*same));
      entries.back().shown = std::move(shown);
      if (moved) place(entries.back());
      continue;
    }
    MeshEntry entry;
    entry.shown = std::move(shown);
    entry.surface = std::make_unique<SurfaceActor>(*entry.shown.mesh);
    entry.picker = std::make_unique<MeshPicker>(entry.shown.mesh);
    place(entry);
    state_->renderer.AddActor(&entry.surface->actor());
    entries.push_back(std::move(entry));
  }
  for (const MeshEntry& gone : state_->meshes) {
    if (gone.surface != nullptr) state_->renderer.RemoveActor(&gone.surface->actor());
  }
  state_->meshes = std::move(entries);
  const MeshEntry* now = state_->active();
  if (now == nullptr || now->shown.mesh != active_before) {
    set_parts({}, {});
    set_outside({});
    state_->mesh_of_open_edges.reset();
    state_->open_edges.set({}, false);
    show_open_edges(false);
  }
  state_->apply_transform();
  state_->apply_look();
  state_->fit_grid();
}

void SceneView::set_parts(const TriangleMesh& cut_model, const std::vector<int>& triangle_parts) {
  if (state_->parts != nullptr) state_->renderer.RemoveActor(&state_->parts->actor());
  state_->parts.reset();
  state_->cut_model = cut_model;
  state_->cut_model_parts = triangle_parts;
  state_->apply_look();
}

void SceneView::set_outside(const std::vector<std::uint32_t>& vertices) {
  state_->outside = vertices;
  state_->outside_is_coloured = false;
  state_->apply_look();
}

void SceneView::set_slides(std::vector<ShownSlide> slides) {
  std::erase_if(slides, [](const ShownSlide& slide) { return !is_finite(slide.ellipse); });
  state_->slides = std::move(slides);
  state_->slide_actors.set(state_->slides);
  state_->slide_labels.set(state_->slides);
}

void SceneView::set_cage(const ShownCage* cage) {
  state_->cage_actors.set(cage);
  state_->cage = cage == nullptr ? std::nullopt : std::optional<ShownCage>(*cage);
}

void SceneView::set_stroke(const std::vector<Point3>& points) {
  std::vector<std::vector<Point>> runs;
  if (points.size() > 1) runs.emplace_back(points.begin(), points.end());
  state_->stroke.set(std::move(runs), false);
}

void SceneView::set_place(const std::optional<Point3>& place) { state_->place_mark.set(place); }

void SceneView::show_open_edges(bool shown) {
  const MeshEntry* active = state_->active();
  if (shown && active != nullptr && state_->mesh_of_open_edges != active->shown.mesh) {
    state_->mesh_of_open_edges = active->shown.mesh;
    state_->open_edges.set(open_edges(*active->shown.mesh, kMostOpenEdges), false);
  }
  state_->shows_open_edges = shown && active != nullptr;
  state_->apply_look();
}

void SceneView::set_options(const ViewOptions& options) {
  const bool turns_grid = options.z_up != state_->options.z_up;
  state_->options = options;
  state_->apply_background();
  state_->apply_look();
  if (turns_grid) state_->fit_grid();
}

const ViewOptions& SceneView::options() const { return state_->options; }

Matrix4 SceneView::active_to_scene() const {
  return state_->active() == nullptr ? ShownMesh{}.to_scene : state_->active()->shown.to_scene;
}

}  // namespace cagewright::host
