// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/tighter_step.h"

#include <ceres/ceres.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <stdexcept>

namespace cagewright::host {
namespace {

template <class T>
using Vector = Eigen::Matrix<T, 3, 1>;

constexpr double penalties[] = {1e3, 1e4, 1e5, 1e6};  // over the volume's share, one solve after the other
constexpr double rounding = 0.05;     // of the penalty's corner, over the penalty: about what stays violated
constexpr double least_fold = -0.97;  // cosine between the normals of triangles that share an edge

// Where a vertex is after the step s, given in its own axes: of one that stays in a plane, the third is its normal.
struct Place {
  Eigen::Vector3d from;
  Eigen::Matrix3d axes;

  template <class T>
  Vector<T> at(const T* s) const {
    return from.cast<T>() + axes.cast<T>() * Eigen::Map<const Vector<T>>(s);
  }
};

// A penalty's square root: root * max(0, violation), its corner rounded, since Gauss-Newton steps overshoot a sharp
// one.
struct Hinge {
  double root;

  template <class T>
  T operator()(const T& violation) const {
    const double round = rounding / (root * root);
    return T(root / 2) * (violation + sqrt(violation * violation + T(round * round)));
  }
};

template <class T>
Vector<T> normal_of(const Vector<T>& a, const Vector<T>& b, const Vector<T>& c) {
  const Vector<T> n = (b - a).cross(c - a);
  return n / sqrt(n.squaredNorm() + T(1e-24));
}

struct BehindCost {
  Place a, b, c;
  Eigen::Vector3d point;
  double margin;
  Hinge hinge;

  template <class T>
  bool operator()(const T* sa, const T* sb, const T* sc, T* residual) const {
    const Vector<T> at = a.at(sa);
    const Vector<T> n = normal_of<T>(at, b.at(sb), c.at(sc));
    residual[0] = hinge(T(margin) - (at - point.cast<T>()).dot(n));
    return true;
  }
};

struct AboveCost {
  Place place;
  Eigen::Vector3d axis;
  double least;
  Hinge hinge;

  template <class T>
  bool operator()(const T* s, T* residual) const {
    residual[0] = hinge(T(least) - axis.cast<T>().dot(place.at(s)));
    return true;
  }
};

struct ApartCost {
  Place upper, lower;
  Eigen::Vector3d axis;
  double margin;
  Hinge hinge;

  template <class T>
  bool operator()(const T* su, const T* sl, T* residual) const {
    residual[0] = hinge(T(margin) - axis.cast<T>().dot(upper.at(su) - lower.at(sl)));
    return true;
  }
};

// Triangles (a, b, c) and (b, a, d).
struct FoldCost {
  Place a, b, c, d;
  Hinge hinge;

  template <class T>
  bool operator()(const T* sa, const T* sb, const T* sc, const T* sd, T* residual) const {
    const Vector<T> pa = a.at(sa), pb = b.at(sb);
    residual[0] = hinge(T(least_fold) - normal_of<T>(pa, pb, c.at(sc)).dot(normal_of<T>(pb, pa, d.at(sd))));
    return true;
  }
};

struct CornerCost {
  Place at, before, after;
  double most;
  Hinge hinge;

  template <class T>
  bool operator()(const T* s, const T* sb, const T* sa, T* residual) const {
    const Vector<T> here = at.at(s), one = before.at(sb) - here, other = after.at(sa) - here;
    const T cosine = one.dot(other) / sqrt(one.squaredNorm() * other.squaredNorm() + T(1e-24));
    residual[0] = hinge((cosine > T(0) ? cosine : -cosine) - T(most));
    return true;
  }
};

// The volume over what it was; the square of this is least where the volume is.
struct VolumeCost {
  const std::vector<Place>* places;
  const std::vector<Corners>* triangles;
  double scale;  // one over six times the volume

  template <class T>
  bool operator()(T const* const* steps, T* residual) const {
    std::vector<Vector<T>> x;
    for (std::size_t j = 0; j < places->size(); ++j) x.push_back((*places)[j].at(steps[j]));
    T sum(0);
    for (const Corners& t : *triangles) {
      sum += x[static_cast<std::size_t>(t[0])].dot(
          x[static_cast<std::size_t>(t[1])].cross(x[static_cast<std::size_t>(t[2])]));
    }
    residual[0] = T(scale) * sum;
    return true;
  }
};

struct RestraintCost {
  double root;

  template <class T>
  bool operator()(const T* s, T* residual) const {
    for (int i = 0; i < 3; ++i) residual[i] = T(root) * s[i];
    return true;
  }
};

class Step {
 public:
  Step(const TighterProblem& problem, const PointList& from, const Contacts& contacts, double restraint)
      : given_(problem), contacts_(contacts), restraint_(restraint), steps_(from.size(), {0, 0, 0}) {
    for (std::size_t j = 0; j < from.size(); ++j) {
      Place place{from[j], Eigen::Matrix3d::Identity()};
      if (const Eigen::Vector3d& n = problem.plane_normals[j]; !n.isZero()) {
        place.axes.col(0) = n.unitOrthogonal();
        place.axes.col(1) = n.cross(place.axes.col(0)).normalized();
        place.axes.col(2) = n;
      }
      places_.push_back(place);
    }
    scale_ = 1 / (6 * volume_of(from, problem.triangles));
  }

  PointList run() {
    for (const double penalty : penalties) solve(std::sqrt(penalty));
    PointList after;
    for (std::size_t j = 0; j < places_.size(); ++j) after.push_back(places_[j].at(steps_[j].data()));
    return after;
  }

 private:
  double* step(int j) { return steps_[static_cast<std::size_t>(j)].data(); }
  const Place& place(int j) const { return places_[static_cast<std::size_t>(j)]; }

  template <class Cost, int... sizes, class... Blocks>
  static void add(ceres::Problem& problem, Cost* cost, Blocks... blocks) {
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Cost, sizes...>(cost), nullptr, blocks...);
  }

  void solve(double root) {
    ceres::Problem problem;
    add_volume(problem);
    add_contacts(problem, root);
    add_shape(problem, root);
    for (std::size_t j = 0; j < steps_.size(); ++j) {
      if (given_.plane_normals[j].isZero()) continue;
      problem.SetManifold(steps_[j].data(), new ceres::SubsetManifold(3, {2}));
    }
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
    options.num_threads = 1;
    options.logging_type = ceres::SILENT;
    options.max_num_iterations = 30;
    options.function_tolerance = 1e-7;
    ceres::Solver::Summary summary;
    ceres::Solve(options, &problem, &summary);
    if (!summary.IsSolutionUsable()) throw std::runtime_error("Ceres on a tighter cage: " + summary.message);
  }

  void add_volume(ceres::Problem& problem) {
    auto* volume =
        new ceres::DynamicAutoDiffCostFunction<VolumeCost, 4>(new VolumeCost{&places_, &given_.triangles, scale_});
    std::vector<double*> blocks;
    for (std::array<double, 3>& s : steps_) {
      volume->AddParameterBlock(3);
      blocks.push_back(s.data());
      add<RestraintCost, 3, 3>(problem, new RestraintCost{std::sqrt(restraint_)}, s.data());
    }
    volume->SetNumResiduals(1);
    problem.AddResidualBlock(volume, nullptr, blocks);
  }

  void add_contacts(ceres::Problem& problem, double root) {
    for (const Contacts::Behind& c : contacts_.behind) {
      const Corners& t = given_.triangles[static_cast<std::size_t>(c.triangle)];
      add<BehindCost, 1, 3, 3, 3>(problem,
                                  new BehindCost{place(t[0]), place(t[1]), place(t[2]), c.point, given_.margin, {root}},
                                  step(t[0]), step(t[1]), step(t[2]));
    }
    for (const Contacts::Above& c : contacts_.above) {
      add<AboveCost, 1, 3>(problem, new AboveCost{place(c.vertex), c.axis, c.least + given_.margin, {root}},
                           step(c.vertex));
    }
    for (const Contacts::Apart& c : contacts_.apart) {
      add<ApartCost, 1, 3, 3>(problem, new ApartCost{place(c.upper), place(c.lower), c.axis, given_.margin, {root}},
                              step(c.upper), step(c.lower));
    }
  }

  void add_shape(ceres::Problem& problem, double root) {
    for (const TighterProblem::Corner& c : given_.corners) {
      add<CornerCost, 1, 3, 3, 3>(problem,
                                  new CornerCost{place(c.at), place(c.before), place(c.after), c.most, {0.1 * root}},
                                  step(c.at), step(c.before), step(c.after));
    }
    std::map<std::pair<int, int>, int> opposite;  // by directed edge: the third corner
    for (const Corners& t : given_.triangles)
      for (std::size_t i = 0; i < 3; ++i) opposite[{t[i], t[(i + 1) % 3]}] = t[(i + 2) % 3];
    for (const auto& [edge, c] : opposite) {
      const auto back = opposite.find({edge.second, edge.first});
      if (edge.first > edge.second || back == opposite.end()) continue;
      const int d = back->second;
      add<FoldCost, 1, 3, 3, 3, 3>(
          problem, new FoldCost{place(edge.first), place(edge.second), place(c), place(d), {0.01 * root}},
          step(edge.first), step(edge.second), step(c), step(d));
    }
  }

  const TighterProblem& given_;
  const Contacts& contacts_;
  double restraint_, scale_ = 1;
  std::vector<Place> places_;
  std::vector<std::array<double, 3>> steps_;  // Ceres holds its addresses
};

}  // namespace

PointList tighter_step(const TighterProblem& problem, const PointList& from, const Contacts& contacts,
                       double restraint) {
  return Step(problem, from, contacts, restraint).run();
}

double volume_of(const PointList& vertices, const std::vector<Corners>& triangles) {
  double sum = 0;
  for (const Corners& t : triangles) {
    sum += vertices[static_cast<std::size_t>(t[0])].dot(
        vertices[static_cast<std::size_t>(t[1])].cross(vertices[static_cast<std::size_t>(t[2])]));
  }
  return sum / 6;
}

}  // namespace cagewright::host
