// SPDX-License-Identifier: BSD-3-Clause
#include "core/meshing/meshing.h"

#include <algorithm>
#include <map>

#include "core/error/error.h"
#include "core/meshing/bound.h"
#include "core/meshing/cap.h"
#include "core/meshing/flip.h"
#include "core/meshing/limb_caps.h"
#include "core/meshing/projection_center.h"
#include "core/meshing/spherical_triangulation.h"

namespace cagewright {
namespace {

// Corners counter-clockwise as seen from the side that `outward` points to, starting at corner 0.
Bound make_bound(const std::array<Vector3, 4>& corners, int first_vertex, bool along_normal, const Vector3& outward,
                 int slide) {
  Bound bound;
  for (int i = 0; i < 4; ++i) {
    const int corner = corner_as_seen(along_normal, i);
    bound.vertices[static_cast<std::size_t>(i)] = first_vertex + corner;
    bound.corners[static_cast<std::size_t>(i)] = corners[static_cast<std::size_t>(corner)];
  }
  bound.outward = outward;
  bound.slide = slide;
  return bound;
}

class CageBuilder {
 public:
  CageBuilder(const Segmentation& segmentation, const std::vector<SectionFrame>& sections,
              const std::vector<std::string>& names)
      : segmentation_(segmentation), sections_(sections), names_(names) {
    for (std::size_t k = 0; k < sections.size(); ++k)
      for (const Vector3& corner : sections[k].corners()) add_point(corner, static_cast<int>(k));
  }

  void add_part(std::size_t index) {
    const Part& part = segmentation_.parts[index];
    cage_.part_center.emplace_back(Vector3::Zero());
    if (part.enclosed) return;
    if (part.sections.empty())
      add_box(index);
    else
      add_meshed(index);
  }

  Cage finish() {
    check_closed();
    cage_.points.resize(static_cast<Eigen::Index>(points_.size()), 3);
    for (std::size_t i = 0; i < points_.size(); ++i)
      cage_.points.row(static_cast<Eigen::Index>(i)) = points_[i].transpose();
    cage_.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (int i = 0; i < 3; ++i)
        cage_.triangles(static_cast<Eigen::Index>(t), i) = triangles_[t][static_cast<std::size_t>(i)];
    return std::move(cage_);
  }

 private:
  int add_point(const Vector3& point, int section) {
    points_.push_back(point);
    cage_.vertex_section.push_back(section);
    return static_cast<int>(points_.size()) - 1;
  }

  void add_triangle(int a, int b, int c, std::size_t part) {
    triangles_.push_back({a, b, c});
    cage_.triangle_part.push_back(static_cast<int>(part));
  }

  void add_box(std::size_t index) {
    const std::array<Vector3, 8> corners = box_of(segmentation_.cut.points, segmentation_.parts[index]);
    const int first = static_cast<int>(points_.size());
    for (const Vector3& corner : corners) add_point(corner, -1);
    for (const auto& [a, b, c] : box_triangles) add_triangle(first + a, first + b, first + c, index);
    cage_.part_center.back() = (corners.front() + corners.back()) / 2;
  }

  Bounds bounds_of(const Part& part) {
    Bounds bounds;
    for (const PartSection& side : part.sections) {
      const SectionFrame& section = sections_[static_cast<std::size_t>(side.slide)];
      bounds.list.push_back(make_bound(section.corners(), 4 * side.slide, side.outward,
                                       side.outward ? section.normal : Vector3(-section.normal), side.slide));
    }
    if (part.sections.size() == 1) {
      const PartSection& side = part.sections.front();
      const SectionFrame& section = sections_[static_cast<std::size_t>(side.slide)];
      const Vector3 into = side.outward ? Vector3(-section.normal) : section.normal;
      const std::array<Vector3, 4> cap = cap_of(segmentation_.cut.points, part, section, into);
      const int first = static_cast<int>(points_.size());
      for (const Vector3& corner : cap) add_point(corner, -1);
      bounds.list.push_back(make_bound(cap, first, !side.outward, into, -1));
    }
    return bounds;
  }

  // What bounds the part, with as many of its limbs' caps as a centre sees beside its sections; and that centre.
  std::pair<Bounds, Vector3> seen_bounds(std::size_t index) {
    const Part& part = segmentation_.parts[index];
    const Bounds bounds = bounds_of(part);
    std::vector<SectionFrame> sections;
    for (const PartSection& side : part.sections) sections.push_back(sections_[static_cast<std::size_t>(side.slide)]);
    for (auto caps = limb_caps(segmentation_.cut.points, part, bounds.corners(), sections); !caps.empty();
         caps.pop_back()) {
      Bounds capped = bounds;
      for (const CapCorners& cap : caps) capped.free_corners.insert(capped.free_corners.end(), cap.begin(), cap.end());
      if (const auto center = find_projection_center(capped)) return {capped, *center};
    }
    return {bounds, projection_center(bounds, index, names_)};
  }

  // Triangulates the part on a sphere and takes over what is not inside a section.
  void add_meshed(std::size_t index) {
    const auto [bounds, center] = seen_bounds(index);
    cage_.part_center.back() = center;

    const std::vector<Vector3> corners = bounds.corners();
    std::vector<int> vertices;  // of the cage, by corner
    std::vector<Edge> section_edges;
    SectionNormals normals;
    for (std::size_t i = 0; i < bounds.list.size(); ++i) {
      const int first = static_cast<int>(4 * i);
      const Bound& bound = bounds.list[i];
      vertices.insert(vertices.end(), bound.vertices.begin(), bound.vertices.end());
      normals.outward.push_back(bound.outward);
      for (int c = 0; c < 4; ++c) {
        section_edges.emplace_back(std::minmax(first + c, first + (c + 1) % 4));
        normals.section_of[first + c] = static_cast<int>(i);
      }
    }
    for (const Vector3& corner : bounds.free_corners) {
      normals.section_of[static_cast<int>(vertices.size())] = -1 - static_cast<int>(vertices.size());
      vertices.push_back(add_point(corner, -1));
    }
    SphericalTriangulation triangulation(corners, center);
    const std::set<Edge> fixed(section_edges.begin(), section_edges.end());
    recover_edges(triangulation, section_edges);
    make_delaunay(triangulation, fixed);
    smooth_by_flips(triangulation, fixed, normals);

    std::vector<std::array<int, 3>> walls = triangulation.triangles();
    for (auto& t : walls) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::sort(walls.begin(), walls.end());
    for (const auto& [a, b, c] : walls) {
      const int section = normals.section_of.at(a);
      const bool is_inside = section == normals.section_of.at(b) && section == normals.section_of.at(c);
      if (is_inside && bounds.list[static_cast<std::size_t>(section)].slide >= 0) continue;
      const auto vertex = [&vertices = vertices](int i) { return vertices[static_cast<std::size_t>(i)]; };
      add_triangle(vertex(a), vertex(b), vertex(c), index);
    }
  }

  // Every directed edge once, and its opposite once. Two parts between the same slides can break this.
  void check_closed() const {
    std::map<Edge, std::size_t> owner;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i) {
        const Edge edge{triangles_[t][i], triangles_[t][(i + 1) % 3]};
        const auto [first, added] = owner.emplace(edge, t);
        if (!added) fail_shared(edge, first->second, t);
      }
    for (const auto& [edge, t] : owner)
      if (!owner.count({edge.second, edge.first})) throw Error(ErrorCode::internal, "meshing: the cage is open");
  }

  [[noreturn]] void fail_shared(const Edge& edge, std::size_t first, std::size_t second) const {
    const int a = cage_.vertex_section[static_cast<std::size_t>(edge.first)];
    const int b = cage_.vertex_section[static_cast<std::size_t>(edge.second)];
    if (a < 0 || b < 0) throw Error(ErrorCode::internal, "meshing: two parts share a cap");
    ErrorPlace place;
    place.slide = static_cast<std::size_t>(std::min(a, b));
    place.other_slide = static_cast<std::size_t>(std::max(a, b));
    place.part = static_cast<std::size_t>(cage_.triangle_part[second]);
    place.point = (points_[static_cast<std::size_t>(edge.first)] + points_[static_cast<std::size_t>(edge.second)]) / 2;
    const auto part = [&](std::size_t t) { return std::to_string(cage_.triangle_part[t]); };
    throw Error(ErrorCode::parts_share_wall,
                "parts " + part(first) + " and " + part(second) + " both lie between slide '" + names_[*place.slide] +
                    "' and slide '" + names_[*place.other_slide] +
                    "' and would share a wall of the cage: add a slide across one of them",
                place);
  }

  const Segmentation& segmentation_;
  const std::vector<SectionFrame>& sections_;
  const std::vector<std::string>& names_;
  Cage cage_;
  std::vector<Vector3> points_;
  std::vector<std::array<int, 3>> triangles_;
};

}  // namespace

Cage mesh_cage(const Segmentation& segmentation, const std::vector<SectionFrame>& sections,
               const std::vector<std::string>& names) {
  CageBuilder builder(segmentation, sections, names);
  for (std::size_t part = 0; part < segmentation.parts.size(); ++part) builder.add_part(part);
  return builder.finish();
}

}  // namespace cagewright
