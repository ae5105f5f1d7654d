// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/tighten.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/error/error.h"
#include "core/mesh/tolerance.h"

namespace cagewright {
namespace {

using Whose = MovableCage::Whose;

constexpr int most_sweeps = 100, most_slides = 4;
constexpr double longer = 1.6, shorter = 0.5;

// The unit direction with the most of `wish` that moves away from no contact plane, or zero where there is none.
Vector3 along_contacts(const Vector3& wish, const std::vector<Vector3>& contacts) {
  constexpr double rounding = 1e-9;
  const auto leaves_none = [&](const Vector3& d) {
    return std::all_of(contacts.begin(), contacts.end(), [&](const Vector3& n) { return n.dot(d) >= -rounding; });
  };
  if (leaves_none(wish)) return wish;
  Vector3 best = Vector3::Zero();
  const auto offer = [&](const Vector3& d) {
    if (d.dot(wish) > best.dot(wish) && leaves_none(d)) best = d;
  };
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    offer(wish - contacts[i] * contacts[i].dot(wish));
    for (std::size_t j = 0; j < i; ++j) {
      const Vector3 edge = contacts[i].cross(contacts[j]);
      if (edge.norm() > rounding) offer(edge * edge.dot(wish) / edge.squaredNorm());
    }
  }
  return best;
}

class Descent {
 public:
  Descent(MovableCage& movable, const Points& plane_normals, double diagonal)
      : movable_(movable),
        planes_(plane_normals),
        least_step_(tolerance::least_tightening_step * diagonal),
        steps_(static_cast<std::size_t>(plane_normals.rows()), tolerance::first_tightening_step * diagonal) {}

  // Tries the step, then others along the triangles that were in the way. `obstacle(v)` is a triangle at v that may not
  // stay so, -1 where none is, or `refused` where no direction would help.
  static constexpr int refused = -2;
  template <typename Obstacle>
  bool move(int v, const Obstacle& obstacle) {
    const Vector3 from = movable_.point(v);
    const Vector3 wish = in_plane(v, -movable_.volume_gradient(v)).stableNormalized();
    double& step = steps_[static_cast<std::size_t>(v)];
    std::vector<Vector3> contacts;
    bool has_moved = false;
    for (int slide = 0; slide < most_slides && !has_moved; ++slide) {
      const Vector3 direction = in_plane(v, along_contacts(wish, contacts));
      if (!(direction.norm() > tolerance::least_slide)) break;
      movable_.place(v, from + step * direction.normalized());
      const int in_the_way = obstacle(v);
      if (in_the_way == -1) {
        has_moved = true;
      } else {
        movable_.place(v, from);
        if (in_the_way == refused) break;
        contacts.push_back(movable_.normal(in_the_way));
      }
    }
    step = has_moved ? longer * step : std::max(shorter * step, least_step_);
    return has_moved;
  }

 private:
  Vector3 in_plane(int v, const Vector3& d) const {
    const Vector3 n = planes_.row(v);
    return d - n * n.dot(d);
  }

  MovableCage& movable_;
  const Points& planes_;
  double least_step_;
  std::vector<double> steps_;
};

int degenerate_at(const MovableCage& movable, int v) {
  for (const int t : movable.triangles_at(v))
    if (is_degenerate(movable.triangle(t))) return t;
  return -1;
}

long others_in_the_way(const MovableCage& movable, int v) {
  long count = 0;
  for (const int t : movable.triangles_at(v))
    count += movable.count_cage_hits(t) + movable.count_model_hits(t, Whose::others);
  return count;
}

void check_progress(const Progress& progress, int sweep, const char* what) {
  if (progress && !progress(static_cast<double>(sweep) / most_sweeps)) throw Error(ErrorCode::cancelled, what);
}

}  // namespace

bool untangle(MovableCage& movable, const Points& plane_normals, double diagonal, const Progress& progress) {
  Descent descent(movable, plane_normals, diagonal);
  const auto count = static_cast<int>(movable.points().rows());
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    check_progress(progress, sweep, "cancelled while the cage was untangled");
    bool is_clear = true;
    for (int v = 0; v < count; ++v) {
      const long before = others_in_the_way(movable, v);
      if (before == 0) continue;
      is_clear = false;
      descent.move(v, [&](int moved) {
        if (const int t = degenerate_at(movable, moved); t >= 0) return t;
        for (const int t : movable.triangles_at(moved))
          if (movable.hits_model(t, Whose::own)) return t;
        return others_in_the_way(movable, moved) <= before ? -1 : Descent::refused;
      });
    }
    if (is_clear) return true;
  }
  return false;
}

int tighten(MovableCage& movable, const Points& plane_normals, double diagonal, const Progress& progress) {
  Descent descent(movable, plane_normals, diagonal);
  const auto count = static_cast<int>(movable.points().rows());
  double volume = movable.volume();
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    check_progress(progress, sweep, "cancelled while the cage was tightened");
    for (int v = 0; v < count; ++v)
      descent.move(v, [&](int moved) {
        if (const int t = degenerate_at(movable, moved); t >= 0) return t;
        for (const int t : movable.triangles_at(moved))
          if (movable.hits_model(t, Whose::any) || movable.hits_cage(t)) return t;
        return -1;
      });
    const double now = movable.volume();
    if (volume - now <= tolerance::least_tightening * volume) return sweep + 1;
    volume = now;
  }
  return most_sweeps;
}

}  // namespace cagewright
