// SPDX-License-Identifier: BSD-3-Clause
#include "host/validate/equation_1.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

namespace cagewright::host {
namespace {

constexpr double tie = 1e-9;                // normals so near to 45 degrees count as perpendicular
constexpr double nearest_centers = 1e-3;    // centres nearer than this to the slides' size weigh no more
constexpr double tie_break_weight = 1e-10;  // of the heaviest weight

double size_of(const ObservedSection& s) { return s.u.squaredNorm() + s.v.squaredNorm(); }  // (4b), (4c)

double smoothness(const ObservedSection& k, const ObservedSection& h) {  // (4a)
  const double s_k = size_of(k), s_h = size_of(h);
  const double apart = (k.center - h.center).squaredNorm();
  return (s_k + s_h - std::abs(s_k - s_h)) / std::max(apart, nearest_centers * nearest_centers * (s_k + s_h));
}

double alignment(const ObservedSection& k, double lambda) {  // (5b)
  return lambda * std::pow(k.u.norm() - k.v.norm(), 2) / size_of(k);
}

Eigen::Vector2d fourth_power(double angle) { return {std::cos(4 * angle), std::sin(4 * angle)}; }

// The first case of (2): k follows the normal of h, seen in k's plane.
Eigen::Vector2d followed(const ObservedSection& k, const ObservedSection& h) {
  return fourth_power(std::atan2(h.normal.dot(k.v.normalized()), h.normal.dot(k.u.normalized())));
}

// The second case: R^4 F.
Eigen::Matrix2d turn_between(const ObservedSection& k, const ObservedSection& h) {
  Eigen::Matrix<double, 3, 2> axes_k, axes_h;
  axes_k << k.u.normalized(), k.v.normalized();
  axes_h << h.u.normalized(), h.v.normalized();
  Eigen::Matrix2d flip = Eigen::Matrix2d::Identity();
  if (k.normal.dot(h.normal) <= 0) flip(1, 1) = -1;  // (3)
  const Eigen::Matrix2d change = axes_h.transpose() * axes_k * flip;
  const Eigen::JacobiSVD<Eigen::Matrix2d> svd(change, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Matrix2d proper = Eigen::Matrix2d::Identity();
  proper(1, 1) = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  const Eigen::Matrix2d rotation = svd.matrixU() * proper * svd.matrixV().transpose();
  return rotation * rotation * rotation * rotation * flip;
}

std::set<std::pair<int, int>> neighbours(const std::vector<ObservedSection>& sections) {
  std::set<std::pair<int, int>> pairs;
  for (std::size_t k = 0; k < sections.size(); ++k) {
    for (std::size_t h = k + 1; h < sections.size(); ++h) {
      for (const int part : sections[k].parts) {
        if (part == sections[h].parts[0] || part == sections[h].parts[1]) {
          pairs.emplace(static_cast<int>(k), static_cast<int>(h));
        }
      }
    }
  }
  return pairs;
}

}  // namespace

double Equation1::at(const std::vector<Eigen::Vector2d>& x) const {
  double energy = 0;
  for (const Pull& p : pulls) energy += p.weight * (x[static_cast<std::size_t>(p.k)] - p.target).squaredNorm();
  for (const Tie& t : ties) {
    energy += t.weight * (t.turn * x[static_cast<std::size_t>(t.k)] - x[static_cast<std::size_t>(t.h)]).squaredNorm();
  }
  return energy;
}

double Equation1::at_angles(const std::vector<double>& angles) const {
  std::vector<Eigen::Vector2d> x;
  for (const double angle : angles) x.push_back(fourth_power(angle));
  return at(x);
}

Equation1 equation_1(const ObservedCage& seen) {
  Equation1 equation;
  equation.slides = seen.sections.size();
  for (const auto& [first, second] : neighbours(seen.sections)) {
    const ObservedSection& k = seen.sections[static_cast<std::size_t>(first)];
    const ObservedSection& h = seen.sections[static_cast<std::size_t>(second)];
    const double weight = smoothness(k, h);
    if (std::abs(k.normal.dot(h.normal)) <= std::numbers::sqrt2 / 2 + tie) {
      equation.pulls.push_back({first, followed(k, h), weight});
      equation.pulls.push_back({second, followed(h, k), weight});
    } else {
      equation.ties.push_back({first, second, turn_between(k, h), weight});
    }
  }
  for (std::size_t k = 0; k < seen.sections.size(); ++k) {
    equation.pulls.push_back({static_cast<int>(k), Eigen::Vector2d::UnitX(), alignment(seen.sections[k], seen.lambda)});
  }
  double heaviest = 0;
  for (const Equation1::Pull& p : equation.pulls) heaviest = std::max(heaviest, p.weight);
  for (const Equation1::Tie& t : equation.ties) heaviest = std::max(heaviest, t.weight);
  equation.tie_break = tie_break_weight * (heaviest > 0 ? heaviest : 1);
  return equation;
}

double angle_of(const ObservedSection& section) {
  return std::atan2(section.p.dot(section.v.normalized()), section.p.dot(section.u.normalized()));
}

}  // namespace cagewright::host
