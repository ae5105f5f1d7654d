// SPDX-License-Identifier: BSD-3-Clause
// A face's half-plane at an edge is that of any corner of its source which lies strictly on its side, so angles compare
// by the signs of given points over given planes.
#include "core/enclose/edge_fans.h"

#include <algorithm>
#include <map>

#include "core/enclose/triangle_intersection.h"
#include "core/error/error.h"
#include "core/mesh/predicates.h"

namespace cagewright {
namespace {

class FanOrder {
 public:
  FanOrder(const IndexedMesh& mesh, const Arrangement& arrangement, int low, int high, const std::vector<FanFace>& fan)
      : mesh_(mesh), arrangement_(arrangement), low_(low), high_(high) {
    for (const FanFace& face : fan) beyond_.push_back(corner_beyond(face));
  }

  // 1 where g is less than half a turn counter-clockwise of f, -1 where it is more, 0 where they are in one plane.
  int turn(const FanFace& f, const FanFace& g, std::size_t g_index) const {
    const int s = source(f), t = source(g);
    if (s == t) return 0;
    const Triangle3 c = triangle_of(mesh_, s);
    const Vector3 p = mesh_.points.row(mesh_.triangles(t, beyond_[g_index]));
    return orient3d(c[0], c[1], c[2], p) * (f.is_left ? 1 : -1);
  }
  // Of two in one plane: whether they are on the same side of the edge.
  bool is_same(const FanFace& f, const FanFace& g, std::size_t g_index) const {
    const int s = source(f), t = source(g);
    if (s == t) return f.is_left == g.is_left;
    const int p = arrangement_.points.of_row(mesh_.triangles(t, beyond_[g_index]));
    const int side = arrangement_.points.orientation(low_, high_, p, arrangement_.planes[static_cast<std::size_t>(s)]);
    return side == (f.is_left ? 1 : -1);
  }

 private:
  int source(const FanFace& f) const { return arrangement_.faces[static_cast<std::size_t>(f.face)].source; }

  int corner_beyond(const FanFace& f) const {
    const auto s = static_cast<std::size_t>(source(f));
    for (int i = 0; i < 3; ++i) {
      const int p = arrangement_.corners[s][static_cast<std::size_t>(i)];
      if (arrangement_.points.orientation(low_, high_, p, arrangement_.planes[s]) == (f.is_left ? 1 : -1)) return i;
    }
    throw Error(ErrorCode::internal, "hull: a face lies beside its triangle");
  }

  const IndexedMesh& mesh_;
  const Arrangement& arrangement_;
  int low_, high_;
  std::vector<int> beyond_;  // of each face: a corner of its source on its side
};

// 0: as the first, 1: less than half a turn on, 2: half a turn, 3: more.
int quarter(const FanOrder& order, const FanFace& first, const FanFace& g, std::size_t index) {
  const int turn = order.turn(first, g, index);
  if (turn != 0) return turn > 0 ? 1 : 3;
  return order.is_same(first, g, index) ? 0 : 2;
}

void sort_fan(const IndexedMesh& mesh, const Arrangement& arrangement, int low, int high, std::vector<FanFace>& fan) {
  const FanOrder order(mesh, arrangement, low, high, fan);
  std::vector<std::size_t> sorted;
  std::vector<int> quarters;
  for (std::size_t i = 0; i < fan.size(); ++i) {
    quarters.push_back(quarter(order, fan[0], fan[i], i));
    sorted.push_back(i);
  }
  const auto turn = [&](std::size_t a, std::size_t b) {
    return quarters[a] % 2 == 0 ? 0 : order.turn(fan[a], fan[b], b);
  };
  std::stable_sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) {
    return quarters[a] != quarters[b] ? quarters[a] < quarters[b] : turn(a, b) > 0;
  });
  std::vector<FanFace> result;
  for (std::size_t k = 0; k < sorted.size(); ++k) {
    FanFace face = fan[sorted[k]];
    const bool is_next =
        k > 0 && (quarters[sorted[k - 1]] != quarters[sorted[k]] || turn(sorted[k - 1], sorted[k]) != 0);
    face.angle = k == 0 ? 0 : result.back().angle + (is_next ? 1 : 0);
    result.push_back(face);
  }
  fan = std::move(result);
}

}  // namespace

std::vector<std::vector<FanFace>> find_edge_fans(const IndexedMesh& mesh, const Arrangement& arrangement) {
  std::map<std::pair<int, int>, std::vector<FanFace>> at;
  for (std::size_t f = 0; f < arrangement.faces.size(); ++f) {
    const Arrangement::Face& face = arrangement.faces[f];
    for (std::size_t i = 0; i < 3; ++i) {
      if (!face.is_constrained[i]) continue;
      const int a = face.points[i], b = face.points[(i + 1) % 3];
      at[std::minmax(a, b)].push_back({static_cast<int>(f), static_cast<int>(i), a < b, 0});
    }
  }
  std::vector<std::vector<FanFace>> fans;
  for (auto& [edge, fan] : at) {
    sort_fan(mesh, arrangement, edge.first, edge.second, fan);
    fans.push_back(std::move(fan));
  }
  return fans;
}

}  // namespace cagewright
