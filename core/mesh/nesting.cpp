// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/nesting.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>

#include "core/mesh/predicates.h"

namespace cagewright {
namespace {

struct Probe {
  Vector3 point;
  int component;
};

// A triangle of `component` above a probe or, where `on`, through it.
struct Hit {
  int probe, component;
  int turn;  // how the triangle, seen from above, goes round the probe
  bool on;

  auto key() const { return std::tie(probe, component); }
};

struct Extent {
  Eigen::AlignedBox3d box;
  std::array<int, 6> extreme{-1, -1, -1, -1, -1, -1};  // vertices: least and greatest x, y, z
};

std::vector<Extent> find_extents(const IndexedMesh& mesh, const Labels& components) {
  std::vector<Extent> extents(static_cast<std::size_t>(components.count));
  const auto& [points, triangles] = mesh;
  for (Eigen::Index corner = 0; corner < triangles.size(); ++corner) {
    const int v = triangles.data()[corner];
    Extent& extent = extents[components.of[static_cast<std::size_t>(corner / 3)]];
    extent.box.extend(points.row(v).transpose());
    for (int axis = 0; axis < 3; ++axis) {
      int& least = extent.extreme[2 * axis];
      int& greatest = extent.extreme[2 * axis + 1];
      if (least < 0 || points(v, axis) < points(least, axis)) least = v;
      if (greatest < 0 || points(v, axis) > points(greatest, axis)) greatest = v;
    }
  }
  return extents;
}

// Sorted by x, so that a triangle finds those in its range by bisection.
std::vector<Probe> find_probes(const Points& points, const std::vector<Extent>& extents) {
  std::vector<Probe> probes;
  for (std::size_t k = 0; k < extents.size(); ++k) {
    for (const int v : extents[k].extreme) probes.push_back({points.row(v).transpose(), static_cast<int>(k)});
  }
  std::ranges::stable_sort(probes, {}, [](const Probe& probe) { return probe.point.x(); });
  return probes;
}

// What the edge from a to b adds to the winding round q, seen along z. An edge counts where it crosses the level of q
// (its lower end included, its upper end not) on q's left or right, so that neighbouring triangles never both count.
int winding_of_edge(const Vector3& a, const Vector3& b, const Vector3& q) {
  const bool upward = a.y() <= q.y() && q.y() < b.y();
  const bool downward = b.y() <= q.y() && q.y() < a.y();
  if (!upward && !downward) return 0;
  const int side = orient2d(a.head<2>(), b.head<2>(), q.head<2>());
  return upward ? side > 0 : -(side < 0);
}

std::vector<Hit> find_hits(const IndexedMesh& mesh, const Labels& components, const std::vector<Extent>& extents,
                           const std::vector<Probe>& probes) {
  std::vector<Hit> hits;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const int component = components.of[static_cast<std::size_t>(t)];
    std::array<Vector3, 3> corner;
    Eigen::AlignedBox3d box;
    for (int i = 0; i < 3; ++i) {
      corner[i] = mesh.points.row(mesh.triangles(t, i)).transpose();
      box.extend(corner[i]);
    }
    const auto& [a, b, c] = corner;
    auto probe = std::ranges::lower_bound(probes, box.min().x(), {}, [](const Probe& p) { return p.point.x(); });
    for (; probe != probes.end() && probe->point.x() <= box.max().x(); ++probe) {
      const Vector3& q = probe->point;
      if (q.y() < box.min().y() || q.y() > box.max().y() || q.z() > box.max().z()) continue;
      if (probe->component == component || !extents[component].box.contains(extents[probe->component].box)) continue;
      const int turn = winding_of_edge(a, b, q) + winding_of_edge(b, c, q) + winding_of_edge(c, a, q);
      if (turn == 0) continue;
      const int side = orient3d(a, b, c, q);  // q is below the triangle where it is behind one that faces up
      if (side * turn > 0) continue;
      hits.push_back({static_cast<int>(probe - probes.begin()), component, turn, side == 0});
    }
  }
  std::ranges::stable_sort(hits, {}, &Hit::key);
  return hits;
}

// How many probes of component `inner` lie strictly inside, and on, component `outer`.
struct Count {
  int inner, outer;
  int inside, on;

  auto key() const { return std::tie(inner, outer); }
};

std::vector<Count> count_enclosed(const std::vector<Hit>& hits, const std::vector<Probe>& probes) {
  std::vector<Count> single;
  for (std::size_t i = 0; i < hits.size();) {
    const Hit& first = hits[i];
    int winding = 0;
    bool on = false;
    for (; i < hits.size() && hits[i].key() == first.key(); ++i) {
      on = on || hits[i].on;
      winding += hits[i].turn;
    }
    if (on || winding != 0) single.push_back({probes[first.probe].component, first.component, !on, on});
  }
  std::ranges::stable_sort(single, {}, &Count::key);
  std::vector<Count> counts;
  for (const Count& count : single) {
    if (!counts.empty() && counts.back().key() == count.key()) {
      counts.back().inside += count.inside;
      counts.back().on += count.on;
    } else {
      counts.push_back(count);
    }
  }
  return counts;
}

}  // namespace

std::vector<int> find_outermost(const IndexedMesh& mesh, const Labels& components, const Volumes& volumes) {
  std::vector<int> outermost(static_cast<std::size_t>(components.count));
  std::iota(outermost.begin(), outermost.end(), 0);
  if (components.count == 1) return outermost;

  const auto size = [&](int k) { return std::abs(volumes.of[k]); };
  const std::vector<Extent> extents = find_extents(mesh, components);
  const std::vector<Probe> probes = find_probes(mesh.points, extents);
  const int probes_of_each = static_cast<int>(extents.front().extreme.size());
  for (const Count& count : count_enclosed(find_hits(mesh, components, extents, probes), probes)) {
    if (count.inside == 0 || count.inside + count.on < probes_of_each || size(count.outer) <= size(count.inner))
      continue;
    int& best = outermost[count.inner];
    if (best == count.inner || size(count.outer) > size(best)) best = count.outer;
  }
  return outermost;
}

}  // namespace cagewright
