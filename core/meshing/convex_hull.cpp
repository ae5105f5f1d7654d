// SPDX-License-Identifier: BSD-3-Clause
#include "core/meshing/convex_hull.h"

#include <Eigen/Geometry>
#include <cstdio>
#include <memory>
#include <string>

extern "C" {
#include <libqhull_r/libqhull_r.h>
}

namespace cagewright {
namespace {

// Owns Qhull's state, and the stream that Qhull insists on writing its complaints to.
class Qhull {
 public:
  Qhull() : complaints_(std::fopen("/dev/null", "w"), &std::fclose) { qh_zero(&state_, complaints_.get()); }
  ~Qhull() {
    qh_freeqhull(&state_, !qh_ALL);
    int blocks = 0, bytes = 0;
    qh_memfreeshort(&state_, &blocks, &bytes);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  bool run(const std::vector<Vector3>& points, std::string command) {
    for (const Vector3& p : points) coordinates_.insert(coordinates_.end(), p.data(), p.data() + 3);
    return qh_new_qhull(&state_, 3, static_cast<int>(points.size()), coordinates_.data(), False, command.data(),
                        nullptr, complaints_.get()) == 0;
  }
  qhT* state() { return &state_; }

 private:
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> complaints_;
  std::vector<double> coordinates_;
  qhT state_;
};

}  // namespace

std::vector<std::array<int, 3>> hull_triangles(const std::vector<Vector3>& points) {
  Qhull qhull;
  std::vector<std::array<int, 3>> triangles;
  if (!qhull.run(points, "qhull QJ Pp")) return triangles;
  qhT* qh = qhull.state();  // the FORALL macros read this name
  facetT* facet = nullptr;
  FORALLfacets {
    std::array<int, 3> corners{};
    int count = 0;
    vertexT* vertex = nullptr;
    vertexT** vertexp = nullptr;
    FOREACHvertex_(facet->vertices) {
      if (count < 3) corners[static_cast<std::size_t>(count)] = qh_pointid(qh, vertex->point);
      ++count;
    }
    const Vector3 normal(facet->normal[0], facet->normal[1], facet->normal[2]);
    const auto point = [&](int i) { return points[static_cast<std::size_t>(corners[static_cast<std::size_t>(i)])]; };
    if ((point(1) - point(0)).cross(point(2) - point(0)).dot(normal) < 0) std::swap(corners[1], corners[2]);
    triangles.push_back(corners);
  }
  return triangles;
}

std::vector<HullPlane> hull_planes(const std::vector<Vector3>& points) {
  Qhull qhull;
  std::vector<HullPlane> planes;
  if (!qhull.run(points, "qhull Pp")) return planes;
  qhT* qh = qhull.state();
  facetT* facet = nullptr;
  FORALLfacets planes.push_back({{facet->normal[0], facet->normal[1], facet->normal[2]}, facet->offset});
  return planes;
}

}  // namespace cagewright
