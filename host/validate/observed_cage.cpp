// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/observed_cage.h"

#include <algorithm>
#include <limits>

namespace cagewright::host {
namespace {

Eigen::Vector3d to_vector(const double (&from)[3]) { return Eigen::Vector3d::Map(from); }

std::vector<Corners> to_triangles(const std::vector<std::uint32_t>& rows) {
  std::vector<Corners> triangles(rows.size() / 3);
  for (std::size_t i = 0; i < rows.size(); ++i) triangles[i / 3][i % 3] = static_cast<int>(rows[i]);
  return triangles;
}

void read_parameters(const Session& session, ObservedCage& seen) {
  const cgw_summary summary = session.summary();
  seen.diagonal = session.mesh_report().diagonal;
  seen.extent = summary.extent;
  seen.lambda = session.parameter("orient.lambda");
  seen.is_enclosed = summary.last_stage >= CGW_STAGE_ENCLOSE;
  seen.certified = summary.certified == 1;
  seen.converged = summary.converged == 1;
  seen.max_signed_distance = summary.max_signed_distance_over_diagonal * seen.diagonal;
  seen.damping = session.parameter("refine.damping");
  seen.push = session.parameter("refine.push");
  seen.is_local = session.parameter("refine.scope") == 0;
  seen.corner_angle = session.parameter("enclose.corner_angle");
  // What enclosing asks of the refinement: docs/c-abi.md, "Results".
  seen.delta = seen.is_enclosed ? 0 : session.parameter("refine.delta") * seen.diagonal;
  seen.is_in_plane =
      session.parameter("refine.in_plane") != 0 || (seen.is_enclosed && session.parameter("enclose.in_plane") != 0);
}

std::vector<ObservedPart> to_parts(const CutModel& cut) {
  std::vector<ObservedPart> parts(cut.is_enclosed.size());
  for (std::size_t t = 0; t < cut.triangle_part.size(); ++t) {
    std::vector<int>& vertices = parts[static_cast<std::size_t>(cut.triangle_part[t])].vertices;
    for (std::size_t i = 0; i < 3; ++i) vertices.push_back(static_cast<int>(cut.mesh.triangles[3 * t + i]));
  }
  for (std::size_t p = 0; p < parts.size(); ++p) {
    std::vector<int>& vertices = parts[p].vertices;
    std::sort(vertices.begin(), vertices.end());
    vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
    parts[p].is_enclosed = cut.is_enclosed[p];
    parts[p].center = Eigen::Vector3d::Map(cut.centers[p].data());
  }
  return parts;
}

std::vector<ObservedSection> to_sections(const Session& session) {
  std::vector<ObservedSection> sections;
  const std::vector<SlideInfo> slides = session.slides();
  for (const cgw_section& from : session.sections()) {
    ObservedSection section;
    for (const SlideInfo& slide : slides) {
      if (slide.info.id == from.slide) section.slide = slide.name;
    }
    section.center = to_vector(from.center);
    section.normal = to_vector(from.normal);
    section.u = to_vector(from.u);
    section.v = to_vector(from.v);
    section.p = to_vector(from.p);
    section.q = to_vector(from.q);
    section.x = Eigen::Vector2d::Map(from.x);
    section.linear = Eigen::Vector2d::Map(from.linear_x);
    section.parts = {from.part_behind, from.part_ahead};
    sections.push_back(std::move(section));
  }
  return sections;
}

ObservedIteration to_iteration(const IterationRecord& record) {
  ObservedIteration iteration;
  iteration.max_signed_distance = record.max_signed_distance;
  iteration.before = to_points(record.before);
  iteration.after = to_points(record.after);
  iteration.plane_normals = to_points(record.plane_normals);
  iteration.damping = record.damping;
  iteration.normals = to_points(record.normals);
  iteration.anchors = to_points(record.anchors);
  for (std::size_t t = 0; 3 * t < record.weights.size(); ++t) {
    iteration.weights.push_back({record.weights[3 * t], record.weights[3 * t + 1], record.weights[3 * t + 2]});
  }
  iteration.signed_distances = record.signed_distances;
  iteration.outermost = record.outermost;
  return iteration;
}

}  // namespace

PointList to_points(const std::vector<double>& rows) {
  PointList points;
  for (std::size_t i = 0; i + 2 < rows.size(); i += 3) points.emplace_back(rows[i], rows[i + 1], rows[i + 2]);
  return points;
}

ObservedCage observe(const Session& session) {
  ObservedCage seen;
  read_parameters(session, seen);
  const CutModel cut = session.cut_model();
  seen.model = to_points(cut.mesh.points);
  seen.model_triangles = to_triangles(cut.mesh.triangles);
  seen.parts = to_parts(cut);
  seen.sections = to_sections(session);
  const TriangleMesh cage = session.cage();
  seen.vertices = to_points(cage.points);
  seen.triangles = to_triangles(cage.triangles);
  seen.triangle_part = session.triangle_parts();
  seen.vertex_section = session.vertex_sections();
  for (const IterationRecord& record : session.iterations()) seen.iterations.push_back(to_iteration(record));
  return seen;
}

}  // namespace cagewright::host
