// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/certificate.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "core/enclose/box_tree.h"
#include "core/enclose/triangle_intersection.h"
#include "core/enclose/winding.h"
#include "core/mesh/connectivity.h"
#include "core/mesh/inspect.h"
#include "core/mesh/nesting.h"
#include "core/mesh/volume.h"
#include "core/mesh/weld.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {
namespace {

constexpr std::size_t block_size = 1024;  // fixed, so that the work is cut the same way for any number of threads

// Runs `find`, which appends what it finds about item i, over all items, and joins the findings in order.
template <typename Finding, typename Find>
std::vector<Finding> gather(Eigen::Index count, unsigned threads, const Find& find) {
  const std::size_t items = static_cast<std::size_t>(count), blocks = (items + block_size - 1) / block_size;
  std::vector<std::vector<Finding>> found(blocks);
  parallel_for(blocks, threads, [&](std::size_t b) {
    for (std::size_t i = b * block_size; i < std::min(items, (b + 1) * block_size); ++i)
      find(static_cast<int>(i), found[b]);
  });
  std::vector<Finding> all;
  for (const auto& block : found) all.insert(all.end(), block.begin(), block.end());
  return all;
}

// Whether every component that lies in no other encloses a positive volume.
bool is_outward(const IndexedMesh& cage, const Connectivity& connectivity) {
  const Volumes volumes = find_volumes(cage, connectivity.components);
  const std::vector<int> outermost = find_outermost(cage, connectivity.components, volumes);
  for (std::size_t c = 0; c < outermost.size(); ++c)
    if (outermost[c] == static_cast<int>(c) && !(volumes.of[c] > 0)) return false;
  return true;
}

class Certifying {
 public:
  Certifying(const IndexedMesh& model, const IndexedMesh& cage, unsigned threads)
      : model_(model), cage_(cage), threads_(threads), tree_(cage) {}

  Certificate run() {
    const WeldedMesh welded = weld(cage_);
    const Connectivity connectivity = connect(welded);
    const MeshReport report = inspect(welded, connectivity);
    result_.closed = report.closed() && report.consistently_oriented() && report.bow_tie_vertices == 0 &&
                     report.degenerate_triangles == 0 && report.welded_vertices == 0 &&
                     is_outward(welded.mesh, connectivity);
    find_degenerate();
    find_self_intersections();
    find_model_intersections();
    find_vertices_outside();
    return std::move(result_);
  }

 private:
  void find_degenerate() {
    flat_.assign(static_cast<std::size_t>(cage_.triangles.rows()), false);
    for (Eigen::Index t = 0; t < cage_.triangles.rows(); ++t) {
      if (!is_degenerate(triangle_of(cage_, t))) continue;
      flat_[static_cast<std::size_t>(t)] = true;
      result_.degenerate_triangles.push_back(static_cast<int>(t));
    }
  }

  void find_self_intersections() {
    result_.self_intersections = gather<std::array<int, 2>>(cage_.triangles.rows(), threads_, [&](int s, auto& found) {
      if (flat_[static_cast<std::size_t>(s)]) return;
      const auto begin = static_cast<std::ptrdiff_t>(found.size());
      tree_.visit(box_of_triangle(cage_, s), [&](int t) {
        if (t > s && !flat_[static_cast<std::size_t>(t)] && triangles_of_mesh_meet(cage_, s, t))
          found.push_back({s, t});
        return false;
      });
      std::sort(found.begin() + begin, found.end());
    });
  }

  // Of a model triangle without area its longest edge is also another triangle's, so its edges are enough.
  bool meets(const Triangle3& model_triangle, bool is_flat, int cage_triangle) const {
    if (flat_[static_cast<std::size_t>(cage_triangle)]) return false;
    const Triangle3 cage_corners = triangle_of(cage_, cage_triangle);
    if (!is_flat) return triangles_meet(model_triangle, cage_corners);
    for (std::size_t i = 0; i < 3; ++i)
      if (segment_meets_triangle(model_triangle[i], model_triangle[(i + 1) % 3], cage_corners)) return true;
    return false;
  }

  void find_model_intersections() {
    result_.model_cage_intersections =
        gather<std::array<int, 2>>(model_.triangles.rows(), threads_, [&](int t, auto& found) {
          const Triangle3 corners = triangle_of(model_, t);
          const bool is_flat = is_degenerate(corners);
          int first = std::numeric_limits<int>::max();
          tree_.visit(box_of_triangle(model_, t), [&](int wall) {
            if (wall < first && meets(corners, is_flat, wall)) first = wall;
            return false;
          });
          if (first != std::numeric_limits<int>::max()) found.push_back({t, first});
        });
  }

  // Vertices that are joined by triangles which do not meet the cage are on the same side of it.
  std::vector<int> sides() const {
    std::vector<int> group(static_cast<std::size_t>(model_.points.rows()));
    std::iota(group.begin(), group.end(), 0);
    const auto root = [&](int v) {
      while (group[static_cast<std::size_t>(v)] != v) {
        int& up = group[static_cast<std::size_t>(v)];
        up = group[static_cast<std::size_t>(up)];
        v = up;
      }
      return v;
    };
    std::size_t next = 0;
    const auto& crossing = result_.model_cage_intersections;
    for (Eigen::Index t = 0; t < model_.triangles.rows(); ++t) {
      if (next < crossing.size() && crossing[next][0] == t) {
        ++next;
        continue;
      }
      for (const int i : {1, 2}) {
        const int a = root(model_.triangles(t, 0)), b = root(model_.triangles(t, i));
        group[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
      }
    }
    for (std::size_t v = 0; v < group.size(); ++v) group[v] = root(static_cast<int>(v));
    return group;
  }

  void find_vertices_outside() {
    const std::vector<int> group = sides();
    std::vector<bool> used(group.size(), false);
    for (const int v : model_.triangles.reshaped()) used[static_cast<std::size_t>(v)] = true;
    std::vector<int> asked;
    for (std::size_t v = 0; v < group.size(); ++v)
      if (used[v] && group[v] == static_cast<int>(v)) asked.push_back(static_cast<int>(v));
    const Winding winding(cage_, tree_);
    const std::vector<int> outside =
        gather<int>(static_cast<Eigen::Index>(asked.size()), threads_, [&](int i, auto& found) {
          const int v = asked[static_cast<std::size_t>(i)];
          const auto number = winding.of(model_.points.row(v));
          if (!number || *number <= 0) found.push_back(v);
        });
    for (std::size_t v = 0; v < group.size(); ++v)
      if (used[v] && std::binary_search(outside.begin(), outside.end(), group[v]))
        result_.vertices_outside.push_back(static_cast<int>(v));
  }

  const IndexedMesh& model_;
  const IndexedMesh& cage_;
  unsigned threads_;
  BoxTree tree_;
  std::vector<bool> flat_;  // of each cage triangle
  Certificate result_;
};

}  // namespace

Certificate certify(const IndexedMesh& model, const IndexedMesh& cage, unsigned threads) {
  return Certifying(model, cage, threads).run();
}

}  // namespace cagewright
