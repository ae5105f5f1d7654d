// SPDX-License-Identifier: BSD-3-Clause
#include <CGAL/Polygon_mesh_processing/bbox.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>

#include "host/bench/baselines/cage_search.h"
#include "host/bench/baselines/simplify.h"
#include "host/bench/baselines/stopwatch.h"
#include "host/bench/baselines/voxel_grid.h"

namespace cagewright::bench {
namespace {

// The cells that hold some of the model, manifold, with `cells` of them along the longest side.
VoxelGrid voxelise(const Judge& judge, double cells, int grown) {
  constexpr int margin = 4;  // two to grow, and room for what make_manifold() adds
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(judge.model());
  const double sides[] = {box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin()};
  const double length = *std::max_element(sides, sides + 3) / cells;
  VoxelGrid::Cell size;
  double low[3];
  for (int axis = 0; axis < 3; ++axis) {
    // The cells lie symmetrically over the box.
    const int inner = static_cast<int>(std::ceil(sides[axis] / length));
    size[static_cast<std::size_t>(axis)] = inner + 2 * margin;
    low[axis] = box.min(axis) + (sides[axis] - (inner + 2 * margin) * length) / 2;
  }
  VoxelGrid grid({low[0], low[1], low[2]}, length, size);
  VoxelGrid::Cell cell;
  for (cell[2] = 1; cell[2] + 1 < size[2]; ++cell[2])
    for (cell[1] = 1; cell[1] + 1 < size[1]; ++cell[1])
      for (cell[0] = 1; cell[0] + 1 < size[0]; ++cell[0])
        if (judge.meets_surface(grid.box(cell))) grid.fill(cell);
  grid.fill_inside();
  for (int layer = 0; layer < grown; ++layer) grid.grow();
  grid.make_manifold();
  return grid;
}

std::string text(double cells, int grown) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, "%.2f cells, grown by %d", cells, grown);
  return buffer;
}

void offer_as_it_is(BestCage& best, const Judge& judge) {
  for (double cells = 2; cells < 16; cells += 0.25) {
    const Stopwatch making;
    Surface cage = voxelise(judge, cells, 0).boundary();
    best.offer(std::move(cage), text(cells, 0), making.seconds());
  }
}

}  // namespace

void search_voxel_grids(BestCage& best, const Judge& judge, std::size_t most_triangles) {
  offer_as_it_is(best, judge);
  for (const double cells : {8.0, 10.0, 12.0, 14.0, 17.0, 20.0, 24.0, 29.0, 35.0, 42.0, 50.0, 60.0})
    for (int grown = 0; grown <= 2; ++grown) {
      const Stopwatch making;
      const Surface fine = voxelise(judge, cells, grown).boundary();
      const double made = making.seconds();
      for (const Collapse collapse : {Collapse::lindstrom_turk, Collapse::quadrics}) {
        const Stopwatch simplifying;
        Surface cage = simplified(fine, most_triangles, collapse);
        const double seconds = made + simplifying.seconds();
        best.offer(std::move(cage), text(cells, grown) + ", " + name_of(collapse), seconds);
      }
    }
}

}  // namespace cagewright::bench
