// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "host/bench/baselines/surface.h"

namespace cagewright::bench {

// Cells of a regular grid, some of them full. One layer of empty cells is kept all round.
class VoxelGrid {
 public:
  using Cell = std::array<int, 3>;

  // All cells empty. `origin`: the lowest corner; `size`: cells along each axis, at least 3.
  VoxelGrid(const Kernel::Point_3& origin, double cell_length, const Cell& size);

  bool full(const Cell& cell) const { return full_[row(cell)] != 0; }
  void fill(const Cell& cell) { full_[row(cell)] = 1; }
  const Cell& size() const { return size_; }
  Kernel::Iso_cuboid_3 box(const Cell& cell) const;

  // Fills what the full cells shut off from the grid's border.
  void fill_inside();
  // Fills the 26 neighbours of every full cell, the border's excepted.
  void grow();
  // Fills cells until the boundary of the full ones is a 2-manifold: until no edge and no vertex of it is shared by
  // full cells that are not neighbours by faces round it. Ends, as cells are only added.
  void make_manifold();

  // The boundary of the full cells as triangles, two for each face, counter-clockwise as seen from outside. The full
  // cells have to be manifold.
  Surface boundary() const;

 private:
  std::size_t row(const Cell& cell) const;
  Kernel::Point_3 corner(const Cell& lattice) const;
  void for_each_inner(const std::function<void(const Cell&)>& visit) const;
  bool mend_corner(const Cell& lattice);

  Kernel::Point_3 origin_;
  double cell_length_;
  Cell size_;
  std::vector<std::uint8_t> full_;
};

}  // namespace cagewright::bench
