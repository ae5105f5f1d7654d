// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/inspect.h"

#include <limits>

#include "core/mesh/bow_tie.h"
#include "core/mesh/connectivity.h"
#include "core/mesh/orientation.h"
#include "core/mesh/volume.h"
#include "core/mesh/weld.h"

namespace cagewright {
namespace {

// Counts edges of one kind and remembers the one that the earliest triangle has.
class EdgeCount {
 public:
  void add(int half_edge) {
    ++count_;
    if (half_edge < first_) first_ = half_edge;
  }
  void write(const IndexedMesh& mesh, std::size_t& count, std::optional<Vector3>& first) const {
    count = count_;
    if (count_ > 0) first = edge_midpoint(mesh, first_);
  }

 private:
  std::size_t count_ = 0;
  int first_ = std::numeric_limits<int>::max();
};

void count_edges(const IndexedMesh& mesh, const EdgeTable& edges, MeshReport& report) {
  EdgeCount open, non_manifold, inconsistent;
  for (int e = 0; e < edges.count(); ++e) {
    const auto group = edges.of(e);
    const int h = group.front();
    if (group.size() == 1) {
      open.add(h);
    } else if (group.size() > 2) {
      non_manifold.add(h);
    } else if (from_vertex(mesh.triangles, h) == from_vertex(mesh.triangles, group[1])) {
      inconsistent.add(h);
    }
  }
  open.write(mesh, report.open_edges, report.first_open_edge);
  non_manifold.write(mesh, report.non_manifold_edges, report.first_non_manifold_edge);
  inconsistent.write(mesh, report.inconsistent_edges, report.first_inconsistent_edge);
}

bool is_orientable(const IndexedMesh& mesh, const Connectivity& connectivity) {
  return !find_consistent_turns(mesh.triangles, connectivity).conflicting_edge;
}

}  // namespace

Vector3 edge_midpoint(const IndexedMesh& mesh, int half_edge) {
  return 0.5 * mesh.points.row(from_vertex(mesh.triangles, half_edge)).transpose() +
         0.5 * mesh.points.row(to_vertex(mesh.triangles, half_edge)).transpose();
}

MeshReport inspect(const WeldedMesh& welded, const Connectivity& connectivity) {
  const IndexedMesh& mesh = welded.mesh;
  MeshReport report;
  report.vertices = static_cast<std::size_t>(mesh.points.rows());
  report.triangles = static_cast<std::size_t>(mesh.triangles.rows());
  report.welded_vertices = welded.welded_vertices;
  report.degenerate_triangles = welded.degenerate_triangles;
  report.unused_vertices = welded.unused_vertices;
  report.components = static_cast<std::size_t>(connectivity.components.count);
  report.box_min = mesh.points.colwise().minCoeff().transpose();
  report.box_max = mesh.points.colwise().maxCoeff().transpose();
  count_edges(mesh, connectivity.edges, report);

  const std::vector<int> bow_ties = find_bow_ties(mesh, connectivity.fans);
  report.bow_tie_vertices = bow_ties.size();
  if (!bow_ties.empty()) report.first_bow_tie = mesh.points.row(bow_ties.front()).transpose();

  const Volumes volumes = find_volumes(mesh, connectivity.components);
  report.signed_volume = volumes.in_model_units();
  if (!report.closed()) return report;
  report.inside_out = report.consistently_oriented() && volumes.total < 0;
  if (report.consistently_oriented() || is_orientable(mesh, connectivity)) {
    // Euler's formula, every fan counted as a vertex of its own.
    const long characteristic = static_cast<long>(connectivity.fans.count) - connectivity.edges.count() +
                                static_cast<long>(mesh.triangles.rows());
    report.genus = connectivity.components.count - characteristic / 2;
  }
  return report;
}

MeshReport inspect(const IndexedMesh& mesh) {
  const WeldedMesh welded = weld(mesh);
  return inspect(welded, connect(welded));
}

}  // namespace cagewright
