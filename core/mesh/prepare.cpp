// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/prepare.h"

#include <cmath>
#include <string>

#include "core/error/error.h"
#include "core/mesh/bow_tie.h"
#include "core/mesh/connectivity.h"
#include "core/mesh/fingerprint.h"
#include "core/mesh/orientation.h"
#include "core/mesh/volume.h"
#include "core/mesh/weld.h"

namespace cagewright {
namespace {

std::string count_of(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

ErrorPlace at_point(const std::optional<Vector3>& point) {
  ErrorPlace place;
  place.point = point;
  return place;
}

void require_closed_manifold(const MeshReport& report) {
  if (report.closed()) return;
  std::string shared;
  if (report.non_manifold_edges > 0) {
    shared = count_of(report.non_manifold_edges, "edge", "edges") + " with more than two triangles, the first at " +
             to_text(*report.first_non_manifold_edge);
  }
  if (report.open_edges > 0) {
    std::string sentence = "the model is open: " + count_of(report.open_edges, "open edge", "open edges") +
                           ", the first at " + to_text(*report.first_open_edge);
    sentence += shared.empty()
                    ? ": close the holes"
                    : "; and it has " + shared + ": close the holes and separate the surfaces that meet there";
    throw Error(ErrorCode::mesh_open, sentence, at_point(report.first_open_edge));
  }
  throw Error(ErrorCode::mesh_non_manifold,
              "the model is not manifold: " + shared + ": separate the surfaces that meet there",
              at_point(report.first_non_manifold_edge));
}

void require_volume(const Volumes& volumes, const MeshReport& report) {
  if (!(volumes.total > volumes.rounding)) {
    throw Error(ErrorCode::mesh_empty, "the model encloses no volume: give its surface a thickness");
  }
  if (!std::isnormal(volumes.in_model_units()) || !std::isnormal(report.diagonal())) {
    throw Error(ErrorCode::mesh_not_finite, "the model reaches from " + to_text(report.box_min) + " to " +
                                                to_text(report.box_max) +
                                                ", so that its volume is no floating-point number: scale it");
  }
}

// Turns triangles until the components are consistent and their outermost ones face outward. Returns how many it
// turned.
std::size_t orient_outward(IndexedMesh& mesh, const Connectivity& connectivity) {
  const Labels& components = connectivity.components;
  Turns turns = find_consistent_turns(mesh.triangles, connectivity);
  if (turns.conflicting_edge) {
    const Vector3 place = edge_midpoint(mesh, connectivity.edges.of(*turns.conflicting_edge).front());
    throw Error(ErrorCode::mesh_not_orientable,
                "the model has no inside: no orientation of its triangles agrees across the edge at " + to_text(place) +
                    ": cut the one-sided surface there or remesh it as the surface of a solid",
                at_point(place));
  }
  const Eigen::Index count = mesh.triangles.rows();
  for (Eigen::Index t = 0; t < count; ++t) {
    if (turns.turned[static_cast<std::size_t>(t)]) turn(mesh.triangles, t);
  }
  const std::vector<bool> inside_out = find_inside_out(mesh, components, find_volumes(mesh, components));
  std::size_t turned = 0;
  for (Eigen::Index t = 0; t < count; ++t) {
    const std::size_t row = static_cast<std::size_t>(t);
    if (inside_out[components.of[row]]) turn(mesh.triangles, t);
    turned += turns.turned[row] != inside_out[components.of[row]];
  }
  return turned;
}

}  // namespace

Model prepare_model(const IndexedMesh& mesh) {
  WeldedMesh welded = weld(mesh);
  const Connectivity connectivity = connect(welded);
  Model model;
  model.report = inspect(welded, connectivity);
  require_closed_manifold(model.report);

  split_bow_ties(welded.mesh, connectivity.fans);  // before triangles are turned: fans are told by corner
  model.given_vertices = find_given_vertices(welded);
  model.given_triangles = std::move(welded.given_rows);
  model.report.turned_triangles = orient_outward(welded.mesh, connectivity);
  const Volumes volumes = find_volumes(welded.mesh, connectivity.components);
  require_volume(volumes, model.report);

  model.mesh = to_half_edge_mesh(welded.mesh);
  model.edge_blocks = EdgeBlocks(model.mesh);
  model.diagonal = model.report.diagonal();
  model.volume = volumes.in_model_units();
  model.fingerprint = fingerprint(mesh);
  return model;
}

}  // namespace cagewright
