// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/push_out.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/enclose/find_contacts.h"
#include "core/enclose/own_outside.h"
#include "core/enclose/solve_step.h"
#include "core/enclose/triangle_distance.h"
#include "core/error/error.h"
#include "core/mesh/tolerance.h"
#include "core/parallel/parallel_for.h"

namespace cagewright {
namespace {

using Whose = MovableCage::Whose;

constexpr int fields = 5;          // along each side of a triangle: in each the farthest vertex counts
constexpr double softness = 0.05;  // of what is wanted, against what has to be

class Pushing {
 public:
  Pushing(const MovableCage& movable, const PushOptions& options, double margin)
      : movable_(movable), options_(options), margin_(margin), walls_(movable.segmentation().parts.size()) {
    for (int t = 0; t < movable.triangle_count(); ++t)
      walls_[static_cast<std::size_t>(movable.cage().triangle_part[static_cast<std::size_t>(t)])].push_back(t);
  }

  // Conditions that bring in what is outside.
  Contacts inward(const Outside& outside, const VertexNeighbours& neighbours) const {
    std::vector<int> out;
    for (std::size_t v = 0; v < outside.vertices.size(); ++v)
      if (outside.vertices[v]) out.push_back(static_cast<int>(v));
    std::vector<OnWall> on_wall(out.size());
    parallel_for(out.size(), options_.threads, [&](std::size_t i) { on_wall[i] = nearest_wall(out[i], neighbours); });
    std::vector<Farthest> farthest(static_cast<std::size_t>(movable_.triangle_count()) * fields * fields);
    for (std::size_t i = 0; i < out.size(); ++i)
      if (on_wall[i].wall >= 0) offer(movable_.model().points.row(out[i]), on_wall[i], farthest);
    Contacts contacts;
    for (std::size_t i = 0; i < farthest.size(); ++i)
      if (farthest[i].distance >= 0) contacts.push_back(contact(static_cast<int>(i / (fields * fields)), farthest[i]));
    for (int t = 0; t < movable_.triangle_count(); ++t)
      for (const int k : outside.meeting[static_cast<std::size_t>(t)]) add_pierced(t, k, outside, contacts);
    return contacts;
  }

 private:
  struct Farthest {
    double distance = -1;
    Vector3 weights, n;
  };
  struct OnWall {
    int wall = -1;
    double squared = std::numeric_limits<double>::infinity();  // distance
    Vector3 weights;
  };

  Contact contact(int t, const Farthest& far) const {
    Contact contact = contact_of(movable_, t, far.weights, far.n, far.distance + margin_);
    contact.softness = softness;
    return contact;
  }

  std::vector<int> parts_of(int v, const VertexNeighbours& neighbours) const {
    std::vector<int> parts;
    for (int i = neighbours.first[static_cast<std::size_t>(v)]; i < neighbours.first[static_cast<std::size_t>(v) + 1];
         ++i)
      parts.push_back(movable_.segmentation()
                          .triangle_part[static_cast<std::size_t>(neighbours.triangles[static_cast<std::size_t>(i)])]);
    const int k = neighbours.triangles[static_cast<std::size_t>(neighbours.first[static_cast<std::size_t>(v)])];
    const auto beyond = movable_.parts_beyond(k);
    parts.insert(parts.end(), beyond.begin(), beyond.end());
    std::sort(parts.begin(), parts.end());
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    return parts;
  }

  OnWall nearest_wall(int v, const VertexNeighbours& neighbours) const {
    const Vector3 p = movable_.model().points.row(v);
    OnWall nearest;
    for (const int part : parts_of(v, neighbours))
      for (const int t : walls_[static_cast<std::size_t>(part)]) {
        if (movable_.box(t).squaredExteriorDistance(p) >= nearest.squared) continue;
        const Triangle3 corners = movable_.triangle(t);
        const Vector3 here = nearest_on_triangle(p, corners);
        const double squared = (at_barycentric(corners, here) - p).squaredNorm();
        if (squared < nearest.squared) nearest = {t, squared, here};
      }
    return nearest;
  }

  void offer(const Vector3& p, const OnWall& nearest, std::vector<Farthest>& farthest) const {
    const auto& [wall, squared, weights] = nearest;
    const double distance = std::sqrt(squared);
    const Vector3 normal = movable_.normal(wall);
    Vector3 n = p - at_barycentric(movable_.triangle(wall), weights);
    n = distance > 0.1 * margin_ && n.dot(normal) > 0 ? Vector3(n / distance) : normal;
    const auto field = [](double share) { return std::min(fields - 1, static_cast<int>(share * fields)); };
    Farthest& far =
        farthest[static_cast<std::size_t>((wall * fields + field(weights[1])) * fields + field(weights[2]))];
    if (distance > far.distance) far = {distance, weights, n};
  }

  // A model triangle that no vertex tells about: it meets an edge of the cage that points inward, or it belongs to
  // another part, which the triangle then has to draw back from.
  void add_pierced(int t, int k, const Outside& outside, Contacts& contacts) const {
    constexpr double faces = -0.25;  // cosine: a model triangle turned towards the cage's from outside
    const bool is_own = movable_.is_own(t, k);
    const auto& triangles = movable_.model().triangles;
    if (is_own)
      for (int i = 0; i < 3; ++i)
        if (outside.vertices[static_cast<std::size_t>(triangles(k, i))]) return;
    const Triangle3 corners = movable_.triangle(t), model = triangle_of(movable_.model(), k);
    const Vector3 middle = (model[0] + model[1] + model[2]) / 3, wall_normal = movable_.normal(t);
    const Vector3 model_normal = unit_normal(model);
    const Vector3 n = is_own && wall_normal.dot(model_normal) > faces ? wall_normal : model_normal;
    contacts.push_back(contact(t, {10 * margin_, nearest_on_triangle(middle, corners), n}));
  }

  const MovableCage& movable_;
  const PushOptions& options_;
  double margin_;
  std::vector<std::vector<int>> walls_;  // of each part
};

long amount_missing(const Outside& outside) {
  long amount = std::count(outside.vertices.begin(), outside.vertices.end(), 1);
  for (const std::vector<int>& meeting : outside.meeting) amount += static_cast<long>(meeting.size());
  return amount;
}

// Cage and model triangles that are nearer to each other than the clearance, ascending.
std::vector<std::pair<int, int>> find_too_near(const MovableCage& movable, const PushOptions& options) {
  std::vector<std::vector<std::pair<int, int>>> found(static_cast<std::size_t>(movable.triangle_count()));
  parallel_for(found.size(), options.threads, [&](std::size_t t) {
    movable.visit_hits(static_cast<int>(t), options.own_only ? Whose::own : Whose::any, options.clearance, [&](int k) {
      if (!options.own_only || movable.is_of_part(static_cast<int>(t), k))
        found[t].emplace_back(static_cast<int>(t), k);
      return false;
    });
    std::sort(found[t].begin(), found[t].end());
  });
  std::vector<std::pair<int, int>> all;
  for (const auto& pairs : found) all.insert(all.end(), pairs.begin(), pairs.end());
  return all;
}

}  // namespace

int push_out(MovableCage& movable, const SectionShape& shape, const VertexNeighbours& neighbours,
             const std::vector<int>& vertex_owners, const PushOptions& options, const Progress& progress) {
  const auto count = static_cast<std::size_t>(movable.triangle_count());
  Guard guard{options.guarded, std::vector<double>(count, options.gap), options.gap, {}, options.threads,
              options.own_only};
  StepProblem problem;
  problem.pull = Points::Zero(movable.vertex_count(), 3);
  problem.mobility.assign(static_cast<std::size_t>(movable.vertex_count()), 1);
  problem.plane_normals = shape.plane_normals();
  problem.longest = tolerance::longest_push * options.diagonal;
  long fewest = std::numeric_limits<long>::max();
  int last_gain = 0;
  for (int step = 0; step < options.most; ++step) {
    if (progress && !progress(static_cast<double>(step) / options.most))
      throw Error(ErrorCode::cancelled, "cancelled while the cage was pushed out");
    const Outside outside = options.own_only ? find_own_outside(movable, neighbours, options.gap, options.threads)
                                             : find_outside(movable, neighbours, options.gap, options.threads);
    std::vector<std::pair<int, int>> too_near = find_too_near(movable, options);
    if (outside.none && too_near.empty()) return step;
    if (const long missing = amount_missing(outside) + static_cast<long>(too_near.size()); missing < fewest) {
      fewest = missing;
      last_gain = step;
    }
    if (step - last_gain > options.patience) return options.most;
    // A little farther every time, as a step is right to first order only.
    const double margin = tolerance::push_margin * (1 + step) * options.diagonal;
    ContactQuery query{std::vector<double>(count, options.clearance + 0.1 * margin),
                       2 * options.gap,
                       problem.longest,
                       std::move(too_near),
                       &outside.vertices,
                       &outside.meeting,
                       options.threads,
                       options.own_only};
    // What has to be comes last: the solver then gives it the last word.
    Contacts contacts = Pushing(movable, options, margin).inward(outside, neighbours);
    Contacts others = find_contacts(movable, vertex_owners, query);
    for (Contact& contact : others) contact.softness = contact.least > 0 ? softness : 0;
    contacts.insert(contacts.end(), others.begin(), others.end());
    for (Contact& contact : contacts) contact.least = std::min(contact.least, problem.longest);
    shape.add_contacts(movable.points(), contacts);
    guard.exempt.assign(count, 0);
    guard.exempt = find_objections(movable, guard);
    StepSolver solver(problem);
    solver.add(contacts);
    const GuardedMove moved = move_guarded(movable, shape, solver, guard, 0.1 * margin);
    problem.longest *= moved.share < 0.95 ? 0.7 : 1.3;
    problem.longest = std::clamp(problem.longest, 0.02 * tolerance::longest_push * options.diagonal,
                                 tolerance::longest_push * options.diagonal);
  }
  return options.most;
}

}  // namespace cagewright
