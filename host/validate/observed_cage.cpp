// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/observed_cage.h"

#include <algorithm>
#include <stdexcept>

#include "host/file/file_error.h"

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
  seen.is_over_angles = session.parameter("orient.minimum") == 1;
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

[[noreturn]] void refuse(const std::string& what) {
  throw std::runtime_error("the plug-in hands out " + what + ": its figures cannot be checked");
}

template <class Index>
void require_rows(const std::vector<Index>& indices, long least, std::size_t count, const std::string& what) {
  for (const auto index : indices) {
    if (index < least || index >= static_cast<std::int64_t>(count)) refuse(what + " " + std::to_string(index));
  }
}

std::vector<ObservedPart> to_parts(const CutModel& cut) {
  std::vector<ObservedPart> parts(cut.is_enclosed.size());
  require_rows(cut.triangle_part, 0, parts.size(), "triangles of the cut model in part");
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

void require_triangles(const std::vector<Corners>& triangles, std::size_t vertices, const std::string& what) {
  for (const Corners& t : triangles) require_rows(std::vector<int>(t.begin(), t.end()), 0, vertices, what);
}

// What the checks index by must be there, whatever the plug-in does.
void require_consistent(const ObservedCage& seen) {
  require_triangles(seen.model_triangles, seen.model.size(), "triangles of the cut model with a vertex");
  require_triangles(seen.triangles, seen.vertices.size(), "triangles of the cage with a vertex");
  require_rows(seen.triangle_part, 0, seen.parts.size(), "triangles of the cage that bound part");
  require_rows(seen.vertex_section, -1, seen.sections.size(), "vertices of the cage that are corners of section");
  if (seen.vertices.size() < 4 * seen.sections.size()) refuse("fewer vertices of the cage than corners of sections");
  for (std::size_t k = 0; k < seen.iterations.size(); ++k) {
    const ObservedIteration& iteration = seen.iterations[k];
    const std::string where = "iteration " + std::to_string(k) + " with ";
    for (const std::size_t rows : {iteration.before.size(), iteration.after.size(), iteration.damping.size()}) {
      if (rows != seen.vertices.size()) refuse(where + counted(rows, "vertex") + " of another cage");
    }
    for (const std::size_t rows : {iteration.normals.size(), iteration.weights.size(), iteration.outermost.size()}) {
      if (rows != seen.triangles.size()) refuse(where + counted(rows, "triangle") + " of another cage");
    }
    require_rows(iteration.outermost, -1, seen.model.size(), where + "the outermost vertex");
  }
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
  require_consistent(seen);
  return seen;
}

}  // namespace cagewright::host
