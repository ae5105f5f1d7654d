// SPDX-License-Identifier: BSD-3-Clause
#include "core/enclose/section_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace cagewright {
namespace {

constexpr double right_angle = std::numbers::pi / 2;
constexpr double inner_share = 0.98;  // of the deviation allowed: what linear conditions aim at

}  // namespace

SectionShape::SectionShape(const Cage& cage, const std::vector<SectionFrame>& sections, bool in_plane, double most_off)
    : sections_(sections),
      is_released_(sections.size(), !in_plane),
      most_off_(most_off),
      sections_of_(cage.vertex_section),
      normals_(Points::Zero(cage.points.rows(), 3)) {
  for (int k = 0; k < section_count(); ++k) {
    corners_.push_back(cage.has_whole(k) ? cage.corners_of(k) : std::array<int, 4>{-1, -1, -1, -1});
    if (!is_whole(k)) is_released_[static_cast<std::size_t>(k)] = 1;
  }
  if (!in_plane) return;
  for (std::size_t v = 0; v < sections_of_.size(); ++v)
    if (const int k = sections_of_[v]; k >= 0 && !is_released(k))
      normals_.row(static_cast<Eigen::Index>(v)) = sections[static_cast<std::size_t>(k)].normal.transpose();
}

void SectionShape::release(int section) {
  is_released_[static_cast<std::size_t>(section)] = 1;
  if (!is_whole(section)) return;
  for (int i = 0; i < 4; ++i) normals_.row(corner(section, i)).setZero();
}

void SectionShape::hold(int section) {
  if (!is_whole(section)) return;
  const auto k = static_cast<std::size_t>(section);
  is_released_[k] = 0;
  for (int i = 0; i < 4; ++i) normals_.row(corner(section, i)) = sections_[k].normal.transpose();
}

void SectionShape::put_in_plane(Points& points) const {
  put_in_plane(points, std::vector<char>(sections_of_.size(), 1));
}

void SectionShape::put_in_plane(Points& points, const std::vector<char>& chosen) const {
  for (std::size_t v = 0; v < sections_of_.size(); ++v) {
    if (sections_of_[v] < 0 || !chosen[v] || is_released(sections_of_[v])) continue;
    const SectionFrame& section = sections_[static_cast<std::size_t>(sections_of_[v])];
    const auto row = static_cast<Eigen::Index>(v);
    const Vector3 p = points.row(row);
    points.row(row) -= (section.normal * section.normal.dot(p - section.center)).transpose();
  }
}

std::array<double, 4> SectionShape::angles(int section, const Points& points) const {
  const Vector3 n = sections_[static_cast<std::size_t>(section)].normal;
  std::array<double, 4> result{};
  for (int i = 0; i < 4; ++i) {
    const Vector3 here = points.row(corner(section, i));
    const Vector3 next = points.row(corner(section, (i + 1) % 4)).transpose() - here;
    const Vector3 last = points.row(corner(section, (i + 3) % 4)).transpose() - here;
    result[static_cast<std::size_t>(i)] = std::atan2(n.dot(next.cross(last)), next.dot(last));
  }
  return result;
}

bool SectionShape::is_sound(int section, const Points& points) const {
  if (is_released(section)) return true;
  const std::array<double, 4> all = angles(section, points);
  return std::all_of(all.begin(), all.end(), [&](double a) { return std::abs(a - right_angle) <= most_off_; });
}

double SectionShape::most_off(const Points& points) const {
  double most = 0;
  for (int k = 0; k < section_count(); ++k) {
    if (is_released(k)) continue;
    for (const double a : angles(k, points)) most = std::max(most, std::abs(a - right_angle));
  }
  return most;
}

void SectionShape::put_in_shape(Points& points) const {
  put_in_plane(points);
  for (int k = 0; k < section_count(); ++k) {
    if (is_sound(k, points)) continue;
    const SectionFrame& section = sections_[static_cast<std::size_t>(k)];
    const Vector3 p = section.p.normalized(), q = section.q.normalized();
    const auto mean = [&](const Vector3& axis, int i, int j) {
      return axis.dot((points.row(corner(k, i)) + points.row(corner(k, j))).transpose() / 2 - section.center);
    };
    const double most_p = mean(p, 0, 3), least_p = mean(p, 1, 2), most_q = mean(q, 0, 1), least_q = mean(q, 2, 3);
    const auto at = [&](double a, double b) { return (section.center + a * p + b * q).transpose(); };
    points.row(corner(k, 0)) = at(most_p, most_q);
    points.row(corner(k, 1)) = at(least_p, most_q);
    points.row(corner(k, 2)) = at(least_p, least_q);
    points.row(corner(k, 3)) = at(most_p, least_q);
  }
}

void SectionShape::add_contacts(const Points& points, Contacts& contacts) const {
  for (int k = 0; k < section_count(); ++k) {
    if (is_released(k)) continue;
    const Vector3 n = sections_[static_cast<std::size_t>(k)].normal;
    const std::array<double, 4> all = angles(k, points);
    for (int i = 0; i < 4; ++i) {
      const int here = corner(k, i), after = corner(k, (i + 1) % 4), before = corner(k, (i + 3) % 4);
      const Vector3 next = (points.row(after) - points.row(here)).transpose();
      const Vector3 last = (points.row(before) - points.row(here)).transpose();
      const double length = std::min(next.norm(), last.norm());  // so that the condition is one on lengths
      const Vector3 by_last = length * n.cross(last) / last.squaredNorm();
      const Vector3 by_next = -length * n.cross(next) / next.squaredNorm();
      const double off = all[static_cast<std::size_t>(i)] - right_angle, most = inner_share * most_off_;
      for (const double sign : {1.0, -1.0}) {
        Contact contact;
        contact.add(before, sign * by_last);
        contact.add(after, sign * by_next);
        contact.add(here, -sign * (by_last + by_next));
        contact.least = length * (-most - sign * off);
        contacts.push_back(contact);
      }
    }
  }
}

}  // namespace cagewright
