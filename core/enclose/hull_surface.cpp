// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/hull_surface.h"

#include <algorithm>

#include "core/enclose/disjoint_sets.h"
#include "core/error/error.h"

namespace cagewright {
namespace {

using Kept = OuterSides::Kept;

class Surface {
 public:
  Surface(const Arrangement& arrangement, const OuterSides& sides)
      : arrangement_(arrangement), sides_(sides), corners_(3 * arrangement.faces.size()) {}

  HullSurface run() {
    find_vertices();
    find_edges();
    for (std::size_t v = 0; v < result_.point_of.size(); ++v) {
      const auto& edges = edges_at_[v];
      result_.stays[v] = !edges.empty() && (edges.size() != 2 || is_corner_[v] || result_.is_touching[v] || bends(v));
    }
    find_borders();
    return std::move(result_);
  }

 private:
  struct EdgeAt {
    int edge;       // the lower of its two: 3 f + i
    int neighbour;  // point
    int source;
    bool operator<(const EdgeAt& other) const { return edge < other.edge; }
    bool operator==(const EdgeAt& other) const { return edge == other.edge; }
  };

  const Arrangement::Face& face(int f) const { return arrangement_.faces[static_cast<std::size_t>(f)]; }
  bool is_kept(int f) const { return sides_.faces[static_cast<std::size_t>(f)] != Kept::no; }
  int point(int corner) const { return face(corner / 3).points[static_cast<std::size_t>(corner % 3)]; }
  static int next(int corner) { return corner % 3 == 2 ? corner - 2 : corner + 1; }
  int partner(int edge) const { return sides_.partners[static_cast<std::size_t>(edge)]; }
  int vertex(int corner) const { return vertex_of_[static_cast<std::size_t>(corner)]; }
  // Whether a border runs along the edge 3 f + i: the surface goes on with another source.
  bool is_border(int edge) const { return face(edge / 3).source != face(partner(edge) / 3).source; }

  void find_vertices() {
    const int count = static_cast<int>(arrangement_.faces.size());
    for (int f = 0; f < count; ++f)
      for (int edge = 3 * f; is_kept(f) && edge < 3 * f + 3; ++edge) {
        const int other = partner(edge);
        if (other < 0 || !is_kept(other / 3)) throw Error(ErrorCode::internal, "hull: it is open");
        const bool runs_along = point(other) == point(edge);
        corners_.join(edge, runs_along ? other : next(other));
        corners_.join(next(edge), runs_along ? next(other) : other);
      }
    vertex_of_.assign(static_cast<std::size_t>(3 * count), -1);
    std::map<int, int> copies;
    for (int corner = 0; corner < 3 * count; ++corner) {
      if (!is_kept(corner / 3)) continue;
      int& vertex = vertex_of_[static_cast<std::size_t>(corners_.of(corner))];
      if (vertex < 0) {
        vertex = static_cast<int>(result_.point_of.size());
        result_.point_of.push_back(point(corner));
        ++copies[point(corner)];
      }
      vertex_of_[static_cast<std::size_t>(corner)] = vertex;
    }
    result_.faces_of.resize(result_.point_of.size());
    is_corner_.assign(result_.point_of.size(), 0);
    result_.stays = is_corner_;
    for (const int p : result_.point_of) result_.is_touching.push_back(copies[p] > 1);
    for (int corner = 0; corner < 3 * count; ++corner) {
      if (!is_kept(corner / 3)) continue;
      const auto v = static_cast<std::size_t>(vertex(corner));
      result_.faces_of[v].push_back(corner / 3);
      const auto& of_source = arrangement_.corners[static_cast<std::size_t>(face(corner / 3).source)];
      if (std::find(of_source.begin(), of_source.end(), point(corner)) != of_source.end()) is_corner_[v] = 1;
    }
  }

  void find_edges() {
    edges_at_.resize(result_.point_of.size());
    for (int f = 0; f < static_cast<int>(arrangement_.faces.size()); ++f)
      for (int edge = 3 * f; is_kept(f) && edge < 3 * f + 3; ++edge) {
        if (!is_border(edge)) continue;
        const int id = std::min(edge, partner(edge)), source = face(f).source;
        edges_at_[static_cast<std::size_t>(vertex(edge))].push_back({id, point(next(edge)), source});
        edges_at_[static_cast<std::size_t>(vertex(next(edge)))].push_back({id, point(edge), source});
      }
    for (auto& edges : edges_at_) {
      std::sort(edges.begin(), edges.end());
      edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    }
  }

  // Both edges are in the plane of the source of either.
  bool bends(std::size_t v) const {
    const EdgeAt &a = edges_at_[v][0], &b = edges_at_[v][1];
    const Projection plane = arrangement_.planes[static_cast<std::size_t>(a.source)];
    return arrangement_.points.orientation(a.neighbour, result_.point_of[v], b.neighbour, plane) != 0;
  }

  void find_borders() {
    result_.borders.resize(arrangement_.corners.size());
    std::map<std::pair<int, int>, int> onward;  // of a source and a vertex that goes: the border's next edge
    const int count = static_cast<int>(arrangement_.faces.size());
    const auto for_borders = [&](const auto& visit) {
      for (int f = 0; f < count; ++f)
        for (int edge = 3 * f; is_kept(f) && edge < 3 * f + 3; ++edge)
          if (is_border(edge)) visit(edge);
    };
    for_borders([&](int edge) {
      if (!result_.stays[static_cast<std::size_t>(vertex(edge))]) onward[{face(edge / 3).source, vertex(edge)}] = edge;
    });
    for_borders([&](int edge) {
      if (!result_.stays[static_cast<std::size_t>(vertex(edge))]) return;
      const int source = face(edge / 3).source;
      int last = edge, id = std::min(edge, partner(edge));
      while (!result_.stays[static_cast<std::size_t>(vertex(next(last)))]) {
        const auto found = onward.find({source, vertex(next(last))});
        if (found == onward.end()) throw Error(ErrorCode::internal, "hull: a border ends");
        last = found->second;
        id = std::min({id, last, partner(last)});
      }
      result_.borders[static_cast<std::size_t>(source)].push_back(
          {point(edge), point(next(last)), vertex(edge), vertex(next(last)), id,
           sides_.faces[static_cast<std::size_t>(edge / 3)] == Kept::turned});
    });
  }

  const Arrangement& arrangement_;
  const OuterSides& sides_;
  DisjointSets corners_;
  std::vector<int> vertex_of_;   // of each corner 3 f + i
  std::vector<char> is_corner_;  // of each vertex: of a source, too
  std::vector<std::vector<EdgeAt>> edges_at_;
  HullSurface result_;
};

}  // namespace

HullSurface find_hull_surface(const Arrangement& arrangement, const OuterSides& sides) {
  return Surface(arrangement, sides).run();
}

}  // namespace cagewright
