// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/bow_tie.h"

namespace cagewright {

std::vector<int> find_bow_ties(const IndexedMesh& mesh, const Labels& fans) {
  std::vector<int> fans_at(static_cast<std::size_t>(mesh.points.rows()), 0);
  int next_fan = 0;
  for (std::size_t corner = 0; corner < fans.of.size(); ++corner) {
    if (fans.of[corner] != next_fan) continue;  // labels are numbered by first occurrence
    ++fans_at[mesh.triangles.data()[corner]];
    ++next_fan;
  }
  std::vector<int> bow_ties;
  for (std::size_t v = 0; v < fans_at.size(); ++v) {
    if (fans_at[v] > 1) bow_ties.push_back(static_cast<int>(v));
  }
  return bow_ties;
}

void split_bow_ties(IndexedMesh& mesh, const Labels& fans) {
  const Eigen::Index before = mesh.points.rows();
  std::vector<bool> taken(static_cast<std::size_t>(before), false);
  std::vector<int> vertex_of(static_cast<std::size_t>(fans.count), -1);
  std::vector<int> copies;
  for (std::size_t corner = 0; corner < fans.of.size(); ++corner) {
    int& named = mesh.triangles.data()[corner];
    int& vertex = vertex_of[fans.of[corner]];
    if (vertex < 0 && !taken[named]) {
      taken[named] = true;
      vertex = named;
    } else if (vertex < 0) {
      vertex = static_cast<int>(before) + static_cast<int>(copies.size());
      copies.push_back(named);
    }
    named = vertex;
  }
  mesh.points.conservativeResize(before + static_cast<Eigen::Index>(copies.size()), 3);
  for (std::size_t i = 0; i < copies.size(); ++i) {
    mesh.points.row(before + static_cast<Eigen::Index>(i)) = mesh.points.row(copies[i]);
  }
}

}  // namespace cagewright
