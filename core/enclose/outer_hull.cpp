// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/outer_hull.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "core/enclose/arrangement.h"
#include "core/enclose/face_triangulation.h"
#include "core/enclose/hull_surface.h"
#include "core/enclose/outer_sides.h"
#include "core/enclose/triangle_intersection.h"
#include "core/error/error.h"

namespace cagewright {
namespace {

// Triangulates what is kept of one source between its borders.
class KeptPart {
 public:
  KeptPart(const Arrangement& arrangement, std::size_t source, const std::vector<HullEdge>& borders)
      : triangulation_(arrangement.points, arrangement.planes[source], arrangement.corners[source]) {
    std::set<int> points;
    for (const HullEdge& border : borders) {
      borders_[{border.from, border.to}] = border;
      points.insert(border.from);
      points.insert(border.to);
    }
    for (const int p : points) triangulation_.insert(p);
    for (const HullEdge& border : borders) triangulation_.constrain(border.from, border.to);
    triangulation_.improve();
  }

  // By vertices of the surface, outward.
  std::vector<std::array<int, 3>> triangles() const {
    std::vector<std::array<int, 3>> found;
    std::map<std::array<int, 3>, bool> is_turned;
    for (const auto& [edge, border] : borders_) spread(border, is_turned);
    for (const auto& [t, turned] : is_turned) {
      std::array<int, 3> vertices = {vertex_at(t, 0), vertex_at(t, 1), vertex_at(t, 2)};
      if (turned) std::swap(vertices[1], vertices[2]);
      found.push_back(vertices);
    }
    return found;
  }

 private:
  std::array<int, 3> triangle_left_of(int a, int b) const {
    std::array<int, 3> t = {a, b, triangulation_.apex(a, b)};
    if (t[2] < 0) throw Error(ErrorCode::internal, "hull: nothing is left of a border");
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  }

  void spread(const HullEdge& from, std::map<std::array<int, 3>, bool>& is_turned) const {
    std::vector<std::array<int, 3>> open = {triangle_left_of(from.from, from.to)};
    while (!open.empty()) {
      const std::array<int, 3> t = open.back();
      open.pop_back();
      if (!is_turned.emplace(t, from.is_turned).second) continue;
      for (std::size_t i = 0; i < 3; ++i)
        if (!triangulation_.is_constrained(t[i], t[(i + 1) % 3]))
          open.push_back(triangle_left_of(t[(i + 1) % 3], t[i]));
    }
  }

  // Of a corner of a kept triangle: that of the border which the turn round the corner comes to first.
  int vertex_at(const std::array<int, 3>& t, std::size_t i) const {
    const int x = t[i], first = t[(i + 1) % 3];
    if (const auto into = borders_.find({t[(i + 2) % 3], x}); into != borders_.end()) return into->second.to_vertex;
    int y = first;
    for (;;) {
      if (const auto out = borders_.find({x, y}); out != borders_.end()) return out->second.from_vertex;
      y = triangulation_.apex(y, x);
      if (y < 0 || y == first) throw Error(ErrorCode::internal, "hull: a corner has no border");
    }
  }

  FaceTriangulation triangulation_;
  std::map<std::pair<int, int>, HullEdge> borders_;
};

// A direction from a vertex into the solid: away from all faces at it, as far as there is one.
Vector3 find_inward(const IndexedMesh& mesh, const Arrangement& arrangement, const OuterSides& sides,
                    const std::vector<int>& faces) {
  std::set<std::pair<int, bool>> sources;
  for (const int f : faces)
    sources.emplace(arrangement.faces[static_cast<std::size_t>(f)].source,
                    sides.faces[static_cast<std::size_t>(f)] == OuterSides::Kept::turned);
  std::vector<Vector3> normals;
  Vector3 inward = Vector3::Zero();
  for (const auto& [source, is_turned] : sources) {
    const Triangle3 t = triangle_of(mesh, source);
    const Vector3 n = (t[1] - t[0]).cross(t[2] - t[0]).stableNormalized();
    normals.push_back(is_turned ? Vector3(-n) : n);
    inward -= normals.back();
  }
  constexpr int rounds = 200;
  constexpr double enough = -0.1;  // cosine
  for (int round = 0; round < rounds; ++round) {
    inward = inward.stableNormalized();
    const auto worst = std::max_element(normals.begin(), normals.end(), [&](const Vector3& a, const Vector3& b) {
      return a.dot(inward) < b.dot(inward);
    });
    if (worst->dot(inward) < enough) break;
    inward -= 0.2 * *worst;
  }
  return inward.stableNormalized();
}

class Hull {
 public:
  Hull(const IndexedMesh& mesh, double apart)
      : mesh_(mesh),
        apart_(apart),
        arrangement_(arrange(mesh)),
        sides_(find_outer_sides(mesh, arrangement_)),
        surface_(find_hull_surface(arrangement_, sides_)) {}

  OuterHull run() {
    for (std::size_t s = 0; s < surface_.borders.size(); ++s) add_source(s);
    number_vertices();
    OuterHull hull;
    const auto count = static_cast<Eigen::Index>(order_.size());
    hull.mesh.points.resize(count, 3);
    for (Eigen::Index row = 0; row < count; ++row) {
      const auto v = static_cast<std::size_t>(order_[static_cast<std::size_t>(row)]);
      hull.mesh.points.row(row) = place_of(v).transpose();
      hull.vertex_source.push_back(source_of_[v]);
      if (surface_.is_touching[v]) hull.touching.push_back(static_cast<int>(row));
    }
    hull.mesh.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        hull.mesh.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(i)) =
            row_of_[static_cast<std::size_t>(triangles_[t][i])];
    hull.triangle_source = std::move(triangle_source_);
    return hull;
  }

 private:
  void add_source(std::size_t s) {
    const std::vector<HullEdge>& borders = surface_.borders[s];
    if (borders.empty()) return;
    if (const auto whole = as_a_whole(s)) {
      triangles_.push_back(*whole);
      triangle_source_.push_back(static_cast<int>(s));
      return;
    }
    for (const auto& t : KeptPart(arrangement_, s, borders).triangles()) {
      triangles_.push_back(t);
      triangle_source_.push_back(static_cast<int>(s));
    }
  }

  // Where the borders are the source's own edges: its triangle, first corner first.
  std::optional<std::array<int, 3>> as_a_whole(std::size_t s) const {
    const std::vector<HullEdge>& borders = surface_.borders[s];
    if (borders.size() != 3) return {};
    std::array<int, 3> vertices{};
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = arrangement_.corners[s][i], to = arrangement_.corners[s][(i + 1) % 3];
      const auto border =
          std::find_if(borders.begin(), borders.end(), [&](const HullEdge& b) { return b.from == from && b.to == to; });
      if (border == borders.end()) return {};
      vertices[i] = border->from_vertex;
    }
    if (borders[0].is_turned) std::swap(vertices[1], vertices[2]);
    return vertices;
  }

  // Given vertices first, in their order; of several copies of one the first.
  void number_vertices() {
    source_of_.assign(surface_.point_of.size(), -1);
    std::vector<char> is_taken(static_cast<std::size_t>(mesh_.points.rows()), 0);
    std::set<std::pair<int, int>> order;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const int v : triangles_[t]) {
        const auto i = static_cast<std::size_t>(v);
        const int row = row_given(v, static_cast<std::size_t>(triangle_source_[t]));
        if (source_of_[i] >= 0 || row < 0 || is_taken[static_cast<std::size_t>(row)]) continue;
        source_of_[i] = row;
        is_taken[static_cast<std::size_t>(row)] = 1;
      }
    for (const auto& t : triangles_)
      for (const int v : t) {
        const int row = source_of_[static_cast<std::size_t>(v)];
        order.emplace(row >= 0 ? row : static_cast<int>(mesh_.points.rows()) + v, v);
      }
    row_of_.assign(surface_.point_of.size(), -1);
    for (const auto& [key, v] : order) {
      row_of_[static_cast<std::size_t>(v)] = static_cast<int>(order_.size());
      order_.push_back(v);
    }
  }

  // The source's row of a vertex, where it is a corner of it, or -1.
  int row_given(int v, std::size_t source) const {
    const auto& corners = arrangement_.corners[source];
    const auto found = std::find(corners.begin(), corners.end(), surface_.point_of[static_cast<std::size_t>(v)]);
    if (found == corners.end()) return -1;
    return mesh_.triangles(static_cast<Eigen::Index>(source), found - corners.begin());
  }

  Vector3 place_of(std::size_t v) const {
    const Vector3 place = arrangement_.points.rounded(surface_.point_of[v]);
    if (!surface_.is_touching[v] || apart_ <= 0) return place;
    return place + apart_ * find_inward(mesh_, arrangement_, sides_, surface_.faces_of[v]);
  }

  const IndexedMesh& mesh_;
  double apart_;
  Arrangement arrangement_;
  OuterSides sides_;
  HullSurface surface_;
  std::vector<std::array<int, 3>> triangles_;  // by vertices of the surface
  std::vector<int> triangle_source_;
  std::vector<int> source_of_, row_of_;  // of each vertex of the surface
  std::vector<int> order_;               // vertices of the surface by row
};

}  // namespace

OuterHull outer_hull(const IndexedMesh& mesh, double apart) { return Hull(mesh, apart).run(); }

}  // namespace cagewright
