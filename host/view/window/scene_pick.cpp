// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "host/view/polydata.h"
#include "host/view/window/projection.h"
#include "host/view/window/scene_state.h"
#include "host/view/window/scene_view.h"

namespace cagewright::host {
namespace {

using Eigen::Vector3d;

constexpr double kSlideReach = 6;     // pixels
constexpr double kAlike = 1;          // pixels: of what is as near as that the nearer to the viewer is meant
constexpr double kPlaceSize = 0.125;  // of the active mesh's diagonal, to either side
constexpr double kHiddenTolerance =
    0.01;  // of the distance to the centre: a slide so far behind the model is still on it

SightLine moved(const SightLine& line, const Eigen::Matrix4d& matrix) {
  return {transformed(matrix, line.origin), (matrix.topLeftCorner<3, 3>() * line.direction).stableNormalized()};
}

struct ModelHit {
  const MeshEntry* entry = nullptr;
  MeshHit hit;       // in the mesh's space
  double along = 0;  // from the line's origin, scene units
};

std::optional<ModelHit> hit_of(const MeshEntry& entry, const SightLine& line) {
  if (entry.is_flat) return std::nullopt;
  const SightLine own = moved(line, entry.from_scene);
  const auto hit = entry.picker->first_hit(own.origin, own.direction);
  if (!hit) return std::nullopt;
  return ModelHit{&entry, *hit, (transformed(entry.to_scene, hit->point) - line.origin).dot(line.direction)};
}

Hit to_hit(const ModelHit& found) {
  Hit hit;
  hit.what = Hit::What::model;
  hit.node = found.entry->shown.node;
  hit.point = to_point(found.hit.point);
  hit.normal = to_point(found.hit.normal);
  return hit;
}

struct SlideHit {
  std::int64_t slide = -1;
  Vector3d point;     // in the slide's space
  double pixels = 0;  // from the display point
  double depth = 0;   // along the view
};

// The nearest segment of the slide's outline on the screen.
std::optional<SlideHit> hit_of(const ShownSlide& slide, const Projection& projection, const Eigen::Matrix4d& to_scene,
                               const Eigen::Vector2d& at, double reach) {
  const auto outline = ellipse_points(slide.ellipse.center, slide.ellipse.u, slide.ellipse.v, kEllipseSegments);
  std::vector<Projection::Seen> seen;
  for (const Point3& point : outline) seen.push_back(projection.see(transformed(to_scene, to_vector(point))));
  std::optional<SlideHit> best;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    if (!seen[i].is_visible || !seen[next].is_visible) continue;
    const Eigen::Vector2d a(seen[i].x, seen[i].y), b(seen[next].x, seen[next].y);
    const double length = (b - a).squaredNorm();
    const double t = length > 0 ? std::clamp((at - a).dot(b - a) / length, 0.0, 1.0) : 0;
    const double pixels = (at - a - t * (b - a)).norm();
    const double depth = (1 - t) * seen[i].depth + t * seen[next].depth;
    // A slide seen from its edge: of its two sides the nearer one.
    const bool is_better =
        !best || pixels < best->pixels - kAlike || (pixels < best->pixels + kAlike && depth < best->depth);
    if (pixels > reach || !is_better) continue;
    best = SlideHit{slide.id, (1 - t) * to_vector(outline[i]) + t * to_vector(outline[next]), pixels, depth};
  }
  return best;
}

// Where a line in the cage's space meets it first (Möller and Trumbore, 1997).
std::optional<Hit> hit_of(const TriangleMesh& cage, const SightLine& line) {
  std::optional<Hit> best;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 2 < cage.triangles.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return Vector3d(&cage.points[3 * std::size_t{cage.triangles[i + k]}]); };
    const Vector3d a = corner(0), ab = corner(1) - a, ac = corner(2) - a;
    const Vector3d across = line.direction.cross(ac);
    const double volume = ab.dot(across);
    if (volume == 0) continue;
    const Vector3d way = line.origin - a, around = way.cross(ab);
    const double u = way.dot(across) / volume, v = line.direction.dot(around) / volume;
    const double along = ac.dot(around) / volume;
    if (u < 0 || v < 0 || u + v > 1 || along < 0 || along >= nearest) continue;
    nearest = along;
    best.emplace();
    best->what = Hit::What::cage;
    best->point = to_point(line.origin + along * line.direction);
    best->normal = to_point(ab.cross(ac).stableNormalized());
  }
  return best;
}

// Along the view: what is farther is behind what the line of sight meets there.
double hidden_depth(const Projection& projection, const SightLine& line, double along) {
  const Vector3d met = line.origin + along * line.direction;
  return (met - projection.eye).dot(projection.forward) +
         kHiddenTolerance * (projection.focal_point - projection.eye).norm();
}

std::optional<std::array<double, 6>> to_bounds(const Eigen::AlignedBox3d& box) {
  if (box.isEmpty()) return std::nullopt;
  return std::array{box.min().x(), box.max().x(), box.min().y(), box.max().y(), box.min().z(), box.max().z()};
}

void extend(Eigen::AlignedBox3d& box, const Slide::Ellipse& ellipse, const Eigen::Matrix4d& to_scene) {
  for (const Point3& point : ellipse_points(ellipse.center, ellipse.u, ellipse.v, kEllipseSegments)) {
    box.extend(transformed(to_scene, to_vector(point)));
  }
}

}  // namespace

Hit SceneView::pick(double x, double y, bool slides_first) const {
  const Projection projection(state_->renderer);
  const SightLine line = projection.sight_line(x, y);
  std::optional<ModelHit> model;
  for (const MeshEntry& entry : state_->meshes) {
    const auto hit = state_->shows(entry) ? hit_of(entry, line) : std::nullopt;
    if (hit && (!model || hit->along < model->along)) model = hit;
  }
  std::optional<SlideHit> slide;
  if (state_->options.slides) {
    const double reach = kSlideReach * pixel_ratio(state_->renderer);
    const double hidden =
        model ? hidden_depth(projection, line, model->along) : std::numeric_limits<double>::infinity();
    for (const ShownSlide& shown : state_->slides) {
      if (shown.id < 0) continue;
      const auto hit = hit_of(shown, projection, state_->active_to_scene(), {x, y}, reach);
      if (hit && (slides_first || hit->depth <= hidden) && (!slide || hit->pixels < slide->pixels)) slide = hit;
    }
  }
  if (slide) {
    Hit hit;
    hit.what = Hit::What::slide;
    hit.slide = slide->slide;
    hit.point = to_point(slide->point);
    return hit;
  }
  if (model) return to_hit(*model);
  if (state_->cage && state_->options.cage) {
    return hit_of(state_->cage->mesh, moved(line, state_->active_from_scene())).value_or(Hit{});
  }
  return {};
}

std::optional<Hit> SceneView::pick_model(double x, double y) const {
  const MeshEntry* active = state_->active();
  if (active == nullptr) return std::nullopt;
  const auto hit = hit_of(*active, Projection(state_->renderer).sight_line(x, y));
  return hit ? std::optional(to_hit(*hit)) : std::nullopt;
}

Ray SceneView::ray(double x, double y) const {
  const SightLine line = moved(Projection(state_->renderer).sight_line(x, y), state_->active_from_scene());
  return {to_point(line.origin), to_point(line.direction)};
}

std::array<double, 2> SceneView::to_display(const Point3& point) const {
  const auto seen = Projection(state_->renderer).see(transformed(state_->active_to_scene(), to_vector(point)));
  return {seen.x, seen.y};
}

std::optional<std::array<double, 6>> SceneView::bounds() const {
  Eigen::AlignedBox3d box;
  for (const MeshEntry& entry : state_->meshes) box.extend(entry.bounds);
  const Eigen::Matrix4d to_scene = state_->active_to_scene();
  for (const ShownSlide& slide : state_->slides) extend(box, slide.ellipse, to_scene);
  return to_bounds(box);
}

std::optional<std::array<double, 6>> SceneView::bounds_of_model() const {
  const MeshEntry* active = state_->active();
  return active == nullptr ? std::nullopt : to_bounds(active->bounds);
}

std::optional<std::array<double, 6>> SceneView::bounds_of_slides(const std::vector<std::int64_t>& ids) const {
  Eigen::AlignedBox3d box;
  for (const ShownSlide& slide : state_->slides) {
    if (std::find(ids.begin(), ids.end(), slide.id) != ids.end()) {
      extend(box, slide.ellipse, state_->active_to_scene());
    }
  }
  return to_bounds(box);
}

std::optional<std::array<double, 6>> SceneView::bounds_of_place(const Point3& place) const {
  const MeshEntry* active = state_->active();
  if (active == nullptr || active->bounds.isEmpty()) return std::nullopt;
  const Vector3d center = transformed(active->to_scene, to_vector(place));
  const Vector3d half = Vector3d::Constant(kPlaceSize * active->bounds.diagonal().norm());
  return to_bounds({center - half, center + half});
}

}  // namespace cagewright::host
