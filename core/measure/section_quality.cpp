// SPDX-License-Identifier: BSD-3-Clause
#include "core/measure/section_quality.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "core/mesh/tolerance.h"
#include "core/slide/plane_frame.h"

namespace cagewright {
namespace {

constexpr double right_angle = std::numbers::pi / 2;

double angle_round(const Vector3& normal, const Vector3& from, const Vector3& to) {
  return std::atan2(normal.dot(from.cross(to)), from.dot(to));
}

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

bool is_whole(const PlacedSection& section) {
  return std::all_of(section.corners.begin(), section.corners.end(), [](const Vector3& c) { return c.allFinite(); });
}

// To the nearest of four directions.
double folded(double angle) { return std::abs(std::remainder(angle, right_angle)); }

double squareness_of(const PlacedSection& section) {
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3 next = section.corners[(i + 1) % 4] - section.corners[i];
    const Vector3 previous = section.corners[(i + 3) % 4] - section.corners[i];
    double angle = std::atan2(next.cross(previous).norm(), next.dot(previous));
    if (section.normal.dot(next.cross(previous)) < 0) angle = 2 * std::numbers::pi - angle;
    worst = std::max(worst, std::abs(angle - right_angle));
  }
  return worst;
}

double planarity_of(const PlacedSection& section) {
  double worst = 0;
  for (const Vector3& corner : section.corners)
    worst = std::max(worst, std::abs(section.normal.dot(corner - section.center)));
  return worst;
}

// A direction in the section's plane that its axes follow.
Vector3 axis_of(const PlacedSection& section) {
  const auto& c = section.corners;
  const PlaneFrame frame(Vector3::Zero(), section.normal);
  std::complex<double> sum = 0;
  for (const Vector3& edges : {Vector3((c[0] - c[1]) + (c[3] - c[2])), Vector3((c[0] - c[3]) + (c[1] - c[2]))}) {
    const Vector2 flat = frame.to_plane(edges);
    if (!flat.isZero(0)) sum += std::polar(1.0, 4 * std::atan2(flat.y(), flat.x()));
  }
  const double angle = std::arg(sum) / 4;
  return frame.to_space({std::cos(angle), std::sin(angle)});
}

double twist_between(const PlacedSection& k, const PlacedSection& h) {
  const Vector3 axis_k = axis_of(k), axis_h = axis_of(h);
  const double cosine = k.normal.dot(h.normal);
  if (std::abs(cosine) <= std::numbers::sqrt2 / 2 + tolerance::tie) {
    const Vector3 bend = k.normal.cross(h.normal);  // a quarter turn from both projections
    return std::max(folded(angle_round(k.normal, bend, axis_k)), folded(angle_round(h.normal, bend, axis_h)));
  }
  const Vector3 same_way = cosine > 0 ? h.normal : Vector3(-h.normal);
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(k.normal, same_way);
  return folded(angle_round(same_way, turn * axis_k, axis_h));
}

double largest(const std::vector<double>& values) {
  double most = 0;
  for (const double value : values)
    if (value > most) most = value;  // not NaN
  return most;
}

}  // namespace

double SectionQuality::worst_squareness() const { return largest(squareness); }
double SectionQuality::worst_planarity() const { return largest(planarity); }
double SectionQuality::worst_twist() const { return largest(twist); }

std::vector<PlacedSection> place_sections(const std::vector<SectionFrame>& frames, const Cage& cage) {
  std::vector<PlacedSection> sections;
  for (const SectionFrame& frame : frames) {
    const std::array<int, 4> rows = cage.corners_of(static_cast<int>(sections.size()));
    PlacedSection section{{}, frame.center, frame.normal};
    for (std::size_t i = 0; i < 4; ++i)
      section.corners[i] = rows[i] < 0 ? Vector3(Vector3::Constant(unknown)) : Vector3(cage.points.row(rows[i]));
    sections.push_back(section);
  }
  return sections;
}

SectionQuality measure_sections(const std::vector<PlacedSection>& sections, const NeighbourPairs& neighbours,
                                double diagonal) {
  SectionQuality quality;
  for (const PlacedSection& section : sections) {
    quality.squareness.push_back(is_whole(section) ? squareness_of(section) : unknown);
    quality.planarity.push_back(is_whole(section) ? planarity_of(section) / diagonal : unknown);
  }
  for (const auto& [k, h] : neighbours) {
    const PlacedSection &a = sections[static_cast<std::size_t>(k)], &b = sections[static_cast<std::size_t>(h)];
    quality.twist.push_back(is_whole(a) && is_whole(b) ? twist_between(a, b) : unknown);
  }
  return quality;
}

}  // namespace cagewright
