// SPDX-License-Identifier: BSD-3-Clause
#include "core/tests/cage_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

namespace cagewright::checks {
namespace {

class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) { parent_[of(a)] = of(b); }

 private:
  std::vector<std::size_t> parent_;
};

// Of each vertex of `cage` its partner: the nearest vertex of `other` to where the motion takes it.
std::vector<int> partners(const Cage& cage, const Cage& other, const shapes::Motion& motion, double& farthest) {
  std::vector<int> partner;
  farthest = 0;
  for (Eigen::Index i = 0; i < cage.points.rows(); ++i) {
    Eigen::Index nearest = 0;
    const Vector3 there = motion(Vector3(cage.points.row(i)));
    const double distance = (other.points.rowwise() - there.transpose()).rowwise().norm().minCoeff(&nearest);
    farthest = std::max(farthest, distance);
    partner.push_back(static_cast<int>(nearest));
  }
  if (std::set<int>(partner.begin(), partner.end()).size() != partner.size())
    farthest = std::numeric_limits<double>::infinity();
  return partner;
}

template <class Label>
std::set<std::array<int, 4>> labelled_triangles(const Cage& cage, Label label) {
  std::set<std::array<int, 4>> result;
  for (Eigen::Index t = 0; t < cage.triangles.rows(); ++t) {
    std::array<int, 3> corners;
    for (int i = 0; i < 3; ++i) corners[static_cast<std::size_t>(i)] = label(cage.triangles(t, i));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    result.insert({corners[0], corners[1], corners[2], cage.triangle_part[static_cast<std::size_t>(t)]});
  }
  return result;
}

}  // namespace

long components_of(const Triangles& triangles) {
  Sets sets(static_cast<std::size_t>(triangles.maxCoeff()) + 1);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t) {
    sets.join(triangles(t, 0), triangles(t, 1));
    sets.join(triangles(t, 0), triangles(t, 2));
  }
  std::set<std::size_t> roots;
  for (Eigen::Index c = 0; c < triangles.size(); ++c) roots.insert(sets.of(triangles.data()[c]));
  return static_cast<long>(roots.size());
}

void expect_closed_manifold(const Points& points, const Triangles& triangles, long genus) {
  EXPECT_TRUE(points.allFinite());
  ASSERT_GT(triangles.rows(), 0);
  ASSERT_GE(triangles.minCoeff(), 0);
  ASSERT_LT(triangles.maxCoeff(), points.rows());
  std::map<std::pair<int, int>, int> third;
  std::map<int, int> fan_size;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
    for (int i = 0; i < 3; ++i) {
      const int a = triangles(t, i), b = triangles(t, (i + 1) % 3), c = triangles(t, (i + 2) % 3);
      EXPECT_NE(a, b);
      EXPECT_TRUE(third.emplace(std::pair{a, b}, c).second) << "edge " << a << " -> " << b << " is run twice";
      ++fan_size[a];
    }
  EXPECT_EQ(static_cast<Eigen::Index>(fan_size.size()), points.rows()) << "not every point is used";
  for (const auto& [edge, c] : third)
    ASSERT_TRUE(third.count({edge.second, edge.first})) << edge.first << " -> " << edge.second << " is open";
  std::map<int, int> start;
  for (const auto& [edge, c] : third) start[edge.first] = edge.second;
  for (const auto& [v, first] : start) {
    int size = 0;
    int next = first;
    do {
      next = third.at({v, next});
      ++size;
    } while (next != first);
    EXPECT_EQ(size, fan_size[v]) << "vertex " << v << " has more than one fan";
  }
  const long euler = static_cast<long>(fan_size.size()) - static_cast<long>(third.size()) / 2 + triangles.rows();
  EXPECT_EQ(euler, 2 * components_of(triangles) - 2 * genus);
}

long genus_of_slides(const Segmentation& segmentation) {
  Sets sets(segmentation.parts.size());
  for (const auto& [behind, ahead] : segmentation.slide_parts) sets.join(behind, ahead);
  long parts = 0;
  std::set<std::size_t> components;
  for (std::size_t p = 0; p < segmentation.parts.size(); ++p) {
    if (segmentation.parts[p].enclosed) continue;
    ++parts;
    components.insert(sets.of(p));
  }
  return static_cast<long>(segmentation.slide_parts.size()) - parts + static_cast<long>(components.size());
}

double distance_between(const Cage& cage, const Cage& other, const shapes::Motion& motion) {
  if (cage.points.rows() != other.points.rows()) return std::numeric_limits<double>::infinity();
  double farthest = 0;
  partners(cage, other, motion, farthest);
  return farthest;
}

void expect_same_cage(const Cage& cage, const Cage& other, double tolerance, const shapes::Motion& motion) {
  ASSERT_EQ(cage.points.rows(), other.points.rows());
  double farthest = 0;
  const std::vector<int> partner = partners(cage, other, motion, farthest);
  EXPECT_LE(farthest, tolerance);
  const auto moved_triangles = labelled_triangles(cage, [&](int v) { return partner[static_cast<std::size_t>(v)]; });
  EXPECT_EQ(moved_triangles, labelled_triangles(other, [](int v) { return v; }));
  for (std::size_t v = 0; v < partner.size(); ++v)
    EXPECT_EQ(cage.vertex_section[v], other.vertex_section[static_cast<std::size_t>(partner[v])]);
}

std::vector<std::multiset<std::array<Corner, 3>>> parts_by_position(const Segmentation& segmentation) {
  std::vector<std::multiset<std::array<Corner, 3>>> parts(segmentation.parts.size());
  for (std::size_t t = 0; t < segmentation.triangle_part.size(); ++t) {
    std::array<Corner, 3> corners;
    for (int i = 0; i < 3; ++i) {
      const auto p = segmentation.cut.points.row(segmentation.cut.triangles(static_cast<Eigen::Index>(t), i));
      corners[static_cast<std::size_t>(i)] = {p.x(), p.y(), p.z()};
    }
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    parts[static_cast<std::size_t>(segmentation.triangle_part[t])].insert(corners);
  }
  return parts;
}

double area_of(const IndexedMesh& mesh) {
  double area = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto at = [&](int i) { return Vector3(mesh.points.row(mesh.triangles(t, i))); };
    area += (at(1) - at(0)).cross(at(2) - at(0)).norm() / 2;
  }
  return area;
}

double volume_of(const IndexedMesh& mesh) {
  double volume = 0;
  for (Eigen::Index t = 0; t < mesh.triangles.rows(); ++t) {
    const auto at = [&](int i) { return Vector3(mesh.points.row(mesh.triangles(t, i))); };
    volume += at(0).dot(at(1).cross(at(2))) / 6;
  }
  return volume;
}

std::vector<std::string> names_of(const std::vector<Slide>& slides) {
  std::vector<std::string> names;
  for (const Slide& slide : slides) names.push_back(slide.name);
  return names;
}

}  // namespace cagewright::checks
