// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/merge_limbs.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/enclose/disjoint_sets.h"
#include "core/enclose/nearest_slide.h"
#include "core/enclose/outer_hull.h"
#include "core/enclose/simplify_hull.h"
#include "core/enclose/triangle_distance.h"
#include "core/enclose/winding.h"
#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

// Of each triangle of a closed mesh the lowest one that it hangs together with.
std::vector<int> find_pieces(const Triangles& triangles, Eigen::Index vertices) {
  DisjointSets joined(static_cast<std::size_t>(vertices));
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (const int i : {1, 2}) joined.join(triangles(t, 0), triangles(t, i));
  std::vector<int> piece;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) piece.push_back(joined.of(triangles(t, 0)));
  return piece;
}

class Merging {
 public:
  Merging(const MovableCage& movable, const MergeOptions& options)
      : movable_(movable), options_(options), hull_(outer_hull(movable.mesh(), 4 * options.gap)) {
    for (std::size_t t = 0; t < hull_.triangle_source.size(); ++t) source_.push_back(hull_.triangle_source[t]);
    for (const int row : hull_.vertex_source) given_.push_back(row);
    if (options.to_floats) hull_.mesh.points = hull_.mesh.points.cast<float>().cast<double>().eval();
  }

  MergedLimbs run() {
    drop_pieces_without_model();
    find_seams();
    simplify();
    fill_cage();
    return std::move(result_);
  }

 private:
  const Cage& cage() const { return movable_.cage(); }
  int part_of(int source) const { return cage().triangle_part[static_cast<std::size_t>(source)]; }

  void keep(const std::vector<char>& triangles) {
    std::vector<int> row(static_cast<std::size_t>(hull_.mesh.points.rows()), -1), kept_given;
    IndexedMesh mesh;
    std::vector<int> source;
    std::vector<std::array<int, 3>> kept;
    for (std::size_t t = 0; t < triangles.size(); ++t) {
      if (!triangles[t]) continue;
      const auto corners = hull_.mesh.triangles.row(static_cast<Eigen::Index>(t));
      kept.push_back({corners(0), corners(1), corners(2)});
      source.push_back(source_[t]);
      for (const int v : kept.back()) row[static_cast<std::size_t>(v)] = 0;
    }
    int count = 0;
    for (std::size_t v = 0; v < row.size(); ++v)
      if (row[v] == 0) {
        row[v] = count++;
        kept_given.push_back(given_[v]);
      }
    mesh.points.resize(count, 3);
    for (std::size_t v = 0; v < row.size(); ++v)
      if (row[v] >= 0) mesh.points.row(row[v]) = hull_.mesh.points.row(static_cast<Eigen::Index>(v));
    mesh.triangles.resize(static_cast<Eigen::Index>(kept.size()), 3);
    for (std::size_t t = 0; t < kept.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        mesh.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(i)) =
            row[static_cast<std::size_t>(kept[t][i])];
    hull_.mesh = std::move(mesh);
    source_ = std::move(source);
    given_ = std::move(kept_given);
  }

  void drop_pieces_without_model() {
    const std::vector<int> piece = find_pieces(hull_.mesh.triangles, hull_.mesh.points.rows());
    std::set<int> all(piece.begin(), piece.end());
    if (all.size() < 2) return;
    std::vector<char> is_kept(piece.size(), 0);
    for (const int one : all) {
      std::vector<int> rows;
      for (std::size_t t = 0; t < piece.size(); ++t)
        if (piece[t] == one) rows.push_back(static_cast<int>(t));
      IndexedMesh mesh{hull_.mesh.points, Triangles(static_cast<Eigen::Index>(rows.size()), 3)};
      for (std::size_t t = 0; t < rows.size(); ++t)
        mesh.triangles.row(static_cast<Eigen::Index>(t)) = hull_.mesh.triangles.row(rows[t]);
      const BoxTree tree(mesh);
      const Winding winding(mesh, tree);
      const auto& parts = movable_.segmentation().parts;
      const bool has_model = std::any_of(parts.begin(), parts.end(), [&](const Part& part) {
        return std::any_of(part.vertices.begin(), part.vertices.end(), [&](int v) {
          const auto number = winding.of(movable_.model().points.row(v));
          return number && *number > 0;
        });
      });
      for (const int t : rows) is_kept[static_cast<std::size_t>(t)] = has_model;
    }
    keep(is_kept);
  }

  // Where triangles are neighbours now that had no vertex in common.
  void find_seams() {
    std::map<std::pair<int, int>, double> lengths;
    std::map<std::pair<int, int>, int> owner;
    const Triangles& triangles = hull_.mesh.triangles;
    for (int t = 0; t < static_cast<int>(triangles.rows()); ++t)
      for (int i = 0; i < 3; ++i) owner[{triangles(t, i), triangles(t, (i + 1) % 3)}] = t;
    for (const auto& [edge, t] : owner) {
      const auto other = owner.find({edge.second, edge.first});
      if (other == owner.end() || edge.first > edge.second) continue;
      const int s = source_[static_cast<std::size_t>(t)], u = source_[static_cast<std::size_t>(other->second)];
      bool shares = false;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) shares = shares || movable_.vertex_of(s, i) == movable_.vertex_of(u, j);
      if (shares) continue;
      const Vector3 middle = (hull_.mesh.points.row(edge.first) + hull_.mesh.points.row(edge.second)).transpose() / 2;
      const int a = nearest_slide_of_part(part_of(s), middle), b = nearest_slide_of_part(part_of(u), middle);
      if (a >= 0 && b >= 0 && a != b)
        lengths[std::minmax(a, b)] += (hull_.mesh.points.row(edge.first) - hull_.mesh.points.row(edge.second)).norm();
    }
    for (const auto& [slides, length] : lengths) result_.slides.push_back(slides);
    std::stable_sort(result_.slides.begin(), result_.slides.end(),
                     [&](const auto& a, const auto& b) { return lengths.at(a) > lengths.at(b); });
  }

  int nearest_slide_of_part(int part, const Vector3& place) const {
    const Segmentation& segmentation = movable_.segmentation();
    return nearest_slide(segmentation, slides_of_part(segmentation, part), place);
  }

  // Of each section the rows of its corners among the hull's vertices, or -1.
  std::vector<std::array<int, 4>> find_sections() const {
    std::map<int, int> row_of;
    for (std::size_t v = 0; v < given_.size(); ++v)
      if (given_[v] >= 0) row_of[given_[v]] = static_cast<int>(v);
    std::vector<std::array<int, 4>> sections;
    for (std::size_t k = 0; k < movable_.segmentation().ellipses.size(); ++k) {
      std::array<int, 4> rows = cage().corners_of(static_cast<int>(k));
      for (int& row : rows) {
        const auto found = row_of.find(row);
        row = found == row_of.end() ? -1 : found->second;
      }
      sections.push_back(rows);
    }
    return sections;
  }

  bool is_clear(const Triangle3& wall) const {
    bool hits = false;
    movable_.model_tree().visit_near(wall, options_.clearance, [&](int k) {
      const Triangle3 t = triangle_of(movable_.model(), k);
      hits = are_nearer_than(t, wall, options_.clearance) || (!is_degenerate(t) && triangles_meet(t, wall));
      return hits;
    });
    return !hits;
  }

  void simplify() {
    SimplifyOptions options;
    options.is_fixed.assign(given_.size(), 0);
    for (const std::array<int, 4>& rows : find_sections())
      if (*std::min_element(rows.begin(), rows.end()) >= 0)
        for (const int v : rows) options.is_fixed[static_cast<std::size_t>(v)] = 1;
    options.most_volume = tolerance::most_collapsed * movable_.volume();
    options.is_allowed = [&](const Triangle3& t) { return is_clear(t); };
    Simplified left = simplify_hull(hull_.mesh, options);
    hull_.mesh = std::move(left.mesh);
    std::vector<int> source, given;
    for (const int t : left.triangle_row) source.push_back(source_[static_cast<std::size_t>(t)]);
    for (const int v : left.vertex_row) given.push_back(given_[static_cast<std::size_t>(v)]);
    source_ = std::move(source);
    given_ = std::move(given);
  }

  void fill_cage() {
    Cage& merged = result_.cage;
    merged.points = hull_.mesh.points;
    merged.triangles = hull_.mesh.triangles;
    merged.part_center = cage().part_center;
    for (const int s : source_) merged.triangle_part.push_back(part_of(s));
    for (const int row : given_)
      merged.vertex_section.push_back(row < 0 ? -1 : cage().vertex_section[static_cast<std::size_t>(row)]);
    merged.section_vertices = find_sections();
  }

  const MovableCage& movable_;
  const MergeOptions& options_;
  OuterHull hull_;
  std::vector<int> source_, given_;  // of each triangle and vertex: the cage's
  MergedLimbs result_;
};

}  // namespace

MergedLimbs merge_limbs(const MovableCage& movable, const MergeOptions& options) {
  return Merging(movable, options).run();
}

}  // namespace cagewright
