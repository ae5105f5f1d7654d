// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/grow_through.h"

#include "core/enclose/offset_walls.h"

namespace cagewright {
namespace {

constexpr int most_at_first = 48, patience_at_first = 12;
constexpr int stages = 4, most_at_stage = 12, patience_at_stage = 4;

// Walls that cannot keep away from their model would be pushed on and on.
void shorten(MovableCage& movable, const Points& from, double longest) {
  Points points = movable.points();
  for (Eigen::Index v = 0; v < points.rows(); ++v) {
    const Vector3 step = points.row(v) - from.row(v);
    if (const double length = step.norm(); length > longest)
      points.row(v) = from.row(v) + longest / length * step.transpose();
  }
  movable.place_all(points);
}

}  // namespace

int grow_through(MovableCage& movable, const SectionShape& shape, const VertexNeighbours& neighbours,
                 const std::vector<int>& vertex_owners, const PushOptions& options, const Progress& progress) {
  const auto part_of = [&](int round) -> Progress {
    if (!progress) return {};
    return [&progress, round](double fraction) { return progress((round + fraction) / (stages + 1)); };
  };
  PushOptions push = options;
  push.own_only = true;
  push.guarded = MovableCage::Whose::nobody;
  push.clearance = options.gap;
  push.most = most_at_first;
  push.patience = patience_at_first;
  int steps = push_out(movable, shape, neighbours, vertex_owners, push, part_of(0));
  if (options.clearance <= options.gap) return steps;
  push.most = most_at_stage;
  push.patience = patience_at_stage;
  const double stride = (options.clearance - options.gap) / stages;
  for (int stage = 1; stage <= stages; ++stage) {
    Points points = movable.points() + offset_walls(movable, shape.plane_normals(), stride);
    shape.put_in_shape(points);
    movable.place_all(points);
    const Points offset = points;
    push.clearance = options.gap + stage * stride;
    steps += push_out(movable, shape, neighbours, vertex_owners, push, part_of(stage));
    shorten(movable, offset, stride);
  }
  return steps;
}

}  // namespace cagewright
