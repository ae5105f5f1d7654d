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

struct HullTriangle {
  std::array<int, 3> vertices;  // of the surface
  std::array<int, 3> borders;   // of the edge from corner i to the next: its id, or -1

  void turn() {
    std::swap(vertices[1], vertices[2]);
    std::swap(borders[0], borders[2]);
  }
};

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

  // Outward.
  std::vector<HullTriangle> triangles() const {
    std::vector<HullTriangle> found;
    std::map<std::array<int, 3>, bool> is_turned;
    for (const auto& [edge, border] : borders_) spread(border, is_turned);
    for (const auto& [t, turned] : is_turned) {
      HullTriangle triangle{{vertex_at(t, 0), vertex_at(t, 1), vertex_at(t, 2)}, {}};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto border = borders_.find({t[i], t[(i + 1) % 3]});
        triangle.borders[i] = border == borders_.end() ? -1 : border->second.id;
      }
      if (turned) triangle.turn();
      found.push_back(triangle);
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
    split_double_edges();
    number_vertices();
    OuterHull hull;
    const auto count = static_cast<Eigen::Index>(order_.size());
    hull.mesh.points.resize(count, 3);
    for (Eigen::Index row = 0; row < count; ++row) {
      const auto v = static_cast<std::size_t>(order_[static_cast<std::size_t>(row)]);
      hull.mesh.points.row(row) = place_of(v).transpose();
      hull.vertex_source.push_back(source_of_[v]);
      if (is_touching(v)) hull.touching.push_back(static_cast<int>(row));
    }
    hull.mesh.triangles.resize(static_cast<Eigen::Index>(triangles_.size()), 3);
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (std::size_t i = 0; i < 3; ++i)
        hull.mesh.triangles(static_cast<Eigen::Index>(t), static_cast<Eigen::Index>(i)) =
            row_of_[static_cast<std::size_t>(triangles_[t].vertices[i])];
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
  std::optional<HullTriangle> as_a_whole(std::size_t s) const {
    const std::vector<HullEdge>& borders = surface_.borders[s];
    if (borders.size() != 3) return {};
    HullTriangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
      const int from = arrangement_.corners[s][i], to = arrangement_.corners[s][(i + 1) % 3];
      const auto border =
          std::find_if(borders.begin(), borders.end(), [&](const HullEdge& b) { return b.from == from && b.to == to; });
      if (border == borders.end()) return {};
      triangle.vertices[i] = border->from_vertex;
      triangle.borders[i] = border->id;
    }
    if (borders[0].is_turned) triangle.turn();
    return triangle;
  }

  // Two sheets that touch along an edge and have both of its ends in common get a vertex each in its middle.
  void split_double_edges() {
    std::map<std::pair<int, int>, std::set<int>> ids;
    for (const HullTriangle& t : triangles_)
      for (std::size_t i = 0; i < 3; ++i)
        if (t.borders[i] >= 0) ids[std::minmax(t.vertices[i], t.vertices[(i + 1) % 3])].insert(t.borders[i]);
    std::map<int, int> middle_of;
    for (std::size_t k = 0; k < triangles_.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) {
        HullTriangle& t = triangles_[k];
        const int a = t.vertices[i], b = t.vertices[(i + 1) % 3], c = t.vertices[(i + 2) % 3], id = t.borders[i];
        if (id < 0 || ids[std::minmax(a, b)].size() < 2) continue;
        const int next = static_cast<int>(surface_.point_of.size() + middles_.size());
        const auto [middle, is_new] = middle_of.emplace(id, next);
        if (is_new) middles_.push_back({a, b, Vector3::Zero()});
        const int m = middle->second;
        middles_[static_cast<std::size_t>(m) - surface_.point_of.size()].outward += normal_of(t, triangle_source_[k]);
        const HullTriangle rest{{m, b, c}, {-1, t.borders[(i + 1) % 3], -1}};
        t = {{a, m, c}, {-1, -1, t.borders[(i + 2) % 3]}};
        triangles_.insert(triangles_.begin() + static_cast<std::ptrdiff_t>(k) + 1, rest);
        triangle_source_.insert(triangle_source_.begin() + static_cast<std::ptrdiff_t>(k), triangle_source_[k]);
        i = static_cast<std::size_t>(-1);  // once more: its other edges
      }
  }

  // Outward, of the source.
  Vector3 normal_of(const HullTriangle& t, int source) const {
    const Triangle3 c = triangle_of(mesh_, source);
    const Vector3 n = (c[1] - c[0]).cross(c[2] - c[0]).stableNormalized();
    Triangle3 here;
    for (std::size_t i = 0; i < 3; ++i) here[i] = place_of(static_cast<std::size_t>(t.vertices[i]));
    return n.dot((here[1] - here[0]).cross(here[2] - here[0])) < 0 ? Vector3(-n) : n;
  }

  // A vertex in the middle of an edge of the surface.
  struct Middle {
    int a, b;
    Vector3 outward;
  };
  bool is_middle(std::size_t v) const { return v >= surface_.point_of.size(); }
  bool is_touching(std::size_t v) const { return is_middle(v) || surface_.is_touching[v]; }

  // Given vertices first, in their order; of several copies of one the first.
  void number_vertices() {
    const std::size_t count = surface_.point_of.size() + middles_.size();
    source_of_.assign(count, -1);
    std::vector<char> is_taken(static_cast<std::size_t>(mesh_.points.rows()), 0);
    std::set<std::pair<int, int>> order;
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const int v : triangles_[t].vertices) {
        const auto i = static_cast<std::size_t>(v);
        const int row = row_given(v, static_cast<std::size_t>(triangle_source_[t]));
        if (source_of_[i] >= 0 || row < 0 || is_taken[static_cast<std::size_t>(row)]) continue;
        source_of_[i] = row;
        is_taken[static_cast<std::size_t>(row)] = 1;
      }
    for (const HullTriangle& t : triangles_)
      for (const int v : t.vertices) {
        const int row = source_of_[static_cast<std::size_t>(v)];
        order.emplace(row >= 0 ? row : static_cast<int>(mesh_.points.rows()) + v, v);
      }
    row_of_.assign(count, -1);
    for (const auto& [key, v] : order) {
      row_of_[static_cast<std::size_t>(v)] = static_cast<int>(order_.size());
      order_.push_back(v);
    }
  }

  // The source's row of a vertex, where it is a corner of it, or -1.
  int row_given(int v, std::size_t source) const {
    if (is_middle(static_cast<std::size_t>(v))) return -1;
    const auto& corners = arrangement_.corners[source];
    const auto found = std::find(corners.begin(), corners.end(), surface_.point_of[static_cast<std::size_t>(v)]);
    if (found == corners.end()) return -1;
    return mesh_.triangles(static_cast<Eigen::Index>(source), found - corners.begin());
  }

  Vector3 place_of(std::size_t v) const {
    if (is_middle(v)) {
      const Middle& middle = middles_[v - surface_.point_of.size()];
      const Vector3 a = place_of(static_cast<std::size_t>(middle.a)), b = place_of(static_cast<std::size_t>(middle.b));
      return (a + b) / 2 - apart_ * middle.outward.stableNormalized();
    }
    const Vector3 place = arrangement_.points.rounded(surface_.point_of[v]);
    if (!surface_.is_touching[v] || apart_ <= 0) return place;
    return place + apart_ * find_inward(mesh_, arrangement_, sides_, surface_.faces_of[v]);
  }

  const IndexedMesh& mesh_;
  double apart_;
  Arrangement arrangement_;
  OuterSides sides_;
  HullSurface surface_;
  std::vector<HullTriangle> triangles_;
  std::vector<int> triangle_source_;
  std::vector<Middle> middles_;          // numbered on from the surface's vertices
  std::vector<int> source_of_, row_of_;  // of each vertex of the surface
  std::vector<int> order_;               // vertices of the surface by row
};

}  // namespace

OuterHull outer_hull(const IndexedMesh& mesh, double apart) { return Hull(mesh, apart).run(); }

}  // namespace cagewright
