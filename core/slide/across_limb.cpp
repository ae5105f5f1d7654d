// SPDX-License-Identifier: BSD-3-Clause
#include "core/slide/across_limb.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "core/error/error.h"
#include "core/mesh/tolerance.h"
#include "core/slide/crossed_edges.h"
#include "core/slide/pivot.h"

namespace cagewright {
namespace {

using OpenMesh::HalfedgeHandle;

constexpr int turn_count = 12;          // directions to start from: round the surface's normal, within half a turn
constexpr int lean_count = 5;           // and towards and away from it
constexpr double lean_step = 0.35;      // radians
constexpr std::size_t most_turned = 3;  // of the starts
constexpr double steepest = 0.8;        // sine of the angle between a plane's normal and the surface
constexpr double longest_loop = 1.25;   // over the start's
constexpr double first_inertia = 0.1;   // of a direction; the variances beside it add up to at most 1
constexpr int rough_turns = 12, most_turns = 60;
constexpr double rough_turn = 1e-3, last_turn = 1e-10;  // radians

// The loop through the pivot, as far as it is of use here.
struct Loop {
  double length = 0;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  // covariance of the surface's normals along it
};

class Search {
 public:
  Search(const HalfEdgeMesh& mesh, const Pivot& pivot) : mesh_(mesh), pivot_(pivot) {}

  // Empty where no plane has a loop.
  std::optional<Vector3> run() const {
    std::optional<Vector3> best;
    double least = std::numeric_limits<double>::infinity();
    for (const Start& start : starts()) {
      const Vector3 turned = turn(start.normal, rough_turns, rough_turn);
      const double cost_of_turned = cost(turned, *loop_of(turned, false));
      if (cost_of_turned >= (1 - tolerance::tie) * least) continue;
      best = turned;
      least = cost_of_turned;
    }
    if (best) best = turn(*best, most_turns, last_turn);
    return best;
  }

 private:
  double height(OpenMesh::VertexHandle v, const Vector3& normal) const {
    return normal.dot(mesh_.point(v) - pivot_.point);
  }

  // The half-edge by which the loop leaves the pivot's triangle.
  std::optional<HalfedgeHandle> first_crossed(const Vector3& normal) const {
    HalfedgeHandle h = mesh_.halfedge_handle(pivot_.face);
    for (int i = 0; i < 3; ++i, h = mesh_.next_halfedge_handle(h))
      if (!is_ahead(height(mesh_.from_vertex_handle(h), normal)) && is_ahead(height(mesh_.to_vertex_handle(h), normal)))
        return h;
    return {};
  }

  // Empty where it does not run round solid material, or is shorter than rounding shows.
  std::optional<Loop> loop_of(const Vector3& normal, bool with_spread) const {
    const auto start = first_crossed(normal);
    if (!start) return {};
    Loop loop;
    double twice_area = 0;
    Vector3 sum = Vector3::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
    HalfedgeHandle h = *start;
    Vector3 from = mesh_.point(mesh_.from_vertex_handle(h)), to = mesh_.point(mesh_.to_vertex_handle(h));
    double behind = normal.dot(from - pivot_.point), ahead = normal.dot(to - pivot_.point);
    Vector3 crossing = crossing_point(from, behind, to, ahead);
    do {
      const Vector3& third = mesh_.point(third_vertex(mesh_, h));
      const double beyond = normal.dot(third - pivot_.point);
      const Vector3 before = crossing;
      Vector3 across = Vector3::Zero();
      if (with_spread) across = (to - from).cross(from - third);
      h = next_crossed(mesh_, h, beyond);
      (is_ahead(beyond) ? to : from) = third;
      (is_ahead(beyond) ? ahead : behind) = beyond;
      crossing = crossing_point(from, behind, to, ahead);
      const double length = (crossing - before).norm();
      loop.length += length;
      twice_area += normal.dot((before - pivot_.point).cross(crossing - pivot_.point));
      if (!with_spread || across.isZero(0)) continue;
      across.normalize();
      sum += length * across;
      squares += length * across * across.transpose();
    } while (h != *start);
    if (!(twice_area > 0)) return {};
    const Vector3 mean = sum / loop.length;
    loop.spread = squares / loop.length - mean * mean.transpose();
    return loop;
  }

  // A loop near the surface's tangent plane is short without being round a limb: on a sphere, by the cosine.
  double cost(const Vector3& normal, const Loop& loop) const {
    const double sine = normal.dot(pivot_.normal), squared_cosine = 1 - sine * sine;
    return loop.length / (squared_cosine * squared_cosine);
  }

  struct Start {
    Vector3 normal;
    double cost;
  };

  std::vector<Start> grid_of_starts() const {
    const Vector3 e1 = (pivot_.along - pivot_.along.dot(pivot_.normal) * pivot_.normal).normalized();
    const Vector3 e2 = pivot_.normal.cross(e1);
    std::vector<Start> grid;
    for (int k = 0; k < turn_count; ++k) {
      const double angle = std::numbers::pi * k / turn_count;
      const Vector3 level = std::cos(angle) * e1 + std::sin(angle) * e2;
      for (int i = 0; i < lean_count; ++i) {
        const double lean = lean_step * (i - lean_count / 2);
        const Vector3 normal = std::cos(lean) * level + std::sin(lean) * pivot_.normal;
        const auto loop = loop_of(normal, false);
        grid.push_back({normal, loop ? cost(normal, *loop) : std::numeric_limits<double>::infinity()});
      }
    }
    return grid;
  }

  // Those that cost no more than their neighbours, the cheapest first.
  std::vector<Start> starts() const {
    const std::vector<Start> grid = grid_of_starts();
    const auto cost_at = [&](int k, int i) {
      if (i < 0 || i >= lean_count) return std::numeric_limits<double>::infinity();
      const bool turned = k < 0 || k >= turn_count;  // half a turn on, the normal is the opposite one
      const int row = (k + turn_count) % turn_count, column = turned ? lean_count - 1 - i : i;
      return grid[static_cast<std::size_t>(row * lean_count + column)].cost;
    };
    std::vector<Start> least;
    for (int k = 0; k < turn_count; ++k)
      for (int i = 0; i < lean_count; ++i) {
        double around = std::numeric_limits<double>::infinity();
        for (int dk = -1; dk <= 1; ++dk)
          for (int di = -1; di <= 1; ++di) around = std::min(around, cost_at(k + dk, i + di));
        const Start& start = grid[static_cast<std::size_t>(k * lean_count + i)];
        if (std::isfinite(start.cost) && start.cost <= around) least.push_back(start);
      }
    std::stable_sort(least.begin(), least.end(), [](const Start& a, const Start& b) { return a.cost < b.cost; });
    if (least.size() > most_turned) least.resize(most_turned);
    return least;
  }

  // The direction along which the normals round the loop of `normal` spread least; `inertia` holds it to `normal`.
  static Vector3 least_spread(const Loop& loop, const Vector3& normal, double inertia) {
    const Eigen::Matrix3d held = inertia * (Eigen::Matrix3d::Identity() - normal * normal.transpose());
    const Vector3 axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(loop.spread + held).eigenvectors().col(0);
    return axis.dot(normal) < 0 ? Vector3(-axis) : axis;
  }

  // Turns the plane until that direction is its normal. Precondition: `normal` has a loop.
  Vector3 turn(Vector3 normal, int turns, double enough) const {
    Loop loop = *loop_of(normal, true);
    const double longest = longest_loop * loop.length;
    double inertia = first_inertia;
    Vector3 last = Vector3::Zero();
    for (int k = 0; k < turns; ++k) {
      const Vector3 next = least_spread(loop, normal, inertia);
      const Vector3 step = next - normal;
      if (step.dot(last) < -last.squaredNorm() / 4) inertia *= 2;  // it goes to and fro
      last = step;
      const bool is_steep = std::abs(next.dot(pivot_.normal)) > steepest;
      const auto next_loop = is_steep ? std::nullopt : loop_of(next, true);
      if (!next_loop || next_loop->length > longest) break;
      normal = next;
      loop = *next_loop;
      if (step.norm() <= enough) break;
    }
    return normal;
  }

  const HalfEdgeMesh& mesh_;
  const Pivot& pivot_;
};

// Away from the middle of the model; where that does not tell, along the edge.
bool points_outward(const Vector3& normal, const Pivot& pivot) {
  const Vector3 outward = pivot.point - pivot.middle;
  const double along = normal.dot(outward);
  if (std::abs(along) > tolerance::on_plane * outward.norm()) return along > 0;
  return normal.dot(pivot.along) > 0;
}

}  // namespace

PointNormalDefinition plane_across_limb(const HalfEdgeMesh& mesh, const PointDefinition& click,
                                        const std::string& name) {
  const Pivot pivot = find_pivot(mesh, click.point, name);
  const auto found = Search(mesh, pivot).run();
  if (!found)
    throw Error(ErrorCode::slide_not_enclosed,
                slide_text(name) + ": no plane cuts the model round its point " + to_text(click.point) +
                    ", which lies on an inside wall; put it on the outside of the limb to cut");
  const Vector3 normal = points_outward(*found, pivot) ? *found : Vector3(-*found);
  const Vector3 inward = -(pivot.normal - pivot.normal.dot(normal) * normal).normalized();
  return {pivot.point + tolerance::into_surface * pivot.diagonal * inward, normal};
}

}  // namespace cagewright
