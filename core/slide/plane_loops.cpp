// SPDX-License-Identifier: BSD-3-Clause
#include "core/slide/plane_loops.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error/error.h"
#include "core/mesh/predicates.h"
#include "core/mesh/tolerance.h"
#include "core/slide/across_limb.h"
#include "core/slide/crossed_edges.h"
#include "core/slide/fit_ellipse.h"
#include "core/slide/plane_frame.h"

namespace cagewright {
namespace {

using OpenMesh::HalfedgeHandle;
using OpenMesh::VertexHandle;

// Signed distances from the plane. The same for a vertex whichever edge asks; what is on the plane but for rounding is
// exactly on it, so that a turned model is cut through the same vertices.
class Heights {
 public:
  Heights(const HalfEdgeMesh& mesh, const EdgeBlocks& blocks, const Vector3& point, const Vector3& normal)
      : mesh_(mesh), point_(point), normal_(normal), on_plane_(tolerance::tie * blocks.farthest_from(point, normal)) {}

  double of(VertexHandle v) const {
    const double height = normal_.dot(mesh_.point(v) - point_);
    return std::abs(height) <= on_plane_ ? 0 : height;
  }

 private:
  const HalfEdgeMesh& mesh_;
  const Vector3& point_;
  const Vector3& normal_;
  double on_plane_;
};

Vector3 crossing(const HalfEdgeMesh& mesh, const Heights& heights, HalfedgeHandle h) {
  const VertexHandle a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
  return crossing_point(mesh.point(a), heights.of(a), mesh.point(b), heights.of(b));
}

// The half-edge of `edge` that runs from behind the plane to ahead of it; invalid where both ends are on one side.
HalfedgeHandle crossed_half(const HalfEdgeMesh& mesh, const Heights& heights, int edge) {
  const HalfedgeHandle h = mesh.halfedge_handle(OpenMesh::EdgeHandle(edge), 0);
  const bool from = is_ahead(heights.of(mesh.from_vertex_handle(h)));
  const bool to = is_ahead(heights.of(mesh.to_vertex_handle(h)));
  if (from == to) return HalfedgeHandle();
  return from ? mesh.opposite_halfedge_handle(h) : h;
}

PlaneLoop loop_from(const HalfEdgeMesh& mesh, const Heights& heights, HalfedgeHandle start) {
  PlaneLoop loop;
  HalfedgeHandle h = start;
  do {
    loop.crossed.push_back(h);
    h = next_crossed(mesh, h, heights.of(third_vertex(mesh, h)));
  } while (h != start);
  loop.points.resize(static_cast<Eigen::Index>(loop.crossed.size()), 3);
  for (std::size_t i = 0; i < loop.crossed.size(); ++i)
    loop.points.row(static_cast<Eigen::Index>(i)) = crossing(mesh, heights, loop.crossed[i]).transpose();
  return loop;
}

double signed_area(const std::vector<Vector2>& polygon) {
  double area = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2 a = polygon[i] - polygon[0], b = polygon[(i + 1) % polygon.size()] - polygon[0];
    area += (a.x() * b.y() - a.y() * b.x()) / 2;
  }
  return area;
}

double distance_to(const std::vector<Vector2>& polygon, const Vector2& point) {
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2 edge = polygon[(i + 1) % polygon.size()] - a;
    const double length = edge.squaredNorm();
    const double t = length > 0 ? std::clamp(edge.dot(point - a) / length, 0.0, 1.0) : 0.0;
    best = std::min(best, (a + t * edge - point).norm());
  }
  return best;
}

// The innermost loop of solid material round `center`: it runs counter-clockwise and has the least area.
const PlaneLoop* enclosing_loop(const std::vector<PlaneLoop>& loops, const Vector3& center, const Vector3& normal) {
  const PlaneFrame frame(center, normal);
  const PlaneLoop* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const PlaneLoop& loop : loops) {
    const double area = signed_area(frame.to_plane(loop.points));
    if (area <= 0 || area >= least || winding_number(loop.points, center, normal) <= 0) continue;
    best = &loop;
    least = area;
  }
  return best;
}

const PlaneLoop* nearest_loop(const std::vector<PlaneLoop>& loops, const Vector3& point, const Vector3& normal) {
  const PlaneFrame frame(point, normal);
  const PlaneLoop* best = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const PlaneLoop& loop : loops) {
    const std::vector<Vector2> polygon = frame.to_plane(loop.points);
    const double distance = distance_to(polygon, Vector2::Zero());
    if (signed_area(polygon) <= 0 || distance >= least) continue;
    best = &loop;
    least = distance;
  }
  return best;
}

bool has_inside_wall(const std::vector<PlaneLoop>& loops, const Ellipse& ellipse) {
  return std::any_of(loops.begin(), loops.end(), [&](const PlaneLoop& loop) {
    return winding_number(loop.points, ellipse.center, ellipse.normal) < 0;
  });
}

// A point well inside the loop, for a crescent whose centroid is not: the best of a grid along u and v.
Vector3 deepest_point(const Points& loop, const Ellipse& ellipse) {
  const PlaneFrame frame(ellipse.center, ellipse.normal);
  const std::vector<Vector2> polygon = frame.to_plane(loop);
  const int steps = 24;
  Vector3 best = ellipse.center;
  double depth = 0;
  for (int i = -steps; i <= steps; ++i) {
    for (int j = -steps; j <= steps; ++j) {
      const Vector3 candidate = ellipse.center + 2.0 * i / steps * ellipse.u + 2.0 * j / steps * ellipse.v;
      const double distance = distance_to(polygon, frame.to_plane(candidate));
      if (distance <= depth || winding_number(loop, candidate, ellipse.normal) <= 0) continue;
      best = candidate;
      depth = distance;
    }
  }
  return best;
}

// Where the slide is; not finite where it does not say.
Vector3 place_of(const SlideDefinition& definition) {
  if (const auto* stroke = std::get_if<StrokeDefinition>(&definition)) {
    return stroke->points.colwise().sum() / static_cast<double>(stroke->points.rows());
  }
  if (const auto* plane = std::get_if<PointNormalDefinition>(&definition)) return plane->point;
  if (const auto* click = std::get_if<PointDefinition>(&definition)) return click->point;
  return std::get<EllipseDefinition>(definition).center;
}

Error of_slide(const Error& error, const Slide& slide, std::size_t index) {
  ErrorPlace place = error.place();
  place.slide = index;
  const Vector3 own = place_of(slide.definition);
  if (!place.point && own.allFinite()) place.point = own;
  return {error.code(), error.what(), place};
}

[[noreturn]] void fail(ErrorCode code, const std::string& sentence, std::size_t index, const Vector3& point) {
  ErrorPlace place;
  place.slide = index;
  place.point = point;
  throw Error(code, sentence, place);
}

SlideOnModel place_by_point(const HalfEdgeMesh& mesh, const EdgeBlocks& blocks, const PointNormalDefinition& plane,
                            const std::string& name, std::size_t index) {
  const std::vector<PlaneLoop> loops = plane_loops(mesh, blocks, plane.point, plane.normal);
  const PlaneLoop* loop = enclosing_loop(loops, plane.point, plane.normal);
  if (!loop) loop = nearest_loop(loops, plane.point, plane.normal);
  if (!loop)
    fail(ErrorCode::slide_misses_model,
         slide_text(name) + " misses the model: its plane through " + to_text(plane.point) +
             " does not cut it; move the point onto the limb to cut",
         index, plane.point);
  SlideOnModel placed{fit_loop(loop->points, plane.point, plane.normal, name), *loop, false};
  if (winding_number(loop->points, placed.ellipse.center, placed.ellipse.normal) <= 0)
    placed.ellipse.center = deepest_point(loop->points, placed.ellipse);
  placed.hollow = has_inside_wall(loops, placed.ellipse);
  return placed;
}

SlideOnModel place_ellipse(const HalfEdgeMesh& mesh, const EdgeBlocks& blocks, const Ellipse& ellipse,
                           const std::string& name, std::size_t index) {
  const std::vector<PlaneLoop> loops = plane_loops(mesh, blocks, ellipse.center, ellipse.normal);
  if (loops.empty())
    fail(ErrorCode::slide_misses_model,
         slide_text(name) + " misses the model: its plane through " + to_text(ellipse.center) +
             " does not cut it; move the slide onto the limb to cut",
         index, ellipse.center);
  const PlaneLoop* loop = enclosing_loop(loops, ellipse.center, ellipse.normal);
  if (!loop)
    fail(ErrorCode::slide_not_enclosed,
         slide_text(name) + ": no closed loop of the model goes round its centre " + to_text(ellipse.center) +
             " in its plane; move the centre inside the limb to cut",
         index, ellipse.center);
  return {ellipse, *loop, has_inside_wall(loops, ellipse)};
}

}  // namespace

std::vector<PlaneLoop> plane_loops(const HalfEdgeMesh& mesh, const EdgeBlocks& blocks, const Vector3& point,
                                   const Vector3& normal) {
  const Vector3 unit = normal.stableNormalized();
  const Heights heights(mesh, blocks, point, unit);
  std::vector<int> crossed;
  blocks.visit_near_plane(point, unit, [&](int e) {
    if (crossed_half(mesh, heights, e).is_valid()) crossed.push_back(e);
  });
  std::sort(crossed.begin(), crossed.end());
  std::vector<PlaneLoop> loops;
  std::vector<bool> visited(mesh.n_edges(), false);
  for (const int e : crossed) {
    if (visited[static_cast<std::size_t>(e)]) continue;
    loops.push_back(loop_from(mesh, heights, crossed_half(mesh, heights, e)));
    for (const HalfedgeHandle h : loops.back().crossed)
      visited[static_cast<std::size_t>(mesh.edge_handle(h).idx())] = true;
  }
  return loops;
}

int winding_number(const Points& loop, const Vector3& center, const Vector3& normal) {
  const PlaneFrame frame(center, normal);
  const std::vector<Vector2> polygon = frame.to_plane(loop);
  const Vector2 query = Vector2::Zero();
  int winding = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vector2& a = polygon[i];
    const Vector2& b = polygon[(i + 1) % polygon.size()];
    if (a.y() <= 0 && b.y() > 0 && orient2d(a, b, query) > 0) ++winding;
    if (a.y() > 0 && b.y() <= 0 && orient2d(a, b, query) < 0) --winding;
  }
  return winding;
}

SlideOnModel place_slide(const HalfEdgeMesh& mesh, const EdgeBlocks& blocks, const Slide& slide, std::size_t index) {
  try {
    if (const auto* click = std::get_if<PointDefinition>(&slide.definition)) {
      check_definition(slide);
      return place_by_point(mesh, blocks, plane_across_limb(mesh, *click, slide.name), slide.name, index);
    }
    if (const auto* plane = std::get_if<PointNormalDefinition>(&slide.definition)) {
      check_definition(slide);
      return place_by_point(mesh, blocks, *plane, slide.name, index);
    }
    if (const auto* stroke = std::get_if<StrokeDefinition>(&slide.definition))
      return place_ellipse(mesh, blocks, fit_stroke(stroke->points, slide.name), slide.name, index);
    return place_ellipse(mesh, blocks, from_radii(std::get<EllipseDefinition>(slide.definition), slide.name),
                         slide.name, index);
  } catch (const Error& error) {
    throw of_slide(error, slide, index);
  }
}

Slide with_plane(const HalfEdgeMesh& mesh, const Slide& slide, std::size_t index) {
  const auto* click = std::get_if<PointDefinition>(&slide.definition);
  if (!click) return slide;
  try {
    check_definition(slide);
    return {slide.name, plane_across_limb(mesh, *click, slide.name)};
  } catch (const Error& error) {
    throw of_slide(error, slide, index);
  }
}

}  // namespace cagewright
