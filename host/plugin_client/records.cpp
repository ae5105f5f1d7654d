// SPDX-License-Identifier: BSD-3-Clause
#include "host/plugin_client/records.h"

#include "host/plugin_client/session.h"

namespace cagewright::host {

CutModel Session::cut_model() const {
  cgw_parts parts = CGW_PARTS_INIT;
  check(api().get_parts(session_, &parts), "get_parts");
  CutModel cut;
  std::vector<std::int32_t> triangle_part(parts.triangle_count);
  std::vector<std::uint32_t> flags(parts.part_count);
  cut.mesh.points.resize(3 * parts.vertex_count);
  cut.mesh.triangles.resize(3 * parts.triangle_count);
  cut.centers.resize(parts.part_count);
  parts.vertices = cut.mesh.points.data();
  parts.vertex_capacity = parts.vertex_count;
  parts.triangles = cut.mesh.triangles.data();
  parts.triangle_part = triangle_part.data();
  parts.triangle_capacity = parts.triangle_count;
  parts.part_flags = flags.data();
  parts.part_center = cut.centers.empty() ? nullptr : cut.centers.front().data();
  parts.part_capacity = parts.part_count;
  check(api().get_parts(session_, &parts), "get_parts");
  cut.triangle_part.assign(triangle_part.begin(), triangle_part.end());
  for (const std::uint32_t flag : flags) cut.is_enclosed.push_back((flag & CGW_PART_ENCLOSED) != 0);
  return cut;
}

std::vector<int> Session::triangle_parts() const {
  cgw_cage cage = CGW_CAGE_INIT;
  check(api().get_cage(session_, &cage), "get_cage");
  std::vector<std::int32_t> parts(cage.triangle_count);
  cage.triangle_part = parts.data();
  cage.triangle_capacity = cage.triangle_count;
  check(api().get_cage(session_, &cage), "get_cage");
  return {parts.begin(), parts.end()};
}

std::vector<IterationRecord> Session::iterations() const {
  std::vector<IterationRecord> records(api().iteration_count(session_));
  for (std::size_t k = 0; k < records.size(); ++k) {
    IterationRecord& record = records[k];
    cgw_iteration iteration = CGW_ITERATION_INIT;
    check(api().get_iteration(session_, k, &iteration), "get_iteration");
    const std::size_t vertices = iteration.vertex_count, triangles = iteration.triangle_count;
    for (auto* list : {&record.before, &record.after, &record.plane_normals}) list->resize(3 * vertices);
    for (auto* list : {&record.normals, &record.anchors, &record.weights}) list->resize(3 * triangles);
    record.damping.resize(vertices);
    record.signed_distances.resize(triangles);
    record.outermost.resize(triangles);
    iteration.vertices_before = record.before.data();
    iteration.vertices_after = record.after.data();
    iteration.damping = record.damping.data();
    iteration.plane_normal = record.plane_normals.data();
    iteration.vertex_capacity = vertices;
    iteration.normals = record.normals.data();
    iteration.anchors = record.anchors.data();
    iteration.weights = record.weights.data();
    iteration.signed_distance = record.signed_distances.data();
    iteration.outermost = record.outermost.data();
    iteration.triangle_capacity = triangles;
    check(api().get_iteration(session_, k, &iteration), "get_iteration");
    record.max_signed_distance = iteration.max_signed_distance;
  }
  return records;
}

}  // namespace cagewright::host
