// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "host/command/command_group.h"
#include "host/command/slide_commands.h"
#include "host/file/file_error.h"
#include "host/workspace/slide_geometry.h"
#include "host/workspace/slide_names.h"
#include "host/workspace/tilted_plane.h"
#include "host/workspace/workspace_state.h"

namespace cagewright::host {
namespace {

// "remove slide 'knee'" of one, "remove 3 slides" of more.
std::string label_of(const std::string& verb, const std::vector<const SceneSlide*>& slides) {
  if (slides.size() == 1) return verb + " slide " + in_quotes(slides.front()->name);
  return verb + " " + counted(slides.size(), "slide");
}

double middle_of(const TriangleMesh& mesh, int axis) {
  double least = mesh.points[static_cast<std::size_t>(axis)], greatest = least;
  for (std::size_t i = static_cast<std::size_t>(axis); i < mesh.points.size(); i += 3) {
    least = std::min(least, mesh.points[i]);
    greatest = std::max(greatest, mesh.points[i]);
  }
  return (least + greatest) / 2;
}

// Slides that are to be added in one step.
class Additions {
 public:
  explicit Additions(int mesh_node) : mesh_node_(mesh_node) {}

  void add(const std::string& name, const Slide::Ellipse& ellipse, std::vector<Point3> stroke) {
    auto command = std::make_unique<AddSlide>(mesh_node_, name, ellipse, std::move(stroke));
    added_.push_back(command.get());
    commands_.push_back(std::move(command));
  }
  std::vector<std::unique_ptr<Command>> take_commands() { return std::move(commands_); }
  // Once they are done; the commands live on in the stack.
  std::vector<std::int64_t> ids() const {
    std::vector<std::int64_t> ids;
    for (const AddSlide* command : added_) ids.push_back(command->id());
    return ids;
  }

 private:
  int mesh_node_;
  std::vector<const AddSlide*> added_;
  std::vector<std::unique_ptr<Command>> commands_;
};

}  // namespace

void Workspace::State::run_group(const std::string& label, std::vector<std::unique_ptr<Command>> commands) {
  if (commands.empty()) return;
  run(std::make_unique<CommandGroup>(label, std::move(commands)));
}

Slide::Ellipse Workspace::fit(const Slide& slide) const {
  if (const auto* ellipse = std::get_if<Slide::Ellipse>(&slide.shape)) return *ellipse;
  State& s = *state_;
  OpenScene& open = s.scene_with_mesh();
  if (!s.plugin) throw CommandError("the plug-in fits slides to strokes and points, and none is loaded: load one");
  Slide named = slide;
  if (named.name.empty()) named.name = "new slide";
  return s.fitter->fit(open.mesh(open.mesh_node), named);
}

void Workspace::prepare_to_fit() {
  const State& s = *state_;
  if (s.fitter && s.scene && s.scene->mesh_node >= 0) s.fitter->prepare(s.scene->mesh(s.scene->mesh_node));
}

Slide::Ellipse Workspace::fit_across(const std::vector<Point3>& stroke, const Point3& line_of_sight) const {
  return fit({"", plane_across(stroke, line_of_sight)});
}

std::int64_t Workspace::add_slide(const Slide& slide) {
  const OpenScene& open = state_->scene_with_mesh();
  Slide named = slide;
  if (named.name.empty()) named.name = SlideNames(slides()).next();
  const auto* stroke = std::get_if<Slide::Stroke>(&slide.shape);
  Additions additions(open.mesh_node);
  additions.add(named.name, fit(named), stroke ? stroke->points : std::vector<Point3>());
  state_->run(std::move(additions.take_commands().front()));
  state_->select(additions.ids());
  return additions.ids().front();
}

Workspace::SlideAcross Workspace::add_slide_across(const std::vector<Point3>& stroke, const Point3& line_of_sight,
                                                   const std::string& name) {
  static_cast<void>(state_->scene_with_mesh());
  const auto fit_plane = [this](const Slide::PointNormal& plane) { return fit({"", plane}); };
  const TiltedPlane tilted = tilted_plane(stroke, line_of_sight, fit_plane);
  return {add_slide({name, tilted.plane}), tilted.tilt};
}

void Workspace::extend_stroke(std::int64_t id, const std::vector<Point3>& points) {
  const SceneSlide& slide = state_->slide(id);
  if (slide.stroke.empty()) {
    throw CommandError("slide " + in_quotes(slide.name) +
                       " was not fitted to a stroke, or has been moved since: draw a new one");
  }
  std::vector<Point3> stroke = slide.stroke;
  stroke.insert(stroke.end(), points.begin(), points.end());
  const Slide::Ellipse ellipse = fit({slide.name, Slide::Stroke{stroke}});
  std::vector<std::unique_ptr<Command>> commands;
  commands.push_back(std::make_unique<ChangeSlide>(id, ellipse, std::move(stroke)));
  state_->run_group("extend the stroke of " + in_quotes(slide.name), std::move(commands));
}

void Workspace::change_slides(const std::vector<std::pair<std::int64_t, Slide::Ellipse>>& slides,
                              const std::string& label) {
  std::vector<std::unique_ptr<Command>> commands;
  for (const auto& [id, ellipse] : slides) commands.push_back(std::make_unique<ChangeSlide>(id, ellipse));
  state_->run_group(label, std::move(commands));
}

void Workspace::rename_slide(std::int64_t id, const std::string& name) {
  if (state_->slide(id).name == name) return;
  state_->run(std::make_unique<RenameSlide>(id, name));
}

void Workspace::remove_slides(const std::vector<std::int64_t>& ids) {
  std::vector<const SceneSlide*> slides;
  std::vector<std::unique_ptr<Command>> commands;
  for (const std::int64_t id : ids) {
    slides.push_back(&state_->slide(id));
    commands.push_back(std::make_unique<RemoveSlide>(id));
  }
  state_->run_group(label_of("remove", slides), std::move(commands));
}

std::vector<std::int64_t> Workspace::duplicate_slides(const std::vector<std::int64_t>& ids) {
  constexpr double of_radius = 0.25;  // far enough to be seen and to leave most limbs' loops apart
  const OpenScene& open = state_->scene_with_mesh();
  SlideNames names(slides());
  Additions additions(open.mesh_node);
  std::vector<const SceneSlide*> originals;
  for (const std::int64_t id : ids) {
    const SceneSlide& slide = *originals.emplace_back(&state_->slide(id));
    Point3 way = normal_of(slide.ellipse);
    const Point3& u = slide.ellipse.u;
    const double radius = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    for (double& x : way) x *= of_radius * radius;
    additions.add(names.copy_of(slide.name), moved(slide.ellipse, way), {});
  }
  state_->run_group(label_of("duplicate", originals), additions.take_commands());
  state_->select(additions.ids());
  return additions.ids();
}

std::vector<std::int64_t> Workspace::mirror_slides(const std::vector<std::int64_t>& ids, int axis,
                                                   std::optional<double> at) {
  OpenScene& open = state_->scene_with_mesh();
  if (axis < 0 || axis > 2) throw CommandError("a plane to mirror across is that of axis 0, 1 or 2");
  const double plane = at ? *at : middle_of(*open.mesh(open.mesh_node), axis);
  SlideNames names(slides());
  Additions additions(open.mesh_node);
  std::vector<const SceneSlide*> originals;
  for (const std::int64_t id : ids) {
    const SceneSlide& slide = *originals.emplace_back(&state_->slide(id));
    std::vector<Point3> stroke;
    for (const Point3& point : slide.stroke) stroke.push_back(mirrored(point, axis, plane));
    additions.add(names.mirror_of(slide.name), mirrored(slide.ellipse, axis, plane), std::move(stroke));
  }
  state_->run_group(label_of("mirror", originals), additions.take_commands());
  state_->select(additions.ids());
  return additions.ids();
}

void Workspace::snap_slides(const std::vector<std::int64_t>& ids) {
  std::vector<const SceneSlide*> slides;
  std::vector<std::unique_ptr<Command>> commands;
  for (const std::int64_t id : ids) {
    const SceneSlide& slide = *slides.emplace_back(&state_->slide(id));
    const Slide::PointNormal plane{slide.ellipse.center, normal_of(slide.ellipse)};
    commands.push_back(std::make_unique<ChangeSlide>(id, fit({slide.name, plane})));
  }
  state_->run_group(label_of("snap", slides), std::move(commands));
}

std::string Workspace::copy_slides(const std::vector<std::int64_t>& ids) const {
  std::vector<Slide> slides;
  for (const std::int64_t id : ids) slides.push_back({state_->slide(id).name, state_->slide(id).ellipse});
  return slides_text("clipboard", slides);
}

std::vector<std::int64_t> Workspace::paste_slides(const std::string& text) {
  const OpenScene& open = state_->scene_with_mesh();
  SlideNames names(slides());
  Additions additions(open.mesh_node);
  const std::vector<Slide> pasted = parse_slides("clipboard", text);
  for (const Slide& slide : pasted) {
    const auto* stroke = std::get_if<Slide::Stroke>(&slide.shape);
    additions.add(names.like(slide.name), fit(slide), stroke ? stroke->points : std::vector<Point3>());
  }
  state_->run_group("paste " + counted(pasted.size(), "slide"), additions.take_commands());
  state_->select(additions.ids());
  return additions.ids();
}

}  // namespace cagewright::host
