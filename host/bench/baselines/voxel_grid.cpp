// SPDX-License-Identifier: BSD-3-Clause
#include "host/bench/baselines/voxel_grid.h"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>
#include <utility>

namespace cagewright::bench {
namespace {

using Cell = VoxelGrid::Cell;
using Octants = std::uint8_t;  // bit x + 2 y + 4 z: the cell of the eight round a corner

// Whether the octants of the set hang together by faces.
bool is_connected(Octants set) {
  if (set == 0) return true;
  Octants reached = static_cast<Octants>(set & -set);
  for (;;) {
    const auto along = [&](int bit, Octants low) {
      return ((reached & low) << bit) | ((reached & static_cast<Octants>(~low)) >> bit);
    };
    const auto next = static_cast<Octants>((reached | along(1, 0x55) | along(2, 0x33) | along(4, 0x0F)) & set);
    if (next == reached) return reached == set;
    reached = next;
  }
}

// Whether the boundary of the full octants is a disc round the corner, or does not meet it.
bool is_manifold(Octants full) { return is_connected(full) && is_connected(static_cast<Octants>(~full)); }

Cell octant(const Cell& lattice, int bit) {
  return {lattice[0] - 1 + (bit & 1), lattice[1] - 1 + (bit >> 1 & 1), lattice[2] - 1 + (bit >> 2 & 1)};
}

}  // namespace

VoxelGrid::VoxelGrid(const Kernel::Point_3& origin, double cell_length, const Cell& size)
    : origin_(origin),
      cell_length_(cell_length),
      size_(size),
      full_(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(size[2])) {
}

std::size_t VoxelGrid::row(const Cell& cell) const {
  return (static_cast<std::size_t>(cell[2]) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(cell[1])) *
             static_cast<std::size_t>(size_[0]) +
         static_cast<std::size_t>(cell[0]);
}

Kernel::Point_3 VoxelGrid::corner(const Cell& lattice) const {
  return origin_ + cell_length_ * Kernel::Vector_3(lattice[0], lattice[1], lattice[2]);
}

Kernel::Iso_cuboid_3 VoxelGrid::box(const Cell& cell) const {
  return {corner(cell), corner({cell[0] + 1, cell[1] + 1, cell[2] + 1})};
}

void VoxelGrid::for_each_inner(const std::function<void(const Cell&)>& visit) const {
  for (int z = 1; z + 1 < size_[2]; ++z)
    for (int y = 1; y + 1 < size_[1]; ++y)
      for (int x = 1; x + 1 < size_[0]; ++x) visit({x, y, z});
}

void VoxelGrid::fill_inside() {
  std::vector<std::uint8_t> outside(full_.size());
  std::vector<Cell> open{{0, 0, 0}};
  outside[0] = 1;
  while (!open.empty()) {
    const Cell cell = open.back();
    open.pop_back();
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        Cell next = cell;
        next[axis] += step;
        if (next[axis] < 0 || next[axis] >= size_[axis] || full(next) || outside[row(next)] != 0) continue;
        outside[row(next)] = 1;
        open.push_back(next);
      }
  }
  std::transform(outside.begin(), outside.end(), full_.begin(), [](std::uint8_t out) { return out == 0; });
}

void VoxelGrid::grow() {
  const VoxelGrid before = *this;
  for_each_inner([&](const Cell& cell) {
    for (int z = -1; z <= 1 && !full(cell); ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x)
          if (before.full({cell[0] + x, cell[1] + y, cell[2] + z})) fill(cell);
  });
}

bool VoxelGrid::mend_corner(const Cell& lattice) {
  Octants set = 0;
  for (int bit = 0; bit < 8; ++bit)
    if (full(octant(lattice, bit))) set = static_cast<Octants>(set | 1 << bit);
  if (is_manifold(set)) return false;
  int chosen = -1;  // an empty one that mends it; else any, and the next pass looks again
  for (int bit = 0; bit < 8; ++bit) {
    if ((set >> bit & 1) != 0) continue;
    const bool mends = is_manifold(static_cast<Octants>(set | 1 << bit));
    if (chosen < 0 || mends) chosen = bit;
    if (mends) break;
  }
  fill(octant(lattice, chosen));
  return true;
}

void VoxelGrid::make_manifold() {
  for (bool changed = true; changed;) {
    changed = false;
    for (int z = 1; z < size_[2]; ++z)
      for (int y = 1; y < size_[1]; ++y)
        for (int x = 1; x < size_[0]; ++x) changed = mend_corner({x, y, z}) || changed;
  }
}

Surface VoxelGrid::boundary() const {
  Surface surface;
  std::unordered_map<std::size_t, Surface::Vertex_index> vertices;
  const auto vertex = [&](const Cell& lattice) {
    const auto [place, is_new] = vertices.try_emplace(row(lattice));
    if (is_new) place->second = surface.add_vertex(corner(lattice));
    return place->second;
  };
  const auto add = [&](auto a, auto b, auto c) {
    if (surface.add_face(a, b, c) == Surface::null_face()) throw std::logic_error("the full cells are not manifold");
  };
  for_each_inner([&](const Cell& cell) {
    if (!full(cell)) return;
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (const int side : {0, 1}) {
        Cell beyond = cell;
        beyond[axis] += side == 0 ? -1 : 1;
        if (full(beyond)) continue;
        // The face's corners, counter-clockwise about +axis, turned round where it looks the other way.
        const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
        Cell a = cell;
        a[axis] += side;
        Cell b = a, c = a, d = a;
        ++b[u], ++c[u], ++c[v], ++d[v];
        if (side == 0) std::swap(b, d);
        const auto va = vertex(a), vb = vertex(b), vc = vertex(c), vd = vertex(d);
        add(va, vb, vc);
        add(va, vc, vd);
      }
  });
  return surface;
}

}  // namespace cagewright::bench
