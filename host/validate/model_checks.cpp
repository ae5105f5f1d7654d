// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/model_checks.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace cagewright::host {
namespace {

struct Sums {
  double area = 0, volume = 0;

  void add(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
    area += (b - a).cross(c - a).norm() / 2;
    volume += a.dot(b.cross(c)) / 6;
  }
};

double solid_angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const double la = a.norm(), lb = b.norm(), lc = c.norm();
  return 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}

}  // namespace

Check check_segmentation(const ObservedCage& seen, const TriangleMesh& model, bool is_turned) {
  Check check{"segment", "the cut model is the model, and what was added lies on the planes of slides", 1e-9,
              "relative"};
  const PointList given = to_points(model.points);
  const Eigen::Vector3d origin = given.empty() ? Eigen::Vector3d::Zero() : given.front();
  Sums before, after;
  for (std::size_t t = 0; t < model.triangle_count(); ++t) {
    const std::uint32_t* corners = &model.triangles[3 * t];
    before.add(given[corners[0]] - origin, given[corners[1]] - origin, given[corners[2]] - origin);
  }
  for (const Corners& t : seen.model_triangles) {
    const auto corner = [&](std::size_t i) -> Eigen::Vector3d {
      return seen.model[static_cast<std::size_t>(t[i])] - origin;
    };
    after.add(corner(0), corner(1), corner(2));
  }
  check.offer(std::abs(after.area / before.area - 1), [&] {
    return "the cut model's area is " + text_of(after.area) + ", the model's " + text_of(before.area);
  });
  // Of triangles that face either way the sum is no volume.
  check.offer(is_turned ? 0 : std::abs(after.volume / std::abs(before.volume) - 1), [&] {
    return "the cut model's volume is " + text_of(after.volume) + ", the model's " + text_of(before.volume);
  });
  std::set<std::array<double, 3>> known;
  for (const Eigen::Vector3d& v : given) known.insert({v.x(), v.y(), v.z()});
  for (std::size_t i = 0; i < seen.model.size(); ++i) {
    const Eigen::Vector3d& v = seen.model[i];
    if (known.contains({v.x(), v.y(), v.z()})) continue;
    double nearest = std::numeric_limits<double>::infinity();
    for (const ObservedSection& s : seen.sections) {
      nearest = std::min(nearest, std::abs((v - s.center).dot(s.normal)) / seen.diagonal);
    }
    check.offer(nearest, [&] {
      return "vertex " + std::to_string(i) + " of the cut model at " + text_of(v) +
             " is neither the model's nor on the plane of a slide";
    });
  }
  return check;
}

Check check_enclosing(const ObservedCage& seen) {
  Check check{"enclose",
              "a cage that is called enclosing winds round every vertex of the model, a whole number of times", 1e-6,
              "turns"};
  if (!seen.certified) return check;
  for (std::size_t i = 0; i < seen.model.size(); ++i) {
    const Eigen::Vector3d& v = seen.model[i];
    double angle = 0;
    for (const Corners& t : seen.triangles) {
      angle += solid_angle(seen.vertices[static_cast<std::size_t>(t[0])] - v,
                           seen.vertices[static_cast<std::size_t>(t[1])] - v,
                           seen.vertices[static_cast<std::size_t>(t[2])] - v);
    }
    const double turns = angle / (4 * std::numbers::pi);
    check.offer(std::abs(turns - std::max(1.0, std::round(turns))), [&] {
      return "the cage is called enclosing, but winds " + text_of(turns) + " times round vertex " + std::to_string(i) +
             " of the cut model at " + text_of(v);
    });
  }
  return check;
}

}  // namespace cagewright::host
