// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/guarded_move.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "core/enclose/find_contacts.h"
#include "core/enclose/triangle_distance.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {
namespace {

constexpr int halvings = 5;  // of a step, then it is taken back

struct Objection {
  bool any = false;
  int model_triangle = -1, cage_triangle = -1;
};

Objection objection_to(const MovableCage& movable, const Guard& guard, int t) {
  if (guard.exempt[static_cast<std::size_t>(t)]) return {};
  if (is_degenerate(movable.triangle(t))) return {true, -1, -1};
  if (!guard.through_cage)
    if (const int other = movable.hit_of_cage(t, guard.gap); other >= 0) return {true, -1, other};
  const int k = movable.hit_of_model(t, guard.whose, guard.clearance[static_cast<std::size_t>(t)]);
  return {k >= 0, k, -1};
}

class Moving {
 public:
  Moving(MovableCage& movable, const SectionShape& shape, const Points& step, const Guard& guard)
      : movable_(movable), shape_(shape), step_(step), guard_(guard), from_(movable.points()) {
    const auto count = static_cast<std::size_t>(step.rows());
    taken_.assign(count, 0);
    halved_.assign(count, 0);
    for (Eigen::Index v = 0; v < step.rows(); ++v)
      if (!step.row(v).isZero(0)) taken_[static_cast<std::size_t>(v)] = 1;
  }

  GuardedMove run() {
    GuardedMove result;
    const auto to_move = std::count(taken_.begin(), taken_.end(), 1.0);
    if (to_move == 0) return result;
    std::vector<char> changed(taken_.size(), 0);
    for (std::size_t v = 0; v < changed.size(); ++v) changed[v] = taken_[v] > 0;
    place(changed);
    std::vector<char> looked_at = triangles_at(changed);
    for (;;) {
      changed = shorten(looked_at, result.hits);
      if (std::find(changed.begin(), changed.end(), 1) == changed.end()) break;
      place(changed);
      looked_at = triangles_at(changed);
    }
    for (const double share : taken_) result.share += share;
    result.share /= static_cast<double>(to_move);
    std::sort(result.hits.begin(), result.hits.end());
    result.hits.erase(std::unique(result.hits.begin(), result.hits.end()), result.hits.end());
    return result;
  }

 private:
  void place(const std::vector<char>& changed) {
    Points points = movable_.points();
    for (std::size_t v = 0; v < changed.size(); ++v) {
      if (!changed[v]) continue;
      const auto row = static_cast<Eigen::Index>(v);
      points.row(row) = from_.row(row);
      if (taken_[v] > 0) points.row(row) += taken_[v] * step_.row(row);
    }
    shape_.put_in_plane(points, changed);
    for (std::size_t v = 0; v < changed.size(); ++v)
      if (changed[v]) {
        const auto row = static_cast<Eigen::Index>(v);
        movable_.place(static_cast<int>(v), taken_[v] > 0 ? Vector3(points.row(row)) : Vector3(from_.row(row)));
      }
  }

  std::vector<char> triangles_at(const std::vector<char>& changed) const {
    std::vector<char> found(static_cast<std::size_t>(movable_.triangle_count()), 0);
    for (std::size_t v = 0; v < changed.size(); ++v)
      if (changed[v])
        for (const int t : movable_.triangles_at(static_cast<int>(v))) found[static_cast<std::size_t>(t)] = 1;
    return found;
  }

  void shorten_vertex(int v, std::vector<char>& changed) {
    const auto i = static_cast<std::size_t>(v);
    if (changed[i] || taken_[i] == 0) return;
    taken_[i] = ++halved_[i] > halvings ? 0 : taken_[i] / 2;
    changed[i] = 1;
  }

  std::vector<char> shorten(const std::vector<char>& looked_at, std::vector<std::pair<int, int>>& hits) {
    std::vector<Objection> objections(looked_at.size());
    parallel_for(looked_at.size(), guard_.threads, [&](std::size_t t) {
      if (looked_at[t]) objections[t] = objection_to(movable_, guard_, static_cast<int>(t));
    });
    std::vector<char> changed(taken_.size(), 0);
    const auto shorten_triangle = [&](int t) {
      for (int i = 0; i < 3; ++i) shorten_vertex(movable_.vertex_of(t, i), changed);
    };
    for (std::size_t t = 0; t < objections.size(); ++t) {
      if (!objections[t].any) continue;
      shorten_triangle(static_cast<int>(t));
      if (objections[t].cage_triangle >= 0) shorten_triangle(objections[t].cage_triangle);
      if (objections[t].model_triangle >= 0) hits.emplace_back(static_cast<int>(t), objections[t].model_triangle);
    }
    for (int k = 0; k < shape_.section_count(); ++k)
      if (!shape_.is_sound(k, movable_.points()))
        for (int i = 0; i < 4; ++i) shorten_vertex(shape_.corner(k, i), changed);
    return changed;
  }

  MovableCage& movable_;
  const SectionShape& shape_;
  const Points& step_;
  const Guard& guard_;
  const Points from_;
  std::vector<double> taken_;  // share of each vertex's step
  std::vector<int> halved_;
};

// Of the model triangle k that cage triangle t, where it is now, runs into: conditions on the step from `from` that
// keep k's vertices behind t.
void add_contacts_of_hit(const MovableCage& movable, const Points& from, int t, int k, double clearance,
                         Contacts& contacts) {
  constexpr double beside = -0.05;
  const Triangle3 wall = movable.triangle(t), model = triangle_of(movable.model(), k);
  const Vector3 across = (wall[1] - wall[0]).cross(wall[2] - wall[0]), n = across.stableNormalized();
  Triangle3 before;
  for (int i = 0; i < 3; ++i) before[static_cast<std::size_t>(i)] = from.row(movable.vertex_of(t, i));
  const auto add = [&](const Vector3& weights, const Vector3& direction, const Vector3& p) {
    contacts.push_back(
        contact_of(movable, t, weights, direction, clearance - direction.dot(at_barycentric(before, weights) - p)));
  };
  bool any = false;
  for (const Vector3& p : model) {
    if (n.dot(p - wall[0]) < -clearance) continue;
    Vector3 weights;
    for (int i = 0; i < 3; ++i) {
      const Vector3& a = wall[static_cast<std::size_t>((i + 1) % 3)];
      weights[i] = n.dot((wall[static_cast<std::size_t>((i + 2) % 3)] - a).cross(p - a)) / across.norm();
    }
    if (!(weights.minCoeff() >= beside)) continue;
    add(weights.cwiseMax(0) / weights.cwiseMax(0).sum(), n, p);
    any = true;
  }
  if (any) return;
  const NearestPoints nearest = nearest_points(before, model);
  const Vector3 apart = at_barycentric(before, nearest.on_s) - at_barycentric(model, nearest.on_t);
  if (nearest.distance > 0) add(nearest.on_s, apart / nearest.distance, at_barycentric(model, nearest.on_t));
}

// Tells what is in the way of triangles that move from `from` to where they are, of those alone that have moved since
// it was last asked or that something was in the way of.
class Obstacles {
 public:
  Obstacles(const MovableCage& movable, const Points& from, const Guard& guard, double slack)
      : movable_(movable),
        from_(from),
        guard_(guard),
        slack_(slack),
        last_(from),
        is_clear_(static_cast<std::size_t>(movable.triangle_count()), 1) {}

  Contacts find() {
    std::vector<Contacts> found(is_clear_.size());
    parallel_for(is_clear_.size(), guard_.threads, [&](std::size_t t) {
      if (!guard_.exempt[t] && (!is_clear_[t] || has_moved(static_cast<int>(t)))) look(static_cast<int>(t), found[t]);
    });
    last_ = movable_.points();
    Contacts all;
    for (const Contacts& contacts : found) all.insert(all.end(), contacts.begin(), contacts.end());
    return all;
  }
  bool is_clear() const { return std::find(is_clear_.begin(), is_clear_.end(), 0) == is_clear_.end(); }

 private:
  bool has_moved(int t) const {
    for (int i = 0; i < 3; ++i) {
      const int v = movable_.vertex_of(t, i);
      if (movable_.points().row(v) != last_.row(v)) return true;
    }
    return false;
  }
  void look(int t, Contacts& contacts) {
    const auto i = static_cast<std::size_t>(t);
    is_clear_[i] = !is_degenerate(movable_.triangle(t)) && (guard_.through_cage || !movable_.hits_cage(t, guard_.gap));
    movable_.visit_hits(t, guard_.whose, guard_.clearance[i], [&](int k) {
      add_contacts_of_hit(movable_, from_, t, k, guard_.clearance[i] + slack_, contacts);
      is_clear_[i] = 0;
      return false;
    });
  }

  const MovableCage& movable_;
  const Points& from_;
  const Guard& guard_;
  double slack_;
  Points last_;
  std::vector<char> is_clear_;
};

}  // namespace

std::vector<char> find_objections(const MovableCage& movable, const Guard& guard) {
  std::vector<char> found(static_cast<std::size_t>(movable.triangle_count()), 0);
  parallel_for(found.size(), guard.threads,
               [&](std::size_t t) { found[t] = objection_to(movable, guard, static_cast<int>(t)).any; });
  return found;
}

GuardedMove move_guarded(MovableCage& movable, const SectionShape& shape, const Points& step, const Guard& guard) {
  return Moving(movable, shape, step, guard).run();
}

GuardedMove move_guarded(MovableCage& movable, const SectionShape& shape, StepSolver& solver, const Guard& guard,
                         double slack) {
  constexpr int attempts = 4, sweeps = 60;
  const Points from = movable.points();
  Obstacles obstacles(movable, from, guard, slack);
  Points step = solver.solve(sweeps);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    Points to = from + step;
    shape.put_in_plane(to);
    movable.place_all(to);
    const Contacts contacts = obstacles.find();
    bool is_clear = obstacles.is_clear();
    for (int k = 0; k < shape.section_count(); ++k) is_clear = is_clear && shape.is_sound(k, to);
    if (is_clear) return {1, {}};
    if (contacts.empty()) break;
    solver.add(contacts);
    const Points again = solver.solve(sweeps / 2);
    for (Eigen::Index v = 0; v < step.rows(); ++v)
      if ((again.row(v) - step.row(v)).norm() > slack) step.row(v) = again.row(v);  // what hardly changes stays
  }
  movable.place_all(from);
  return move_guarded(movable, shape, step, guard);
}

}  // namespace cagewright
