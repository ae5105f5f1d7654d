// SPDX-License-Identifier: BSD-3-Clause
#include "core/tests/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace cagewright::shapes {
namespace {

constexpr double flattening = 0.75;  // along y
constexpr double blend = 0.08;

class Marcher {
 public:
  Marcher(const std::function<double(const Vector3&)>& field, const Eigen::AlignedBox3d& box, double cell)
      : field_(field), origin_(box.min()), cell_(cell) {
    for (int k = 0; k < 3; ++k) size_[k] = static_cast<int>(std::ceil(box.sizes()[k] / cell)) + 1;
    values_.resize(static_cast<std::size_t>(size_[0]) * size_[1] * size_[2]);
    for (int i = 0; i < static_cast<int>(values_.size()); ++i) values_[static_cast<std::size_t>(i)] = field_(node(i));
  }

  IndexedMesh run() {
    // The six tetrahedra of a cube round its diagonal: from corner 0 one axis after the other to corner 7.
    const std::array<std::array<int, 3>, 6> orders = {
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    for (int x = 0; x + 1 < size_[0]; ++x)
      for (int y = 0; y + 1 < size_[1]; ++y)
        for (int z = 0; z + 1 < size_[2]; ++z)
          for (const auto& order : orders) {
            std::array<int, 3> at = {x, y, z};
            std::array<int, 4> corners = {index(at), 0, 0, 0};
            for (std::size_t step = 0; step < 3; ++step) {
              ++at[static_cast<std::size_t>(order[step])];
              corners[step + 1] = index(at);
            }
            add_tetrahedron(corners);
          }
    IndexedMesh mesh{Points(static_cast<Eigen::Index>(points_.size()), 3),
                     Triangles(static_cast<Eigen::Index>(triangles_.size()), 3)};
    for (std::size_t i = 0; i < points_.size(); ++i)
      mesh.points.row(static_cast<Eigen::Index>(i)) = points_[i].transpose();
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      mesh.triangles.row(static_cast<Eigen::Index>(t)) << triangles_[t][0], triangles_[t][1], triangles_[t][2];
    return mesh;
  }

 private:
  int index(const std::array<int, 3>& at) const { return (at[0] * size_[1] + at[1]) * size_[2] + at[2]; }
  Vector3 node(int i) const {
    return origin_ + cell_ * Vector3(i / size_[2] / size_[1], i / size_[2] % size_[1], i % size_[2]);
  }
  double value(int i) const { return values_[static_cast<std::size_t>(i)]; }

  int point_between(int inside, int outside) {
    const auto [entry, is_new] = point_of_edge_.try_emplace({inside, outside}, static_cast<int>(points_.size()));
    if (is_new) {
      const double share = std::clamp(value(inside) / (value(inside) - value(outside)), 0.02, 0.98);
      points_.push_back(node(inside) + share * (node(outside) - node(inside)));
    }
    return entry->second;
  }

  void add_triangle(int a, int b, int c, const Vector3& outward) {
    const auto at = [&](int i) -> const Vector3& { return points_[static_cast<std::size_t>(i)]; };
    if ((at(b) - at(a)).cross(at(c) - at(a)).dot(outward) < 0) std::swap(b, c);
    triangles_.push_back({a, b, c});
  }

  void add_tetrahedron(const std::array<int, 4>& corners) {
    std::vector<int> in, out;
    for (int c : corners) (value(c) < 0 ? in : out).push_back(c);
    if (in.empty() || out.empty()) return;
    Vector3 outward = Vector3::Zero();
    for (int c : out) outward += node(c) / static_cast<double>(out.size());
    for (int c : in) outward -= node(c) / static_cast<double>(in.size());
    std::vector<int> ring;  // in order round the cut
    if (in.size() == 2)
      ring = {point_between(in[0], out[0]), point_between(in[0], out[1]), point_between(in[1], out[1]),
              point_between(in[1], out[0])};
    else
      for (int a : in)
        for (int b : out) ring.push_back(point_between(a, b));
    for (std::size_t i = 2; i < ring.size(); ++i) add_triangle(ring[0], ring[i - 1], ring[i], outward);
  }

  const std::function<double(const Vector3&)>& field_;
  Vector3 origin_;
  double cell_;
  std::array<int, 3> size_{};
  std::vector<double> values_;
  std::map<std::pair<int, int>, int> point_of_edge_;
  std::vector<Vector3> points_;
  std::vector<std::array<int, 3>> triangles_;
};

double distance_to(const Tube& tube, const Vector3& p) {
  const Vector3 axis = tube.to - tube.from;
  const double t = std::clamp(axis.dot(p - tube.from) / axis.squaredNorm(), 0.0, 1.0);
  return (tube.from + t * axis - p).norm() - tube.radius;
}

Vector3 flattened(Vector3 p) {
  p.y() *= flattening;
  return p;
}

SlidBody slid(const std::string& name, const std::vector<Tube>& tubes, long genus) {
  return {name, body_of(tubes, 0.11), {}, genus};
}

void add_slides(SlidBody& body, const Tube& tube, const std::vector<double>& shares) {
  for (double share : shares)
    body.slides.push_back(slide_across("slide " + std::to_string(body.slides.size()), tube, share));
}

std::vector<double> spread(int count, double first, double last) {
  std::vector<double> shares;
  for (int i = 0; i < count; ++i)
    shares.push_back(first + (last - first) * (count == 1 ? 0.5 : double(i) / (count - 1)));
  return shares;
}

std::vector<Tube> ring_tubes(int count) {
  std::vector<Vector3> corners;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count + 0.3;
    corners.emplace_back(1.6 * std::cos(angle), 0.1 * std::sin(2 * angle), 1.5 * std::sin(angle));
  }
  std::vector<Tube> tubes;
  for (int i = 0; i < count; ++i) tubes.push_back({corners[i], corners[(i + 1) % count], 0.36 + 0.02 * (i % 3)});
  return tubes;
}

}  // namespace

IndexedMesh surface_of(const std::function<double(const Vector3&)>& field, const Eigen::AlignedBox3d& box,
                       double cell) {
  return Marcher(field, box, cell).run();
}

IndexedMesh body_of(const std::vector<Tube>& tubes, double cell) {
  Eigen::AlignedBox3d box;
  for (const Tube& tube : tubes)
    for (const Vector3& end : {tube.from, tube.to}) {
      box.extend(Vector3(end + Vector3::Constant(1.3 * tube.radius + 2 * cell)));
      box.extend(Vector3(end - Vector3::Constant(1.3 * tube.radius + 2 * cell)));
    }
  const auto field = [&](const Vector3& p) {
    double sum = 0;
    for (const Tube& tube : tubes) sum += std::exp(-distance_to(tube, p) / blend);
    const double bumps = std::sin(5.1 * p.x() + 0.3) * std::sin(4.3 * p.y() + 1.1) * std::sin(4.7 * p.z() + 0.7);
    return -blend * std::log(sum) + 0.02 * bumps;
  };
  IndexedMesh mesh = surface_of(field, box, cell);
  mesh.points.col(1) *= flattening;
  return mesh;
}

Slide slide_across(const std::string& name, const Tube& tube, double share) {
  const Vector3 from = flattened(tube.from), to = flattened(tube.to);
  return {name, PointNormalDefinition{from + share * (to - from), to - from}};
}

SlidBody limb(int slides) {
  const Tube tube{{-1.4, 0.2, -0.3}, {1.5, -0.1, 0.4}, 0.5};
  SlidBody body = slid("limb", {tube}, 0);
  add_slides(body, tube, spread(slides, 0.1, 0.9));
  return body;
}

SlidBody fork(int slides_on_each_arm) {
  const Vector3 center(0.05, -0.03, 0.02);
  const std::vector<Tube> arms = {
      {center, {1.9, 0.15, 0.2}, 0.38}, {center, {-1.1, 0.1, 1.5}, 0.42}, {center, {-0.9, -0.2, -1.6}, 0.4}};
  SlidBody body = slid("fork", arms, 0);
  for (const Tube& arm : arms) add_slides(body, arm, spread(slides_on_each_arm, 0.45, 0.85));
  return body;
}

SlidBody ring(int slides) {
  const std::vector<Tube> tubes = ring_tubes(12);
  SlidBody body = slid("ring", tubes, 1);
  for (int i = 0; i < slides; ++i) add_slides(body, tubes[static_cast<std::size_t>(12 * i / slides)], {0.45});
  return body;
}

SlidBody figure() {
  const Vector3 chest(0.03, 0, 1.1), hip(-0.02, 0.05, 0);
  const Tube trunk{hip, chest, 0.5}, head{{0.03, 0, 1.6}, {0.1, 0.05, 2.2}, 0.3};
  const Tube left{{0.3, 0, 1.1}, {1.7, 0.2, 1.3}, 0.25}, right{{-0.3, 0, 1.1}, {-1.7, -0.1, 0.9}, 0.27};
  const Tube left_leg{{0.3, 0, -0.2}, {0.42, 0.1, -1.9}, 0.27}, right_leg{{-0.35, 0.1, -0.2}, {-0.45, 0, -1.9}, 0.25};
  SlidBody body = slid("figure", {trunk, head, left, right, left_leg, right_leg}, 0);
  add_slides(body, head, {0.1});
  add_slides(body, left, {0.4, 0.8});
  add_slides(body, right, {0.4});
  add_slides(body, left_leg, {0.35, 0.75});
  add_slides(body, right_leg, {0.4});
  return body;
}

SlidBody close_legs(double gap) {
  const Tube trunk{{0, 0.05, 0}, {0.03, 0, 1.1}, 0.55};
  const Tube left{{0.45, 0, -0.2}, {0.6, 0.05, -2.2}, 0.27}, right{{-0.45, 0.05, -0.2}, {-0.6, 0, -2.2}, 0.27};
  SlidBody body = slid("close legs", {trunk, left, right}, 0);
  add_slides(body, trunk, {0.6});
  add_slides(body, left, {0.3, 0.75});
  add_slides(body, right, {0.3, 0.78});
  const auto share = [](double z) { return std::clamp((-0.9 - z) / 0.3, 0.0, 1.0); };
  const Points before = body.mesh.points;
  // How far the leg on p's side is from the middle plane, at p's height: so that its inner side becomes straight.
  const auto inner = [&](const Vector3& p) {
    double least = 10;
    for (const auto& q : before.rowwise())
      if (share(q.z()) > 0 && q.x() * p.x() > 0) least = std::min(least, std::abs(q.x()) + 2 * std::abs(q.z() - p.z()));
    return least;
  };
  const auto move = [&](const Vector3& p) -> Vector3 {
    return p - Vector3(std::copysign((inner(p) - gap / 2) * share(p.z()), p.x()), 0, 0);
  };
  for (auto point : body.mesh.points.rowwise()) point = move(point.transpose()).transpose().eval();
  for (Slide& slide : body.slides) {
    auto& definition = std::get<PointNormalDefinition>(slide.definition);
    definition.point = move(definition.point);
  }
  return body;
}

SlidBody handle_body() {
  const Vector3 bottom(0.1, 0, -1.3), top(0, 0.1, 1.3), far_bottom(1.7, 0.05, -0.9), far_top(1.6, 0, 0.9);
  const Tube trunk{bottom, top, 0.42}, lower{bottom, far_bottom, 0.33}, upper{top, far_top, 0.35};
  const Tube side{far_bottom, far_top, 0.33}, arm{top, {-1.3, 0.1, 2.1}, 0.33};
  SlidBody body = slid("handle body", {trunk, lower, upper, side, arm}, 1);
  add_slides(body, trunk, {0.3, 0.7});
  add_slides(body, lower, {0.6});
  add_slides(body, upper, {0.6});
  add_slides(body, side, {0.5});
  add_slides(body, arm, {0.6});
  return body;
}

std::vector<SlidBody> slid_bodies() { return {limb(3), fork(2), ring(5), figure(), handle_body()}; }

Motion random_motion(unsigned seed, double scale, double offset) {
  std::mt19937 random(seed);
  const auto uniform = [&] { return 2 * static_cast<double>(random()) / static_cast<double>(std::mt19937::max()) - 1; };
  Motion motion;
  motion.scale = scale;
  const double w = uniform(), x = uniform(), y = uniform(), z = uniform();
  motion.rotation = Eigen::Quaterniond(w, x, y, z).normalized().toRotationMatrix();
  for (int k = 0; k < 3; ++k) motion.offset[k] = offset * uniform();
  return motion;
}

IndexedMesh moved(const IndexedMesh& mesh, const Motion& motion) {
  IndexedMesh result = mesh;
  for (Eigen::Index v = 0; v < mesh.points.rows(); ++v) result.points.row(v) = motion(mesh.points.row(v)).transpose();
  return result;
}

Slide moved(const Slide& slide, const Motion& motion) {
  Slide result = slide;
  if (auto* stroke = std::get_if<StrokeDefinition>(&result.definition)) {
    for (Eigen::Index i = 0; i < stroke->points.rows(); ++i)
      stroke->points.row(i) = motion(Vector3(stroke->points.row(i))).transpose();
  } else if (auto* plane = std::get_if<PointNormalDefinition>(&result.definition)) {
    *plane = {motion(plane->point), motion.turn(plane->normal)};
  } else if (auto* click = std::get_if<PointDefinition>(&result.definition)) {
    click->point = motion(click->point);
  } else {
    auto& ellipse = std::get<EllipseDefinition>(result.definition);
    ellipse = {motion(ellipse.center), motion.scale * motion.turn(ellipse.u), motion.scale * motion.turn(ellipse.v)};
  }
  return result;
}

std::vector<Slide> moved(const std::vector<Slide>& slides, const Motion& motion) {
  std::vector<Slide> result;
  for (const Slide& slide : slides) result.push_back(moved(slide, motion));
  return result;
}

}  // namespace cagewright::shapes
