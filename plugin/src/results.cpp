// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/src/results.h"

#include <algorithm>
#include <limits>
#include <string>

#include "plugin/src/abi_struct.h"
#include "plugin/src/buffers.h"

namespace cagewright::plugin {

namespace {

const Results& results_of(const cgw_session& session, const char* what) {
  if (!session.results) not_ready(what);
  return *session.results;
}

std::uint64_t rows(const auto& matrix) { return static_cast<std::uint64_t>(matrix.rows()); }

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

void copy_centers(const PipelineResult& made, double* to) {
  if (!to) return;
  const std::vector<Part>& parts = made.segmentation.parts;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const bool has_center = made.cage && !parts[k].enclosed;
    copy_vector(has_center ? made.cage->part_center[k] : Vector3(Vector3::Constant(unknown)), to + 3 * k);
  }
}

}  // namespace

void read_parts(const cgw_session& session, cgw_parts* out) {
  cgw_parts parts = read_struct<cgw_parts>(out, CGW_PARTS_INIT, "cgw_parts");
  const PipelineResult& made = results_of(session, "segmentation").made;
  const Segmentation& segmentation = made.segmentation;
  parts.part_count = segmentation.parts.size();
  parts.vertex_count = rows(segmentation.cut.points);
  parts.triangle_count = rows(segmentation.cut.triangles);
  write_struct(out, parts, "cgw_parts");
  check_room(parts.vertices, parts.vertex_capacity, parts.vertex_count, "vertices");
  check_room(parts.triangles, parts.triangle_capacity, parts.triangle_count, "triangles");
  check_room(parts.triangle_part, parts.triangle_capacity, parts.triangle_count, "triangles' parts");
  check_room(parts.section_count, parts.part_capacity, parts.part_count, "parts' section counts");
  check_room(parts.part_flags, parts.part_capacity, parts.part_count, "parts' flags");
  check_room(parts.part_center, parts.part_capacity, parts.part_count, "parts' centres");
  copy_rows(segmentation.cut.points, parts.vertices);
  copy_rows(segmentation.cut.triangles, parts.triangles);
  copy_list(segmentation.triangle_part, parts.triangle_part);
  for (std::size_t k = 0; k < segmentation.parts.size(); ++k) {
    const Part& part = segmentation.parts[k];
    if (parts.section_count) parts.section_count[k] = static_cast<std::uint32_t>(part.sections.size());
    if (parts.part_flags) parts.part_flags[k] = part.enclosed ? CGW_PART_ENCLOSED : 0;
  }
  copy_centers(made, parts.part_center);
}

std::uint64_t section_count(const cgw_session& session) noexcept {
  return session.results ? session.results->slide_ids.size() : 0;
}

void read_section(const cgw_session& session, std::uint64_t index, cgw_section* out) {
  common_size(out, "cgw_section");
  const Results& results = results_of(session, "section");
  check_index(index, section_count(session), "section");
  cgw_section section = CGW_SECTION_INIT;
  section.slide = results.slide_ids[index];
  section.part_behind = results.made.segmentation.slide_parts[index][0];
  section.part_ahead = results.made.segmentation.slide_parts[index][1];
  const Ellipse& ellipse = results.made.segmentation.ellipses[index];
  copy_vector(ellipse.center, section.center);
  copy_vector(ellipse.normal, section.normal);
  copy_vector(ellipse.u, section.u);
  copy_vector(ellipse.v, section.v);
  if (results.made.last_stage >= Stage::orient) {
    const SectionFrame& frame = results.made.sections[index];
    copy_vector(frame.p, section.p);
    copy_vector(frame.q, section.q);
    std::copy_n(frame.x.data(), 2, section.x);
    std::copy_n(frame.linear.data(), 2, section.linear_x);
    const auto corners = frame.corners();
    for (std::size_t i = 0; i < 4; ++i) copy_vector(corners[i], section.corners + 3 * i);
  }
  if (results.made.cage) {
    const std::array<int, 4> rows = results.made.cage->corners_of(static_cast<int>(index));
    for (std::size_t i = 0; i < 4; ++i) {
      section.cage_vertex[i] = rows[i];
      if (rows[i] >= 0) copy_vector(results.made.cage->points.row(rows[i]), section.corners + 3 * i);
    }
  }
  write_struct(out, section, "cgw_section");
}

void read_loop(const cgw_session& session, std::uint64_t index, cgw_loop* out) {
  cgw_loop loop = read_struct<cgw_loop>(out, CGW_LOOP_INIT, "cgw_loop");
  const Results& results = results_of(session, "loop");
  check_index(index, section_count(session), "loop");
  const Points& points = results.made.segmentation.loops[index];
  loop.point_count = rows(points);
  write_struct(out, loop, "cgw_loop");
  check_room(loop.points, loop.point_capacity, loop.point_count, "points");
  copy_rows(points, loop.points);
}

void read_cage(const cgw_session& session, cgw_cage* out) {
  cgw_cage cage = read_struct<cgw_cage>(out, CGW_CAGE_INIT, "cgw_cage");
  const Results& results = results_of(session, "cage");
  if (!results.made.cage) not_ready("cage");
  const Cage& made = *results.made.cage;
  cage.vertex_count = rows(made.points);
  cage.triangle_count = rows(made.triangles);
  write_struct(out, cage, "cgw_cage");
  check_room(cage.vertices, cage.vertex_capacity, cage.vertex_count, "vertices");
  check_room(cage.vertex_section, cage.vertex_capacity, cage.vertex_count, "vertices' sections");
  check_room(cage.triangles, cage.triangle_capacity, cage.triangle_count, "triangles");
  check_room(cage.triangle_part, cage.triangle_capacity, cage.triangle_count, "triangles' parts");
  copy_rows(made.points, cage.vertices);
  copy_list(made.vertex_section, cage.vertex_section);
  copy_rows(made.triangles, cage.triangles);
  copy_list(made.triangle_part, cage.triangle_part);
}

std::uint64_t iteration_count(const cgw_session& session) noexcept {
  if (!session.results || !session.results->made.refinement) return 0;
  return session.results->made.refinement->records.size();
}

namespace {

void check_rooms(const cgw_iteration& iteration) {
  check_room(iteration.vertices_before, iteration.vertex_capacity, iteration.vertex_count, "vertices before");
  check_room(iteration.vertices_after, iteration.vertex_capacity, iteration.vertex_count, "vertices after");
  check_room(iteration.damping, iteration.vertex_capacity, iteration.vertex_count, "damping");
  check_room(iteration.plane_normal, iteration.vertex_capacity, iteration.vertex_count, "plane normals");
  check_room(iteration.normals, iteration.triangle_capacity, iteration.triangle_count, "normals");
  check_room(iteration.anchors, iteration.triangle_capacity, iteration.triangle_count, "anchors");
  check_room(iteration.weights, iteration.triangle_capacity, iteration.triangle_count, "weights");
  check_room(iteration.signed_distance, iteration.triangle_capacity, iteration.triangle_count, "signed distances");
  check_room(iteration.outermost, iteration.triangle_capacity, iteration.triangle_count, "outermost vertices");
}

}  // namespace

void read_iteration(const cgw_session& session, std::uint64_t index, cgw_iteration* out) {
  cgw_iteration iteration = read_struct<cgw_iteration>(out, CGW_ITERATION_INIT, "cgw_iteration");
  const Results& results = results_of(session, "refinement");
  if (!results.made.refinement) not_ready("refinement");
  check_index(index, iteration_count(session), "refinement iteration");
  const RefineRecord& record = results.made.refinement->records[index];
  iteration.max_signed_distance = record.max_signed_distance;
  iteration.vertex_count = rows(record.before);
  iteration.triangle_count = rows(record.normals);
  write_struct(out, iteration, "cgw_iteration");
  check_rooms(iteration);
  copy_rows(record.before, iteration.vertices_before);
  copy_rows(record.after, iteration.vertices_after);
  copy_list(record.damping, iteration.damping);
  copy_rows(record.plane_normal, iteration.plane_normal);
  copy_rows(record.normals, iteration.normals);
  copy_rows(record.anchors, iteration.anchors);
  copy_rows(record.weights, iteration.weights);
  copy_list(record.signed_distance, iteration.signed_distance);
  copy_list(record.outermost, iteration.outermost);
}

void read_summary(const cgw_session& session, cgw_summary* out) {
  common_size(out, "cgw_summary");
  const Results& results = results_of(session, "summary");
  const PipelineResult& made = results.made;
  const auto time = [&](Stage stage, double ms) { return stage <= made.last_stage ? ms : unknown; };
  cgw_summary summary = CGW_SUMMARY_INIT;
  summary.last_stage = static_cast<std::int32_t>(made.last_stage);
  summary.iterations = iteration_count(session);
  summary.converged = made.refinement && made.refinement->converged;
  summary.threads = results.threads;
  summary.max_signed_distance_over_diagonal =
      made.refinement ? made.refinement->max_signed_distance / results.diagonal : unknown;
  summary.extent = made.refinement ? made.refinement->extent : unknown;
  summary.volume_ratio = made.volume_ratio.value_or(unknown);
  summary.cage_genus = made.cage_genus.value_or(-1);
  summary.segment_ms = time(Stage::segment, made.segment_ms);
  summary.orient_ms = time(Stage::orient, made.orient_ms);
  summary.meshing_ms = time(Stage::meshing, made.meshing_ms);
  summary.refine_ms = time(Stage::refine, made.refine_ms);
  summary.enclose_ms = time(Stage::enclose, made.enclose_ms);
  summary.certified = made.enclosure && made.enclosure->certificate.encloses();
  summary.merged = made.enclosure && made.enclosure->merged;
  write_struct(out, summary, "cgw_summary");
}

}  // namespace cagewright::plugin
